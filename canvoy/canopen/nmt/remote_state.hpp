// What a node knows of another one by its error control messages (CiA 301, 7.2.8.3).
//
//     consumer.on_change(Callback<void(NodeId, RemoteState)>::to<&Charger::battery_is>(charger));
#pragma once

#include <cstdint>

namespace canvoy {

/// The NMT states with their numbers on the wire, and what stands for the lack of one.
enum class RemoteState : std::uint8_t {
  boot_up = 0x00,  ///< it has just started, or started again
  stopped = 0x04,
  operational = 0x05,
  pre_operational = 0x7F,
  unknown = 0xFE,  ///< not heard of yet
  lost = 0xFF,     ///< was heard of, but not within the time that was set
};

/// Of the byte of an error control message: the state, or `unknown` where the byte stands for none.
/// Bit 7 is left out: it is reserved in a heartbeat, and toggles in an answer to node guarding.
constexpr RemoteState remote_state(std::uint8_t byte) {
  const auto state = static_cast<RemoteState>(byte & 0x7F);
  const bool exists = state == RemoteState::boot_up || state == RemoteState::stopped ||
                      state == RemoteState::operational || state == RemoteState::pre_operational;
  return exists ? state : RemoteState::unknown;
}

}  // namespace canvoy
