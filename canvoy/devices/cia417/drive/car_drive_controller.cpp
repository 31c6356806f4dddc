#include "canvoy/devices/cia417/drive/car_drive_controller.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

using cia402::DriveMode;

/// Distance past its target: an overshoot beyond the error of a car is detected late.
constexpr double overshoot_distance = 300;
/// Distance past the last floor: the limit switches of the shaft are behind it (EN 81-20, 5.12.2).
/// With a late position, the car appears to be too fast, the more the faster it is.
constexpr double beyond_last_floor = 30;
constexpr double seen_late_s = 0.08;
/// Slipped ropes may have taken it farther, by this distance: the next trip stops short of its
/// target, and shows the rest.
constexpr double overshoot_more = 1000;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Number of the RPDO for `row` of the pre-defined ones.
constexpr std::uint16_t rpdo_of(unsigned lift, std::uint16_t rpdo) {
  return number_of_rpdo(rpdo + (lift - 1) * lift_pdo_pitch);
}
constexpr std::uint16_t control_rpdos[] = {0x1504, 0x1503};
constexpr std::uint16_t status_rpdos[] = {0x1505, 0x1507, 0x1506};

constexpr unsigned shutdown_word = 0x0006;
constexpr unsigned switch_on_word = 0x0007;
constexpr unsigned enable_word = 0x000F;
constexpr unsigned immediately = enable_word | control_bit::change_immediately;
constexpr unsigned quick_stop_word = 0x0002;
/// Between the target and the edge that makes it a set-point: two frames.
constexpr Duration set_point_gap = 5ms;

}  // namespace

constexpr AccessHandlers CarDriveController::hook_calls[] = {
    after_write<&CarDriveController::status_received, statusword_object>,
    after_write<&CarDriveController::velocity_received, velocity_actual_value_object>,
    after_write<&CarDriveController::position_received, position_value>};
constexpr ServiceHandlers CarDriveController::service_calls = {
    .reset = method<&CarDriveController::reset>,
    .state_entered = method<&CarDriveController::state_entered>,
    .error_changed = method<&CarDriveController::error_changed>,
    .hooks = hook_calls};

CarDriveController::CarDriveController(Node& node, const CarDriveControllerServices& services,
                                       const CarDriveControllerSettings& settings)
    : node_(node),
      rpdos_(services.rpdos),
      tpdos_(services.tpdos),
      settings_(settings),
      controlword_(node.dictionary(), settings.lift),
      statusword_(node.dictionary(), settings.lift),
      target_velocity_(node.dictionary(), settings.lift),
      car_(node.dictionary(), settings.lift,
           {settings.drive_unit_micrometre, settings.position_step_micrometre}),
      mode_(services.client, settings.drive, settings.trip_mode,
            callback<&CarDriveController::pursue>(*this)),
      timer_(callback<&CarDriveController::expired>(*this)) {
  node.attach(service_);
}

