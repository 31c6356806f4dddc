// What the virtual devices of one physical device of CiA 407 share: events from and for them
// (6001h, 6002h; 9.2.4, 9.2.5), and that one learns of what the bus or another one of them has
// written.
//
//     VirtualDevices all(node);
//     VirtualDevice canceller(all, ticket_canceller, 1);
//     canceller.signal(1, true);       // an event arises: 6001h:02h, and its bit in 6001h:01h
//     canceller.on_event = ...;        // somebody wrote 6002h:01h
//     canceller.react(*this, rows);    // a table of reactions: see profiles/reactions.hpp
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia407/handles.hpp"
#include "canvoy/profiles/device_values.hpp"
#include "canvoy/profiles/reactions.hpp"

namespace canvoy::cia407 {

/// Where code and manufacturer-specific information stand in an entry of 6001h and 6002h.
inline constexpr unsigned event_code_bit = 24;
inline constexpr unsigned event_information_bit = 8;

/// The objects of the profile: 6000h to 67FFh.
inline constexpr HookCalls any_object = {.first = 0x6000, .last = 0x67FF};
/// `function` reacts to all of them: see after_write.
template <auto function>
inline constexpr HookCalls after_any_write = [] {
  HookCalls row = any_object;
  row.after_write = detail::Reaction<function>::after_write;
  return row;
}();

class FileShelf;
class VirtualDevice;

/// It has to be made before the node starts. A step for each row of each virtual device at each
/// access.
class VirtualDevices {
 public:
  /// 6001h and 6002h have room for so many; others have no events (errata 80).
  static constexpr unsigned with_events_max = 32;

  explicit VirtualDevices(Node& node);
  VirtualDevices(const VirtualDevices&) = delete;
  VirtualDevices& operator=(const VirtualDevices&) = delete;

  Node& node() { return node_; }

 private:
  friend class VirtualDevice;

  void defaults_restored(ResetScope scope);
  void reset(ResetScope scope);
  AbortCode before_read(const Entry& entry);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void tell_events(VirtualDevice& device);
  void listen(std::span<const HookCalls> rows);
  bool has_listener(std::uint16_t index) const {
    return (listened_[index / 64 % listened_.size()] >> index % 64 & 1) != 0;
  }

  Node& node_;
  /// Indices modulo 512 of which a row of a virtual device is told, a bit each.
  std::array<std::uint64_t, 8> listened_{};
  VirtualDevice* first_ = nullptr;
  VirtualDevice** last_ = &first_;
  const VirtualDevice* teller_ = nullptr;  ///< whose value it is that is announced
  FileShelf* shelves_ = nullptr;
  std::uint16_t own_counts_ = 0;  ///< 6700h before it was written
  Callback<void(ResetScope)> next_restored_;
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
};

/// One of them, for the unit that is its behaviour. What is not set is not told.
class VirtualDevice {
 public:
  /// `number` counts from 1 on. It must outlive the node, and so must `all`.
  VirtualDevice(VirtualDevices& all, const VirtualDeviceInfo& info, unsigned number);
  VirtualDevice(const VirtualDevice&) = delete;
  VirtualDevice& operator=(const VirtualDevice&) = delete;

  Node& node() { return all_.node(); }
  const VirtualDeviceInfo& info() const { return info_; }
  unsigned number() const { return number_; }
  Values values() { return Values(node().dictionary()); }
  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle) {
    return values()[handle];
  }

  /// See FoundValues.
  template <class Handle, class Function>
  ValueWatch<Handle, Function> on(const Handle& handle, Function function) {
    return {node().dictionary(), handle, std::move(function)};
  }

  /// All events are gone, and its objects have their defaults where the node was reset.
  Callback<void(ResetScope)> on_reset = {};
  /// 6002h was written for this one: its flags, and the manufacturer-specific information.
  Callback<void(std::uint8_t flags, std::uint16_t information)> on_event = {};

  /// What `unit` does when objects of the profile are accessed by the bus, or were written by
  /// another virtual device of this physical one; the first that refuses decides. Both must outlive
  /// this.
  template <class Unit>
  void react(Unit& unit, std::span<const HookCalls> rows) {
    unit_ = &unit;
    rows_ = rows;
    all_.listen(rows);
  }

  /// Sets or clears flags of 6001h. While there is neither a flag nor information the entry is
  /// zero.
  void signal(std::uint8_t flags, bool is_pending);
  /// The manufacturer-specific information of 6001h.
  void inform(std::uint16_t information);
  std::uint8_t flags() const { return flags_; }
  /// An error of this one came (`is_present`) or went; the emergency says which number it has.
  void report(std::uint16_t code, bool is_present, std::uint8_t register_bits = 0) {
    node().report({.code = code,
                   .instance = static_cast<std::uint16_t>(number_),
                   .register_bits = register_bits},
                  is_present);
  }

  /// Writes a value that this one provides, and has those of this physical device learn of it that
  /// consume it.
  template <class Handle, class Value>
  void tell(const Handle& handle, const Value& value) {
    const auto reference = values()[handle];
    reference = value;
    announce_at(handle.index(), handle.sub());
  }
  /// The same of a value that was written past tell().
  void announce_at(std::uint16_t index, std::uint8_t sub);

  /// Of this physical device: the last that was made.
  FileShelf*& shelves() { return all_.shelves_; }

 private:
  friend class VirtualDevices;

  /// Calls act(row, unit) for the rows of this entry, until one refuses.
  template <class Act>
  AbortCode for_rows_of(const Entry& entry, const Act& act) const;

  VirtualDevices& all_;
  const VirtualDeviceInfo& info_;
  unsigned number_;
  std::uint8_t flags_ = 0;
  std::uint16_t information_ = 0;
  void* unit_ = nullptr;
  std::span<const HookCalls> rows_;
  VirtualDevice* next_ = nullptr;
};

}  // namespace canvoy::cia407
