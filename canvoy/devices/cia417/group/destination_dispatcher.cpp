#include "canvoy/devices/cia417/group/destination_dispatcher.hpp"

#include <algorithm>

namespace canvoy::cia417 {

namespace {

bool is_possible(const DestinationCall& call) {
  return FloorSet::is_floor(call.source) && FloorSet::is_floor(call.target) &&
         call.source != call.target;
}

void add_stops_of(const DestinationCall& call, Route& route) {
  FloorSet& stops = route.stops_of({call.source, call.direction()});
  stops.insert(call.source);
  stops.insert(call.target);
}

Landing source_of(const DestinationCall& call) {
  return {call.source, call.direction()};
}

/// On the way in this direction, `a` comes before `b`.
constexpr bool is_before(std::uint8_t a, std::uint8_t b, Direction direction) {
  return direction == Direction::down ? a > b : a < b;
}

/// True if the passenger is in the car when it leaves there.
bool rides_from(const DestinationCall& call, const Landing& landing) {
  return call.direction() == landing.direction &&
         !is_before(landing.floor, call.source, landing.direction) &&
         is_before(landing.floor, call.target, landing.direction);
}

}  // namespace

DestinationDispatcher::DestinationDispatcher(std::span<const GroupLift> lifts,
                                             std::span<Slot> slots,
                                             const DestinationSettings& settings)
    : lifts_(lifts.first(std::min<std::size_t>(lifts.size(), group_lifts_max))),
      slots_(slots),
      settings_(settings) {}

OtherPlans DestinationDispatcher::plans() {
  using Self = DestinationDispatcher;
  return {.add_stops = callback<&Self::add_stops>(*this),
          .delayed = callback<&Self::delayed>(*this),
          .is_full = callback<&Self::is_full>(*this)};
}

// Events

DestinationDispatcher::Answer DestinationDispatcher::add(const DestinationCall& call) {
  bool possible = false;
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    possible = possible || could_ever(call, lift);
  }
  if (!possible) return {DispatchAnswer::refused};
  const unsigned lift = waits_already(call) ? 0 : best(call, 1);
  if (!put({call, static_cast<std::uint8_t>(lift), 1})) return {DispatchAnswer::no_room};
  if (lift == 0) return {DispatchAnswer::waits};
  assigned_(call, lift);
  return {DispatchAnswer::assigned, static_cast<std::uint8_t>(lift)};
}

void DestinationDispatcher::departed(unsigned lift, const Landing& landing, DoorMask doors,
                                     Callback<void(const DestinationCall&)> boarded) {
  if (lift == 0 || lift > lifts_.size()) return;
  alighted(lift, landing.floor);
  for (std::size_t i = count_; i-- > 0;) {
    const Slot slot = slots_[i];
    const bool fits =
        landing.direction == Direction::none || landing.direction == slot.call.direction();
    if (slot.lift != lift || slot.call.source != landing.floor || !fits ||
        (slot.call.source_doors & doors) == 0) {
      continue;
    }
    erase(i);
    ride(slot);
    boarded(slot.call);
  }
}

void DestinationDispatcher::alighted(unsigned lift, std::uint8_t floor) {
  for (std::size_t i = riding_; i-- > 0;) {
    const Slot& rider = riders()[i];
    if (rider.lift == lift && rider.call.target == floor) erase_rider(i);
  }
}

void DestinationDispatcher::service_changed() {
  for (std::size_t i = riding_; i-- > 0;) {
    if (!lifts_[riders()[i].lift - 1U].in_service) erase_rider(i);
  }
  // Passengers to be assigned again are first set to waiting for any lift, so that plans do not
  // include a lift that is gone.
  for (Slot& slot : slots_.first(count_)) {
    if (slot.lift == 0 || can(slot.call, slot.lift)) continue;
    withdrawn_(slot.call, slot.lift);
    slot.lift = 0;
    if (best(slot.call, slot.persons) == 0) assigned_(slot.call, 0);
  }
  assign_waiting();
}

void DestinationDispatcher::assign_waiting() {
  for (std::size_t i = 0, left = count_; left > 0; --left) {
    const Slot slot = slots_[i];
    const unsigned lift = slot.lift == 0 ? best(slot.call, slot.persons) : 0;
    if (lift == 0) {
      ++i;
      continue;
    }
    erase(i);
    put({slot.call, static_cast<std::uint8_t>(lift), slot.persons});
    assigned_(slot.call, lift);
  }
}

