// Error frames of logs that tell of them in their own way, as SocketCAN would have told.
//
//     frame.frame = trace_error_frame(sja1000_error(0xA2));  // a stuff error in ID bits 28 to 21
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/frame.hpp"

namespace canvoy::formats {

/// What a log tells of an error on the bus. Numbers are those of canvoy/can/error_frame.hpp.
struct TraceError {
  std::uint8_t violation = 0;
  std::uint8_t location = 0;
  bool is_unacknowledged = false;
  std::optional<std::uint8_t> transmit_counter = {};
  std::optional<std::uint8_t> receive_counter = {};
};

/// A bus error; with nothing told, no more than that.
Frame trace_error_frame(const TraceError& error = {});

/// Of the ECC register of an SJA1000: two bits of what it is, one of the direction, five of the
/// place.
TraceError sja1000_error(unsigned register_value);
/// The register that says the same; none where the error frame names neither kind nor place.
std::optional<std::uint8_t> sja1000_register(const Frame& error);
/// Of the error register of Vector's own controller: six bits of what it is, two of the direction,
/// and whether nobody has acknowledged.
TraceError vector_core_error(unsigned register_value);
/// Of the registers in logs of Vector, by the flags that say which one it is; a log without either
/// tells nothing.
TraceError vector_error(std::uint32_t flags, unsigned register_value);

}  // namespace canvoy::formats
