#include "canvoy/devices/cia417/drive/car_drive_controller.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/devices/cia417/lift_number.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/profiles/reactions.hpp"

namespace canvoy::cia417 {

namespace {

using cia402::DriveMode;

/// In motion, in units of the drive: more than an encoder jitters.
constexpr double moving_velocity = 20;
constexpr double moving_distance = 5;
/// Past its target: more than a car is wrong by that is seen late.
constexpr double overshoot_distance = 300;
/// It may be as much farther: a car that stops short of a target says how far it is.
constexpr double overshoot_more = 1000;

/// The number of the RPDO that brings what `row` of the pre-defined ones does.
constexpr std::uint16_t rpdo_of(unsigned lift, std::uint16_t rpdo) {
  return number_of_rpdo(rpdo + (lift - 1) * lift_pdo_pitch);
}
constexpr std::uint16_t control_rpdo = 0x1504;
constexpr std::uint16_t status_rpdos[] = {0x1505, 0x1507, 0x1506};

}  // namespace

constexpr HookCalls CarDriveController::hook_calls[] = {
    after_write<&CarDriveController::status_received, statusword_object>,
    after_write<&CarDriveController::velocity_received, velocity_actual_value_object>,
    after_write<&CarDriveController::position_received, position_value>};
constexpr ServiceCalls CarDriveController::service_calls = {
    .reset = method<&CarDriveController::reset>,
    .state_entered = method<&CarDriveController::state_entered>,
    .error_changed = method<&CarDriveController::error_changed>,
    .hooks = hook_calls};

CarDriveController::CarDriveController(Node& node, const CarDriveControllerServices& services,
                                       const CarDriveControllerSettings& settings)
    : node_(node),
      services_(services),
      settings_(settings),
      controlword_(node.dictionary(), settings.lift),
      statusword_(node.dictionary(), settings.lift),
      target_position_(node.dictionary(), settings.lift),
      target_velocity_(node.dictionary(), settings.lift),
      velocity_(node.dictionary(), settings.lift),
      position_(node.dictionary(), settings.lift),
      timer_(Callback<void(Time)>::to<&CarDriveController::expired>(*this)) {
  node.attach(service_);
}

void CarDriveController::reset(ResetScope) {
  aim_ = Aim::none;
  is_reached_ = is_writing_mode_ = is_stopping_fast_ = has_homed_ = false;
  drive_is_known_ = position_is_known_ = false;
  drive_is_lost_ = position_is_lost_ = position_stands_ = is_held_ = false;
  mode_.reset();
  controlword_ = 0;
  is_at_target_ = false;
  node_.timers().disarm(timer_);
}

void CarDriveController::state_entered(NmtState state) {
  if (state != NmtState::operational) {
    aim_ = Aim::none;
    controlword_ = 0;
    return;
  }
  ask();
  node_.timers().arm(timer_, node_.now() + settings_.answer_time);
}

void CarDriveController::error_changed(const Error& error, bool present) {
  if (error.code != canvoy::emergency_code::heartbeat) return;
  if (error.instance == settings_.drive) {
    drive_is_lost_ = present;
    forget_drive();
    if (present) controlword_ = 0;
  }
  if (error.instance == settings_.position_unit) {
    position_is_lost_ = present;
    position_is_known_ = false;
    if (present) fast_stop();
  }
  if (!present) ask();
  tell();
}

void CarDriveController::heard(NodeId node, RemoteState state) {
  if (node != settings_.drive && node != settings_.position_unit) return;
  if (state == RemoteState::operational) {
    for (const std::uint16_t rpdo : status_rpdos) request(rpdo);
  }
  if (state != RemoteState::boot_up) return;
  if (node == settings_.drive) {
    forget_drive();
    controlword_ = 0;
  } else {
    position_is_known_ = false;
    fast_stop();
  }
  tell();
}

/// What it said before counts no longer: neither that it moves, nor that the position does not.
void CarDriveController::forget_drive() {
  drive_is_known_ = false;
  aim_ = Aim::none;
  mode_.reset();
  position_stands_ = false;
  velocity_ = 0;
}

/// What is not known yet; the answers are ordinary PDOs.
void CarDriveController::ask() {
  for (const std::uint16_t rpdo : status_rpdos) {
    const bool is_known = rpdo == status_rpdos[2] ? position_is_known_ : drive_is_known_;
    if (!is_known) request(rpdo);
  }
}

void CarDriveController::request(std::uint16_t rpdo) {
  if (services_.rpdos == nullptr || node_.state() != NmtState::operational) return;
  const std::uint16_t number = rpdo_of(settings_.lift, rpdo);
  if (services_.rpdos->has(number)) services_.rpdos->request(number);
}

void CarDriveController::status_received() {
  drive_is_known_ = !drive_is_lost_;
  drive_told();
}

void CarDriveController::velocity_received() {
  acceleration_ = velocity() - last_velocity_;
  last_velocity_ = velocity();
  drive_told();
}

void CarDriveController::drive_told() {
  // The time before a start does not count.
  if (std::abs(velocity()) <= moving_velocity) watch_anew();
  watch_overshoot();
  pursue();
  tell();
}

void CarDriveController::position_received() {
  position_is_known_ = !position_is_lost_;
  if (std::abs(position() - watched_position_) > moving_distance) position_stands_ = false;
  watch_overshoot();
  if (aim_ == Aim::trip && settings_.trip_mode == DriveMode::profile_velocity) pursue();
  tell();
}

// Commands.

void CarDriveController::travel_to(std::int32_t position_micrometre) {
  wanted_position_ = static_cast<double>(position_micrometre) / settings_.drive_unit_micrometre;
  goes_up_ = wanted_position_ > nearest_stop();
  take_aim(Aim::trip);
}

void CarDriveController::run(std::int32_t velocity_micrometre_per_second) {
  if (velocity_micrometre_per_second == 0) return stop();
  wanted_velocity_ =
      static_cast<double>(velocity_micrometre_per_second) / settings_.drive_unit_micrometre;
  take_aim(Aim::run);
}

void CarDriveController::home() {
  has_homed_ = false;
  take_aim(Aim::home);
}

void CarDriveController::stop() {
  take_aim(Aim::none);
}

void CarDriveController::fast_stop() {
  is_stopping_fast_ = true;
  take_aim(Aim::none);
}

/// Less than an encoder jitters is none.
void CarDriveController::learn_drift() {
  if (!is_at_target_ || !position_is_known_) return;
  const double drift = target_position_.raw() - position();
  if (std::abs(drift - drift_) > moving_distance) drift_ = drift;
}

void CarDriveController::take_aim(Aim aim) {
  if (aim == Aim::trip && status().standing) learn_drift();
  if (aim != Aim::none) is_at_target_ = false;
  const bool is_available = drive_is_known_ && node_.state() == NmtState::operational;
  aim_ = is_available && !has_fault() && !is_held_ ? aim : Aim::none;
  step_ = Step::wanted;
  is_reached_ = false;
  stands_since_ = node_.now();
  pursue();
  tell();
}

void CarDriveController::begin_anew() {
  aim_ = Aim::none;
  is_at_target_ = false;
  drive_is_known_ = position_is_known_ = position_stands_ = is_stopping_fast_ = false;
  mode_.reset();
  controlword_ = 0;
  velocity_ = 0;
  ask();
  tell();
}

AbortCode CarDriveController::refuses_lift_number() {
  const bool is_under_way = aim_ != Aim::none || (drive_is_known_ && !status().standing);
  return is_under_way ? AbortCode::device_state : AbortCode::none;
}

void CarDriveController::hold(bool is_held) {
  if (is_held_ == is_held) return;
  is_held_ = is_held;
  if (is_held) return fast_stop();
  tell();
}

/// By the edge of bit 7.
void CarDriveController::reset_fault() {
  controlword_ = 0;
  command(control_bit::fault_reset);
  reset_at_ = node_.now();
}

void CarDriveController::expired(Time now) {
  node_.timers().arm(timer_, now + settings_.answer_time / 2);
  // Always, or a car that just begins to move has not moved for longer than it should.
  watch_position(now);
  watch_standstill(now);
  if (step_ == Step::placed && aim_ == Aim::trip) return send_set_point();
  if (!drive_is_known_ || !position_is_known_) ask();
  const bool is_late = now - told_at_ >= settings_.answer_time;
  const bool by_position = aim_ == Aim::trip && mode() == DriveMode::profile_position;
  if (is_late && by_position && step_ == Step::sent) return repeat_set_point();
  pursue();
  if (is_late) tell_again(now);
  tell();
}

/// Where the drive did not do what it was told: a frame was lost, or it was held.
void CarDriveController::tell_again(Time now) {
  const bool is_done = is_powered(drive_state()) == (aim_ != Aim::none);
  if (is_done || services_.tpdos == nullptr || !drive_is_known_) return;
  told_at_ = now;
  const std::uint16_t number = rpdo_of(settings_.lift, control_rpdo);
  if (services_.tpdos->has(number)) services_.tpdos->trigger(number);
}

void CarDriveController::watch_anew() {
  watched_position_ = position();
  watched_since_ = node_.now();
}

/// A dead encoder tells the same position for ever.
void CarDriveController::watch_position(Time now) {
  const bool is_watched = drive_is_known_ && position_is_known_;
  const bool moves = is_watched && std::abs(velocity()) > moving_velocity;
  const bool has_moved = std::abs(position() - watched_position_) > moving_distance;
  if (!moves || has_moved) return watch_anew();
  if (now - watched_since_ < settings_.position_time || position_stands_) return;
  position_stands_ = true;
  fast_stop();
}

/// A limit stops the car, or the drive goes on waiting for what never comes.
void CarDriveController::watch_standstill(Time now) {
  const bool stands = aim_ == Aim::trip && std::abs(velocity()) <= moving_velocity;
  if (!stands) {
    stands_since_ = now;
  } else if (now - stands_since_ >= settings_.standstill_time) {
    reach(false);
  }
}

/// A drive whose ropes have slipped leads the car past its target, if need be into the buffers.
/// Where it counts is known only so far: it needs as much way to its target as to stop, or more.
void CarDriveController::watch_overshoot() {
  const bool is_led = aim_ == Aim::trip && mode() == DriveMode::profile_position;
  const double sign = goes_up_ ? 1 : -1;
  const bool goes_there = velocity() * sign > moving_velocity && position_is_known_;
  if (!is_led || !goes_there || step_ != Step::taken) return;
  const double past = (nearest_stop() - wanted_position_) * sign;
  if (past <= overshoot_distance) return;
  drift_ -= sign * (past + overshoot_more);
  fast_stop();
}

// What the lift controller sees.

bool CarDriveController::has_fault() const {
  const DriveState state = drive_state();
  return drive_is_known_ &&
         (state == DriveState::fault || state == DriveState::fault_reaction_active);
}

double CarDriveController::position() const {
  const auto counts = static_cast<std::int32_t>(position_.raw());
  return static_cast<double>(counts) * settings_.position_step_micrometre /
         settings_.drive_unit_micrometre;
}

/// While it gains speed, with all of its acceleration: so the stopping position is never too near.
MotionState CarDriveController::motion() const {
  const double now = velocity();
  const bool speeds_up = acceleration_ * now > 0 && std::abs(now) < settings_.ramps.velocity;
  const double sign = now < 0 ? -1 : 1;
  return {position(), now, speeds_up ? sign * settings_.ramps.acceleration : 0};
}

/// Where a car stands still that slows down with all of its deceleration already.
double CarDriveController::nearest_stop() const {
  return position() + velocity() * std::abs(velocity()) / (2 * settings_.ramps.deceleration);
}

MotionStatus CarDriveController::status() const {
  const double unit = settings_.drive_unit_micrometre;
  const auto micrometres = [&](double value) {
    return static_cast<std::int32_t>(std::lround(value * unit));
  };
  const MotionState now = motion();
  double stopping = now.position;
  if (std::abs(now.velocity) > moving_velocity) {
    stopping += MotionProfile::stopping_distance(now, settings_.ramps);
    // On its last ramp it stops at its target, and not behind it.
    const bool leads_there =
        aim_ == Aim::trip && (wanted_position_ - now.position) * now.velocity > 0;
    if (leads_there && now.velocity > 0) stopping = std::min(stopping, wanted_position_);
    if (leads_there && now.velocity < 0) stopping = std::max(stopping, wanted_position_);
  }
  const DriveState state = drive_state();
  const bool is_still = !is_powered(state) && std::abs(now.velocity) <= moving_velocity;
  MotionStatus status;
  status.available =
      drive_is_known_ && position_is_known_ && !has_fault() && !position_stands_ && !is_held_;
  status.standing = drive_is_known_ && aim_ == Aim::none && is_still;
  status.arrived = status.standing && is_reached_;
  status.position_micrometre = micrometres(now.position);
  status.velocity_micrometre_per_second = micrometres(now.velocity);
  status.stopping_position_micrometre = micrometres(stopping);
  return status;
}

void CarDriveController::tell() {
  const MotionStatus now = status();
  if (now == told_) return;
  told_ = now;
  changed_();
}

LiftMotion CarDriveController::interface() {
  using Command = Callback<void(std::int32_t)>;
  return {.travel_to = Command::to<&CarDriveController::travel_to>(*this),
          .run = Command::to<&CarDriveController::run>(*this),
          .stop = Callback<void()>::to<&CarDriveController::stop>(*this),
          .fast_stop = Callback<void()>::to<&CarDriveController::fast_stop>(*this),
          .status = Callback<MotionStatus()>::to<&CarDriveController::status_for_lift>(*this)};
}

}  // namespace canvoy::cia417
