#include "canvoy/formats/trace/trace_error.hpp"

#include <array>

#include "canvoy/can/error_frame.hpp"

namespace canvoy::formats {

Frame trace_error_frame(const TraceError& error) {
  Frame frame;
  frame.id = error_class::bus_error;
  frame.flags = FrameFlags::error;
  frame.length = Frame::length_max;
  if (error.violation != 0 || error.location != 0) frame.id |= error_class::protocol;
  if (error.is_unacknowledged) frame.id |= error_class::no_acknowledgement;
  if (error.transmit_counter || error.receive_counter) frame.id |= error_class::counters;
  frame.data[error_byte::violation] = error.violation;
  frame.data[error_byte::location] = error.location;
  frame.data[error_byte::transmit_counter] = error.transmit_counter.value_or(0);
  frame.data[error_byte::receive_counter] = error.receive_counter.value_or(0);
  return frame;
}

TraceError sja1000_error(unsigned register_value) {
  constexpr std::array<std::uint8_t, 4> kinds = {error_violation::bit, error_violation::form,
                                                 error_violation::stuff, 0};
  constexpr unsigned kind_place = 6;
  constexpr unsigned reception = 0x20;
  constexpr unsigned place = 0x1F;
  TraceError error;
  error.violation = kinds.at(register_value >> kind_place & 3U);
  if ((register_value & reception) == 0) error.violation |= error_violation::on_transmission;
  error.location = static_cast<std::uint8_t>(register_value & place);
  return error;
}

std::optional<std::uint8_t> sja1000_register(const Frame& error) {
  const std::uint8_t violation = error.data[error_byte::violation];
  const std::uint8_t location = error.data[error_byte::location];
  if ((error.id & error_class::protocol) == 0 || (violation == 0 && location == 0)) return {};
  constexpr unsigned kind_place = 6;
  constexpr unsigned other = 3;
  unsigned kind = other;
  if ((violation & error_violation::stuff) != 0) kind = 2;
  if ((violation & error_violation::form) != 0) kind = 1;
  if ((violation & error_violation::bit) != 0) kind = 0;
  const unsigned reception = (violation & error_violation::on_transmission) == 0 ? 0x20 : 0;
  return static_cast<std::uint8_t>(kind << kind_place | reception | (location & 0x1FU));
}

TraceError vector_core_error(unsigned register_value) {
  enum Kind : std::uint8_t { bit, form, stuff, other, crc, ack_delimiter, unused, ack };
  constexpr unsigned kind_bits = 0x3F;
  constexpr unsigned direction_place = 6;
  const unsigned direction = register_value >> direction_place & 3U;
  TraceError error;
  switch (register_value & kind_bits) {
    case Kind::bit:
      error.violation = error_violation::bit;
      break;
    case Kind::form:
      error.violation = error_violation::form;
      break;
    case Kind::stuff:
      error.violation = error_violation::stuff;
      break;
    case Kind::crc:
      error.location = error_location::crc_sequence;
      break;
    case Kind::ack_delimiter:
      error.violation = error_violation::form;
      error.location = error_location::ack_delimiter;
      break;
    case Kind::ack:
      error.location = error_location::ack_slot;
      error.is_unacknowledged = true;
      break;
    default:
      break;
  }
  const bool is_sent = (direction & 1U) != 0;
  const bool is_of_acknowledgement = direction < 2;
  if (is_sent) error.violation |= error_violation::on_transmission;
  if (is_of_acknowledgement) error.is_unacknowledged = true;
  return error;
}

TraceError vector_error(std::uint32_t flags, unsigned register_value) {
  constexpr std::uint32_t has_sja1000 = 1;
  constexpr std::uint32_t has_core = 2;
  if ((flags & has_sja1000) != 0) return sja1000_error(register_value);
  if ((flags & has_core) != 0) return vector_core_error(register_value);
  return {};
}

}  // namespace canvoy::formats
