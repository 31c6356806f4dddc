#include "canvoy/devices/cia417/drive/car_drive_unit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/canopen/nmt/error_control_id.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// Of CiA 417 (facts 1.6) and of CiA 402.
constexpr std::uint16_t unintended_code = 0xFF06;
constexpr std::uint16_t following_code = 0x8611;

/// After these nothing is known of what the controller wants.
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

constexpr HookCalls CarDriveUnit::hook_calls[] = {
    before_write<&CarDriveUnit::note_order, controlword_object>,
    before_write<&CarDriveUnit::check, statusword_object, velocity_control_parameter_set_object>,
    after_write<&CarDriveUnit::order_written, controlword_object>,
    after_write<&CarDriveUnit::mode_written, modes_of_operation_object>,
    after_write<&CarDriveUnit::target_velocity_written, target_velocity_object>,
    after_write<&CarDriveUnit::refresh_status, target_position_object>,
    after_write<&CarDriveUnit::parameter_written, statusword_object,
                velocity_control_parameter_set_object>};
constexpr ServiceCalls CarDriveUnit::service_calls = {
    .reset = method<&CarDriveUnit::reset>,
    .state_entered = method<&CarDriveUnit::state_entered>,
    .bus_state_changed = method<&CarDriveUnit::bus_state_changed>,
    .error_changed = method<&CarDriveUnit::error_changed>,
    .hooks = hook_calls};

CarDriveUnit::CarDriveUnit(Node& node, const CarDriveServices& services,
                           const CarDriveHardware& hardware, const CarDriveSettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      parameters_(node.dictionary(), settings.lift),
      controlword_(node.dictionary(), settings.lift),
      statusword_(node.dictionary(), settings.lift),
      mode_wanted_(node.dictionary(), settings.lift),
      mode_shown_(node.dictionary(), settings.lift),
      target_position_(node.dictionary(), settings.lift),
      target_velocity_(node.dictionary(), settings.lift),
      velocity_demand_(node.dictionary(), settings.lift),
      velocity_actual_(node.dictionary(), settings.lift),
      velocity_sensor_(node.dictionary(), settings.lift),
      sensor_selection_(node.dictionary(), settings.lift),
      control_effort_(node.dictionary(), settings.lift),
      timer_(Callback<void(Time)>::to<&CarDriveUnit::tick>(*this)),
      search_(settings.homing) {
  node.attach(service_);
  if (services.emergencies != nullptr) {
    services.emergencies->on_emergency(
        Callback<void(NodeId, const Emergency&)>::to<&CarDriveUnit::emergency_heard>(*this));
    for (const NodeId node_id : settings.stops_for) services.emergencies->listen(node_id);
  }
}

// The bus.

/// Transitions 0 and 1.
void CarDriveUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) tune();
  read_parameters();
  if (scope == ResetScope::communication) return stop_fast();
  readings_ = hardware_.sense();
  release_all();
  faults_ = 0;
  asked_ = obeyed_ = 0;
  count_from(0, 0);
  has_homed_ = homing_failed_ = is_standing_ = has_stood_ = false;
  slow_since_ = near_since_ = behind_since_ = never;
  take_mode();
  enter(DriveState::switch_on_disabled);
  tick(node_.now());
}

void CarDriveUnit::read_parameters() {
  parameters_.read();
  hardware_.control(parameters_.gain(), parameters_.integration_time());
}

void CarDriveUnit::tune() {
  const auto set = [this](const auto& handle, std::uint32_t value) {
    if (value == 0) return;
    Values(node_.dictionary())[in_lift(settings_.lift, handle)].set_raw(value);
  };
  const DriveTuning& tuning = settings_.tuning;
  set(max_profile_velocity, tuning.velocity);
  set(profile_velocity, tuning.velocity);
  set(profile_acceleration, tuning.acceleration);
  set(profile_deceleration, tuning.acceleration);
  for (unsigned bend = 1; bend <= 6; ++bend) set(profile_jerk[bend], tuning.jerk);
  const auto highest = Values(node_.dictionary())[in_lift(settings_.lift, max_acceleration)];
  if (highest.raw() >= tuning.acceleration) return;
  set(max_acceleration, tuning.acceleration);
  set(max_deceleration, tuning.acceleration);
}

void CarDriveUnit::state_entered(NmtState state) {
  if (state != NmtState::operational) stop_fast();
  refresh_status();
}

void CarDriveUnit::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) stop_fast();
}

void CarDriveUnit::error_changed(const Error& error, bool present) {
  if (present && is_loss_of_control(error, settings_.controller)) stop_fast();
}

/// An error that goes leaves others there while the register is not 0.
void CarDriveUnit::emergency_heard(NodeId node_id, const Emergency& emergency) {
  if (emergency.code == emergency_code::overspeed || emergency.code == unintended_code) {
    hold_for(node_id);
    stop_fast();
    hasten();
  }
  if (emergency.code == canvoy::emergency_code::no_error && emergency.register_bits == 0) {
    release(node_id);
  }
}

/// Its boot-up is heard meanwhile. Without room for that, a fault reset is left.
void CarDriveUnit::hold_for(NodeId node_id) {
  if (holders_[node_id]) return;
  holders_[node_id] = true;
  node_.router().add(error_control_id(node_id),
                     Router::Receiver::to<&CarDriveUnit::error_control_heard>(*this));
}

void CarDriveUnit::release(NodeId node_id) {
  if (!holders_[node_id]) return;
  holders_[node_id] = false;
  node_.router().remove(error_control_id(node_id),
                        Router::Receiver::to<&CarDriveUnit::error_control_heard>(*this));
}

