#include "canvoy/worlds/taxi/tampering.hpp"

#include <algorithm>

namespace canvoy::taxi {

namespace {

/// Node-ID of no device here: a foreign device without one of its own takes it.
constexpr NodeId stranger_id = 12;
constexpr std::uint32_t default_request = 0x600;
constexpr Duration writing_period = 1s;
/// 20 m of the wheels of the simulated cars.
constexpr std::uint16_t count_step = 480;

/// An expedited download of sub-index 00h, of `bytes` bytes (CiA 301, 7.2.4.3.3).
Frame download(std::uint32_t can_id, std::uint16_t index, unsigned bytes, std::uint32_t value) {
  Frame frame{.id = can_id, .length = Frame::length_max};
  frame.data = {static_cast<std::uint8_t>(0x23 | (4 - bytes) << 2),
                static_cast<std::uint8_t>(index),
                static_cast<std::uint8_t>(index >> 8),
                0,
                static_cast<std::uint8_t>(value),
                static_cast<std::uint8_t>(value >> 8),
                static_cast<std::uint8_t>(value >> 16),
                static_cast<std::uint8_t>(value >> 24)};
  return frame;
}

bool finds(const cia447::AuditEntry& entry, FaultKind kind) {
  using cia447::AuditEvent;
  switch (kind) {
    case FaultKind::stranger_writes:
      return entry.what == AuditEvent::write_refused;
    case FaultKind::extra_pulses:
      return entry.what == AuditEvent::error &&
             entry.detail == static_cast<std::uint32_t>(cia447::TaximeterError::extra_pulses);
    case FaultKind::seal_opened:
      return entry.what == AuditEvent::seal_opened;
    case FaultKind::clock_drift:
      return entry.what == AuditEvent::clock_step || entry.what == AuditEvent::clock_refused;
    default:
      return false;
  }
}

}  // namespace

void TamperWatch::recorded(const cia447::AuditEntry& entry) {
  for (Act& act : acts_) act.is_found |= finds(entry, act.kind);
}

void TamperWatch::passengers_see() {
  for (Act& act : acts_) act.is_found = true;
}

std::uint64_t TamperWatch::judged(Time now) const {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      acts_, [now](const Act& act) { return act.is_found || now - act.begin > found_within; }));
}

std::uint64_t TamperWatch::missed(Time now) const {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      acts_, [now](const Act& act) { return !act.is_found && now - act.begin > found_within; }));
}

void Tampering::attach_stranger() {
  if (stranger_ == no_controller) stranger_ = car_.bus().bus().attach({});
}

void Tampering::set(FaultKind kind, bool is_present) {
  switch (kind) {
    case FaultKind::stranger_writes: {
      const bool begins = is_present && !writes_;
      writes_ = is_present;
      if (begins) write_on(car_.bus().world().now());
      return;
    }
    case FaultKind::extra_pulses:
      return car_.add_pulses(is_present);
    case FaultKind::seal_opened:
      return car_.meter().open_seal(is_present);
    case FaultKind::wrong_k:
      return car_.change_wheels(is_present);
    case FaultKind::clock_drift:
      return car_.let_clock_drift(is_present);
    default:
      return;
  }
}

void Tampering::write_on(Time now) {
  if (!writes_) return;
  write(cia447::sdo_request(stranger_id, taximeter_id));
  write(default_request + taximeter_id);
  car_.bus().world().at(now + writing_period, [this](Time then) { write_on(then); });
}

/// Writes pulses, an early overrun, another wheel, and half past eleven at night.
void Tampering::write(std::uint32_t can_id) {
  constexpr std::uint32_t valid = 0xFD'0000;
  count_ = static_cast<std::uint16_t>(count_ + count_step);
  SimulatedBus& bus = car_.bus().bus();
  bus.send(stranger_,
           download(can_id, cia447::wheel_pulse_counter_object.index, 3, valid | count_));
  bus.send(stranger_, download(can_id, cia447::wheel_pulse_counter_overrun_value_object.index, 3,
                               valid | 200));
  bus.send(stranger_, download(can_id, cia447::wheel_signal_source_object.index, 1, 0));
  bus.send(stranger_, download(can_id, cia447::rtc_time_object.index, 4, 0x1E17));
}

}  // namespace canvoy::taxi
