#include "canvoy/devices/cia417/controller/lift_controller.hpp"

#include <algorithm>
#include <cstdlib>

namespace canvoy::cia417 {

constexpr ServiceHandlers LiftController::service_calls = {
    .reset = method<&LiftController::reset>,
    .state_entered = method<&LiftController::state_entered>};

LiftController::LiftController(Node& node, CallController& calls, const LiftParts& parts,
                               const LiftControllerSettings& settings)
    : node_(node),
      calls_(calls),
      parts_(parts),
      settings_(settings),
      timer_(callback<&LiftController::expired>(*this)),
      faults_(node) {
  node.attach(link_);
  settings_.floors =
      settings.floors.first(std::min<std::size_t>(settings.floors.size(), FloorSet::floor_max));
  const auto count = static_cast<std::uint8_t>(settings_.floors.size());
  settings_.fire_floor =
      std::clamp<std::uint8_t>(settings.fire_floor, 1, std::max<std::uint8_t>(count, 1));
  settings_.parking_floor = std::min(settings.parking_floor, count);
  calls_.serve_up_to(count);
  calls_.on_change(callback<&LiftController::update>(*this));
}

void LiftController::reset(ResetScope) {
  node_.timers().disarm(timer_);
  faults_.begin_anew();
  service_.begin_anew();
  calls_.accept(service_.accepted());
  dwell_.begin_anew();
  hand_.begin_anew();
  levelling_.give_up();
  phase_ = LiftPhase::idle;
  direction_ = Direction::none;
  target_ = 0;
  open_doors_ = settings_.doors;  // their last command is not known
  promised_ = {};
  is_errand_ = false;
  idle_since_ = resume_at_ = node_.now();
}

/// It drives in NMT state operational; when it leaves that state, it stops.
void LiftController::state_entered(NmtState state) {
  if (state == NmtState::operational) {
    started_at_ = node_.now();
    // The present movement has been stopped.
    if (phase_ == LiftPhase::driving || phase_ == LiftPhase::manual) phase_ = LiftPhase::idle;
    target_ = 0;
    hand_.begin_anew();
    promised_ = {};
    levelling_.give_up();
    return update();
  }
  const bool drives = phase_ == LiftPhase::driving || phase_ == LiftPhase::manual;
  if (drives || levelling_.is_under_way()) parts_.motion.fast_stop();
  node_.timers().disarm(timer_);
  changed_();
}

void LiftController::update() {
  if (node_.state() != NmtState::operational || settings_.floors.empty()) return;
  // Doors and drive may report a change during a command: it is evaluated afterwards.
  again_ = true;
  if (is_updating_) return;
  is_updating_ = true;
  for (int i = 0; again_ && i < 20; ++i) {
    again_ = false;
    step();
  }
  is_updating_ = false;
  show();
  changed_();
}

void LiftController::wake_at(Time at) {
  if (at < timer_.at()) node_.timers().arm(timer_, std::max(at, node_.now()));
}

AbortCode LiftController::refuses_lift_number() {
  const MotionStatus motion = parts_.motion.status();
  const bool moves = motion.available && !motion.standing;
  const bool rests = phase_ == LiftPhase::idle || phase_ == LiftPhase::stopped;
  const bool serves = node_.state() == NmtState::operational && !rests;
  return moves || serves ? AbortCode::device_state : AbortCode::none;
}

// Inputs.

void LiftController::look() {
  motion_ = parts_.motion.status();
  doors_ = parts_.doors.status();
  if (parts_.load) load_ = parts_.load();
  watch_position();
  if (!motion_.available) return;
  const std::uint8_t before = floor_;
  if (motion_.standing) levelling_.end(node_.now());
  const bool stays = motion_.standing || levelling_.is_under_way();
  floor_ = stays ? floors().nearest(motion_.position_micrometre)
                 : floors().reachable(motion_, direction_, departed_);
  const bool drives = phase_ == LiftPhase::driving && !motion_.standing;
  if (drives && floor_ != before) deadline_ = node_.now() + settings_.times.travel_max;
}

/// A position unit that could not send for a while first sends positions on the way, and finally
/// the present one.
void LiftController::watch_position() {
  constexpr std::int32_t noise_micrometre = 1'000;
  const std::int32_t way = motion_.position_micrometre - steady_micrometre_;
  if (motion_.available && std::abs(way) <= noise_micrometre) return;
  steady_micrometre_ = motion_.position_micrometre;
  steady_since_ = node_.now();
}

LiftFault LiftController::find_fault() const {
  if (!motion_.available) return LiftFault::motion;
  const bool moves = !motion_.standing;
  const DoorMask unlocked = settings_.doors & ~doors_.locked;
  const bool is_free = (unlocked & ~doors_.faulty) != 0;
  if (moves && is_free && !is_levelling_in_zone()) return LiftFault::unlocked;
  // A moving car with a door that is not received ends at the next floor: see drive().
  if ((doors_.faulty & settings_.doors) != 0 && !moves) return LiftFault::door;
  if (!load_.known && !moves) return LiftFault::load;
  return faults_.latched();
}

bool LiftController::is_levelling_in_zone() const {
  return levelling_.is_under_way() &&
         floors().off_floor(motion_.position_micrometre) <= settings_.door_zone_micrometre;
}

void LiftController::change_fault(LiftFault fault) {
  if (!faults_.change(fault)) return;
  deadline_ = never;
  let_out_ = 0;
  if (fault == LiftFault::none) {
    resume_at_ = node_.now() + settings_.times.retry;
    return;
  }
  parts_.ask_anew();
  ask_at_ = node_.now() + settings_.times.retry;
  if (fault == LiftFault::unlocked) faults_.latch(fault);
  if (!motion_.standing || !motion_.available) parts_.motion.fast_stop();
  direction_ = Direction::none;
  target_ = 0;
  hand_.stop();
  levelling_.give_up();
  is_errand_ = false;
  enter(LiftPhase::stopped);
}

bool LiftController::takes_hall_calls() const {
  // With doors that do not lock it does not move: between floors at once, elsewhere after some
  // tries.
  const bool is_between = motion_.standing && floor_here() == 0 && !levelling_.is_under_way();
  const bool is_stranded = faults_.is_closing_late() || (is_between && !is_locked());
  return !faults_.is_there() && !is_stranded && service_.accepted() == all_calls &&
         node_.state() == NmtState::operational &&
         !calls_.is_on(SpecialFunction::hall_call_disable);
}

/// Calls that the new service does not answer are cancelled.
void LiftController::change_service(LiftService service) {
  if (calls_.is_on(SpecialFunction::hall_call_disable)) calls_.cancel(hall_calls);
  if (!service_.change(service)) return;
  const CallKinds accepted = service_.accepted();
  calls_.accept(accepted);
  calls_.cancel(static_cast<CallKinds>(all_calls & ~accepted));
  // Fire brigade service starts without the calls of earlier passengers.
  if (service == LiftService::fire_brigade) calls_.cancel(all_calls);
  // No further passengers get in.
  if (accepted == 0) dwell_.end(node_.now());
  idle_since_ = node_.now();
}

/// The nearest floor with a door, starting with this one; this one also if there is none.
std::uint8_t LiftController::nearest_served_floor(std::uint8_t floor) const {
  return floors().nearest_where(floor, [this](std::uint8_t near) { return doors_at(near) != 0; });
}

/// The first floor with a door on its way at which it can stop, where passengers can get out; a
/// floor behind it if the rest of the way has none.
std::uint8_t LiftController::next_served_floor(std::uint8_t floor) const {
  return floors().next_where(floor, direction_,
                             [this](std::uint8_t next) { return doors_at(next) != 0; });
}

// Actions, by phase.

void LiftController::step() {
  look();
  node_.timers().disarm(timer_);
  const LiftFault fault = find_fault();
  const Time patient_until = started_at_ + settings_.times.start;
  const bool is_early = phase_ == LiftPhase::idle && node_.now() < patient_until;
  if (fault != LiftFault::none && is_early) return wake_at(patient_until);
  change_fault(fault);
  change_service(service_.wanted(calls_, is_at_fire_floor()));
  act();
}

void LiftController::act() {
  switch (phase_) {
    case LiftPhase::idle:
      return idle();
    case LiftPhase::driving:
      return drive();
    case LiftPhase::opening:
      return await_open();
    case LiftPhase::open:
      return keep_open();
    case LiftPhase::closing:
      return await_closed();
    case LiftPhase::manual:
      return drive_by_hand();
    case LiftPhase::stopped:
      return stand();
  }
}

void LiftController::enter(LiftPhase phase) {
  phase_ = phase;
  promised_ = {};
  again_ = true;
}

void LiftController::idle() {
  if (!motion_.standing) return;
  if (node_.now() < resume_at_) return wake_at(resume_at_);
  // Doors that did not open on command may still do so.
  if (!is_locked() || open_doors_ != 0) return close_doors();
  if (service_.is_manual()) return enter(LiftPhase::manual);
  const std::uint8_t floor = floor_here();
  if (floor != 0) return begin_trip(floor);
  // Between floors, after a fault: moves to the next one, and continues from there.
  is_errand_ = true;
  go_to(nearest_served_floor(floors().nearest(motion_.position_micrometre)));
}

void LiftController::drive() {
  if (service_.is_manual()) return break_off();
  if (motion_.standing) return arrive();
  if (node_.now() >= deadline_) {
    faults_.latch(LiftFault::travel_time);
    again_ = true;
    return;
  }
  wake_at(deadline_);
  follow_calls();
}

/// The inspection control ends a trip, one that has not begun as well (EN 81-20, 5.12.1.5.2.1).
void LiftController::break_off() {
  parts_.motion.stop();
  direction_ = Direction::none;
  target_ = 0;
  is_errand_ = false;
  enter(LiftPhase::idle);
}

void LiftController::await_open() {
  if (relevel()) return wake_at(deadline_);
  if ((open_doors_ & ~doors_.open) == 0) {
    faults_.doors_opened(true);
    dwell_.opened(node_.now());
    return enter(LiftPhase::open);
  }
  answer_here();
  if (node_.now() < deadline_) return wake_at(deadline_);
  parts_.ask_anew();
  faults_.doors_opened(false);
  close_doors();
}

void LiftController::keep_open() {
  if (relevel()) return;
  const Time now = node_.now();
  if (service_.clear(is_at_fire_floor())) again_ = true;  // the service may end with it
  if (answer_here() || is_barred() || is_open_wanted()) {
    dwell_.prolong(now + settings_.times.dwell_again);
  }
  const bool is_held = load_.overload || service_.keeps_doors_open(calls_, is_at_fire_floor());
  if (dwell_.hold(is_held, now)) return;
  const bool hurries = calls_.is_on(SpecialFunction::door_close) && !is_barred();
  const bool ends =
      dwell_.ends(now, settings_.times.nudging, calls_.is_on(SpecialFunction::door_open));
  if (ends || hurries) return close_doors();
  wake_at(dwell_.next(settings_.times.nudging));
}

void LiftController::await_closed() {
  if (is_locked()) {
    faults_.doors_closed(true);
    dwell_.closed();
    open_doors_ = 0;
    idle_since_ = node_.now();
    return enter(LiftPhase::idle);
  }
  const bool is_late = node_.now() >= deadline_;
  if (!is_late && !should_open()) {
    // A light barrier that fails on the way slows the doors down.
    if (closing_ == DoorClosing::normal && wanted_closing() != closing_) return close_doors();
    return wake_at(deadline_);
  }
  if (is_late) parts_.ask_anew();
  if (is_late && dwell_.was_late()) faults_.doors_closed(false);
  const std::uint8_t floor = floor_here();
  // Between floors no passenger gets out: it only tries again.
  if (floor == 0) return is_late ? close_doors() : wake_at(deadline_);
  dwell_.open_again(settings_.times.dwell_again);
  open_doors(open_doors_ != 0 ? open_doors_ : doors_at(floor));
}

/// Driven by two buttons: see HandDrive. Stations that are on together must agree (EN 81-20,
/// 5.12.1.5).
void LiftController::drive_by_hand() {
  departed_ = 0;
  const SpecialFunction key = service_.is(LiftService::dogging)
                                  ? SpecialFunction::dogging_service_enable
                                  : SpecialFunction::service_run;
  const bool up = calls_.is_on_wherever(key, SpecialFunction::dogging_service_up);
  const bool down = calls_.is_on_wherever(key, SpecialFunction::dogging_service_down);
  const bool may_move = service_.is_manual() && is_locked() && up != down;
  const int wanted = up ? 1 : -1;
  if (hand_.obey(may_move ? wanted : 0, motion_.stopping_position_micrometre, floors())) {
    direction_ = static_cast<Direction>(hand_.direction());
    const std::int32_t speed = service_.is(LiftService::dogging)
                                   ? settings_.dogging_speed_micrometre_per_second
                                   : settings_.service_speed_micrometre_per_second;
    if (hand_.direction() == 0) {
      parts_.motion.stop();
    } else {
      parts_.motion.run(hand_.direction() * speed);
    }
  }
  if (!service_.is_manual() && motion_.standing) enter(LiftPhase::idle);
}

/// Stops on a fault. After its end, the lift continues after a while.
void LiftController::stand() {
  if (!faults_.is_there()) {
    if (node_.now() < resume_at_) return wake_at(resume_at_);
    idle_since_ = node_.now();
    return enter(LiftPhase::idle);
  }
  ask_while_it_waits();
  let_out();
  if (faults_.latched() == LiftFault::none || !motion_.standing || !motion_.available) return;
  if (deadline_ == never) deadline_ = node_.now() + settings_.times.retry;
  if (node_.now() < deadline_) return wake_at(deadline_);
  faults_.latch(LiftFault::none);
  again_ = true;
}

// Movement of the car.

void LiftController::begin_trip(std::uint8_t floor) {
  const DoorMask here = doors_at(floor);
  if (service_.is(LiftService::out_of_order)) {
    if (service_.is_cleared()) return;
    return here != 0 ? stop_at(floor, here) : leave_for_a_door(floor);
  }
  if (load_.overload) return here != 0 ? stop_at(floor, here) : void();
  if (is_open_wanted() && here != 0) {
    const DoorMask held = calls_.held_doors(SpecialFunction::door_open) & here;
    return stop_at(floor, held != 0 ? held : here);
  }
  // The fire brigade opens with the button, also at the present floor.
  if (service_.is(LiftService::fire_brigade)) calls_.answered(floor, Direction::none);
  const NextStop stop = wanted_stop(floor, false);
  if (stop.floor == 0) return park(floor);
  if (stop.floor == floor) return stop.doors != 0 ? stop_at(floor, stop.doors) : void();
  is_errand_ = false;
  go_to(stop.floor);
}

/// The car stands where it has no door: passengers get out at the nearest floor that has one.
void LiftController::leave_for_a_door(std::uint8_t floor) {
  const std::uint8_t nearest = nearest_served_floor(floor);
  if (nearest == floor) return;
  is_errand_ = true;
  go_to(nearest);
}

void LiftController::park(std::uint8_t floor) {
  direction_ = Direction::none;
  const bool away = settings_.parking_floor != 0 && settings_.parking_floor != floor;
  if (!away || !service_.is(LiftService::normal)) return;
  const Time at = idle_since_ + settings_.times.parking;
  if (node_.now() < at) return wake_at(at);
  is_errand_ = true;
  go_to(settings_.parking_floor);
}

void LiftController::go_to(std::uint8_t floor) {
  target_ = floor;
  // It does not return to the floor that it has just left, even for a late call there.
  departed_ = floor_here();
  const std::int32_t position = floors().position_of(floor);
  const std::int32_t here = motion_.position_micrometre;
  if (position != here) direction_ = position > here ? Direction::up : Direction::down;
  deadline_ = node_.now() + settings_.times.travel_max;
  enter(LiftPhase::driving);
  parts_.motion.travel_to(position);
}

/// Handles changes while the car moves: calls on its way, or none left.
void LiftController::follow_calls() {
  const std::int32_t left = motion_.stopping_position_micrometre - floors().position_of(target_);
  const bool ends = (doors_.faulty & settings_.doors) != 0 || !load_.known;
  if (std::abs(left) <= settings_.floor_tolerance_micrometre) {
    promised_ = ends ? NextStop{} : promised_stop();
    return;
  }
  const std::uint8_t reachable = floors().reachable(motion_, direction_, departed_);
  const NextStop stop =
      ends ? NextStop{.floor = next_served_floor(reachable)} : wanted_stop(reachable, true);
  const bool is_called = stop.doors != 0 || ends || service_.is(LiftService::fire_recall) ||
                         service_.is(LiftService::out_of_order);
  if (stop.floor == 0 || stop.floor == target_ || (is_errand_ && !is_called)) return;
  is_errand_ = false;
  target_ = stop.floor;
  parts_.motion.travel_to(floors().position_of(target_));
}

/// When the drive reports its arrival, or has given up: at its target, the car has arrived in both
/// cases; where it departed, in neither, whatever its drive reports.
void LiftController::arrive() {
  const std::uint8_t floor = floor_here();
  const bool has_arrived = motion_.arrived && floor != departed_;
  if (floor == 0 || (!has_arrived && floor != target_)) {
    faults_.latch(LiftFault::position);
    again_ = true;
    return;
  }
  target_ = 0;
  is_errand_ = false;
  idle_since_ = node_.now();
  // The direction shown by the lantern holds while there are calls for it.
  if (promised_.departure != Direction::none) direction_ = promised_.departure;
  // The fire brigade opens the door itself, after a check of the area behind it.
  if (service_.is(LiftService::fire_brigade)) calls_.answered(floor, Direction::none);
  const NextStop stop = wanted_stop(floor, false);
  // It stands, even if the requested doors do not belong to the car.
  enter(LiftPhase::idle);
  if (stop.floor == floor && stop.doors != 0) stop_at(floor, stop.doors);
}

/// The stop to which the car slows down, for passengers who see its lantern there: its further
/// direction stays the same while there are calls for it. None if no door will open.
NextStop LiftController::promised_stop() const {
  CollectiveCar car = car_at(target_, true);
  if (promised_.departure != Direction::none) car.direction = promised_.departure;
  const NextStop stop = next_stop(calls_.calls(), car);
  return stop.floor == target_ && stop.doors != 0 ? stop : NextStop{};
}

/// The next stop in the present service: one floor for the fire recall, the first one when out of
/// order.
NextStop LiftController::wanted_stop(std::uint8_t floor, bool moving) const {
  if (service_.is(LiftService::out_of_order)) {
    return {.floor = moving ? next_served_floor(floor) : std::uint8_t{0}};
  }
  if (!service_.is(LiftService::fire_recall))
    return next_stop(calls_.calls(), car_at(floor, moving));
  const std::uint8_t fire_floor = settings_.fire_floor;
  const bool lies_behind = direction_ == Direction::up ? fire_floor < floor : fire_floor > floor;
  if (moving && lies_behind) return {.floor = floor};
  if (service_.is_cleared()) return {};
  return {.floor = fire_floor, .doors = doors_at(fire_floor)};
}

CollectiveCar LiftController::car_at(std::uint8_t floor, bool moving) const {
  const bool takes = !is_full() && service_.accepted() == all_calls;
  return {.floor = floor, .direction = direction_, .moving = moving, .takes_hall_calls = takes};
}

// Movement of its doors.

/// Answers the calls of this stop, and opens.
void LiftController::stop_at(std::uint8_t floor, DoorMask doors) {
  direction_ = departure(calls_.calls(), car_at(floor, false));
  const auto kinds = static_cast<CallKinds>(answered_calls(direction_) & service_.accepted());
  const CallKinds there =
      calls_.calls().doors_at(floor, hall_calls & kinds) != 0 ? hall_calls : car_calls;
  dwell_.begin(dwell_for(there));
  calls_.ring(floor, doors, direction_);
  calls_.answered(floor, direction_, kinds);
  open_doors(doors);
  report_stop(floor, open_doors_);
}

void LiftController::report_stop(std::uint8_t floor, DoorMask doors) {
  if (service_.accepted() == all_calls) stopped_({floor, direction_}, doors);
}

void LiftController::open_doors(DoorMask doors) {
  const auto wanted = static_cast<DoorMask>(doors & settings_.doors);
  if (floor_here() == 0 || wanted == 0) return;
  open_doors_ = wanted;
  deadline_ = node_.now() + settings_.times.door_opens_max;
  enter(LiftPhase::opening);
  parts_.doors.open(open_doors_);
}

void LiftController::close_doors() {
  deadline_ = node_.now() + settings_.times.door_closes_max;
  enter(LiftPhase::closing);
  closing_ = wanted_closing();
  parts_.doors.close(settings_.doors, closing_);
}

/// The message of the end of a fault may have been lost.
void LiftController::ask_while_it_waits() {
  if (node_.now() >= ask_at_) {
    parts_.ask_anew();
    ask_at_ = node_.now() + settings_.times.retry;
  }
  wake_at(ask_at_);
}

/// Lets passengers out of the car of a lift with a fault, if it is at a floor.
void LiftController::let_out() {
  const std::uint8_t floor = floor_here();
  if (floor == 0) return;
  const Time steady_at = steady_since_ + settings_.times.steady;
  if (node_.now() < steady_at) return wake_at(steady_at);
  const auto doors = static_cast<DoorMask>(doors_at(floor) & ~doors_.faulty & ~let_out_);
  if (doors == 0) return;
  let_out_ |= doors;
  open_doors_ |= doors;
  parts_.doors.open(doors);
}

/// True if it is on its way back to its floor.
bool LiftController::relevel() {
  if (levelling_.is_under_way()) return true;
  const std::int32_t here = motion_.position_micrometre;
  const bool is_off = !floors().is_at_floor(here);
  const bool is_in_zone = floors().off_floor(here) <= settings_.door_zone_micrometre;
  if (!motion_.standing || !is_off || !is_in_zone) return false;
  if (node_.now() < levelling_.may_begin_at()) {
    wake_at(levelling_.may_begin_at());
    return false;
  }
  levelling_.begin();
  again_ = true;
  parts_.motion.travel_to(floors().position_of(floors().nearest(here)));
  return true;
}

/// A call at this floor that the stop answers as well.
bool LiftController::answer_here() {
  const std::uint8_t floor = floor_here();
  if (floor == 0) return false;
  if (direction_ == Direction::none) direction_ = departure(calls_.calls(), car_at(floor, false));
  const auto kinds = static_cast<CallKinds>(answered_calls(direction_) & service_.accepted());
  const DoorMask doors = calls_.calls().doors_at(floor, kinds);
  if (doors == 0) return false;
  calls_.answered(floor, direction_, kinds);
  const auto more = static_cast<DoorMask>(doors & settings_.doors & ~open_doors_);
  if (more != 0 && phase_ != LiftPhase::closing) open_doors(open_doors_ | more);
  open_doors_ |= more;
  report_stop(floor, open_doors_);
  return true;
}

/// During closing.
bool LiftController::should_open() {
  const bool is_released =
      service_.is(LiftService::fire_brigade) && !calls_.is_on(SpecialFunction::door_close);
  if (load_.overload || is_released) return true;
  return !dwell_.is_nudging() && (is_barred() || is_open_wanted() || answer_here());
}

DoorClosing LiftController::wanted_closing() const {
  if (dwell_.is_nudging() || service_.distrusts_barriers()) return DoorClosing::nudging;
  const bool is_unprotected = (doors_.unprotected & settings_.doors) != 0;
  return is_unprotected ? DoorClosing::gentle : DoorClosing::normal;
}

Duration LiftController::dwell_for(CallKinds kinds) const {
  const bool long_load =
      calls_.is_on(SpecialFunction::load_time_1) || calls_.is_on(SpecialFunction::load_time_2);
  if (long_load || service_.is(LiftService::bed_passenger)) return settings_.times.dwell_long;
  return (kinds & hall_calls) != 0 ? settings_.times.dwell_hall : settings_.times.dwell_car;
}

}  // namespace canvoy::cia417
