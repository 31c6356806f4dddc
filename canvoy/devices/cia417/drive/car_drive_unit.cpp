#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

using cia402::DriveMode;

/// After this time beyond its planned end, a stop for a fault has failed; the brake then stops the
/// car.
constexpr Duration stop_time_reserve = 500ms;

/// A brake that slips at its self-test holds what is there: this is the time for the controller to
/// open doors, before the fault makes the drive unavailable.
constexpr Duration lets_out_time = 4s;

/// In units of the drive: maximum change of a standing encoder in one period.
constexpr double jump_distance = 5;

/// After these errors, the command of the controller is not known.
bool is_loss_of_control(const Error& error, NodeId controller) {
  return (error.code == canvoy::emergency_code::heartbeat && error.instance == controller) ||
         error.code == canvoy::emergency_code::protocol ||
         error.code == canvoy::emergency_code::pdo_too_short ||
         error.code == canvoy::emergency_code::rpdo_time_out;
}

/// No slower than on the quick stop ramp.
constexpr StopReaction fast(StopReaction reaction) {
  switch (reaction) {
    case StopReaction::slow_down_ramp:
      return StopReaction::quick_stop_ramp;
    case StopReaction::slow_down_ramp_and_stay:
      return StopReaction::quick_stop_ramp_and_stay;
    default:
      return reaction;
  }
}

}  // namespace

constexpr AccessHandlers CarDriveUnit::hook_calls[] = {
    before_write<&CarDriveUnit::note_order, controlword_object>,
    before_write<&CarDriveUnit::check, statusword_object, velocity_control_parameter_set_object>,
    after_write<&CarDriveUnit::order_written, controlword_object>,
    after_write<&CarDriveUnit::mode_written, modes_of_operation_object>,
    after_write<&CarDriveUnit::target_velocity_written, target_velocity_object>,
    after_write<&CarDriveUnit::refresh_status, target_position_object>,
    after_write<&CarDriveUnit::parameter_written, statusword_object,
                velocity_control_parameter_set_object>};
constexpr ServiceHandlers CarDriveUnit::service_calls = {
    .reset = method<&CarDriveUnit::reset>,
    .state_entered = method<&CarDriveUnit::state_entered>,
    .bus_state_changed = method<&CarDriveUnit::bus_state_changed>,
    .error_changed = method<&CarDriveUnit::error_changed>,
    .hooks = hook_calls};

CarDriveUnit::CarDriveUnit(Node& node, const CarDriveServices& services,
                           const CarDriveHardware& hardware, const CarDriveSettings& settings)
    : node_(node),
      lift_(settings.lift),
      tuning_(settings.tuning),
      control_period_(settings.control_period),
      standing_period_(settings.standing_period),
      parameters_(node.dictionary(), settings.lift,
                  {settings.current_limit_deceleration, settings.voltage_limit_deceleration}),
      car_(hardware, settings.brake_time, callback<&CarDriveUnit::look_again>(*this)),
      position_mode_(car_, parameters_, settings.position_window),
      velocity_mode_(car_, parameters_, settings.control_period),
      homing_mode_(car_, parameters_,
                   {.method = settings.homing,
                    .velocity = settings.homing_velocity,
                    .travel = settings.travel,
                    .time_max = settings.homing_time_max}),
      watch_({.overspeed_percent = settings.overspeed_percent,
              .unintended_distance = settings.unintended_distance,
              .following_window = settings.following_window,
              .following_time = settings.following_time}),
      faults_(node),
      hold_(node, services.emergencies, settings.stops_for, callback<&CarDriveUnit::held>(*this)),
      controlword_(node.dictionary(), settings.lift),
      statusword_(node.dictionary(), settings.lift),
      mode_wanted_(node.dictionary(), settings.lift),
      velocity_demand_(node.dictionary(), settings.lift),
      velocity_actual_(node.dictionary(), settings.lift),
      velocity_sensor_(node.dictionary(), settings.lift),
      sensor_selection_(node.dictionary(), settings.lift),
      control_effort_(node.dictionary(), settings.lift),
      timer_(callback<&CarDriveUnit::tick>(*this)),
      controller_(settings.controller) {
  node.attach(service_);
}

