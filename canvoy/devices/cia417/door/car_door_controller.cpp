#include "canvoy/devices/cia417/door/car_door_controller.hpp"

#include <algorithm>

#include "canvoy/profiles/cia417/pdos.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia417 {

namespace {

/// Time between a controlword that makes a door accept a command again and the command itself: more
/// than an inhibit time.
constexpr Duration order_gap = 50ms;
/// A door has answered within this time, or has not received the request.
constexpr Duration answer_time = 500ms;

constexpr DoorMask mask_of(unsigned door) {
  return static_cast<DoorMask>(1U << (door - 1));
}

/// Number of the RPDO for `object` of a door; 0: not known.
constexpr std::uint16_t rpdo_of(unsigned lift, const ObjectInfo& object, unsigned door) {
  for (const LiftPdo& row : lift_pdo_table<1>) {
    if (row.mapping[0] == mapped_in(1, object, door)) return number_in_lift(row, lift);
  }
  return 0;
}

bool closes(DoorCommand command) {
  return command == DoorCommand::close_with_limit_force ||
         command == DoorCommand::close_without_limit_force;
}
bool opens(DoorCommand command) {
  return command == DoorCommand::open_with_limit_force ||
         command == DoorCommand::open_without_limit_force;
}

/// True if the door executes its command, or has done so.
bool follows(DoorState state, DoorCommand command) {
  if (closes(command)) return state == DoorState::closing || is_closed(state);
  if (opens(command)) {
    return state == DoorState::opening || state == DoorState::re_opening || is_open(state);
  }
  return state != DoorState::error;
}

/// True with an obstacle on which a door must not close.
bool is_barred(const DoorView& view) {
  return view.light_barrier == Detection::yes || view.report.motion_detector == Detection::yes ||
         view.report.force_limit == Detection::yes;
}
bool is_obstructed(const DoorView& view) {
  return is_barred(view) || view.report.finger_protector == Detection::yes;
}
bool is_faulty(const DoorView& view) {
  return !view.is_known || view.report.state == DoorState::error ||
         view.report.state == DoorState::not_available;
}
/// A lock that is not installed is ignored, and not required.
bool is_locked(const DoorView& view) {
  return view.is_known && is_closed(view.report.state) &&
         view.report.safety_contact == Detection::yes &&
         (view.report.lock == Detection::yes || view.report.lock == Detection::not_available);
}

Disabling enabling(bool enabled) {
  return enabled ? Disabling::enable : Disabling::disable;
}

}  // namespace

constexpr AccessHandlers CarDoorController::hook_calls[] = {
    after_write<&CarDoorController::state_received, door_statusword>,
    after_write<&CarDoorController::received, door_statusword_object, door_position_object>,
    after_write<&CarDoorController::received, light_barrier_status>};
constexpr ServiceHandlers CarDoorController::service_calls = {
    .reset = method<&CarDoorController::reset_state>,
    .state_entered = method<&CarDoorController::state_entered>,
    .error_changed = method<&CarDoorController::error_changed>,
    .hooks = hook_calls};

CarDoorController::CarDoorController(Node& node, const CarDoorControllerSettings& settings,
                                     Rpdos* rpdos)
    : node_(node),
      settings_(settings),
      rpdos_(rpdos),
      timer_(callback<&CarDoorController::expired>(*this)) {
  node.attach(service_);
}

void CarDoorController::reset_state(ResetScope scope) {
  if (scope != ResetScope::node) return;
  doors_ = {};
  node_.timers().disarm(timer_);
}

void CarDoorController::state_entered(NmtState state) {
  if (state != NmtState::operational) return;
  for (unsigned door = 1; door <= door_count; ++door) {
    doors_[door - 1].reported_at = node_.now();
    ask(door);
  }
  plan();
}

void CarDoorController::begin_anew() {
  for (unsigned door = 1; door <= door_count; ++door) {
    doors_[door - 1].view.is_known = false;
    ask(door);
    refresh(door);
  }
  plan();
}

void CarDoorController::error_changed(const Error& error, bool present) {
  if (error.code != canvoy::emergency_code::heartbeat) return;
  for (unsigned number = 1; number <= door_count; ++number) {
    Door& door = doors_[number - 1];
    const bool is_unit = error.instance == settings_.door_units[number - 1];
    const bool is_barrier = error.instance == settings_.light_barrier_units[number - 1];
    if ((!is_unit && !is_barrier) || (settings_.doors & mask_of(number)) == 0) continue;
    if (is_unit) door.is_lost = present;
    if (is_barrier) door.barrier_is_lost = present;
    if (is_unit) door.view.is_known = false;
    if (!present) ask(number);
    refresh(number);
  }
  plan();
}

