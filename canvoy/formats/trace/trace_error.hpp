// Converts error frames of logs with an encoding of their own to those of SocketCAN.
//
//     frame.frame = trace_error_frame(sja1000_error(0xA2));  // a stuff error in ID bits 28 to 21
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"

namespace canvoy::formats {

/// Details of a bus error in a log. Numbers are those of canvoy/can/error_frame.hpp.
struct TraceError {
  std::uint8_t violation = 0;                         ///< bits of error_violation; 0: not known
  std::uint8_t location = 0;                          ///< like an ECC register; 0: not known
  bool is_unacknowledged = false;                     ///< no node acknowledged the frame
  std::optional<std::uint8_t> transmit_counter = {};  ///< 0 to 255, if the log has it
  std::optional<std::uint8_t> receive_counter = {};   ///< 0 to 255, if the log has it
};

/// The error frame; without details, a plain bus error.
Frame trace_error_frame(const TraceError& error = {});

/// Decodes the ECC register of an SJA1000: two bits for the kind, one for the direction, five for
/// the position.
TraceError sja1000_error(unsigned register_value);
/// The ECC register for an error frame; nothing if the error frame has neither kind nor position.
std::optional<std::uint8_t> sja1000_register(const Frame& error);
/// Decodes the error register of Vector's controller: six bits for the kind, two for the direction,
/// and whether the frame was not acknowledged.
TraceError vector_core_error(unsigned register_value);
/// Decodes the registers in Vector logs; `flags` gives which register it is. Without one, the
/// result has no details.
TraceError vector_error(std::uint32_t flags, unsigned register_value);

}  // namespace canvoy::formats
