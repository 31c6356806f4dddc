// The common part of the virtual devices of one physical device of CiA 407: events from and for
// them (6001h, 6002h; 9.2.4, 9.2.5), and notifications of values that the bus or another virtual
// device has written.
//
//     VirtualDevices all(node);
//     VirtualDevice canceller(all, ticket_canceller, 1);
//     canceller.signal(1, true);       // an event arises: 6001h:02h, and its bit in 6001h:01h
//     canceller.on_event = ...;        // somebody wrote 6002h:01h
//     canceller.react(*this, rows);    // a table of reactions: see profiles/reactions.hpp
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia407/handles.hpp"
#include "canvoy/profiles/model/device_values.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia407 {

/// First bits of code and manufacturer-specific information in an entry of 6001h and 6002h.
inline constexpr unsigned event_code_bit = 24;
/// Of the lowest bit of the information in 6001h.
inline constexpr unsigned event_information_bit = 8;

/// The objects of the profile: 6000h to 67FFh.
inline constexpr AccessHandlers any_object = {.first = 0x6000, .last = 0x67FF};
/// `function` reacts to all of the objects: see after_write.
template <auto function>
inline constexpr AccessHandlers after_any_write = [] {
  AccessHandlers row = any_object;
  row.after_write = detail::Reaction<function>::after_write;
  return row;
}();

class FileShelf;
class VirtualDevice;

/// Construct it before the node starts. Each access costs a step for each row of each virtual
/// device.
class VirtualDevices {
 public:
  /// Maximum number in 6001h and 6002h; further virtual devices have no events (errata 80).
  static constexpr unsigned with_events_max = 32;

  /// Attaches to the node, which must outlive this.
  explicit VirtualDevices(Node& node);

  /// The node of the physical device.
  Node& node() { return node_; }

 private:
  friend class VirtualDevice;

  void defaults_restored(ResetScope scope);
  void reset(ResetScope scope);
  AbortCode before_read(const Entry& entry);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void report_events(VirtualDevice& device);
  void listen(std::span<const AccessHandlers> rows);
  /// A virtual device is told that an object was written.
  bool has_listener(std::uint16_t index) const {
    return (listened_[index / 64 % listened_.size()] >> index % 64 & 1) != 0 || is_of_events(index);
  }
  static bool is_of_events(std::uint16_t index);

  Node& node_;
  /// Indices modulo 512 for which a row of a virtual device exists, a bit each.
  std::array<std::uint64_t, 8> listened_{};
  VirtualDevice* first_ = nullptr;
  VirtualDevice** last_ = &first_;
  const VirtualDevice* teller_ = nullptr;  ///< the virtual device that announces a value
  FileShelf* shelves_ = nullptr;
  std::uint16_t own_counts_ = 0;  ///< 6700h before the write
  Callback<void(ResetScope)> next_restored_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// One virtual device, for the unit that implements its behaviour. Callbacks that are not set are
/// not called.
class VirtualDevice {
 public:
  /// `number` counts from 1. Both this and `all` must outlive the node.
  VirtualDevice(VirtualDevices& all, const VirtualDeviceInfo& info, unsigned number);
  VirtualDevice(const VirtualDevice&) = delete;
  VirtualDevice& operator=(const VirtualDevice&) = delete;

  /// The node of the physical device.
  Node& node() { return all_.node(); }
  /// Its description in the profile: name, clause, objects.
  const VirtualDeviceInfo& info() const { return info_; }
  /// Number of the virtual device in its physical device, from 1.
  unsigned number() const { return number_; }
  /// Values of the dictionary, by handle.
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

  /// Called when all events are cleared and, after a node reset, its objects have their defaults.
  Callback<void(ResetScope)> on_reset = {};
  /// Called when 6002h is written for this one, with its flags and the manufacturer-specific
  /// information.
  Callback<void(std::uint8_t flags, std::uint16_t information)> on_event = {};

  /// Calls the rows of `unit` when objects of the profile are accessed by the bus, or have been
  /// written by another virtual device of this physical one. The first one that refuses decides.
  /// Both must outlive this.
  template <class Unit>
  void react(Unit& unit, std::span<const AccessHandlers> rows) {
    unit_ = &unit;
    rows_ = rows;
    all_.listen(rows);
  }

  /// Sets or clears flags of 6001h. Without flags and information, the entry is zero.
  void signal(std::uint8_t flags, bool is_pending);
  /// Sets the manufacturer-specific information of 6001h.
  void inform(std::uint16_t information);
  /// Event flags that this device reports at present.
  std::uint8_t flags() const { return flags_; }
  /// Reports that an error came (`is_present`) or went; the emergency has the number of this
  /// virtual device.
  void report(std::uint16_t code, bool is_present, std::uint8_t register_bits = 0) {
    node().report({.code = code,
                   .instance = static_cast<std::uint16_t>(number_),
                   .register_bits = register_bits},
                  is_present);
  }

  /// Writes a value that this one provides, and notifies its consumers in this physical device.
  template <class Handle, class Value>
  void tell(const Handle& handle, const Value& value) {
    const auto reference = values()[handle];
    reference = value;
    if constexpr (requires { reference.entry(); }) {
      if (reference.exists()) announce(reference.entry());
    } else {
      announce_at(handle.index(), handle.sub());  // a text in several entries
    }
  }
  /// Notifies the consumers of a value that was written without tell().
  void announce_at(std::uint16_t index, std::uint8_t sub);

  /// Of this physical device: the shelf that was made last.
  FileShelf*& shelves() { return all_.shelves_; }

 private:
  friend class VirtualDevices;

  void announce(const Entry& entry);
  /// Calls act(row, unit) for the rows of this entry, until one refuses.
  template <class Act>
  AbortCode for_rows_of(const Entry& entry, const Act& act) const;

  VirtualDevices& all_;
  const VirtualDeviceInfo& info_;
  unsigned number_;
  std::uint8_t flags_ = 0;
  std::uint16_t information_ = 0;
  void* unit_ = nullptr;
  std::span<const AccessHandlers> rows_;
  VirtualDevice* next_ = nullptr;
};

}  // namespace canvoy::cia407