void CarDoorController::heard(NodeId node, RemoteState state) {
  for (unsigned number = 1; number <= door_count; ++number) {
    if ((settings_.doors & mask_of(number)) == 0) continue;
    const bool is_unit = node == settings_.door_units[number - 1];
    const bool is_barrier = node == settings_.light_barrier_units[number - 1];
    if (is_unit && state == RemoteState::boot_up) forget(number);
    if ((is_unit || is_barrier) && state == RemoteState::operational) ask(number);
  }
}

void CarDoorController::ask_anew() {
  for (unsigned number = 1; number <= door_count; ++number) ask(number);
}

void CarDoorController::forget(unsigned number) {
  doors_[number - 1].view.is_known = false;
  refresh(number);
  plan();
}

void CarDoorController::state_received(const Entry& entry) {
  if (!has_door(entry.sub)) return;
  Door& door = doors_[entry.sub - 1U];
  door.view.is_known = !door.is_lost;
}

void CarDoorController::received(const Entry& entry) {
  if (has_door(entry.sub)) refresh(entry.sub);
}

bool CarDoorController::has_door(unsigned number) const {
  return number >= 1 && number <= door_count && (settings_.doors & mask_of(number)) != 0;
}

/// Evaluates the state received from a door, and reports a change.
void CarDoorController::refresh(unsigned number) {
  Door& door = doors_[number - 1];
  const Values values(node_.dictionary());
  DoorView view;
  view.is_known = door.view.is_known && !door.is_lost;
  if (view.is_known) {
    view.report = DoorReport::of(values[in_lift(settings_.lift, door_statusword(number))].raw());
    const auto position = values[in_lift(settings_.lift, door_position(number))];
    if (position.is_valid()) view.position_mm = position.raw();
  }
  const auto barrier = values[in_lift(settings_.lift, light_barrier_status(number))];
  if (barrier.exists()) view.light_barrier = static_cast<Detection>(barrier.raw());
  if (door.barrier_is_lost) view.light_barrier = Detection::error;
  if (view == door.view) return;
  door.view = view;
  react(number);
  changed_();
}

/// A door that meets an obstacle is opened without a command.
void CarDoorController::react(unsigned number) {
  const Door& door = doors_[number - 1];
  const bool gives_way =
      closes(door.order.command) && door.closing != DoorClosing::nudging && settings_.reopens;
  if (gives_way && door.view.is_known && !is_closed(door.view.report.state) &&
      is_barred(door.view)) {
    open(mask_of(number));
  }
  const bool has_nudged = door.closing == DoorClosing::nudging && closes(door.order.command) &&
                          door.view.is_known && is_closed(door.view.report.state);
  // Switched off, it would report no defect until the next closing of the door.
  if (has_nudged && door.order.motion_detector != enabling(true)) {
    enable_motion_detector(mask_of(number));
  }
  plan();
}

// Commands.

template <class Change>
void CarDoorController::change(DoorMask doors, const Change& change) {
  for (unsigned door = 1; door <= door_count; ++door) {
    if ((doors & settings_.doors & mask_of(door)) == 0) continue;
    DoorOrder wanted = doors_[door - 1].order;
    change(wanted);
    order(door, wanted);
  }
  plan();
}

void CarDoorController::open(DoorMask doors, Force force) {
  change(doors, [force](DoorOrder& order) {
    order.command = force == Force::limited ? DoorCommand::open_with_limit_force
                                            : DoorCommand::open_without_limit_force;
    order.velocity = DoorVelocity::standard;
  });
}

void CarDoorController::close(DoorMask doors, DoorClosing closing, Force force) {
  for (unsigned door = 1; door <= door_count; ++door) {
    if ((doors & mask_of(door)) != 0) doors_[door - 1].closing = closing;
  }
  change(doors, [force, closing](DoorOrder& order) {
    order.command = force == Force::limited ? DoorCommand::close_with_limit_force
                                            : DoorCommand::close_without_limit_force;
    const bool is_fast = closing == DoorClosing::normal;
    order.velocity = is_fast ? DoorVelocity::standard : DoorVelocity::reduced;
    order.motion_detector = enabling(closing != DoorClosing::nudging);
  });
}

void CarDoorController::stop(DoorMask doors, Force force) {
  change(doors, [force](DoorOrder& order) {
    order.command = force == Force::limited ? DoorCommand::stop_with_limit_force
                                            : DoorCommand::stop_without_limit_force;
  });
}

