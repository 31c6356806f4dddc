// Errors of a node, as its services report them and its emergency object sends them (CiA 301, 7.2.7
// and 1001h).
#pragma once

#include <array>
#include <cstdint>

namespace canvoy {

/// Bits of the error register 1001h.
namespace error_register {
inline constexpr std::uint8_t generic = 1;         ///< set while any error is present
inline constexpr std::uint8_t current = 2;         ///< class 2xxxh
inline constexpr std::uint8_t voltage = 4;         ///< class 3xxxh
inline constexpr std::uint8_t temperature = 8;     ///< class 4xxxh
inline constexpr std::uint8_t communication = 16;  ///< overrun or error state, class 81xxh
inline constexpr std::uint8_t profile = 32;        ///< as the device profile has it
inline constexpr std::uint8_t manufacturer = 128;  ///< class FFxxh
}  // namespace error_register

/// Emergency error codes that the application layer uses.
namespace emergency_code {
inline constexpr std::uint16_t no_error = 0x0000;     ///< error reset: no error is present any more
inline constexpr std::uint16_t data_set = 0x6300;     ///< here: stored parameters were refused
inline constexpr std::uint16_t can_overrun = 0x8110;  ///< objects were lost
inline constexpr std::uint16_t error_passive = 0x8120;      ///< the controller is error-passive
inline constexpr std::uint16_t heartbeat = 0x8130;          ///< life guard or heartbeat error
inline constexpr std::uint16_t bus_off_recovered = 0x8140;  ///< the controller was bus-off
/// Another node sends on a CAN-ID of this node.
inline constexpr std::uint16_t cob_id_collision = 0x8150;
inline constexpr std::uint16_t protocol = 0x8200;       ///< here: a value of an RPDO was refused
inline constexpr std::uint16_t pdo_too_short = 0x8210;  ///< not processed: fewer bytes than mapped
inline constexpr std::uint16_t pdo_too_long = 0x8220;   ///< more bytes than mapped
inline constexpr std::uint16_t mpdo_destination = 0x8230;  ///< no such object
inline constexpr std::uint16_t sync_length = 0x8240;       ///< SYNC with an unexpected length
inline constexpr std::uint16_t rpdo_time_out = 0x8250;     ///< event timer of an RPDO has expired
}  // namespace emergency_code

/// An error that comes and goes. Two errors are equal if code and instance agree.
struct Error {
  std::uint16_t code = emergency_code::no_error;  ///< emergency error code
  std::uint16_t instance = 0;      ///< distinguishes errors of one kind: a node-ID, a PDO number
  std::uint8_t register_bits = 0;  ///< further bits in 1001h, beside the one that each error sets
  std::array<std::uint8_t, 5> info = {};  ///< manufacturer-specific field of the emergency object
};

/// Error: another node sends with this CAN-ID of the node, which is in the first two bytes of the
/// manufacturer-specific field.
constexpr Error cob_id_collision(std::uint16_t can_id) {
  return {.code = emergency_code::cob_id_collision,
          .register_bits = error_register::communication,
          .info = {static_cast<std::uint8_t>(can_id), static_cast<std::uint8_t>(can_id >> 8)}};
}

}  // namespace canvoy
