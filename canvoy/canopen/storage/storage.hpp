// Storage: keeps parameters without power, and gives them their defaults back (CiA 301, 7.5.2.13
// and 7.5.2.14: objects 1010h and 1011h).
//
//     Storage storage(node, flash, {.slot_size = 2048});
//
// What is stored is the old set or the new one at any moment, whenever power fails (RecordPair).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/storage/parameter_set.hpp"

namespace canvoy {

/// Writing "save" to 1010h stores a group of parameters as they are at that time; "load" to 1011h
/// gives its defaults back, from the next reset on that reaches the group: reset communication for
/// 1000h to 1FFFh, reset node for all. Groups that were not asked for stay as they were stored.
/// Another signature, or an entry of which bit 0 is not set, is refused with 0800 0020h.
///
/// The answer to SDO comes when it is done, or has failed: 0606 0000h where the flash does, 0504
/// 0005h where the slot is too small, 0800 0022h where values change faster than they are stored,
/// or NMT reset the node meanwhile. In all these cases the old set stays, unless the head of the
/// new one was already being programmed, which takes the last moment of a store: then it is the one
/// or the other. Nothing blocks: each advance() of the node erases a sector or programs 32 bytes,
/// and others are served in between. Only a reset waits until the flash can be read again.
///
/// A stored set that is damaged, or not of this device, is refused as a whole: all is as by
/// default, and emergency 6300h tells it with RecordState in byte 3, until something good is stored
/// or a reset finds it. Where the flash could not be read, nothing is stored until a reset reads
/// it.
class Storage {
 public:
  struct Settings {
    std::uint32_t address = 0;    ///< of two slots in the flash
    std::uint32_t slot_size = 0;  ///< of each: whole sectors, 32 bytes more than the set takes
    std::span<const ParameterGroup> groups = manufacturer_group;
    /// What was stored with another dictionary by a device of the same kind (before an update of
    /// its firmware) is taken as far as it fits. Otherwise it is refused.
    bool keep_what_fits = false;
    Duration poll_interval = 1ms;  ///< while the flash is busy
    Duration time_out = 10s;       ///< for all of it
  };
  using Done = Callback<void(AbortCode)>;

  /// `flash`, and what `settings` refer to, must outlive the storage. It attaches itself to `node`
  /// as who knows the power-on values (Node::on_defaults_restored): a node has one storage. What is
  /// stored goes before the values of who did so until now, which the device has where nothing is.
  Storage(Node& node, const Flash& flash, const Settings& settings);
  ~Storage() { node_.timers().disarm(timer_); }
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;

  /// As if a client had written to sub-index `group` of 1010h or 1011h; `done` is called once where
  /// they answer none. From outside of the node's callbacks, call node.advance(now) before. Abort:
  /// device_state while busy().
  AbortCode store(std::uint8_t group, Done done = {});
  AbortCode restore(std::uint8_t group, Done done = {});

  bool busy() const { return record_.busy(); }
  /// What the stored set was worth at the last reset or store.
  RecordState state() const { return state_; }

 private:
  void defaults_restored(ResetScope scope);
  void state_entered(NmtState state);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void sign();
  bool usable() const;
  RecordState load(ResetScope scope);
  bool take(const StoredHead& head, std::uint32_t at);

  AbortCode begin(const ParameterSet::Recipe& recipe, Done done);
  void step(Time now);
  void finish(AbortCode answer);

  Node& node_;
  Settings settings_;
  RecordPair record_;
  ParameterSet set_;
  RecordState state_ = RecordState::empty;
  Time end_{};  ///< until then the flash has to be ready
  Done done_;
  Callback<void(ResetScope)> former_;  ///< who knew the power-on values
  Timer timer_;
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;
  ServiceLink service_{&service_calls, this};
};

}  // namespace canvoy
