#include "canvoy/devices/cia417/door/car_door_unit.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia417/errors.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// For hardware that announces a change that does not come.
constexpr Duration shortest_look = 1ms;
/// In one call.
constexpr int looks_max = 4;

bool is_error(Detection detection) {
  return detection == Detection::error;
}
bool is_closing(DoorCommand command) {
  return command == DoorCommand::close_with_limit_force ||
         command == DoorCommand::close_without_limit_force;
}
bool is_opening(DoorCommand command) {
  return command == DoorCommand::open_with_limit_force ||
         command == DoorCommand::open_without_limit_force;
}
bool is_stop(DoorCommand command) {
  return command == DoorCommand::stop_with_limit_force ||
         command == DoorCommand::stop_without_limit_force;
}
bool limits_force(DoorCommand command) {
  return command == DoorCommand::close_with_limit_force ||
         command == DoorCommand::open_with_limit_force ||
         command == DoorCommand::stop_with_limit_force;
}

/// Enable or disable; a reserved value and "no action" leave it.
void apply(Disabling order, bool& is_enabled) {
  if (order == Disabling::enable) is_enabled = true;
  if (order == Disabling::disable) is_enabled = false;
}

Duration seconds(double count) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(count));
}

}  // namespace

constexpr AccessHandlers CarDoorUnit::hook_calls[] = {
    after_write<&CarDoorUnit::order_received, door_controlword>,
    before_write<&CarDoorUnit::check_setting, door_configuration_object>,
    after_write<&CarDoorUnit::barrier_received, light_barrier_status>};
constexpr ServiceHandlers CarDoorUnit::service_calls = {
    .reset = method<&CarDoorUnit::reset>,
    .error_changed = method<&CarDoorUnit::error_changed>,
    .hooks = hook_calls};

CarDoorUnit::CarDoorUnit(Node& node, const DoorHardware& hardware, const CarDoorSettings& settings)
    : node_(node),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&CarDoorUnit::act>(*this)),
      reclose_(callback<&CarDoorUnit::reclose_expired>(*this)) {
  node.attach(service_);
}

// Events of the bus.

void CarDoorUnit::reset(ResetScope scope) {
  last_command_ = DoorCommand::no_action;
  if (scope == ResetScope::node) {
    stop(false);
    has_failed_ = false;
    barrier_is_lost_ = false;
    limits_force_ = true;
    is_reduced_ = false;
    detects_motion_ = true;
    protects_fingers_ = true;
    locks_ = true;
    defects_told_ = {};
  }
  act(node_.now());
}

void CarDoorUnit::error_changed(const Error& error, bool present) {
  if (error.code != canvoy::emergency_code::heartbeat) return;
  if (settings_.light_barrier != 0 && error.instance == settings_.light_barrier) {
    barrier_is_lost_ = present;
    act(node_.now());
  }
  if (present && error.instance == settings_.controller) lose_controller();
}

void CarDoorUnit::order_received(const Entry& entry, Source source) {
  if (entry.sub != settings_.door) return;
  const auto word = static_cast<std::uint16_t>(load_unsigned(entry.bytes()));
  obey(DoorOrder::of(word), source == Source::sdo);
  act(node_.now());
}

/// Refuses modes and profiles that do not exist.
AbortCode CarDoorUnit::check_setting(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.index != in_lift(settings_.lift, door_type(settings_.door)).index()) {
    return AbortCode::none;
  }
  const std::uint64_t number = load_unsigned(value);
  const auto takes = [number](std::uint64_t highest) {
    return number <= highest ? AbortCode::none : AbortCode::value_range;
  };
  if (entry.sub == door_velocity_profile.sub()) return takes(settings_.velocity_profiles - 1U);
  if (entry.sub == door_width_profile.sub()) return takes(settings_.width_profiles - 1U);
  if (entry.sub == door_type.sub()) {
    return takes(static_cast<unsigned>(DoorType::right_side_opening));
  }
  if (entry.sub >= light_barrier_modus.sub() && entry.sub <= motion_detection_modus.sub()) {
    return takes(static_cast<unsigned>(DoorReaction::stop));
  }
  if (entry.sub == heartbeat_loss.sub()) {
    return takes(static_cast<unsigned>(HeartbeatLoss::close_with_reduced_speed));
  }
  return AbortCode::none;
}

