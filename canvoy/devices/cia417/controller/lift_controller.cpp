#include "canvoy/devices/cia417/controller/lift_controller.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace canvoy::cia417 {

LiftController::LiftController(Node& node, CallController& calls, const LiftParts& parts,
                               const LiftControllerSettings& settings)
    : node_(node),
      calls_(calls),
      parts_(parts),
      settings_(settings),
      timer_(Callback<void(Time)>::to<&LiftController::expired>(*this)) {
  link_.reset = Callback<void(ResetScope)>::to<&LiftController::reset>(*this);
  link_.state_entered = Callback<void(NmtState)>::to<&LiftController::state_entered>(*this);
  node.attach(link_);
  settings_.floors =
      settings.floors.first(std::min<std::size_t>(settings.floors.size(), FloorSet::floor_max));
  const auto count = static_cast<std::uint8_t>(settings_.floors.size());
  settings_.fire_floor =
      std::clamp<std::uint8_t>(settings.fire_floor, 1, std::max<std::uint8_t>(count, 1));
  settings_.parking_floor = std::min(settings.parking_floor, count);
  calls_.serve_up_to(count);
  calls_.on_change(Callback<void()>::to<&LiftController::update>(*this));
}

void LiftController::reset(ResetScope) {
  node_.timers().disarm(timer_);
  fault_ = latched_ = LiftFault::none;
  service_ = LiftService::normal;
  phase_ = LiftPhase::idle;
  direction_ = Direction::none;
  target_ = 0;
  open_doors_ = settings_.doors;  // what they were told before is not known
  tries_ = 0;
  by_hand_ = end_ = 0;
  promised_ = {};
  is_levelling_ = false;
  is_errand_ = is_cleared_ = is_held_ = nudging_ = ignores_button_ = late_opening_ = late_closing_ =
      false;
  idle_since_ = resume_at_ = node_.now();
}

/// In NMT state operational it drives; when it leaves that, it stands.
void LiftController::state_entered(NmtState state) {
  if (state == NmtState::operational) {
    started_at_ = node_.now();
    // What was under way has been stopped.
    if (phase_ == LiftPhase::driving || phase_ == LiftPhase::manual) phase_ = LiftPhase::idle;
    target_ = 0;
    by_hand_ = end_ = 0;
    promised_ = {};
    is_levelling_ = false;
    return update();
  }
  const bool drives = phase_ == LiftPhase::driving || phase_ == LiftPhase::manual;
  if (drives || is_levelling_) parts_.motion.fast_stop();
  node_.timers().disarm(timer_);
}