// Events of the bus.

/// Transitions 0 and 1.
void CarDriveUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) tune();
  read_parameters();
  if (scope == ResetScope::communication) return stop_fast();
  car_.begin_anew();
  hold_.release_all();
  faults_.begin_anew();
  homing_mode_.begin_anew();
  watch_.begin_anew();
  weak_brake_.begin_anew();
  asked_ = obeyed_ = 0;
  parameters_.count_from(0, 0);
  take_mode();
  enter(DriveState::switch_on_disabled);
  tick(node_.now());
}

void CarDriveUnit::read_parameters() {
  parameters_.read();
  car_.tune(parameters_.gain(), parameters_.integration_time());
}

void CarDriveUnit::tune() {
  const auto set = [this](const auto& handle, std::uint32_t wanted) {
    if (wanted != 0) value(handle).set_raw(wanted);
  };
  set(max_profile_velocity, tuning_.velocity);
  set(profile_velocity, tuning_.velocity);
  set(profile_acceleration, tuning_.acceleration);
  set(profile_deceleration, tuning_.acceleration);
  for (unsigned bend = 1; bend <= 6; ++bend) set(profile_jerk[bend], tuning_.jerk);
  if (value(max_acceleration).raw() >= tuning_.acceleration) return;
  set(max_acceleration, tuning_.acceleration);
  set(max_deceleration, tuning_.acceleration);
}

void CarDriveUnit::state_entered(NmtState state) {
  if (state != NmtState::operational) stop_fast();
  refresh_status();
}

void CarDriveUnit::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) stop_fast();
}

void CarDriveUnit::error_changed(const Error& error, bool present) {
  if (present && is_loss_of_control(error, controller_)) stop_fast();
}

/// A node reports a dangerous error.
void CarDriveUnit::held() {
  stop_fast();
  hasten();
}

/// All values of a PDO are checked before one is written: the controlword comes first.
AbortCode CarDriveUnit::note_order(Raw<std::uint16_t> controlword) {
  asked_ = controlword.bits;
  return AbortCode::none;
}

AbortCode CarDriveUnit::check(const Entry& entry, std::span<const std::uint8_t> value) {
  const bool is_relative = (asked_ & control_bit::relative) != 0;
  return parameters_.check(entry, value, state_, is_relative);
}

void CarDriveUnit::order_written() {
  obey(controlword_.raw());
  refresh_status();
}

void CarDriveUnit::mode_written() {
  if (is_standing() || !is_powered(state_)) take_mode();
  refresh_status();
}

void CarDriveUnit::target_velocity_written() {
  obey_velocity();
  refresh_status();
}

void CarDriveUnit::parameter_written(const Entry& entry) {
  if (parameters_.is_command(entry)) return;
  read_parameters();
  refresh_status();
}

// The state machine.

void CarDriveUnit::obey(std::uint16_t word) {
  const std::uint16_t changed = word ^ obeyed_;
  obeyed_ = word;
  if ((changed & word & control_bit::fault_reset) != 0) {
    hold_.release_all();
    if (state_ == DriveState::fault) return reset_fault();
  }
  obey_level();
  if (state_ == DriveState::operation_enabled && !is_stopping_) obey_mode(word, changed);
}

/// The bits of the controlword that select a state.
void CarDriveUnit::obey_level() {
  const std::optional<DriveCommand> command = drive_command(obeyed_);
  if (!command) return;
  const bool stays = parameters_.option(3) >= StopReaction::slow_down_ramp_and_stay;
  const std::optional<DriveState> next = next_state(state_, *command, stays);
  if (next) change_state(*next);
}

