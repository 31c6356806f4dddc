#include "canvoy/worlds/lift/car_follower.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia417/drive/drive_state.hpp"

namespace canvoy::lift {

namespace {

// The pre-defined PDOs of lift 1.
constexpr std::uint32_t position_control = 0x180;
constexpr std::uint32_t position_status = 0x181;
constexpr std::uint32_t velocity_status = 0x185;
constexpr std::uint8_t pdo_length = 6;
constexpr std::uint32_t drive_heartbeat = 0x702;
/// Greatest error of the sum of velocities at the end of a trip.
constexpr double error_max_mm = 100;
/// A drive that reports up to this velocity stands, as for CarWatch: 1 mm/s is what its object
/// resolves.
constexpr double standing_mm_s = 1;

}  // namespace

bool CarFollower::hear(const Frame& frame) {
  if (frame.is_remote() || frame.is_extended()) return false;
  if (frame.id == drive_heartbeat) heard_at_ = clock_();
  if (frame.length != pdo_length || frame.id < shift_) return false;
  const std::uint32_t id = frame.id - shift_;
  if (id == position_control) hear_target(frame);
  if (id != position_status && id != velocity_status) return id == position_control;
  heard_at_ = clock_();
  if (id == velocity_status) hear_velocity(load<std::int32_t>(frame.data.data() + 2));
  hear_status(load<std::uint16_t>(frame.data.data()));
  return true;
}

/// A target counts from the edge that sets it.
void CarFollower::hear_target(const Frame& frame) {
  const auto word = load<std::uint16_t>(frame.data.data());
  const bool is_relative = (word & cia417::control_bit::relative) != 0;
  if ((word & cia417::control_bit::new_set_point) == 0 || is_relative) return;
  target_ = load<std::int32_t>(frame.data.data() + 2);
  has_target_ = true;
  was_moving_ = moves();
}

/// A car that was on its way, and stands near its target, is at the target: the difference is the
/// jitter of frames.
void CarFollower::hear_status(std::uint16_t status) {
  if (moves()) was_moving_ = has_target_;
  const bool is_there = (status & cia417::status_bit::target_reached) != 0;
  const bool obeys = cia402::drive_state(status) == cia402::DriveState::operation_enabled;
  const bool has_come = was_moving_ && obeys;
  if (!has_target_ || moves() || (!is_there && !has_come)) return;
  if (std::abs(position_ - target_) > error_max_mm) return;
  position_ = target_;
  has_target_ = was_moving_ = false;
}

bool CarFollower::moves() const {
  return std::abs(velocity_) > standing_mm_s;
}

/// Integrates from one velocity to the next, linearly where they follow closely.
void CarFollower::hear_velocity(double velocity) {
  constexpr double close_s = 0.1;
  const double past = std::chrono::duration<double>(clock_() - measured_at_).count();
  const bool is_close = past > 0 && past <= close_s;
  position_ = position_mm() + (is_close ? (velocity - velocity_) / 2 * past : 0);
  acceleration_ = is_close ? (velocity - velocity_) / past : 0;
  velocity_ = velocity;
  measured_at_ = clock_();
}

double CarFollower::position_mm() const {
  // After its last message, a drive may have gone on until its silence is detected.
  const Time until = is_silent() ? heard_at_ : clock_();
  const Duration past = std::max(until - measured_at_, Duration{});
  return position_ + velocity_ * std::chrono::duration<double>(past).count();
}

cia417::CarPositionHardware CarFollower::position_hardware() {
  return {.sense = callback<&CarFollower::sense>(*this)};
}

/// Without acceleration: for a real drive that would be the jitter of frames.
cia417::MotionState CarFollower::motion() {
  return {position_mm() / 1000, velocity_mm_s() / 1000, 0};
}

cia417::PositionReadings CarFollower::sense(unsigned) {
  return {.position_millimetre = position_mm(),
          .velocity_millimetre_per_second = velocity_mm_s(),
          .acceleration_millimetre_per_second_squared = velocity_mm_s() == 0 ? 0 : acceleration_};
}

}  // namespace canvoy::lift
