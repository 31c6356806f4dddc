#include "canvoy/worlds/taxi/real_devices.hpp"

#include <utility>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::taxi {

namespace {

constexpr unsigned status_pdo_of_meter = 80;
constexpr unsigned status_pdo_of_alarm = 71;
/// Offset of 6055h in PDO 17, and its length.
constexpr std::size_t wheel_count_place = 4;
constexpr std::size_t wheel_pdo_length = 7;

std::uint32_t can_id_of(NodeId node, unsigned pdo_number, const cia447::PdoOffsets& offsets) {
  for (std::size_t i = 0; node != 0 && i < cia447::predefined.size(); ++i) {
    if (cia447::predefined[i].number == pdo_number) return cia447::pdo_base(node) + offsets[i];
  }
  return 0;
}

/// A field of the object with the first byte `bytes[0]`, within that byte.
template <class Handle>
unsigned field_of(std::uint8_t byte, const Handle& handle) {
  const cia447::FieldPlace place = cia447::place_of(handle);
  return byte >> place.first_bit & ((1U << place.bits) - 1);
}

}  // namespace

RealDevices::RealDevices(const Wanted& wanted, const cia447::PdoOffsets& offsets,
                         std::uint16_t pulse_counter_max, Hands hands)
    : hands_(std::move(hands)),
      meter_id_(can_id_of(wanted.meter, status_pdo_of_meter, offsets)),
      alarm_id_(can_id_of(wanted.alarm, status_pdo_of_alarm, offsets)),
      wheels_id_(can_id_of(wanted.gateway, cia447::wheel_pdo_number, offsets)),
      counts_(pulse_counter_max + 1U) {}

void RealDevices::receive(const Frame& frame, Time) {
  if (frame.is_remote() || frame.is_extended() || frame.id == 0 || frame.length == 0) return;
  if (frame.id == meter_id_) {
    hands_.meter(static_cast<cia447::Taximeter>(field_of(frame.data[0], cia447::taximeter_status)));
  } else if (frame.id == alarm_id_) {
    const auto key = static_cast<cia447::Signal>(
        field_of(frame.data[0], cia447::taxi_alarm_system_status_silent_activated));
    const bool was_pressed = std::exchange(is_pressed_, key == cia447::Signal::yes);
    if (is_pressed_ && !was_pressed) hands_.alarm();
  } else if (frame.id == wheels_id_) {
    hear_wheels(frame);
  }
}

/// A counter that restarts has no information about the time before.
void RealDevices::hear_wheels(const Frame& frame) {
  if (frame.length < wheel_pdo_length) return;
  const auto count = load<std::uint16_t>(frame.data.data() + wheel_count_place);
  const auto valid = static_cast<cia447::Signal>(frame.data[wheel_count_place + 2] & 3U);
  if (valid != cia447::Signal::yes) return count_.reset();
  const std::optional<std::uint16_t> before = std::exchange(count_, count);
  if (before && count < counts_) hands_.wheels((count + counts_ - *before) % counts_);
}

}  // namespace canvoy::taxi