void CarDriveUnit::change_state(DriveState next) {
  const bool is_start = next == DriveState::operation_enabled;
  if (is_held() && (is_start || state_ == DriveState::switch_on_disabled)) return;
  // While the brake still stops the car, or the safety chain is open, the power stage stays off;
  // tick() tries again.
  if (is_start && (!readings().voltage || car_.has_weak_brake())) return;
  if (is_start && !is_powered(state_) && !is_standing()) return;
  if (state_ != DriveState::operation_enabled || next == DriveState::switch_on_disabled) {
    return enter(next);
  }
  if (next == DriveState::quick_stop_active) {
    const StopReaction reaction = parameters_.option(3);
    const bool stays = reaction >= StopReaction::slow_down_ramp_and_stay;
    state_ = next;
    return stop(reaction, stays ? std::nullopt : std::optional(DriveState::switch_on_disabled));
  }
  // The command was repeated, or replaced, on the way there.
  if (is_stopping_) {
    after_stop_ = next;
    return;
  }
  stop(parameters_.option(next == DriveState::ready_to_switch_on ? 1 : 2), next);
}

/// `then` is the state after the standstill; without it, the drive stays in the present state.
void CarDriveUnit::stop(StopReaction reaction, std::optional<DriveState> then) {
  is_halted_ = false;
  position_mode_.give_up();
  homing_mode_.give_up();
  if (reaction == StopReaction::disable && then) return enter(*then);
  after_stop_ = then;
  is_stopping_ = true;
  reaction_ = must_be_fast() ? fast(reaction) : reaction;
  slow_down(reaction_);
  look_again();
}

void CarDriveUnit::slow_down(StopReaction reaction) {
  if (reaction == StopReaction::disable) return car_.close_brake();
  velocity_mode_.give_up();
  const double velocity = car_.present(node_.now()).velocity;
  car_.slow_down(parameters_.stop_ramp(reaction, velocity), node_.now());
}

/// Hastens a stop that is under way.
void CarDriveUnit::hasten() {
  if (is_stopping_ && must_be_fast() && fast(reaction_) != reaction_) stop(reaction_, after_stop_);
}

void CarDriveUnit::enter(DriveState state) {
  state_ = state;
  is_stopping_ = is_halted_ = has_arrived_ = false;
  position_mode_.begin_anew();
  velocity_mode_.begin_anew();
  homing_mode_.give_up();
  after_stop_.reset();
  if (!is_powered(state)) {
    car_.close_brake();
    car_.switch_power(false);
  } else if (state == DriveState::operation_enabled) {
    // With power, standing, and without a command.
    car_.switch_power(true);
    car_.hold(node_.now());
    take_mode();
  }
  look_again();
}

void CarDriveUnit::stop_fast() {
  const std::optional<DriveState> next = next_state(state_, DriveCommand::quick_stop);
  if (next) change_state(*next);
  refresh_status();
}

/// Transitions 13 and 14.
void CarDriveUnit::fail(DriveFault fault, std::uint16_t hardware_code) {
  if (!faults_.add(fault, hardware_code)) return;
  if (state_ == DriveState::fault || state_ == DriveState::fault_reaction_active) return hasten();
  if (!is_powered(state_)) return enter(DriveState::fault);
  state_ = DriveState::fault_reaction_active;
  // Without a known position of the car, the drive cannot make a controlled stop: the brake stops
  // it.
  const bool is_blind = fault == DriveFault::following;
  stop(is_blind ? StopReaction::disable : parameters_.option(5), DriveState::fault);
}

bool CarDriveUnit::is_gone(DriveFault fault) const {
  switch (fault) {
    case DriveFault::overspeed:
      return std::abs(readings().velocity) <= parameters_.velocity_max() && readings().voltage;
    case DriveFault::unintended:
      return is_standing() && readings().voltage;
    case DriveFault::hardware:
      return readings().fault == 0;
    case DriveFault::brake:
      return readings().voltage;
    case DriveFault::following:
      break;
  }
  return true;
}