void CarDriveUnit::release_all() {
  for (NodeId node_id = node_id_min; node_id <= node_id_max; ++node_id) release(node_id);
}

/// A node that boots has forgotten its errors, and tells no end of them.
void CarDriveUnit::error_control_heard(const Frame& frame, Time) {
  const bool is_boot_up = frame.length == 1 && remote_state(frame.data[0]) == RemoteState::boot_up;
  if (is_boot_up) release(static_cast<NodeId>(frame.id - can_id::error_control));
}

/// All values of a PDO are asked for before one is written: the controlword comes first.
AbortCode CarDriveUnit::note_order(std::uint16_t word) {
  asked_ = word;
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
  if (is_standing_ || !is_powered(state_)) take_mode();
  refresh_status();
}

void CarDriveUnit::target_velocity_written() {
  change_velocity();
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
    // Who told of an error may have started again, and never tell that it is gone.
    release_all();
    if (state_ == DriveState::fault) return reset_fault();
  }
  obey_level();
  if (state_ == DriveState::operation_enabled && !is_stopping_) obey_mode(word, changed);
}

/// The bits of the controlword that name a state.
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
  // tick() asks again.
  if (is_start && !readings_.voltage) return;
  if (is_start && !is_powered(state_) && !is_standing_) return;
  if (state_ != DriveState::operation_enabled || next == DriveState::switch_on_disabled) {
    return enter(next);
  }
  if (next == DriveState::quick_stop_active) {
    const StopReaction reaction = parameters_.option(3);
    const bool stays = reaction >= StopReaction::slow_down_ramp_and_stay;
    state_ = next;
    return stop(reaction, stays ? std::nullopt : std::optional(DriveState::switch_on_disabled));
  }
  // The command came again, or another one, on the way there.
  if (is_stopping_) {
    after_stop_ = next;
    return;
  }
  stop(parameters_.option(next == DriveState::ready_to_switch_on ? 1 : 2), next);
}

/// `then` is entered when the car stands; without it the drive stays in this state.
void CarDriveUnit::stop(StopReaction reaction, std::optional<DriveState> then) {
  is_travelling_ = false;
  is_halted_ = false;
  next_.is_waiting = false;
  homing_ = Homing::idle;
  if (reaction == StopReaction::disable && then) return enter(*then);
  after_stop_ = then;
  is_stopping_ = true;
  reaction_ = must_be_fast() ? fast(reaction) : reaction;
  slow_down(reaction_);
  node_.timers().arm(timer_, node_.now());
}

/// Of a stop that is under way.
void CarDriveUnit::hasten() {
  if (is_stopping_ && must_be_fast() && fast(reaction_) != reaction_) stop(reaction_, after_stop_);
}

void CarDriveUnit::enter(DriveState state) {
  state_ = state;
  is_stopping_ = is_halted_ = is_travelling_ = false;
  is_acknowledged_ = has_arrived_ = is_limited_ = false;
  next_.is_waiting = false;
  homing_ = Homing::idle;
  velocity_goal_ = 0;
  velocity_obeyed_.reset();
  after_stop_.reset();
  if (!is_powered(state)) {
    close_brake();
    switch_power(false);
  } else if (state == DriveState::operation_enabled) {
    switch_power(true);
    begin_operation();
  }
  node_.timers().arm(timer_, node_.now());
}

void CarDriveUnit::switch_power(bool on) {
  if (has_power_ != on) hardware_.power(on);
  has_power_ = on;
}

void CarDriveUnit::stop_fast() {
  const std::optional<DriveState> next = next_state(state_, DriveCommand::quick_stop);
  if (next) change_state(*next);
  refresh_status();
}

/// Transitions 13 and 14.
void CarDriveUnit::fail(Fault fault, const Error& error) {
  if ((faults_ & fault) != 0) return;
  faults_ |= fault;
  node_.raise(error);
  if (state_ == DriveState::fault || state_ == DriveState::fault_reaction_active) return hasten();
  if (!is_powered(state_)) return enter(DriveState::fault);
  state_ = DriveState::fault_reaction_active;
  // Who does not know where the car is leads it to no stop: the brake does.
  const bool is_blind = fault == following;
  stop(is_blind ? StopReaction::disable : parameters_.option(5), DriveState::fault);
}

Error CarDriveUnit::error_of(Fault fault) const {
  switch (fault) {
    case overspeed:
      return {.code = emergency_code::overspeed};
    case unintended:
      return {.code = unintended_code};
    case following:
      return {.code = following_code};
    case hardware_fault:
      return {.code = hardware_code_};
  }
  return {};
}

bool CarDriveUnit::is_gone(Fault fault) const {
  switch (fault) {
    case overspeed:
      return std::abs(readings_.velocity) <= parameters_.velocity_max() && readings_.voltage;
    case unintended:
      return is_standing_ && readings_.voltage;
    case hardware_fault:
      return readings_.fault == 0;
    case following:
      break;
  }
  return true;
}

/// Transition 15.
void CarDriveUnit::reset_fault() {
  measure(node_.now());
  constexpr Fault all[] = {overspeed, unintended, following, hardware_fault};
  const auto is_present = [this](Fault fault) { return (faults_ & fault) != 0; };
  if (std::ranges::any_of(all, [&](Fault f) { return is_present(f) && !is_gone(f); })) return;
  for (const Fault fault : all) {
    if (is_present(fault)) node_.clear(error_of(fault));
  }
  faults_ = 0;
  stood_at_ = readings_.position;
  is_following_error_ = false;
  behind_since_ = never;
  enter(DriveState::switch_on_disabled);
}

}  // namespace canvoy::cia417