void CarDoorController::reset(DoorMask doors) {
  change(doors, [](DoorOrder& order) { order.command = DoorCommand::reset; });
}
void CarDoorController::lock(DoorMask doors, bool locks) {
  change(doors, [locks](DoorOrder& order) { order.lock = enabling(locks); });
}
void CarDoorController::enable_motion_detector(DoorMask doors, bool enabled) {
  change(doors, [enabled](DoorOrder& order) { order.motion_detector = enabling(enabled); });
}
void CarDoorController::enable_finger_protector(DoorMask doors, bool enabled) {
  change(doors, [enabled](DoorOrder& order) { order.finger_protector = enabling(enabled); });
}
void CarDoorController::enable_battery(DoorMask doors, bool enabled) {
  change(doors, [enabled](DoorOrder& order) {
    order.battery_power = enabled ? Enabling::enable : Enabling::disable;
  });
}

void CarDoorController::order(unsigned number, const DoorOrder& order) {
  Door& door = doors_[number - 1];
  const bool is_new = order != door.order;
  const bool is_command = order.command != door.order.command;
  door.order = order;
  if (is_command) return tell(number);
  const bool answers = node_.now() - door.reported_at < answer_time ||
                       follows(door.view.report.state, order.command);
  if (!answers) return report_again(number);
  if (is_new && door.report_at == never) tell(number);
}

void CarDoorController::tell(unsigned number) {
  Door& door = doors_[number - 1];
  door.reported_at = node_.now();
  door.report_at = never;
  Values(node_.dictionary())[in_lift(settings_.lift, door_controlword(number))].set_raw(
      door.order.word());
}

/// A door ignores a command that it already has: another one comes first.
void CarDoorController::report_again(unsigned number) {
  Door& door = doors_[number - 1];
  DoorOrder first = door.order;
  const bool has_error = door.view.report.state == DoorState::error;
  first.command = has_error ? DoorCommand::reset : DoorCommand::no_action;
  door.reported_at = node_.now();
  door.report_at = node_.now() + order_gap;
  Values(node_.dictionary())[in_lift(settings_.lift, door_controlword(number))].set_raw(
      first.word());
}

/// Requests its state by remote frame.
void CarDoorController::ask(unsigned number) {
  if (rpdos_ == nullptr || (settings_.doors & mask_of(number)) == 0) return;
  const std::uint16_t status = rpdo_of(settings_.lift, door_statusword_object, number);
  const std::uint16_t barrier = rpdo_of(settings_.lift, light_barrier_status_object, number);
  if (status != 0) rpdos_->request(status);
  if (barrier != 0 && settings_.light_barrier_units[number - 1] != 0) rpdos_->request(barrier);
}

void CarDoorController::expired(Time now) {
  for (unsigned number = 1; number <= door_count; ++number) {
    if ((settings_.doors & mask_of(number)) == 0) continue;
    Door& door = doors_[number - 1];
    if (door.report_at <= now) {
      tell(number);
    } else if (door.report_at == never && now - door.reported_at >= settings_.repeat_time) {
      door.reported_at = now;
      ask(number);
      const bool is_barred_now = closes(door.order.command) && is_barred(door.view);
      if (!follows(door.view.report.state, door.order.command) && !is_barred_now) {
        report_again(number);
      }
    }
  }
  plan();
}

/// The next time at which a door gets a command, if its state does not change before.
void CarDoorController::plan() {
  Time next = never;
  for (unsigned number = 1; number <= door_count; ++number) {
    const Door& door = doors_[number - 1];
    if ((settings_.doors & mask_of(number)) == 0) continue;
    next = std::min(next, door.report_at);
    const bool is_done = door.view.is_known && follows(door.view.report.state, door.order.command);
    if (!is_done) next = std::min(next, door.reported_at + settings_.repeat_time);
  }
  node_.timers().arm(timer_, next);
}

DoorsStatus CarDoorController::status() const {
  DoorsStatus status;
  for (unsigned number = 1; number <= door_count; ++number) {
    const DoorMask bit = settings_.doors & mask_of(number);
    const DoorView& view = doors_[number - 1].view;
    const DoorState state = view.report.state;
    if (is_locked(view)) status.locked |= bit;
    if (view.is_known && cia417::is_open(state)) status.open |= bit;
    if (view.is_known && is_moving(state)) status.moving |= bit;
    if (is_obstructed(view)) status.obstructed |= bit;
    if (is_faulty(view)) status.faulty |= bit;
    if (view.light_barrier == Detection::error) status.unprotected |= bit;
  }
  return status;
}

LiftDoors CarDoorController::interface() {
  using Self = CarDoorController;
  return {.open = callback<&Self::open_for_lift>(*this),
          .close = callback<&Self::close_for_lift>(*this),
          .stop = callback<&Self::stop_for_lift>(*this),
          .status = callback<&Self::status_for_lift>(*this)};
}

}  // namespace canvoy::cia417