/// Transition 15.
void CarDriveUnit::reset_fault() {
  measure(node_.now());
  const auto is_there = [this](DriveFault fault) { return faults_.has(fault) && !is_gone(fault); };
  if (std::ranges::any_of(all_drive_faults, is_there)) return;
  faults_.end_all();
  car_.settle();
  car_.forget_brake_test();
  watch_.begin_anew();
  enter(DriveState::switch_on_disabled);
}

// The mode of operation.

/// The selected mode, if the drive has it.
void CarDriveUnit::take_mode() {
  const auto wanted = mode_wanted_.value();
  if (wanted) mode_ = *wanted;
  value(modes_of_operation_display) = mode_;
  has_arrived_ = false;
  position_mode_.begin_anew();
  velocity_mode_.begin_anew();
  homing_mode_.give_up();
  obey_velocity();
}

void CarDriveUnit::obey_mode(std::uint16_t word, std::uint16_t changed) {
  const bool is_halted = (word & control_bit::halt) != 0;
  if (is_halted != is_halted_) obey_halt(is_halted);
  if ((changed & control_bit::new_set_point) == 0) return;
  const Time now = node_.now();
  if (mode_ == DriveMode::profile_position) {
    if (position_mode_.take(word, value(target_position).raw(), is_halted_, now))
      has_arrived_ = false;
  }
  if (mode_ != DriveMode::homing) return;
  if ((word & control_bit::new_set_point) == 0) return homing_mode_.cancel(now);
  has_arrived_ = false;
  homing_mode_.start(is_halted_, now);
}

/// The target is kept, and travelled to when the halt ends.
void CarDriveUnit::obey_halt(bool is_halted) {
  is_halted_ = is_halted;
  has_arrived_ = false;
  velocity_mode_.ask_again();
  if (is_halted) return slow_down(parameters_.option(4));
  if (mode_ == DriveMode::profile_position) position_mode_.go_on(node_.now());
  if (mode_ == DriveMode::homing && homing_mode_.is_under_way()) {
    homing_mode_.start(false, node_.now());
  }
  obey_velocity();
}

/// Applies the present value of 6430h.
void CarDriveUnit::obey_velocity() {
  const bool obeys = state_ == DriveState::operation_enabled && !is_stopping_ && !is_halted_;
  if (mode_ != DriveMode::profile_velocity || !obeys) return;
  if (velocity_mode_.obey(value(target_velocity).raw(), node_.now())) has_arrived_ = false;
}

// Called every period.

void CarDriveUnit::tick(Time now) {
  measure(now);
  supervise(now);
  if (is_stopping_) {
    finish_stop(now);
  } else if (state_ == DriveState::operation_enabled) {
    advance_mode(now);
  } else if (state_ == DriveState::ready_to_switch_on || state_ == DriveState::switched_on) {
    obey_level();
  }
  refresh_status();
  arm(now);
}

void CarDriveUnit::measure(Time now) {
  car_.sense(now, parameters_.windows(), parameters_.increments(jump_distance));
  velocity_mode_.watch_slippage(now);
  report_velocities(now);
}

void CarDriveUnit::report_velocities(Time now) {
  const DriveUnits& units = parameters_.units();
  const double wanted = car_.has_power() ? demand(now).velocity : 0;
  const bool by_sensor = sensor_selection_.is(cia402::SensorSelection::velocity_encoder);
  const double actual = by_sensor ? readings().sensor_velocity : readings().velocity;
  const auto in_units = [&](double velocity) { return std::llround(velocity / units.velocity); };
  velocity_demand_ = in_units(wanted);
  velocity_actual_ = in_units(actual);
  velocity_sensor_ = std::llround(readings().sensor_velocity * units.sensor_velocity);
  control_effort_ = in_units(wanted);
}