void LiftController::update() {
  if (node_.state() != NmtState::operational || settings_.floors.empty()) return;
  // Doors and drive may tell of a change while they are commanded: that is looked at afterwards.
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

void LiftController::look() {
  motion_ = parts_.motion.status();
  doors_ = parts_.doors.status();
  if (parts_.load) load_ = parts_.load();
  watch_position();
  if (!motion_.available) return;
  const std::uint8_t before = floor_;
  // One that has not succeeded lets the lift go on meanwhile.
  constexpr Duration between_levellings = 1s;
  if (motion_.standing && std::exchange(is_levelling_, false)) {
    level_at_ = node_.now() + between_levellings;
  }
  const bool stays = motion_.standing || is_levelling_;
  floor_ = stays ? nearest_floor(motion_.position_micrometre) : reachable_floor();
  const bool drives = phase_ == LiftPhase::driving && !motion_.standing;
  if (drives && floor_ != before) deadline_ = node_.now() + settings_.times.travel_max;
}

/// A position unit that could not send for a while tells where the car was on its way, at last
/// where it is.
void LiftController::watch_position() {
  constexpr std::int32_t noise_micrometre = 1'000;
  const std::int32_t way = motion_.position_micrometre - steady_micrometre_;
  if (motion_.available && std::abs(way) <= noise_micrometre) return;
  steady_micrometre_ = motion_.position_micrometre;
  steady_since_ = node_.now();
}

void LiftController::step() {
  look();
  node_.timers().disarm(timer_);
  const LiftFault fault = find_fault();
  const Time patient_until = started_at_ + settings_.times.start;
  const bool is_early = phase_ == LiftPhase::idle && node_.now() < patient_until;
  if (fault != LiftFault::none && is_early) return wake_at(patient_until);
  change_fault(fault);
  change_service(wanted_service());
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

LiftFault LiftController::find_fault() const {
  if (!motion_.available) return LiftFault::motion;
  const bool moves = !motion_.standing;
  const DoorMask unlocked = settings_.doors & ~doors_.locked;
  const bool is_free = (unlocked & ~doors_.faulty) != 0;
  if (moves && is_free && !is_levelling_in_zone()) return LiftFault::unlocked;
  // A moving car with a door that is not heard ends at the next floor: see drive().
  if ((doors_.faulty & settings_.doors) != 0 && !moves) return LiftFault::door;
  if (!load_.known && !moves) return LiftFault::load;
  return latched_;
}

bool LiftController::is_levelling_in_zone() const {
  const std::int32_t here = motion_.position_micrometre;
  return is_levelling_ &&
         std::abs(here - position_of(nearest_floor(here))) <= settings_.door_zone_micrometre;
}

void LiftController::change_fault(LiftFault fault) {
  if (fault == fault_) return;
  if (fault_ != LiftFault::none) tell_error(static_cast<std::uint16_t>(fault_), false);
  if (fault != LiftFault::none) tell_error(static_cast<std::uint16_t>(fault), true);
  fault_ = fault;
  deadline_ = never;
  if (fault == LiftFault::none) {
    resume_at_ = node_.now() + settings_.times.retry;
    return;
  }
  if (fault == LiftFault::unlocked) latched_ = fault;
  if (!motion_.standing || !motion_.available) parts_.motion.fast_stop();
  direction_ = Direction::none;
  target_ = 0;
  by_hand_ = 0;
  is_errand_ = is_levelling_ = false;
  enter(LiftPhase::stopped);
}

void LiftController::tell_error(std::uint16_t instance, bool present) {
  const Error error{.code = error_code,
                    .instance = instance,
                    .register_bits = error_register::generic | error_register::profile};
  if (present) {
    node_.raise(error);
  } else {
    node_.clear(error);
  }
}

AbortCode LiftController::refuses_lift_number() {
  const MotionStatus motion = parts_.motion.status();
  const bool moves = motion.available && !motion.standing;
  const bool rests = phase_ == LiftPhase::idle || phase_ == LiftPhase::stopped;
  const bool serves = node_.state() == NmtState::operational && !rests;
  return moves || serves ? AbortCode::device_state : AbortCode::none;
}

LiftService LiftController::wanted_service() const {
  const auto on = [&](SpecialFunction function) { return calls_.is_on(function); };
  if (on(SpecialFunction::out_of_order)) return LiftService::out_of_order;
  const bool alarm = on(SpecialFunction::fire_service_enable);
  const bool brigade = on(SpecialFunction::fire_service);
  const bool in_fire_service =
      service_ == LiftService::fire_recall || service_ == LiftService::fire_brigade;
  if (alarm || brigade) {
    // The fire brigade takes the car over at the fire floor, each time anew.
    const bool has_come = in_fire_service && is_cleared_;
    return brigade && has_come ? LiftService::fire_brigade : LiftService::fire_recall;
  }
  // When the keys are turned back it returns to the fire floor first.
  if (in_fire_service && !(is_cleared_ && floor_here() == settings_.fire_floor)) {
    return LiftService::fire_recall;
  }
  if (on(SpecialFunction::service_run)) return LiftService::service_run;
  if (on(SpecialFunction::dogging_service_enable)) return LiftService::dogging;
  if (on(SpecialFunction::special_service)) return LiftService::special;
  if (on(SpecialFunction::bed_passenger_service)) return LiftService::bed_passenger;
  if (on(SpecialFunction::vip_service)) return LiftService::vip;
  if (on(SpecialFunction::attendant_service)) return LiftService::attendant;
  return LiftService::normal;
}

bool LiftController::is_exclusive() const {
  return service_ == LiftService::vip || service_ == LiftService::bed_passenger ||
         service_ == LiftService::special || service_ == LiftService::fire_brigade;
}

CallKinds LiftController::accepted() const {
  if (service_ == LiftService::normal || service_ == LiftService::attendant) return all_calls;
  return is_exclusive() ? car_calls : CallKinds{0};
}

bool LiftController::takes_hall_calls() const {
  // With doors that do not lock it goes nowhere: between floors at once, elsewhere after some
  // tries.
  const bool is_stranded =
      late_closing_ || (motion_.standing && floor_here() == 0 && !is_levelling_ && !is_locked());
  return fault_ == LiftFault::none && !is_stranded && accepted() == all_calls &&
         node_.state() == NmtState::operational &&
         !calls_.is_on(SpecialFunction::hall_call_disable);
}

/// Calls that the new service does not answer are taken back.
void LiftController::change_service(LiftService service) {
  if (calls_.is_on(SpecialFunction::hall_call_disable)) calls_.cancel(hall_calls);
  if (service == service_) return;
  if (service == LiftService::fire_recall || service == LiftService::out_of_order) {
    is_cleared_ = false;
  }
  service_ = service;
  calls_.accept(accepted());
  calls_.cancel(static_cast<CallKinds>(all_calls & ~accepted()));
  // The fire brigade begins without the calls of those who were there before.
  if (service == LiftService::fire_brigade) calls_.cancel(all_calls);
  // Nobody gets in any more.
  if (accepted() == 0) dwell_until_ = std::min(dwell_until_, node_.now());
  idle_since_ = node_.now();
}

void LiftController::show() {
  LiftDisplay& display = calls_.display();
  display.floor = motion_.available ? nearest_floor(motion_.position_micrometre) : 0;
  display.moving = phase_ == LiftPhase::driving || by_hand_ != 0;
  display.direction = direction_;
  const bool stops = phase_ == LiftPhase::opening || phase_ == LiftPhase::open;
  display.lantern_floor = stops ? floor_ : promised_.floor;
  display.lantern_doors = stops ? open_doors_ : promised_.doors;
  const Direction departs = stops ? direction_ : promised_.departure;
  display.lantern = accepted() == all_calls ? departs : Direction::none;
  SpecialIndications specials = 0;
  const auto add = [&](bool is_case, SpecialIndication indication) {
    if (is_case) specials |= indication_bit(indication);
  };
  const bool in_fire =
      service_ == LiftService::fire_recall || service_ == LiftService::fire_brigade;
  add(load_.zero && load_.known, SpecialIndication::no_load);
  add(load_.full && !load_.overload, SpecialIndication::full_load);
  add(load_.overload, SpecialIndication::overload);
  add(in_fire, SpecialIndication::fire);
  add(service_ == LiftService::fire_brigade, SpecialIndication::fire_brigade_service);
  add(calls_.is_help_coming(), SpecialIndication::help_is_coming);
  add(service_ == LiftService::special || service_ == LiftService::service_run ||
          service_ == LiftService::dogging,
      SpecialIndication::special_service);
  add(calls_.is_on(SpecialFunction::load_time_1) || calls_.is_on(SpecialFunction::load_time_2),
      SpecialIndication::load_time);
  add(service_ == LiftService::vip || service_ == LiftService::bed_passenger,
      SpecialIndication::occupied);
  add(service_ == LiftService::out_of_order || fault_ != LiftFault::none,
      SpecialIndication::out_of_order);
  display.specials = specials;
  calls_.show();
}

void LiftController::wake_at(Time at) {
  if (at < timer_.at()) node_.timers().arm(timer_, std::max(at, node_.now()));
}

std::uint8_t LiftController::nearest_floor(std::int32_t position) const {
  const auto above = std::ranges::lower_bound(settings_.floors, position);
  const auto number = static_cast<std::size_t>(above - settings_.floors.begin()) + 1;
  if (number > settings_.floors.size()) return static_cast<std::uint8_t>(number - 1);
  const auto floor = static_cast<std::uint8_t>(number);
  if (floor == 1) return floor;
  const auto below = static_cast<std::uint8_t>(floor - 1);
  return *above - position <= position - position_of(below) ? floor : below;
}

std::uint8_t LiftController::floor_here() const {
  if (!motion_.available || !motion_.standing) return 0;
  const std::uint8_t floor = nearest_floor(motion_.position_micrometre);
  const std::int32_t off = motion_.position_micrometre - position_of(floor);
  return std::abs(off) <= settings_.floor_tolerance_micrometre ? floor : std::uint8_t{0};
}

std::uint8_t LiftController::reachable_floor() const {
  const std::int32_t tolerance = settings_.floor_tolerance_micrometre;
  const std::int32_t stops_at = motion_.stopping_position_micrometre;
  const auto count = static_cast<std::uint8_t>(settings_.floors.size());
  if (motion_.velocity_micrometre_per_second >= 0 && direction_ != Direction::down) {
    const auto floor = std::ranges::lower_bound(settings_.floors, stops_at - tolerance);
    const auto number = static_cast<std::size_t>(floor - settings_.floors.begin()) + 1;
    const std::size_t next = direction_ == Direction::up ? departed_ + std::size_t{1} : 1;
    return static_cast<std::uint8_t>(std::min<std::size_t>(std::max(number, next), count));
  }
  const auto above = std::ranges::upper_bound(settings_.floors, stops_at + tolerance);
  const std::ptrdiff_t next =
      direction_ == Direction::down && departed_ > 1 ? departed_ - 1 : count;
  return static_cast<std::uint8_t>(
      std::clamp<std::ptrdiff_t>(above - settings_.floors.begin(), 1, next));
}

/// The floor with a door that is next to this one, which is asked first; itself where none has one.
std::uint8_t LiftController::nearest_served_floor(std::uint8_t floor) const {
  const auto count = static_cast<unsigned>(settings_.floors.size());
  for (unsigned away = 0; away < count; ++away) {
    const unsigned below = floor > away ? floor - away : 0;
    const unsigned above = floor + away;
    for (const unsigned near : {below, above}) {
      const auto number = static_cast<std::uint8_t>(near);
      const bool is_floor = near >= 1 && near <= count;
      if (is_floor && (calls_.doors_at(number) & settings_.doors) != 0) return number;
    }
  }
  return floor;
}

/// On its way, from a floor on at which it can stop: the first one with a door, where people can
/// get out; behind it, where the rest of the way has none.
std::uint8_t LiftController::next_served_floor(std::uint8_t floor) const {
  const int step = direction_ == Direction::down ? -1 : 1;
  const int count = static_cast<int>(settings_.floors.size());
  for (int next = floor; next >= 1 && next <= count; next += step) {
    const auto number = static_cast<std::uint8_t>(next);
    if ((calls_.doors_at(number) & settings_.doors) != 0) return number;
  }
  return floor;
}

}  // namespace canvoy::cia417
