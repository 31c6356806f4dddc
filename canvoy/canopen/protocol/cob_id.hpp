// CAN-IDs and COB-IDs: the pre-defined connection set and the restricted CAN-IDs (CiA 301, 7.3.3
// and 7.3.5).
#pragma once

#include <cstdint>

namespace canvoy {

/// Node-ID: 1 to 127; 0 addresses all nodes in an NMT command, FFh is a node without one (CiA 305).
using NodeId = std::uint8_t;
inline constexpr NodeId node_id_min = 1;              ///< the lowest
inline constexpr NodeId node_id_max = 127;            ///< the highest
inline constexpr NodeId node_id_unconfigured = 0xFF;  ///< waits for a node-ID by LSS

/// True for 1 to 127.
constexpr bool is_node_id(unsigned id) {
  return id >= node_id_min && id <= node_id_max;
}

/// Function codes of the pre-defined connection set; with the node-ID added, where one belongs to
/// it, a CAN-ID.
namespace can_id {
inline constexpr std::uint16_t nmt = 0x000;   ///< NMT commands, to all nodes
inline constexpr std::uint16_t sync = 0x080;  ///< default of 1005h
/// Default of 1014h: plus the node-ID, 081h to 0FFh.
inline constexpr std::uint16_t emergency = 0x080;
inline constexpr std::uint16_t time = 0x100;   ///< default of 1012h
inline constexpr std::uint16_t tpdo1 = 0x180;  ///< TPDO 1; numbers 2 to 4 follow in steps of 100h
inline constexpr std::uint16_t rpdo1 = 0x200;  ///< RPDO 1; numbers 2 to 4 follow in steps of 100h
inline constexpr std::uint16_t sdo_response = 0x580;   ///< server to client
inline constexpr std::uint16_t sdo_request = 0x600;    ///< client to server
inline constexpr std::uint16_t error_control = 0x700;  ///< boot-up, heartbeat and node guarding
inline constexpr std::uint16_t lss_response = 0x7E4;   ///< LSS slave to master
inline constexpr std::uint16_t lss_request = 0x7E5;    ///< LSS master to slave
}  // namespace can_id

/// A COB-ID as in a communication object: a CAN-ID and three bits, with a meaning that depends on
/// the object.
struct CobId {
  static constexpr std::uint32_t bit31 = 0x8000'0000;  ///< PDO, SDO, EMCY: invalid; TIME: consumer
  /// TPDO: no RTR; SYNC, TIME: producer; SDO: dynamic.
  static constexpr std::uint32_t bit30 = 0x4000'0000;
  static constexpr std::uint32_t extended = 0x2000'0000;     ///< a 29-bit CAN-ID
  static constexpr std::uint32_t can_id_mask = 0x1FFF'FFFF;  ///< bits 0 to 28

  std::uint32_t raw = bit31;  ///< as in the dictionary

  /// False if bit 31 is set: the PDO, SDO or EMCY does not exist. For TIME and SYNC it means
  /// something else.
  constexpr bool valid() const { return (raw & bit31) == 0; }
  /// CAN-ID, without the upper three bits; 0 to 1FFF FFFFh.
  constexpr std::uint32_t can_id() const { return raw & can_id_mask; }
  /// True if the CAN-ID has 11 bits, the only kind that these nodes use, as CiA 301 allows.
  constexpr bool is_base_frame() const { return (raw & extended) == 0 && can_id() <= 0x7FF; }
};

namespace detail {

struct IdRange {
  std::uint16_t first;
  std::uint16_t last;
};
/// All from 701h on are restricted.
inline constexpr IdRange restricted_ids[] = {{0x000, 0x07F}, {0x101, 0x17F}, {0x581, 0x5FF},
                                             {0x601, 0x67F}, {0x6E0, 0x6FF}, {0x701, 0xFFFF}};

}  // namespace detail

/// True for CAN-IDs that no configurable communication object may use. 180h is allowed, since CiA
/// 417 uses it.
constexpr bool is_restricted(std::uint32_t id) {
  for (const detail::IdRange& range : detail::restricted_ids) {
    if (id <= range.last) return id >= range.first;
  }
  return true;
}

/// True for an 11-bit CAN-ID that a configurable communication object may use. Not inlined: one
/// copy for all callers.
[[gnu::noinline]] constexpr bool has_free_id(CobId cob_id) {
  return cob_id.is_base_frame() && !is_restricted(cob_id.can_id());
}

}  // namespace canvoy
