// What the doors do at a stop: LiftController from arriving to leaving.
#include <algorithm>
#include <utility>

#include "canvoy/devices/cia417/controller/lift_controller.hpp"

namespace canvoy::cia417 {

/// Answers the calls of this stop, and opens.
void LiftController::stop_at(std::uint8_t floor, DoorMask doors) {
  direction_ = departure(calls_.calls(), car_at(floor, false));
  const auto kinds = static_cast<CallKinds>(answered_calls(direction_) & accepted());
  const CallKinds there =
      calls_.calls().doors_at(floor, hall_calls & kinds) != 0 ? hall_calls : car_calls;
  dwell_ = dwell_for(there);
  tries_ = 0;
  nudging_ = false;
  calls_.ring(floor, doors, direction_);
  calls_.answered(floor, direction_, kinds);
  open_doors(doors);
  tell_stop(floor, open_doors_);
}

void LiftController::tell_stop(std::uint8_t floor, DoorMask doors) {
  if (accepted() == all_calls) stopped_({floor, direction_}, doors);
}

void LiftController::open_doors(DoorMask doors) {
  const auto wanted = static_cast<DoorMask>(doors & settings_.doors);
  if (floor_here() == 0 || wanted == 0) return;
  open_doors_ = wanted;
  deadline_ = node_.now() + settings_.times.door_opens_max;
  enter(LiftPhase::opening);
  parts_.doors.open(open_doors_);
}

/// Whether it is on its way back to its floor, from where those who got in or out have brought it.
bool LiftController::relevel() {
  if (is_levelling_) return true;
  const std::int32_t floor = position_of(nearest_floor(motion_.position_micrometre));
  const std::int32_t off = std::abs(motion_.position_micrometre - floor);
  const bool is_off = off > settings_.floor_tolerance_micrometre;
  if (!motion_.standing || !is_off || off > settings_.door_zone_micrometre) return false;
  if (node_.now() < level_at_) {
    wake_at(level_at_);
    return false;
  }
  is_levelling_ = true;
  again_ = true;
  parts_.motion.travel_to(floor);
  return true;
}

void LiftController::await_open() {
  if (relevel()) return wake_at(deadline_);
  if ((open_doors_ & ~doors_.open) == 0) {
    opened(true);
    if (tries_ == 0) opened_at_ = node_.now();
    is_held_ = false;
    dwell_until_ = node_.now() + dwell_;
    return enter(LiftPhase::open);
  }
  answer_here();
  if (node_.now() < deadline_) return wake_at(deadline_);
  opened(false);
  close_doors();
}

void LiftController::keep_open() {
  if (relevel()) return;
  const Time now = node_.now();
  const Time longer = now + settings_.times.dwell_again;
  const bool recalled =
      service_ == LiftService::fire_recall && floor_here() == settings_.fire_floor;
  if ((recalled || service_ == LiftService::out_of_order) && !is_cleared_) {
    is_cleared_ = true;
    again_ = true;  // the service may end with it
  }
  const bool is_barred = is_obstructed() && !distrusts_barriers();
  if (answer_here() || is_barred || is_open_wanted()) {
    dwell_until_ = std::max(dwell_until_, longer);
  }
  // Nobody is in the way of doors that have to stay open: nudging counts from the end of that.
  const bool was_held = std::exchange(is_held_, load_.overload || must_stay_open());
  if (is_held_) return;
  if (was_held) opened_at_ = now;
  const bool hurries = calls_.is_on(SpecialFunction::door_close) && !is_barred;
  const Time nudge_at = opened_at_ + std::max(settings_.times.nudging, dwell_);
  nudging_ = now >= nudge_at;
  if (nudging_) ignores_button_ = calls_.is_on(SpecialFunction::door_open);
  if (nudging_ || hurries || now >= dwell_until_) return close_doors();
  wake_at(dwell_until_);
  wake_at(nudge_at);
}

void LiftController::close_doors() {
  deadline_ = node_.now() + settings_.times.door_closes_max;
  enter(LiftPhase::closing);
  closing_ = wanted_closing();
  parts_.doors.close(settings_.doors, closing_);
}

DoorClosing LiftController::wanted_closing() const {
  if (nudging_ || distrusts_barriers()) return DoorClosing::nudging;
  const bool is_unprotected = (doors_.unprotected & settings_.doors) != 0;
  return is_unprotected ? DoorClosing::gentle : DoorClosing::normal;
}

void LiftController::await_closed() {
  if (is_locked()) {
    closed(true);
    tries_ = 0;
    nudging_ = false;
    open_doors_ = 0;
    idle_since_ = node_.now();
    return enter(LiftPhase::idle);
  }
  const bool is_late = node_.now() >= deadline_;
  if (!is_late && !should_open()) {
    // A light barrier that breaks on the way slows them down.
    if (closing_ == DoorClosing::normal && wanted_closing() != closing_) return close_doors();
    return wake_at(deadline_);
  }
  if (is_late && ++tries_ >= 3) closed(false);
  const std::uint8_t floor = floor_here();
  // Nobody gets out between floors: it only tries again.
  if (floor == 0) return is_late ? close_doors() : wake_at(deadline_);
  dwell_ = settings_.times.dwell_again;
  open_doors(open_doors_ != 0 ? open_doors_ : calls_.doors_at(floor));
}

void LiftController::tell_late(std::uint16_t instance, bool& told, bool late) {
  if (late != told) tell_error(instance, late);
  told = late;
}

/// A call at this floor that the stop answers as well.
bool LiftController::answer_here() {
  const std::uint8_t floor = floor_here();
  if (floor == 0) return false;
  if (direction_ == Direction::none) direction_ = departure(calls_.calls(), car_at(floor, false));
  const auto kinds = static_cast<CallKinds>(answered_calls(direction_) & accepted());
  const DoorMask doors = calls_.calls().doors_at(floor, kinds);
  if (doors == 0) return false;
  calls_.answered(floor, direction_, kinds);
  const auto more = static_cast<DoorMask>(doors & settings_.doors & ~open_doors_);
  if (more != 0 && phase_ != LiftPhase::closing) open_doors(open_doors_ | more);
  open_doors_ |= more;
  tell_stop(floor, open_doors_);
  return true;
}

bool LiftController::must_stay_open() const {
  const bool close = calls_.is_on(SpecialFunction::door_close);
  switch (service_) {
    case LiftService::fire_recall:
      return floor_here() == settings_.fire_floor;
    case LiftService::fire_brigade:
    case LiftService::attendant:
      return !close;
    case LiftService::vip:
    case LiftService::bed_passenger:
    case LiftService::special:
      return !close && calls_.calls().empty(car_calls);
    default:
      return false;
  }
}

/// While it closes.
bool LiftController::should_open() {
  if (load_.overload) return true;
  const bool released =
      service_ == LiftService::fire_brigade && !calls_.is_on(SpecialFunction::door_close);
  if (released) return true;
  const bool is_barred = is_obstructed() && !distrusts_barriers();
  return !nudging_ && (is_barred || is_open_wanted() || answer_here());
}

/// The button is held, and has not been for so long that it may be stuck.
bool LiftController::is_open_wanted() {
  const bool held = calls_.is_on(SpecialFunction::door_open);
  if (!held) ignores_button_ = false;
  return held && !ignores_button_ && service_ != LiftService::fire_recall &&
         service_ != LiftService::out_of_order;
}

Duration LiftController::dwell_for(CallKinds kinds) const {
  const bool long_load =
      calls_.is_on(SpecialFunction::load_time_1) || calls_.is_on(SpecialFunction::load_time_2);
  if (long_load || service_ == LiftService::bed_passenger) return settings_.times.dwell_long;
  return (kinds & hall_calls) != 0 ? settings_.times.dwell_hall : settings_.times.dwell_car;
}

}  // namespace canvoy::cia417
