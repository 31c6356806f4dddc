// Keeps what an LSS master has given a node, its node-ID and bit timing, without power (CiA 305,
// store configuration).
//
//     LssMemory memory(flash, {.address = 0, .slot_size = 256});
//     const LssMemory::Content kept = memory.find();
//     DeviceNode<layout, LssSlave::routes> device(port, kept.node_id);
//     hooks.store = memory.store_hook();
//     LssSlave lss(device.node(), hooks, kept.bit_timing);
//     memory.serve(device.node(), lss);
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/storage/record_pair.hpp"

namespace canvoy {

/// Two slots as those of parameters: the old content or the new one, whenever power fails. It does
/// not block; the slave is told when all is stored, or that the flash has failed (error 2).
class LssMemory {
 public:
  struct Content {
    NodeId node_id = node_id_unconfigured;
    std::uint8_t bit_timing = lss_bit_timing::unknown;
    friend bool operator==(const Content&, const Content&) = default;
  };
  struct Place {
    std::uint32_t address = 0;    ///< of two slots in the flash
    std::uint32_t slot_size = 0;  ///< of each: whole sectors, of 34 bytes at least
  };

  /// `flash` must outlive this.
  LssMemory(const Flash& flash, const Place& place);
  ~LssMemory();
  LssMemory(const LssMemory&) = delete;
  LssMemory& operator=(const LssMemory&) = delete;

  /// What is kept; a node without node-ID where there is nothing, or nothing that can be trusted
  /// (see state()).
  Content find();
  RecordState state() const { return state_; }

  /// For LssSlaveHooks::store.
  Callback<void(NodeId, std::uint8_t)> store_hook() {
    return Callback<void(NodeId, std::uint8_t)>::to<&LssMemory::store>(*this);
  }
  /// Whose memory it is. Both must outlive this.
  void serve(Node& node, LssSlave& slave);

 private:
  static constexpr Duration poll_interval = 1ms;
  static constexpr Duration time_out = 10s;

  void store(NodeId node_id, std::uint8_t bit_timing);
  void step(Time now);
  void finish(AbortCode outcome);
  void rewind() { given_ = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> bytes);

  RecordPair record_;
  RecordState state_ = RecordState::empty;
  Node* node_ = nullptr;
  LssSlave* slave_ = nullptr;
  std::array<std::uint8_t, 2> content_{};
  std::size_t given_ = 0;
  Time end_{};
  Timer timer_{Callback<void(Time)>::to<&LssMemory::step>(*this)};
};

}  // namespace canvoy
