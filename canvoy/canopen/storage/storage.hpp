// Storage: keeps parameters without power, and restores their defaults (CiA 301, 7.5.2.13 and
// 7.5.2.14, objects 1010h and 1011h).
//
//     Storage storage(node, flash, {.slot_size = 2048});
//
// At any moment, the stored set is the old or the new one, whenever power fails (RecordPair).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/storage/parameter_set.hpp"

namespace canvoy {

/// Storage of a node. Writing "save" to 1010h stores a group of parameters with their values at
/// that time; "load" to 1011h restores its defaults, from the next reset on that includes the
/// group: reset communication for 1000h to 1FFFh, reset node for all. Other groups stay as they
/// were stored. Another signature, or an entry with bit 0 not set, is refused with 0800 0020h.
///
/// The SDO answer comes at the end: success, or 0606 0000h if the flash failed, 0504 0005h if the
/// slot is too small, 0800 0022h if values change faster than they are stored, or NMT reset the
/// node meanwhile. In all these cases the old set stays, unless the head of the new one was already
/// being programmed, which takes the last moment of a store: then it is either of them. Nothing
/// blocks: each advance() of the node erases a sector or programs 32 bytes, and other services run
/// in between. Only a reset waits until the flash can be read again.
///
/// A stored set that is damaged, or not of this device, is refused as a whole: all defaults apply,
/// and emergency 6300h reports it with RecordState in byte 3, until a valid set is stored or found
/// at a reset. If the flash could not be read, nothing is stored until a reset reads it.
class Storage {
 public:
  /// Place in the flash, groups, and times.
  struct Settings {
    std::uint32_t address = 0;    ///< of two slots in the flash
    std::uint32_t slot_size = 0;  ///< of each slot: whole sectors, 32 bytes more than the set
    /// Of 1010h and 1011h, from sub-index 4 on.
    std::span<const ParameterGroup> groups = manufacturer_group;
    /// Whether a set that a device of the same kind stored with another dictionary (before a
    /// firmware update) is used as far as it fits. Otherwise it is refused.
    bool keep_what_fits = false;
    Duration poll_interval = 1ms;  ///< while the flash is busy
    Duration time_out = 10s;       ///< for the whole operation
  };
  /// Called with the answer that a client would get.
  using Done = Callback<void(AbortCode)>;

  /// Makes the storage. `flash`, and what `settings` refer to, must outlive it. It sets itself as
  /// source of the power-on values of `node` (Node::on_defaults_restored): a node has one storage.
  /// Stored values take precedence over those of the source set before, which apply if nothing is
  /// stored.
  Storage(Node& node, const Flash& flash, const Settings& settings);
  ~Storage() { node_.timers().disarm(timer_); }
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;

  /// Stores or restores, as if a client had written to sub-index `group` of 1010h or 1011h; `done`
  /// is called once if the result is none. Outside of the node's callbacks, call node.advance(now)
  /// before. Abort: device_state while busy().
  AbortCode store(std::uint8_t group, Done done = {});
  /// Restores defaults, like store().
  AbortCode restore(std::uint8_t group, Done done = {});

  /// True while a set is being written.
  bool busy() const { return record_.busy(); }
  /// State of the stored set at the last reset or store.
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
  Time end_{};  ///< limit of waiting for the flash
  Done done_;
  Callback<void(ResetScope)> former_;  ///< the source of power-on values set before
  Timer timer_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
