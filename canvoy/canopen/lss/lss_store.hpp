// Keeps what LSS "store" asks for without power: node-ID and bit timing (CiA 305). Either the old
// ones or the new ones are there, whenever power fails.
//
//     LssStore store(node, flash, {.address = 0x8000, .slot_size = 2048});
//     LssSlave lss(node, {.store = store.hook()}, store.bit_timing());
//     store.on_stored(LssStore::Stored::to<&LssSlave::stored>(lss));
//     node.start(now);
#pragma once

#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy {

/// Nothing blocks: each advance() of the node takes one step of the flash.
class LssStore {
 public:
  using Stored = Callback<void(LssError)>;
  /// Of two slots in the flash.
  struct Place {
    std::uint32_t address = 0;
    std::uint32_t slot_size = 0;  ///< of each: whole sectors
  };

  /// Before Node::start(): a stored node-ID becomes the node's. What is damaged counts as nothing.
  /// `flash` must outlive this.
  LssStore(Node& node, const Flash& flash, const Place& place);
  ~LssStore() { node_.timers().disarm(timer_); }
  LssStore(const LssStore&) = delete;
  LssStore& operator=(const LssStore&) = delete;

  /// That is stored, as index of table selector 0; lss_bit_timing::unknown where there is none.
  std::uint8_t bit_timing() const { return content_[1]; }
  /// What the flash held at construction.
  RecordState state() const { return state_; }

  Callback<void(NodeId, std::uint8_t)> hook() {
    return Callback<void(NodeId, std::uint8_t)>::to<&LssStore::store>(*this);
  }
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
