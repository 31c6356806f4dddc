// NMT states and commands, with their numbers on the wire (CiA 301, 7.3.2).
#pragma once

#include <cstdint>

namespace canvoy {

/// NMT state, as error control reports it.
enum class NmtState : std::uint8_t {
  initialisation = 0x00,
  stopped = 0x04,
  operational = 0x05,
  pre_operational = 0x7F,
};

/// True for pre-operational and operational: SDO, SYNC and emergency work.
constexpr bool has_services(NmtState state) {
  return state > NmtState::stopped;
}

/// Bit beside the state in an answer to node guarding: it changes from answer to answer (CiA 301,
/// 7.2.8.2.2.1).
inline constexpr unsigned guarding_toggle_bit = 0x80;

/// NMT command specifier, first byte of the message with CAN-ID 000h (CiA 301, 7.2.8.3.1).
enum class NmtCommand : std::uint8_t {
  start = 0x01,
  stop = 0x02,
  enter_pre_operational = 0x80,
  reset_node = 0x81,
  reset_communication = 0x82,
};

/// Scope of an NMT reset: the whole dictionary, or 1000h to 1FFFh.
enum class ResetScope : std::uint8_t { node, communication };

}  // namespace canvoy
