// The common part of the communication records of RPDOs and TPDOs (CiA 301, 7.5.2.35 and 7.5.2.37).
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/pdo/pdo_mapping.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// Sub-indices of 1400h to 15FFh and 1800h to 19FFh.
namespace pdo_sub {
inline constexpr std::uint8_t cob_id = 1;             ///< COB-ID used by the PDO
inline constexpr std::uint8_t transmission_type = 2;  ///< 0 to 240, 252 to 255
inline constexpr std::uint8_t inhibit_time = 3;       ///< in 100 us
inline constexpr std::uint8_t event_timer = 5;        ///< in ms
inline constexpr std::uint8_t sync_start = 6;  ///< counter of the SYNC that begins a cycle; 0: any
}  // namespace pdo_sub

namespace transmission_type {
inline constexpr std::uint8_t acyclic = 0;               ///< at the SYNC after an event
inline constexpr std::uint8_t cyclic_max = 240;          ///< 1 to here: at every n-th SYNC
inline constexpr std::uint8_t remote_synchronous = 252;  ///< sampled at SYNC, sent on request
inline constexpr std::uint8_t remote = 253;              ///< sampled and sent on request
inline constexpr std::uint8_t event_manufacturer = 254;  ///< events as the manufacturer defines
inline constexpr std::uint8_t event_profile = 255;       ///< events as the profile defines
}  // namespace transmission_type

/// True for types that need no SYNC and no request: 254 and 255.
constexpr bool is_event_driven(std::uint8_t type) {
  return type >= transmission_type::event_manufacturer;
}
/// True for types of which the values are taken over at a SYNC: 0 to 240.
constexpr bool is_synchronous(std::uint8_t type) {
  return type <= transmission_type::cyclic_max;
}
/// True for types that no PDO may have: 241 to 251, and for an RPDO also 252 and 253. Larger
/// numbers than 255 are not reserved, but of another type.
constexpr bool is_reserved_type(std::uint32_t type, PdoDirection direction) {
  const std::uint8_t next = direction == PdoDirection::receive
                                ? transmission_type::event_manufacturer
                                : transmission_type::remote_synchronous;
  return type > transmission_type::cyclic_max && type < next;
}

/// True if a PDO can work with this COB-ID: the value in the dictionary at reset may be unchecked.
constexpr bool is_usable(CobId cob_id) {
  return cob_id.valid() && has_free_id(cob_id);
}

/// Checks whether a PDO with COB-ID `present` may get `wanted`. A valid PDO can only be made
/// invalid, and its bit 30 can change: bits 0 to 29 stay. Abort value_range for other changes, for
/// 29-bit and for restricted CAN-IDs (CiA 301, 7.5.2.35 and 7.5.2.37).
constexpr AbortCode check_pdo_cob_id(CobId present, CobId wanted) {
  const bool stays = ((present.raw ^ wanted.raw) & ~CobId::bit30) == 0 || !present.valid();
  const bool fits = wanted.valid() ? stays && is_usable(wanted) : wanted.is_base_frame();
  return fits ? AbortCode::none : AbortCode::value_range;
}

}  // namespace canvoy
