// Contents of an error frame, as SocketCAN numbers them: classes in its CAN-ID, details in its
// bytes. Logs of other tools are converted to these numbers.
//
//     if ((frame.id & error_class::bus_off) != 0) give_up();
//     if (frame.data[error_byte::location] == 0x19) say("in the ACK slot");
#pragma once

#include <cstddef>
#include <cstdint>

namespace canvoy {

/// Bits of the CAN-ID.
namespace error_class {
inline constexpr std::uint32_t transmit_timeout = 0x001;    ///< by the driver
inline constexpr std::uint32_t lost_arbitration = 0x002;    ///< the bit, in byte 0
inline constexpr std::uint32_t controller = 0x004;          ///< state of the controller, in byte 1
inline constexpr std::uint32_t protocol = 0x008;            ///< violation in bytes 2 and 3
inline constexpr std::uint32_t transceiver = 0x010;         ///< state of the transceiver, in byte 4
inline constexpr std::uint32_t no_acknowledgement = 0x020;  ///< no ACK of any node
inline constexpr std::uint32_t bus_off = 0x040;             ///< the controller has left the bus
inline constexpr std::uint32_t bus_error = 0x080;           ///< an error on the bus, one of many
inline constexpr std::uint32_t restarted = 0x100;           ///< the controller is back from bus-off
inline constexpr std::uint32_t counters = 0x200;            ///< error counters, in bytes 6 and 7
}  // namespace error_class

/// Bytes with details.
namespace error_byte {
inline constexpr std::size_t lost_in_bit = 0;  ///< 0: not reported
inline constexpr std::size_t controller = 1;   ///< bits
inline constexpr std::size_t violation = 2;    ///< bits of error_violation
inline constexpr std::size_t location = 3;     ///< like the ECC register of an SJA1000; 0: none
inline constexpr std::size_t transceiver = 4;  ///< CANH in the low four bits, CANL above them
inline constexpr std::size_t transmit_counter = 6;  ///< 0 to 255; with error_class::counters
inline constexpr std::size_t receive_counter = 7;   ///< 0 to 255; with error_class::counters
}  // namespace error_byte

namespace error_violation {
inline constexpr std::uint8_t bit = 0x01;    ///< a single bit
inline constexpr std::uint8_t form = 0x02;   ///< format of the frame
inline constexpr std::uint8_t stuff = 0x04;  ///< six equal bits in a row
/// Of this controller; otherwise on reception.
inline constexpr std::uint8_t on_transmission = 0x80;
}  // namespace error_violation

/// Part of a frame with the error, for logs that name only these.
namespace error_location {
inline constexpr std::uint8_t crc_sequence = 0x08;   ///< CRC
inline constexpr std::uint8_t ack_slot = 0x19;       ///< no receiver confirmed the frame
inline constexpr std::uint8_t ack_delimiter = 0x1B;  ///< after the slot
}  // namespace error_location

}  // namespace canvoy
