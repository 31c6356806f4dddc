// State of another node, as its error control messages report it (CiA 301, 7.2.8.3).
//
//     consumer.on_change(Callback<void(NodeId, RemoteState)>::to<&Charger::battery_is>(charger));
#pragma once

#include <cstdint>

namespace canvoy {

/// The NMT states with their numbers on the wire, and values for a missing state.
enum class RemoteState : std::uint8_t {
  boot_up = 0x00,  ///< it has just started or restarted
  stopped = 0x04,
  operational = 0x05,
  pre_operational = 0x7F,
  unknown = 0xFE,  ///< no message yet
  lost = 0xFF,     ///< silent for longer than the time set, after earlier messages
};

/// State in the byte of an error control message; `unknown` for an invalid byte. Bit 7 is ignored:
/// it is reserved in a heartbeat, and toggles in an answer to node guarding.
constexpr RemoteState remote_state(std::uint8_t byte) {
  const auto state = static_cast<RemoteState>(byte & 0x7F);
  const bool exists = state == RemoteState::boot_up || state == RemoteState::stopped ||
                      state == RemoteState::operational || state == RemoteState::pre_operational;
  return exists ? state : RemoteState::unknown;
}

}  // namespace canvoy
