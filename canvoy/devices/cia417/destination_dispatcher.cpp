#include "canvoy/devices/cia417/destination_dispatcher.hpp"

#include <algorithm>

namespace canvoy::cia417 {

namespace {

bool is_possible(const DestinationCall& call) {
  const auto is_floor = [](std::uint8_t floor) {
    return floor >= 1 && floor <= FloorSet::floor_max;
  };
  return is_floor(call.source) && is_floor(call.target) && call.source != call.target;
}

void add_stops(Route& route, const DestinationCall& call) {
  FloorSet& stops = call.direction() == Direction::up ? route.stops_up : route.stops_down;
  stops.insert(call.source);
  stops.insert(call.target);
}

bool is_on_the_way(std::uint8_t floor, const DestinationCall& call) {
  const auto [low, high] = std::minmax(call.source, call.target);
  return floor > low && floor < high;
}

}  // namespace

DestinationDispatcher::DestinationDispatcher(std::span<const GroupLift> lifts,
                                             std::span<Slot> slots,
                                             const DestinationSettings& settings)
    : lifts_(lifts.first(std::min<std::size_t>(lifts.size(), group_lifts_max))),
      slots_(slots),
      settings_(settings) {}

DestinationDispatcher::Answer DestinationDispatcher::add(const DestinationCall& call) {
  bool possible = false;
  for (unsigned lift = 1; lift <= lifts_.size(); ++lift) {
    possible = possible || could_ever(call, lift);
  }
  if (!possible) return {DispatchAnswer::refused};
  const unsigned lift = best(call);
  if (!put(call, lift, 1)) return {DispatchAnswer::no_room};
  assigned_(call, lift);
  return {lift != 0 ? DispatchAnswer::assigned : DispatchAnswer::waits,
          static_cast<std::uint8_t>(lift)};
}

void DestinationDispatcher::departed(unsigned lift, const Landing& landing, DoorMask doors,
                                     Callback<void(const DestinationCall&)> boarded) {
  if (lift == 0) return;
  for (std::size_t i = count_; i-- > 0;) {
    const Slot slot = slots_[i];
    const bool fits =
        landing.direction == Direction::none || landing.direction == slot.call.direction();
    if (slot.lift != lift || slot.call.source != landing.floor || !fits ||
        (slot.call.source_doors & doors) == 0) {
      continue;
    }
    erase(i);
    boarded(slot.call);
  }
}

void DestinationDispatcher::service_changed() {
  // Those who have to be asked anew are taken out first, so that a lift that is gone is no longer
  // planned with; then each finds a place again, since there was one.
  for (std::size_t i = 0, left = count_; left > 0; --left) {
    const Slot slot = slots_[i];
    if (slot.lift != 0 && can(slot.call, slot.lift)) {
      ++i;
      continue;
    }
    erase(i);
    const unsigned lift = best(slot.call);
    put(slot.call, lift, slot.persons);
    if (lift != slot.lift) assigned_(slot.call, lift);
  }
}

Route DestinationDispatcher::route(unsigned lift) const {
  Route route = route_of(lifts_[lift - 1]);
  for (const Slot& slot : calls()) {
    if (slot.lift == lift) add_stops(route, slot.call);
  }
  return route;
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

/// Passengers of this car who get in where he does, and go the same way.
unsigned DestinationDispatcher::waiting(const DestinationCall& call, unsigned lift) const {
  unsigned persons = 0;
  for (const Slot& slot : calls()) {
    const bool is_beside =
        slot.call.source == call.source && slot.call.direction() == call.direction();
    if (slot.lift == lift && is_beside) persons += slot.persons;
  }
  return persons;
}

/// What his stops cost others, of those that the car would not make without him.
Duration DestinationDispatcher::delay_of_others(const DestinationCall& call, unsigned lift,
                                                const Route& route) const {
  const FloorSet& stops = call.direction() == Direction::up ? route.stops_up : route.stops_down;
  const bool source_is_new = !stops.contains(call.source);
  const bool target_is_new = !stops.contains(call.target);
  unsigned persons = 0;
  for (const Slot& slot : calls()) {
    if (slot.lift != lift || slot.call.direction() != call.direction()) continue;
    if (source_is_new && is_on_the_way(call.source, slot.call)) persons += slot.persons;
    if (target_is_new && is_on_the_way(call.target, slot.call)) persons += slot.persons;
  }
  if (source_is_new) persons += lifts_[lift - 1].car_calls.size();
  return persons * lifts_[lift - 1].times.stop;
}

/// His own time to the destination, and a share of what it costs others.
Duration DestinationDispatcher::cost(const DestinationCall& call, unsigned lift) const {
  const GroupLift& state = lifts_[lift - 1];
  Route route = this->route(lift);
  const Duration others = delay_of_others(call, lift, route);
  Duration time = estimate_arrival(route, {call.source, call.direction()}, state.times);
  add_stops(route, call);
  time += state.times.stop + estimate_leg(route, call.source, call.target, state.times);
  // He does not fit in, and waits until the car comes again.
  const unsigned room = std::max(1U, state.persons_max * settings_.load_percent / 100);
  const unsigned trips = waiting(call, lift) / room + (state.full ? 1 : 0);
  const FloorSet stops = route.stops();
  const auto span = static_cast<unsigned>(stops.highest() - stops.lowest());
  time += trips * (2 * span * state.times.flight + (stops.size() + 1) * state.times.stop);
  return time + others * settings_.courtesy_percent / 100;
}

unsigned DestinationDispatcher::best(const DestinationCall& call) const {
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

bool DestinationDispatcher::put(const DestinationCall& call, unsigned lift, unsigned persons) {
  for (Slot& slot : slots_.first(count_)) {
    if (slot.lift != lift || slot.call != call) continue;
    slot.persons = static_cast<std::uint8_t>(std::min(255U, slot.persons + persons));
    return true;
  }
  if (count_ == slots_.size()) return false;
  slots_[count_++] = {call, static_cast<std::uint8_t>(lift), static_cast<std::uint8_t>(persons)};
  return true;
}

void DestinationDispatcher::erase(std::size_t position) {
  std::move(slots_.begin() + static_cast<std::ptrdiff_t>(position) + 1,
            slots_.begin() + static_cast<std::ptrdiff_t>(count_),
            slots_.begin() + static_cast<std::ptrdiff_t>(position));
  --count_;
}

}  // namespace canvoy::cia417
