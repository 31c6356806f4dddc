// Stores node-ID and bit timing for LSS "store". Whenever power fails, either the old or the new
// values are present (CiA 305).
//
//     LssStore store(node, flash, {.address = 0x8000, .slot_size = 2048});
//     LssSlave lss(node, {.store = store.hook()}, store.bit_timing());
//     store.on_stored(LssStore::Stored::to<&LssSlave::stored>(lss));
//     node.start(now);
#pragma once

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy {

/// Stores without blocking: each advance() of the node takes one step of the flash.
class LssStore {
 public:
  /// Called at the end of storing, with what the master is answered.
  using Stored = Callback<void(LssError)>;
  /// Location of two slots in the flash.
  struct Place {
    std::uint32_t address = 0;    ///< of the first slot; the second follows it
    std::uint32_t slot_size = 0;  ///< size of each slot: whole sectors
  };

  /// Makes the store, before Node::start(): a stored node-ID becomes that of the node. Damaged
  /// contents are ignored. `flash` must outlive this object.
  LssStore(Node& node, const Flash& flash, const Place& place);
  ~LssStore() { node_.timers().disarm(timer_); }
  LssStore(const LssStore&) = delete;
  LssStore& operator=(const LssStore&) = delete;

  /// Stored bit timing, as index of table selector 0; lss_bit_timing::unknown if there is none.
  std::uint8_t bit_timing() const { return content_[1]; }
  /// State of the record in the flash at construction.
  RecordState state() const { return state_; }

  /// Function for LssSlaveHooks::store.
  Callback<void(NodeId, std::uint8_t)> hook() { return callback<&LssStore::store>(*this); }
  /// Sets the callback for the end of storing; usually LssSlave::stored().
  void on_stored(Stored stored) { stored_ = stored; }

 private:
  void store(NodeId id, std::uint8_t bit_timing);
  void step(Time now);
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  Node& node_;
  RecordPair record_;
  Timer timer_;
  Stored stored_;
  Time end_{};
  std::array<std::uint8_t, 2> content_{node_id_unconfigured, lss_bit_timing::unknown};
  RecordState state_;
};

}  // namespace canvoy