void CarDoorUnit::barrier_received(const Entry& entry) {
  if (entry.sub == settings_.door) act(node_.now());
}

// Commands.

void CarDoorUnit::obey(const DoorOrder& order, bool always) {
  apply(order.motion_detector, detects_motion_);
  apply(order.finger_protector, protects_fingers_);
  apply(order.lock, locks_);
  if (order.velocity == DoorVelocity::standard) is_reduced_ = false;
  if (order.velocity == DoorVelocity::reduced) is_reduced_ = true;
  if (order.battery_power == Enabling::enable) hardware_.use_battery(true);
  if (order.battery_power == Enabling::disable) hardware_.use_battery(false);
  if (always || order.command != last_command_) obey_command(order.command);
}

void CarDoorUnit::obey_command(DoorCommand command) {
  const bool is_known = is_closing(command) || is_opening(command) || is_stop(command) ||
                        command == DoorCommand::reset || command == DoorCommand::no_action;
  if (!is_known || (has_failed_ && command != DoorCommand::reset)) return;
  last_command_ = command;
  if (command == DoorCommand::no_action) return;
  if (command == DoorCommand::reset) return clear_error();
  if (is_stop(command)) {
    limits_force_ = limits_force(command);
    return stop(true);
  }
  go(is_closing(command) ? Goal::close : Goal::open, limits_force(command));
}

void CarDoorUnit::go(Goal goal, bool limits_force) {
  goal_ = goal;
  cause_ = Cause::none;
  limits_force_ = limits_force;
  closes_gently_ = false;
  closes_broken_ = is_error(barrier_);
  unlocking_since_ = never;
  node_.timers().disarm(reclose_);
}

void CarDoorUnit::stop(bool has_torque) {
  go(Goal::stay, limits_force_);
  has_torque_ = has_torque;
}

/// Its command has ended, so that the same command is executed when it is repeated.
void CarDoorUnit::stop_by_itself() {
  last_command_ = DoorCommand::no_action;
  stop(true);
}

void CarDoorUnit::clear_error() {
  stop(false);
  has_failed_ = false;
}

/// 6304h:0Bh.
void CarDoorUnit::lose_controller() {
  last_command_ = DoorCommand::no_action;
  if (has_failed_) return;
  const auto loss = static_cast<HeartbeatLoss>(setting(heartbeat_loss).raw());
  if (loss == HeartbeatLoss::close_with_reduced_speed) {
    go(Goal::close, true);
    closes_gently_ = true;
  } else {
    stop(loss == HeartbeatLoss::stop_with_torque);
  }
  act(node_.now());
}

// Readings, and reactions to them.

void CarDoorUnit::act(Time now) {
  // Hardware that reacts at once has other readings then: a lock that opens allows the door to
  // move.
  for (int looks = 0; looks < looks_max; ++looks) {
    look(now);
    if (readings_.has_fault) fail();
    if (!has_failed_) react(now);
    const DoorState state = next_state(now);
    report_.state = has_failed_ ? DoorState::error : state;
    if (!drive(now)) break;
  }
  tell(now);
  plan(now);
}

void CarDoorUnit::look(Time now) {
  readings_ = hardware_.sense(now);
  if (!detects_motion_) readings_.motion = Detection::not_available;
  if (!protects_fingers_) readings_.finger = Detection::not_available;
  const auto told =
      Values(node_.dictionary())[in_lift(settings_.lift, light_barrier_status(settings_.door))];
  const bool is_told = told.exists() && !told.is(Detection::not_available);
  barrier_ = is_told ? static_cast<Detection>(told.raw()) : readings_.light_barrier;
  if (barrier_is_lost_) barrier_ = Detection::error;
  if (std::exchange(seen_position_, readings_.position_mm) != readings_.position_mm) {
    position_changed_at_ = now;
  }
}

void CarDoorUnit::react(Time now) {
  if (goal_ == Goal::close && cause_ == Cause::none && !readings_.is_closed) react_while_closing();
  if (goal_ == Goal::open && cause_ == Cause::none && !readings_.is_open) react_while_opening();
  await_return(now);
  if (is_moving(report_.state)) check_progress(now);
}

