#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

#include <algorithm>

namespace canvoy::cia417 {

namespace {

bool is_same_call(const HallCall& a, const HallCall& b) {
  return a.floor == b.floor && a.direction == b.direction && a.doors == b.doors &&
         a.priority == b.priority;
}

/// The car calls that a stop at `landing` delays: those behind it on the way.
unsigned car_calls_behind(const GroupLift& lift, const Landing& landing) {
  if (lift.direction == Direction::up && landing.floor >= lift.floor) {
    return (lift.car_calls & FloorSet::between(landing.floor + 1U, FloorSet::floor_max)).size();
  }
  if (lift.direction == Direction::down && landing.floor <= lift.floor) {
    return (lift.car_calls & FloorSet::between(1, landing.floor - 1U)).size();
  }
  return 0;
}

}  // namespace

HallDispatcher::HallDispatcher(std::span<const GroupLift> lifts, std::span<Slot> slots,
                               const DispatchSettings& settings)
    : lifts_(lifts.first(std::min<std::size_t>(lifts.size(), group_lifts_max))),
      slots_(slots),
      settings_(settings) {}

DispatchAnswer HallDispatcher::add(const HallCall& call) {
  if (call.doors == 0 || call.doors >= 1U << lift_doors_max) return DispatchAnswer::refused;
  DispatchAnswer worst = DispatchAnswer::assigned;
  for (unsigned door = 0; door < lift_doors_max; ++door) {
    if ((call.doors >> door & 1) == 0) continue;
    HallCall one = call;
    one.doors = static_cast<DoorMask>(1U << door);
    worst = std::max(worst, add_at_door(one));
  }
  return worst;
}

DispatchAnswer HallDispatcher::add_at_door(const HallCall& call) {
  for (const Slot& slot : calls()) {
    if (!is_same_call(slot.call, call)) continue;
    return slot.lift != 0 ? DispatchAnswer::assigned : DispatchAnswer::waits;
  }
  bool possible = false;
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    possible = possible || could_ever(call, lift);
  }
  if (!possible) return DispatchAnswer::refused;
  if (count_ == slots_.size()) return DispatchAnswer::no_room;
  Slot& slot = slots_[count_++];
  slot = {.call = call};
  assign(slot, best(call));
  return slot.lift != 0 ? DispatchAnswer::assigned : DispatchAnswer::waits;
}

void HallDispatcher::answered(unsigned lift, const Landing& landing, DoorMask doors) {
  if (lift == 0 || lift > lifts_.size()) return;
  for (std::size_t i = count_; i-- > 0;) {
    const HallCall& call = slots_[i].call;
    const bool fits = landing.direction == Direction::none || call.direction == Direction::none ||
                      call.direction == landing.direction;
    const bool may = (call.lifts & lift_bit(lift)) != 0;
    if (call.floor == landing.floor && (call.doors & doors) != 0 && fits && may) erase(i);
  }
}

void HallDispatcher::remove(const HallCall& call) {
  for (std::size_t i = count_; i-- > 0;) {
    HallCall whole = slots_[i].call;
    if ((whole.doors & call.doors) == 0) continue;
    whole.doors = call.doors;
    if (is_same_call(whole, call)) erase(i);
  }
}

void HallDispatcher::service_changed() {
  for (Slot& slot : slots_.first(count_)) {
    if (slot.lift != 0 && can(slot.call, slot.lift)) continue;
    const unsigned lift = best(slot.call);
    if (lift != slot.lift) assign(slot, lift);
  }
}

void HallDispatcher::reconsider() {
  for (Slot& slot : slots_.first(count_)) {
    const unsigned lift = best(slot.call);
    if (lift == 0 || lift == slot.lift) continue;
    if (slot.lift != 0 && cost(slot.call, lift) + settings_.gain_min > cost(slot.call, slot.lift)) {
      continue;
    }
    assign(slot, lift);
  }
}

Route HallDispatcher::route(unsigned lift) const {
  return route_without(lift, nullptr);
}

Route HallDispatcher::route_without(unsigned lift, const HallCall* excepted) const {
  Route route = route_of(lifts_[lift - 1]);
  others_.add_stops(lift, route);
  add_stops_without(lift, excepted, route);
  return route;
}

void HallDispatcher::add_stops(unsigned lift, Route& route) const {
  add_stops_without(lift, nullptr, route);
}

void HallDispatcher::add_stops_without(unsigned lift, const HallCall* excepted,
                                       Route& route) const {
  for (const Slot& slot : calls()) {
    if (slot.lift != lift || (excepted != nullptr && is_same_call(slot.call, *excepted))) continue;
    for (const Direction way : {Direction::up, Direction::down}) {
      const bool fits = slot.call.direction == way || slot.call.direction == Direction::none;
      if (fits) route.stops_of({slot.call.floor, way}).insert(slot.call.floor);
    }
  }
}

/// Passengers in the car by then, one for each call: the number of passengers behind a hall call is
/// not known.
unsigned HallDispatcher::delayed(unsigned lift, const Landing& landing) const {
  unsigned persons = 0;
  for (const Slot& slot : calls()) {
    if (slot.lift != lift || slot.call.direction != landing.direction) continue;
    const bool boards_before = landing.direction == Direction::up ? slot.call.floor < landing.floor
                                                                  : slot.call.floor > landing.floor;
    if (boards_before) ++persons;
  }
  return persons;
}

bool HallDispatcher::could_ever(const HallCall& call, unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  return (call.lifts & lift_bit(lift)) != 0 && state.serves(call.floor, call.doors) &&
         state.leaves(call.floor, call.direction);
}

bool HallDispatcher::can(const HallCall& call, unsigned lift) const {
  return lifts_[lift - 1].in_service && could_ever(call, lift);
}

Duration HallDispatcher::cost(const HallCall& call, unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  const Landing landing{call.floor, call.direction};
  const Route route = route_without(lift, &call);
  Duration time = estimate_arrival(route, landing, state.times);
  // The car has to let a passenger out before: otherwise it comes without room, and has to come
  // again.
  if (state.full || others_.is_full(lift, landing))
    time += 2 * state.times.stop + 2 * state.times.flight;
  if (route.all().contains(call.floor)) return time;
  const unsigned persons = car_calls_behind(state, landing) + others_.delayed(lift, landing);
  return time + persons * state.times.stop * settings_.courtesy_percent / 100;
}

unsigned HallDispatcher::best(const HallCall& call) const {
  unsigned found = 0;
  Duration least = Duration::max();
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    if (!can(call, lift)) continue;
    const Duration time = cost(call, lift);
    if (time >= least) continue;
    found = lift;
    least = time;
  }
  return found;
}

void HallDispatcher::assign(Slot& slot, unsigned lift) {
  if (slot.lift == lift) return;
  slot.lift = static_cast<std::uint8_t>(lift);
  assigned_(slot.call, lift);
}

void HallDispatcher::erase(std::size_t position) {
  std::move(slots_.begin() + static_cast<std::ptrdiff_t>(position) + 1,
            slots_.begin() + static_cast<std::ptrdiff_t>(count_),
            slots_.begin() + static_cast<std::ptrdiff_t>(position));
  --count_;
}

}  // namespace canvoy::cia417