void CarDriveController::reset(ResetScope) {
  aim_ = Aim::none;
  is_reached_ = is_stopping_fast_ = has_homed_ = false;
  drive_is_known_ = position_is_known_ = false;
  drive_is_lost_ = position_is_lost_ = position_stands_ = is_held_ = false;
  is_told_by_answer_ = false;
  mode_.begin_anew();
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
  // Values from before: no PDO has come since, and a standing unit does not repeat its position.
  forget_drive();
  position_is_known_ = false;
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

/// Discards its former state: its movement, and the standstill of its position.
void CarDriveController::forget_drive() {
  drive_is_known_ = false;
  aim_ = Aim::none;
  mode_.forget();
  position_stands_ = is_told_by_answer_ = false;
  car_.forget_velocity();
}

/// Requests unknown values; the answers are ordinary PDOs.
void CarDriveController::ask() {
  for (const std::uint16_t rpdo : status_rpdos) {
    const bool is_known = rpdo == status_rpdos[2] ? position_is_known_ : drive_is_known_;
    if (!is_known) request(rpdo);
  }
}

void CarDriveController::ask_anew() {
  is_told_by_answer_ = drive_is_known_;
  for (const std::uint16_t rpdo : status_rpdos) request(rpdo);
}

void CarDriveController::request(std::uint16_t rpdo) {
  if (rpdos_ == nullptr || node_.state() != NmtState::operational) return;
  const std::uint16_t number = rpdo_of(settings_.lift, rpdo);
  if (rpdos_->has(number)) rpdos_->request(number);
}

void CarDriveController::status_received() {
  drive_is_known_ = !drive_is_lost_;
  drive_told();
  const bool rests = aim_ == Aim::none && !is_powered(drive_state());
  if (std::exchange(is_told_by_answer_, false) && !rests) report_command();
}

void CarDriveController::velocity_received() {
  car_.velocity_came();
  // It sends its velocity often while it moves, so it stood before: that is the old value.
  const bool was_old = std::exchange(velocity_may_be_old_, false) && !car_.moves();
  if (was_old) position_stands_ = false;
  drive_told();
}

void CarDriveController::drive_told() {
  // The time before a start does not count.
  if (!car_.moves()) car_.watch_anew(node_.now());
  watch_overshoot();
  pursue();
  tell();
}

void CarDriveController::position_received() {
  position_is_known_ = !position_is_lost_;
  if (car_.has_moved()) position_stands_ = false;
  watch_overshoot();
  if (aim_ == Aim::trip && settings_.trip_mode == DriveMode::profile_velocity) pursue();
  tell();
}

// Commands.

void CarDriveController::travel_to(std::int32_t position_micrometre) {
  wanted_position_ = static_cast<double>(position_micrometre) / settings_.drive_unit_micrometre;
  goes_up_ = wanted_position_ > car_.nearest_stop(settings_.ramps);
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

/// A drift below the jitter of an encoder is ignored.
void CarDriveController::learn_drift() {
  if (!is_at_target_ || !position_is_known_) return;
  const double drift = target().raw() - position();
  if (std::abs(drift - drift_) > moving_distance) drift_ = drift;
  drift_least_ = -unbounded;
  drift_most_ = unbounded;
}

/// Within its bounds, so that the car rather stops short of its target than passes it: it is past
/// the one before.
double CarDriveController::drift_of_trip() const {
  return goes_up_ ? std::max(drift_least_, std::min(drift_, drift_most_ - overshoot_more))
                  : std::min(drift_most_, std::max(drift_, drift_least_ + overshoot_more));
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
  mode_.forget();
  controlword_ = 0;
  car_.forget_velocity();
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
  // Always called: otherwise a car that just starts to move would seem to have stood for too long.
  watch_position(now);
  watch_standstill(now);
  if (step_ == Step::placed && aim_ == Aim::trip) return send_set_point();
  if (!drive_is_known_ || !position_is_known_) ask();
  ask_what_is_odd();
  const bool is_late = now - told_at_ >= settings_.answer_time;
  const bool by_position = aim_ == Aim::trip && mode_.now() == DriveMode::profile_position;
  if (is_late && by_position && step_ == Step::sent) return repeat_set_point();
  pursue();
  if (is_late) report_again(now);
  tell();
}

/// Repeats a command that the drive did not execute: a frame was lost, or the drive was held. Its
/// state may be out of date as well.
void CarDriveController::report_again(Time now) {
  if (!drive_is_known_ || is_obeyed()) return;
  told_at_ = now;
  report_command();
  request(status_rpdos[0]);
}

bool CarDriveController::is_obeyed() const {
  const bool has_power = is_powered(drive_state());
  if (has_power != (aim_ != Aim::none)) return false;
  if (aim_ == Aim::run) return car_.moves();
  // An acknowledgement of the set-point before, which ends with bit 4.
  const bool is_led = aim_ == Aim::trip && mode_.now() == DriveMode::profile_position;
  return !is_led || step_ != Step::wanted;
}

void CarDriveController::report_command() {
  if (tpdos_ == nullptr) return;
  for (const std::uint16_t rpdo : control_rpdos) {
    const std::uint16_t number = rpdo_of(settings_.lift, rpdo);
    if (tpdos_->has(number)) tpdos_->trigger(number);
  }
}

/// A car does not move without power, and does not stand while its drive moves: one of the two
/// values is out of date.
void CarDriveController::ask_what_is_odd() {
  const bool is_odd = drive_is_known_ && !is_powered(drive_state()) && car_.moves();
  if (!is_odd && !position_stands_) return;
  request(status_rpdos[1]);
  if (position_stands_) request(status_rpdos[2]);
}

void CarDriveController::watch_position(Time now) {
  const bool is_watched = drive_is_known_ && position_is_known_ && car_.moves();
  if (!is_watched || car_.has_moved()) return car_.watch_anew(now);
  if (!car_.is_encoder_dead(settings_.position_time, now) || position_stands_) return;
  position_stands_ = velocity_may_be_old_ = true;
  fast_stop();
  ask_what_is_odd();
}

/// A limit stops the car, or the drive waits for an event that does not come.
void CarDriveController::watch_standstill(Time now) {
  const bool stands = (aim_ == Aim::trip || aim_ == Aim::home) && !car_.moves();
  if (!stands) {
    stands_since_ = now;
  } else if (now - stands_since_ >= settings_.standstill_time) {
    reach(false);
  }
}

/// A drive with slipped ropes moves the car past its target, if necessary into the buffers. The
/// position of its count is known only to this extent, from one side: its drift is a bound of the
/// true one.
void CarDriveController::watch_overshoot() {
  const bool is_led = aim_ == Aim::trip && mode_.now() == DriveMode::profile_position;
  const double sign = goes_up_ ? 1 : -1;
  const bool goes_there = car_.moves() && velocity() * sign > 0 && position_is_known_;
  if (!is_led || !goes_there || step_ != Step::taken) return;
  const double past = (car_.nearest_stop(settings_.ramps) - wanted_position_) * sign;
  if (past <= overshoot_distance && !passes_last_floor()) return;
  const double bound = target().raw() - wanted_position_ - sign * past;
  (goes_up_ ? drift_most_ : drift_least_) = bound;
  // The ropes have slipped once more.
  if (drift_least_ > drift_most_) (goes_up_ ? drift_least_ : drift_most_) = sign * -unbounded;
  fast_stop();
}

/// Terminal slow-down: by the position of the car, not by the count of the drive.
bool CarDriveController::passes_last_floor() const {
  const double sign = goes_up_ ? 1 : -1;
  const std::int32_t last = goes_up_ ? settings_.highest_micrometre : settings_.lowest_micrometre;
  const double end = static_cast<double>(last) / settings_.drive_unit_micrometre;
  const double beyond = (car_.nearest_stop(settings_.ramps) - end) * sign;
  return beyond > beyond_last_floor + std::abs(velocity()) * seen_late_s;
}

// Control of the drive on the way to its aim.

DriveMode CarDriveController::wanted_mode() const {
  if (aim_ == Aim::home) return DriveMode::homing;
  return aim_ == Aim::run ? DriveMode::profile_velocity : settings_.trip_mode;
}

void CarDriveController::command(unsigned word) {
  if (controlword_.raw() != word) told_at_ = node_.now();
  controlword_ = word;
}

/// One step towards the aim, by the present state of the drive.
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
      // The drive has left operation by itself, for example by a restart: a set-point belongs to
      // the operation in which it was taken.
      if ((controlword_.raw() & 0x000F) == enable_word) mode_.forget();
      step_ = Step::wanted;
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
    default:  // the drive changes its state by itself
      break;
  }
}