void CarDoorUnit::react_while_closing() {
  const bool is_gentle = is_reduced_ || closes_gently_;
  const bool is_barred = barrier_ == Detection::yes || (is_error(barrier_) && !closes_broken_);
  if (is_barred && !is_gentle) {
    turn(static_cast<DoorReaction>(setting(light_barrier_modus).raw()), Cause::barrier, Goal::open);
  } else if (limits_force_ && readings_.force_limit == Detection::yes) {
    turn(static_cast<DoorReaction>(setting(force_limit_modus).raw()), Cause::force, Goal::open);
  } else if (readings_.motion == Detection::yes) {
    turn(static_cast<DoorReaction>(setting(motion_detection_modus).raw()), Cause::motion,
         Goal::open);
  }
}

/// With a finger drawn in, and with an obstacle in the way: there is nothing to re-open.
void CarDoorUnit::react_while_opening() {
  if (readings_.finger == Detection::yes) {
    turn(static_cast<DoorReaction>(setting(finger_protector_modus).raw()), Cause::finger,
         Goal::close);
  } else if (limits_force_ && readings_.force_limit == Detection::yes &&
             setting(force_limit_modus).is(DoorReaction::stop)) {
    stop_by_itself();
  }
}

void CarDoorUnit::turn(DoorReaction reaction, Cause cause, Goal goal) {
  if (reaction == DoorReaction::stop) return stop_by_itself();
  if (reaction != DoorReaction::turn) return;
  goal_ = goal;
  cause_ = cause;
  closes_gently_ = false;
  reclose_began_ = false;
}

/// For a door that has reversed: returns to its command when the cause is gone or its time is over.
void CarDoorUnit::await_return(Time now) {
  switch (cause_) {
    case Cause::none:
      return;
    case Cause::motion:
      if (readings_.motion != Detection::yes) reclose();
      return;
    case Cause::finger:
      if (readings_.finger != Detection::yes) go(Goal::open, limits_force_);
      return;
    case Cause::force:
      return await_reclose(now, setting(force_limit_reclose).value().value_or(0));
    case Cause::barrier:
      return await_reclose(now, is_error(barrier_)
                                    ? setting(light_barrier_broken_reclose).value().value_or(0)
                                    : setting(light_barrier_reclose).value().value_or(0));
  }
}

/// The time starts when the door is open without an obstacle, and again when the light barrier
/// changes; 0: never.
void CarDoorUnit::await_reclose(Time now, double time) {
  if (!readings_.is_open || (reclose_began_ && reclose_barrier_ == barrier_)) return;
  reclose_began_ = true;
  reclose_barrier_ = barrier_;
  const bool ends = barrier_ != Detection::yes && time > 0;
  node_.timers().arm(reclose_, ends ? now + seconds(time) : never);
}

void CarDoorUnit::reclose() {
  go(Goal::close, limits_force_);
  closes_gently_ = is_error(barrier_);
}

void CarDoorUnit::reclose_expired(Time now) {
  reclose();
  act(now);
}

/// Checks a door that is driven, does not move, and does not report an obstacle.
void CarDoorUnit::check_progress(Time now) {
  const bool moves = readings_.position_mm != moved_position_ || !readings_.position_mm;
  if (moves || readings_.force_limit == Detection::yes ||
      driven_.motion == DoorDrive::Motion::none) {
    moved_position_ = readings_.position_mm;
    moved_at_ = now;
  } else if (now - moved_at_ >= settings_.stall_time) {
    fail();
  }
}

void CarDoorUnit::fail() {
  stop(false);
  has_failed_ = true;
  last_command_ = DoorCommand::no_action;
}

/// True if it waits for its lock, which is stuck if that takes too long.
bool CarDoorUnit::is_unlocking(Time now) {
  if (readings_.lock != Detection::yes) {
    unlocking_since_ = never;
    return false;
  }
  if (unlocking_since_ == never) unlocking_since_ = now;
  if (now - unlocking_since_ >= settings_.lock_time) fail();
  return true;
}

