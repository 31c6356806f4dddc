// How a car drive controller leads its drive to what it aims at: the state machine of the drive,
// the handshake of set-points, the approach in profile velocity mode, homing, and the modes of
// operation (CiA 417-4, 4.11.1 to 4.11.3).
#include <cmath>

#include "canvoy/devices/cia417/drive/car_drive_controller.hpp"
#include "canvoy/devices/cia417/lift_number.hpp"

namespace canvoy::cia417 {

namespace {

using cia402::DriveMode;

constexpr unsigned shutdown_word = 0x0006;
constexpr unsigned switch_on_word = 0x0007;
constexpr unsigned enable_word = 0x000F;
constexpr unsigned immediately = enable_word | control_bit::change_immediately;
constexpr unsigned quick_stop_word = 0x0002;
/// Between the target and the edge that makes it a set-point: two frames.
constexpr Duration set_point_gap = 5ms;

}  // namespace

DriveMode CarDriveController::wanted_mode() const {
  if (aim_ == Aim::home) return DriveMode::homing;
  return aim_ == Aim::run ? DriveMode::profile_velocity : settings_.trip_mode;
}

void CarDriveController::command(unsigned word) {
  if (controlword_.raw() != word) told_at_ = node_.now();
  controlword_ = word;
}

/// One step further towards the aim, by what the drive says now.
void CarDriveController::pursue() {
  if (!drive_is_known_ || node_.state() != NmtState::operational) return;
  const std::uint16_t status = statusword_.raw();
  const DriveState state = cia402::drive_state(status);
  if (is_stopping_fast_) {
    is_stopping_fast_ = is_powered(state);
    return command(quick_stop_word);
  }
  switch (state) {
    case DriveState::switch_on_disabled:
      if (aim_ != Aim::none) command(shutdown_word);
      break;
    case DriveState::ready_to_switch_on:
      if (aim_ != Aim::none && has_mode()) command(switch_on_word);
      break;
    case DriveState::switched_on:
      if (aim_ != Aim::none && has_mode()) command(enable_word);
      break;
    case DriveState::operation_enabled:
      pursue_enabled(status);
      break;
    case DriveState::fault:
      recover();
      break;
    default:  // the drive is under way by itself
      break;
  }
}

void CarDriveController::pursue_enabled(std::uint16_t status) {
  if (aim_ == Aim::none || mode() != wanted_mode()) return rest();
  // Taken back on its way to stand: it has to get there first.
  if ((controlword_.raw() & 0x000F) == switch_on_word) return;
  if (aim_ == Aim::home) return lead_homing(status);
  if (aim_ == Aim::run) return lead_run();
  if (mode() == DriveMode::profile_velocity) return lead_approach();
  lead_trip(status);
}

/// Slows down and disables operation: the brake holds the car.
void CarDriveController::rest() {
  target_velocity_ = 0;
  command(switch_on_word);
}

/// By the handshake of bits 4 and 12. A target that the drive cannot stop at is not acknowledged:
/// it goes to the one before, and is told again from there.
void CarDriveController::lead_trip(std::uint16_t status) {
  const bool is_acknowledged = (status & status_bit::set_point_acknowledge) != 0;
  const bool is_at_target = (status & status_bit::target_reached) != 0;
  switch (step_) {
    case Step::wanted:
      if (is_acknowledged) return command(immediately);
      // Two PDOs bring the controlword, one of them the target: it is there before the edge.
      target_position_ = std::lround(wanted_position_ + drift_);
      command(immediately);
      step_ = Step::placed;
      node_.timers().arm(timer_, node_.now() + set_point_gap);
      break;
    case Step::placed:
      break;
    case Step::sent:
      if (!is_acknowledged) break;
      step_ = Step::taken;
      command(immediately);
      break;
    case Step::taken:
      if (!is_at_target) break;
      is_at_target_ = true;
      reach(true);
      break;
  }
}

void CarDriveController::send_set_point() {
  step_ = Step::sent;
  command(immediately | control_bit::new_set_point);
}

/// The edge of bit 4 takes a frame in which it is 0.
void CarDriveController::repeat_set_point() {
  step_ = Step::wanted;
  command(immediately);
}

/// In profile velocity mode: at full velocity, then at that of the end, then none (4.11).
void CarDriveController::lead_approach() {
  const double left = wanted_position_ - position();
  const double sign = left < 0 ? -1 : 1;
  const double creep = settings_.creep_velocity;
  const double late = std::chrono::duration<double>(settings_.latency).count();
  const MotionState at = motion();
  const double now = std::abs(at.velocity);
  const MotionState moving = {0, now, std::abs(at.acceleration)};
  const double to_creep = MotionProfile::to_velocity(moving, creep, settings_.ramps).end().position;
  const double to_stop = MotionProfile::stopping_distance({0, creep, 0}, settings_.ramps);
  // Once slow it stays slow, and once stopping it stops.
  if (step_ == Step::wanted && std::abs(left) <= to_creep + to_stop + now * late) {
    step_ = Step::sent;
  }
  if (std::abs(left) <= to_stop + creep * late) step_ = Step::taken;
  double wanted = settings_.ramps.velocity;
  if (step_ == Step::sent) wanted = creep;
  if (step_ == Step::taken) wanted = 0;
  target_velocity_ = std::lround(sign * wanted);
  command(enable_word);
  constexpr unsigned standing = status_bit::target_reached | status_bit::speed_zero;
  const bool stands = (statusword_.raw() & standing) == standing;
  if (wanted == 0 && stands) reach(true);
}

void CarDriveController::lead_run() {
  target_velocity_ = std::lround(wanted_velocity_);
  command(enable_word);
}

void CarDriveController::lead_homing(std::uint16_t status) {
  command(enable_word | control_bit::new_set_point);
  if ((status & status_bit::homing_attained) != 0 && step_ == Step::taken) {
    has_homed_ = true;
    drift_ = 0;
  }
  const bool has_ended = (status & (status_bit::homing_attained | status_bit::homing_error)) != 0;
  if (step_ == Step::taken && has_ended) return reach(has_homed_);
  if (!has_ended) step_ = Step::taken;
}

void CarDriveController::reach(bool is_reached) {
  is_reached_ = is_reached && aim_ == Aim::trip;
  aim_ = Aim::none;
  rest();
}

void CarDriveController::recover() {
  aim_ = Aim::none;
  is_at_target_ = false;
  const unsigned word = controlword_.raw();
  if (word != 0 && word != control_bit::fault_reset) reset_at_ = node_.now();
  const bool is_due = node_.now() - reset_at_ >= settings_.fault_reset_period;
  if (settings_.fault_reset_period > Duration{} && is_due) return reset_fault();
  command(0);
}

/// Without a client the mode is that which the drive has by default.
DriveMode CarDriveController::mode() const {
  return services_.client == nullptr ? settings_.trip_mode
                                     : mode_.value_or(static_cast<DriveMode>(0));
}

/// Whether the drive has the mode that the aim needs; otherwise that is on its way.
bool CarDriveController::has_mode() {
  if (mode() == wanted_mode()) return true;
  if (services_.client == nullptr) {
    aim_ = Aim::none;
  } else if (!is_writing_mode_) {
    write_mode();
  }
  return false;
}

void CarDriveController::write_mode() {
  mode_byte_[0] = static_cast<std::uint8_t>(wanted_mode());
  const unsigned lift = present_lift(node_.dictionary(), settings_.lift);
  const std::uint16_t index = in_lift(lift, modes_of_operation).index();
  is_writing_mode_ =
      services_.client->download(settings_.drive, index, 0, mode_byte_,
                                 SdoClient::Done::to<&CarDriveController::mode_written>(*this)) ==
      AbortCode::none;
}

void CarDriveController::mode_written(SdoClient::Outcome outcome) {
  is_writing_mode_ = false;
  if (outcome) mode_ = static_cast<DriveMode>(mode_byte_[0]);
  pursue();
}

}  // namespace canvoy::cia417