void CarDriveController::pursue_enabled(std::uint16_t status) {
  if (aim_ == Aim::none || mode_.now() != wanted_mode()) return rest();
  // A cancelled stop: it has to be completed first.
  if ((controlword_.raw() & 0x000F) == switch_on_word) return;
  if (aim_ == Aim::home) return lead_homing(status);
  if (aim_ == Aim::run) return lead_run();
  if (mode_.now() == DriveMode::profile_velocity) return lead_approach();
  lead_trip(status);
}

/// Slows down and disables operation: the brake holds the car.
void CarDriveController::rest() {
  target_velocity_ = 0;
  command(switch_on_word);
}

/// By the handshake of bits 4 and 12. A target at which the drive cannot stop is not acknowledged:
/// it moves to the one before, and gets the target again from there.
void CarDriveController::lead_trip(std::uint16_t status) {
  const bool is_acknowledged = (status & status_bit::set_point_acknowledge) != 0;
  const bool is_at_target = (status & status_bit::target_reached) != 0;
  switch (step_) {
    case Step::wanted:
      if (is_acknowledged) return command(immediately);
      // Two PDOs carry the controlword, one of them with the target, which arrives before the edge.
      target() = std::lround(wanted_position_ + drift_of_trip());
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
  const MotionState at = car_.state(settings_.ramps);
  const double now = std::abs(at.velocity);
  const MotionState moving = {0, now, std::abs(at.acceleration)};
  const double to_creep = MotionProfile::to_velocity(moving, creep, settings_.ramps).end().position;
  const double to_stop = MotionProfile::stopping_distance({0, creep, 0}, settings_.ramps);
  // A slow car stays slow, and a stopping one stops.
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
    drift_least_ = -unbounded;
    drift_most_ = unbounded;
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

/// True if the drive has the mode that the aim needs; otherwise a request for it is under way.
bool CarDriveController::has_mode() {
  if (mode_.now() == wanted_mode()) return true;
  if (!mode_.can_change()) {
    aim_ = Aim::none;
  } else {
    const unsigned lift = present_lift(node_.dictionary(), settings_.lift);
    mode_.write(in_lift(lift, modes_of_operation).index(), wanted_mode());
  }
  return false;
}

// Status for the lift controller.

bool CarDriveController::has_fault() const {
  const DriveState state = drive_state();
  return drive_is_known_ &&
         (state == DriveState::fault || state == DriveState::fault_reaction_active);
}

MotionStatus CarDriveController::status() const {
  const double unit = settings_.drive_unit_micrometre;
  const auto micrometres = [&](double value) {
    return static_cast<std::int32_t>(std::lround(value * unit));
  };
  const MotionState now = car_.state(settings_.ramps);
  double stopping = now.position;
  if (car_.moves()) {
    stopping += MotionProfile::stopping_distance(now, settings_.ramps);
    // On its last ramp it stops at its target, not behind it.
    const bool leads_there =
        aim_ == Aim::trip && (wanted_position_ - now.position) * now.velocity > 0;
    if (leads_there && now.velocity > 0) stopping = std::min(stopping, wanted_position_);
    if (leads_there && now.velocity < 0) stopping = std::max(stopping, wanted_position_);
  }
  const DriveState state = drive_state();
  const bool is_still = !is_powered(state) && !car_.moves();
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
          .stop = callback<&CarDriveController::stop>(*this),
          .fast_stop = callback<&CarDriveController::fast_stop>(*this),
          .status = callback<&CarDriveController::status_for_lift>(*this)};
}

}  // namespace canvoy::cia417