DoorState CarDoorUnit::next_state(Time now) {
  const bool opens = goal_ == Goal::open && !readings_.is_open;
  if (opens && !(readings_.is_closed && is_unlocking(now))) {
    return cause_ == Cause::none ? DoorState::opening : DoorState::re_opening;
  }
  if (goal_ == Goal::close && !readings_.is_closed) return DoorState::closing;
  const bool stays = goal_ == Goal::stay;
  if (readings_.is_closed) {
    const bool has_torque = stays ? has_torque_ : settings_.holds_closed;
    return has_torque ? DoorState::closed_with_torque : DoorState::closed_without_torque;
  }
  if (readings_.is_open) {
    const bool has_torque = stays ? has_torque_ : settings_.holds_open;
    return has_torque ? DoorState::opened_with_torque : DoorState::opened_without_torque;
  }
  return DoorState::stopped;
}

/// True if the hardware got another command.
bool CarDoorUnit::drive(Time now) {
  DoorDrive wanted{.limits_force = limits_force_,
                   .is_reduced = is_reduced_ || closes_gently_,
                   .velocity_profile = setting(door_velocity_profile).raw(),
                   .width_profile = setting(door_width_profile).raw()};
  const DoorState state = report_.state;
  if (state == DoorState::closing) wanted.motion = DoorDrive::Motion::close;
  if (state == DoorState::opening || state == DoorState::re_opening) {
    wanted.motion = DoorDrive::Motion::open;
  }
  wanted.has_torque = state == DoorState::closed_with_torque ||
                      state == DoorState::opened_with_torque || is_moving(state) ||
                      (state == DoorState::stopped && has_torque_);
  const bool locks = locks_ && readings_.is_closed && goal_ != Goal::open;
  const bool is_lock_news = locks != lock_told_ && !has_failed_;
  if (is_lock_news) {
    lock_told_ = locks;
    hardware_.lock(locks, now);
  }
  if (wanted == driven_) return is_lock_news;
  if (wanted.motion != driven_.motion) moved_at_ = now;
  driven_ = wanted;
  hardware_.drive(wanted, now);
  return true;
}

void CarDoorUnit::tell(Time now) {
  report_.force_limit = readings_.force_limit;
  report_.motion_detector = readings_.motion;
  report_.finger_protector = readings_.finger;
  report_.lock = readings_.lock;
  report_.battery_power = readings_.battery;
  report_.safety_contact = readings_.safety_contact;
  const Values values(node_.dictionary());
  const auto word = values[in_lift(settings_.lift, door_statusword(settings_.door))];
  const bool is_news = word.raw() != report_.word();
  if (is_news) word.set_raw(report_.word());
  if (is_news || !is_moving(report_.state) ||
      now - position_told_at_ >= settings_.position_period) {
    position_told_at_ = now;
    const auto position = values[in_lift(settings_.lift, door_position(settings_.door))];
    position.set_raw(readings_.position_mm.value_or(0xFFFF));
  }
  report_defects();
}

void CarDoorUnit::report_defects() {
  const auto instance = static_cast<std::uint16_t>(settings_.door);
  const Error defects[] = {{.code = emergency_code::finger_protector_defect, .instance = instance},
                           {.code = emergency_code::motion_detection_defect, .instance = instance},
                           {.code = emergency_code::application_error, .instance = instance}};
  const std::array<bool, 3> present = {is_error(readings_.finger), is_error(readings_.motion),
                                       has_failed_};
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i] == defects_told_[i]) continue;
    defects_told_[i] = present[i];
    if (present[i]) {
      node_.raise(defects[i]);
    } else {
      node_.clear(defects[i]);
    }
  }
}

/// Sets the time of the next reading.
void CarDoorUnit::plan(Time now) {
  Time next = hardware_.next_change ? hardware_.next_change() : now + settings_.sensing_period;
  if (next <= now) next = now + shortest_look;
  // A stopped door takes a moment to stand: its final position then has to be sent.
  const bool slows_down = report_.state == DoorState::stopped &&
                          now - position_changed_at_ < 2 * settings_.position_period;
  if (is_moving(report_.state) || slows_down) {
    next = std::min(next, now + settings_.position_period);
  }
  if (unlocking_since_ != never) next = std::min(next, unlocking_since_ + settings_.lock_time);
  node_.timers().arm(timer_, next);
}

}  // namespace canvoy::cia417