void CarDriveUnit::supervise(Time now) {
  if (readings().fault != 0) fail(DriveFault::hardware, readings().fault);
  if (watch_.is_too_fast(car_, parameters_) && !faults_.has(DriveFault::overspeed)) {
    car_.arrest();
    fail(DriveFault::overspeed);
  }
  if (watch_.strays(car_, parameters_) && !faults_.has(DriveFault::unintended)) {
    car_.arrest();
    fail(DriveFault::unintended);
  }
  weak_brake_.watch(car_.has_weak_brake(), now);
  if (weak_brake_.lasts(lets_out_time, now)) fail(DriveFault::brake);
  watch_voltage();
  if (watch_.lags_behind(car_, parameters_, now)) fail(DriveFault::following);
}

/// Transitions 9, 12 and 14: as if the voltage were disabled.
void CarDriveUnit::watch_voltage() {
  if (readings().voltage || !is_powered(state_)) return;
  const bool is_fault = state_ == DriveState::fault_reaction_active;
  enter(is_fault ? DriveState::fault : DriveState::switch_on_disabled);
}

void CarDriveUnit::finish_stop(Time now) {
  const bool gives_up =
      state_ == DriveState::fault_reaction_active && car_.seconds_left(now - stop_time_reserve) < 0;
  if (!is_standing() && !gives_up) return;
  is_stopping_ = false;
  has_arrived_ = true;
  car_.close_brake();
  if (!after_stop_) return;
  enter(*after_stop_);
  // Commands that were given on the way, and could not yet be executed.
  obey_level();
}

void CarDriveUnit::advance_mode(Time now) {
  if (is_halted_) {
    has_arrived_ = is_standing();
    if (is_standing()) car_.close_brake();
    return;
  }
  if (is_standing() && mode_wanted_.value() && mode_wanted_.value() != mode_) take_mode();
  has_arrived_ = look_at_mode(now).value_or(has_arrived_);
}

std::optional<bool> CarDriveUnit::look_at_mode(Time now) {
  switch (mode_) {
    case DriveMode::profile_position:
      return position_mode_.look(now);
    case DriveMode::profile_velocity:
      return velocity_mode_.look(now);
    case DriveMode::homing:
      return homing_mode_.look(now);
    default:
      return std::nullopt;
  }
}

std::uint16_t CarDriveUnit::mode_bits() const {
  const auto bits = [](bool bit_12, bool bit_13) {
    return static_cast<std::uint16_t>((bit_12 ? 0x1000 : 0) | (bit_13 ? 0x2000 : 0));
  };
  switch (mode_) {
    case DriveMode::profile_velocity:
      return bits(car_.is_slow(), velocity_mode_.slips());
    case DriveMode::homing:
      return bits(homing_mode_.has_homed(), homing_mode_.has_failed());
    default:
      return bits(position_mode_.is_acknowledged(), faults_.has(DriveFault::following));
  }
}

void CarDriveUnit::refresh_status() {
  const bool is_limited = position_mode_.is_limited() || velocity_mode_.is_limited();
  unsigned word = state_bits(state_) | mode_bits();
  if (readings().voltage) word |= status_bit::voltage_enabled;
  if (readings().warning) word |= status_bit::warning;
  if (node_.state() == NmtState::operational) word |= status_bit::remote;
  if (has_arrived_) word |= status_bit::target_reached;
  if (is_limited) word |= status_bit::internal_limit;
  statusword_ = word;
}

/// Again when the profile ends; otherwise often while the car moves, and rarely while it stands.
void CarDriveUnit::arm(Time now) {
  const bool is_busy = car_.is_brake_released() || !is_standing();
  Time next = now + (is_busy ? control_period_ : standing_period_);
  if (car_.is_brake_released() && !car_.has_ended(now)) {
    const auto left = std::min(car_.seconds_left(now), 1e6) * 1e6;
    next = std::min(next, now + Duration(std::llround(std::ceil(left))));
  }
  if (timer_.at() > next) node_.timers().arm(timer_, std::max(next, now + 1us));
}

}  // namespace canvoy::cia417
