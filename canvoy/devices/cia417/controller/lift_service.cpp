#include "canvoy/devices/cia417/controller/lift_service.hpp"

#include <utility>

namespace canvoy::cia417 {

LiftService LiftServiceState::wanted(const CallController& calls, bool is_at_fire_floor) const {
  const auto on = [&](SpecialFunction function) { return calls.is_on(function); };
  // Inspection control neutralises all other control, a recall too (EN 81-20, 5.12.1.5.2.1).
  if (on(SpecialFunction::service_run)) return LiftService::service_run;
  if (on(SpecialFunction::dogging_service_enable)) return LiftService::dogging;
  if (on(SpecialFunction::out_of_order)) return LiftService::out_of_order;
  const bool alarm = on(SpecialFunction::fire_service_enable);
  const bool brigade = on(SpecialFunction::fire_service);
  if (alarm || brigade) {
    // The fire brigade takes over the car at the fire floor, each time again.
    const bool has_come = is_in_fire() && is_cleared_;
    return brigade && has_come ? LiftService::fire_brigade : LiftService::fire_recall;
  }
  // When the keys are turned back, the car first returns to the fire floor.
  if (is_in_fire() && !(is_cleared_ && is_at_fire_floor)) return LiftService::fire_recall;
  if (on(SpecialFunction::special_service)) return LiftService::special;
  if (on(SpecialFunction::bed_passenger_service)) return LiftService::bed_passenger;
  if (on(SpecialFunction::vip_service)) return LiftService::vip;
  if (on(SpecialFunction::attendant_service)) return LiftService::attendant;
  return LiftService::normal;
}

bool LiftServiceState::change(LiftService service) {
  if (service == now_) return false;
  if (service == LiftService::fire_recall || service == LiftService::out_of_order) {
    is_cleared_ = false;
  }
  now_ = service;
  return true;
}

CallKinds LiftServiceState::accepted() const {
  if (is(LiftService::normal) || is(LiftService::attendant)) return all_calls;
  const bool is_exclusive =
      is_occupied() || is(LiftService::special) || is(LiftService::fire_brigade);
  return is_exclusive ? car_calls : CallKinds{0};
}

bool LiftServiceState::clear(bool is_at_fire_floor) {
  const bool is_recalled = is(LiftService::fire_recall) && is_at_fire_floor;
  if (!is_recalled && !is(LiftService::out_of_order)) return false;
  return !std::exchange(is_cleared_, true);
}

bool LiftServiceState::keeps_doors_open(const CallController& calls, bool is_at_fire_floor) const {
  const bool close = calls.is_on(SpecialFunction::door_close);
  switch (now_) {
    case LiftService::fire_recall:
      return is_at_fire_floor;
    case LiftService::fire_brigade:
    case LiftService::attendant:
      return !close;
    case LiftService::vip:
    case LiftService::bed_passenger:
    case LiftService::special:
      return !close && calls.calls().empty(car_calls);
    default:
      return false;
  }
}

}  // namespace canvoy::cia417