// Plans

Route DestinationDispatcher::route(unsigned lift) const {
  Route route = route_of(lifts_[lift - 1]);
  others_.add_stops(lift, route);
  add_stops(lift, route);
  return route;
}

/// Targets of riders become car calls when the car has reported them.
void DestinationDispatcher::add_stops(unsigned lift, Route& route) const {
  for (const Slot& slot : calls()) {
    if (slot.lift == lift) add_stops_of(slot.call, route);
  }
  for (const Slot& rider : riders()) {
    if (rider.lift != lift) continue;
    (rider.call.direction() == Direction::up ? route.stops_up : route.stops_down)
        .insert(rider.call.target);
  }
}

bool DestinationDispatcher::could_ever(const DestinationCall& call, unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  if (!is_possible(call) || (call.lifts & lift_bit(lift)) == 0) return false;
  const bool gets_out = call.target_doors == 0 ? state.doors_at(call.target) != 0
                                               : state.serves(call.target, call.target_doors);
  return gets_out && state.serves(call.source, call.source_doors);
}

bool DestinationDispatcher::can(const DestinationCall& call, unsigned lift) const {
  return lifts_[lift - 1].in_service && could_ever(call, lift);
}

/// Passengers who are in the car and still in it when it leaves there.
unsigned DestinationDispatcher::riding_past(unsigned lift, const Landing& landing) const {
  unsigned persons = 0;
  for (const Slot& rider : riders()) {
    if (rider.lift == lift && rides_from(rider.call, landing)) persons += rider.persons;
  }
  return persons;
}

unsigned DestinationDispatcher::delayed(unsigned lift, const Landing& landing) const {
  unsigned persons = 0;
  for (const Slot& slot : calls()) {
    if (slot.lift == lift && slot.call.source != landing.floor && rides_from(slot.call, landing)) {
      persons += slot.persons;
    }
  }
  if (!comes_by(lifts_[lift - 1], landing)) return persons;
  // One is already counted for each car call.
  for (const Slot& rider : riders()) {
    if (rider.lift == lift && rides_from(rider.call, landing)) persons += rider.persons - 1U;
  }
  return persons;
}

unsigned DestinationDispatcher::capacity(unsigned lift) const {
  return std::max(1U, lifts_[lift - 1].persons_max * settings_.load_percent / 100);
}

/// Persons in the car when it leaves that floor, in the same round as it comes to `start`.
unsigned DestinationDispatcher::load_at(unsigned lift, const Landing& landing,
                                        const Landing& start) const {
  const GroupLift& state = lifts_[lift - 1];
  const bool is_this_round = comes_by(state, start);
  unsigned persons = 0;
  for (const Slot& slot : calls()) {
    if (slot.lift != lift || !rides_from(slot.call, landing)) continue;
    if (comes_by(state, source_of(slot.call)) == is_this_round) persons += slot.persons;
  }
  const bool is_under_way = is_this_round && state.direction == landing.direction;
  if (!is_under_way) return persons;
  if (state.full && state.floor == landing.floor) persons += capacity(lift);
  return persons + riding_past(lift, landing);
}

bool DestinationDispatcher::is_full(unsigned lift, const Landing& landing) const {
  return load_at(lift, landing, landing) >= capacity(lift);
}

/// A group that is larger than a car takes an empty one, as far as there is room.
bool DestinationDispatcher::fits(const DestinationCall& call, unsigned persons,
                                 unsigned lift) const {
  const Landing start = source_of(call);
  unsigned load = load_at(lift, start, start);
  for (const Slot& slot : calls()) {
    const Landing landing = source_of(slot.call);
    if (slot.lift != lift || !rides_from(call, landing)) continue;
    load = std::max(load, load_at(lift, landing, start));
  }
  return load == 0 || load + persons <= capacity(lift);
}

// Costs

/// Cost for others of the stops that the car makes only for this passenger.
Duration DestinationDispatcher::delay_of_others(const DestinationCall& call, unsigned lift,
                                                const Route& route) const {
  const FloorSet& stops = route.stops_of(source_of(call));
  unsigned persons = 0;
  for (const std::uint8_t floor : {call.source, call.target}) {
    const Landing landing{floor, call.direction()};
    if (stops.contains(floor)) continue;
    persons += delayed(lift, landing) + others_.delayed(lift, landing);
    if (!comes_by(lifts_[lift - 1], landing)) continue;
    for (unsigned behind = lifts_[lift - 1].car_calls.next_up(1); behind != 0;
         behind = lifts_[lift - 1].car_calls.next_up(behind + 1)) {
      persons += is_before(floor, static_cast<std::uint8_t>(behind), call.direction()) ? 1U : 0U;
    }
  }
  return persons * lifts_[lift - 1].times.stop;
}

/// Delay of the car for the passengers that it serves next: further stops, and distances beyond its
/// turning points.
Duration DestinationDispatcher::delay_of_next(const Route& before, const Route& with,
                                              unsigned lift) const {
  const TravelTimes& times = lifts_[lift - 1].times;
  const auto length = [](const Route& route) -> unsigned {
    const FloorSet stops = route.all();
    if (stops.empty()) return 0;
    return std::max(stops.highest(), route.floor) - std::min(stops.lowest(), route.floor);
  };
  const unsigned stops = with.all().size() - before.all().size();
  const Duration later = stops * times.stop + 2 * (length(with) - length(before)) * times.flight;
  unsigned persons = 0;
  unsigned serving = 0;
  for (const Slot& slot : calls()) persons += slot.persons;
  for (const Slot& rider : riders()) persons += rider.persons;
  for (const GroupLift& state : lifts_) serving += state.in_service ? 1U : 0U;
  const unsigned each = std::min(capacity(lift), persons / std::max(serving, 1U));
  return later * each * settings_.demand_percent / 100;
}

/// The passenger's own time to the destination, and the cost for others.
Duration DestinationDispatcher::cost(const DestinationCall& call, unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  const Route before = route(lift);
  Route with = before;
  add_stops_of(call, with);
  return estimate_arrival(before, source_of(call), state.times) + state.times.stop +
         estimate_leg(with.stops_of(source_of(call)), call.source, call.target, state.times) +
         delay_of_others(call, lift, before) * settings_.courtesy_percent / 100 +
         delay_of_next(before, with, lift);
}

unsigned DestinationDispatcher::best(const DestinationCall& call, unsigned persons) const {
  unsigned found = 0;
  Duration least = Duration::max();
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    if (!can(call, lift) || !fits(call, persons, lift)) continue;
    const Duration time = cost(call, lift);
    if (time >= least) continue;
    found = lift;
    least = time;
  }
  return found;
}

// Memory

bool DestinationDispatcher::waits_already(const DestinationCall& call) const {
  return std::ranges::any_of(calls(),
                             [&](const Slot& slot) { return slot.lift == 0 && slot.call == call; });
}

bool DestinationDispatcher::put(const Slot& added) {
  for (Slot& slot : slots_.first(count_)) {
    if (slot.lift != added.lift || slot.call != added.call) continue;
    slot.persons =
        static_cast<std::uint8_t>(std::min(255U, unsigned{slot.persons} + added.persons));
    return true;
  }
  if (count_ == slots_.size()) return false;
  if (count_ + riding_ == slots_.size()) --riding_;
  slots_[count_++] = added;
  return true;
}

void DestinationDispatcher::ride(const Slot& boarded) {
  for (Slot& rider : slots_.last(riding_)) {
    if (rider.lift != boarded.lift || rider.call.target != boarded.call.target) continue;
    rider.persons =
        static_cast<std::uint8_t>(std::min(255U, unsigned{rider.persons} + boarded.persons));
    return;
  }
  if (count_ + riding_ == slots_.size()) return;
  slots_[slots_.size() - ++riding_] = boarded;
}

void DestinationDispatcher::erase(std::size_t position) {
  std::move(slots_.begin() + static_cast<std::ptrdiff_t>(position) + 1,
            slots_.begin() + static_cast<std::ptrdiff_t>(count_),
            slots_.begin() + static_cast<std::ptrdiff_t>(position));
  --count_;
}

void DestinationDispatcher::erase_rider(std::size_t position) {
  const auto first = slots_.end() - static_cast<std::ptrdiff_t>(riding_);
  std::move_backward(first, first + static_cast<std::ptrdiff_t>(position),
                     first + static_cast<std::ptrdiff_t>(position) + 1);
  --riding_;
}

}  // namespace canvoy::cia417
