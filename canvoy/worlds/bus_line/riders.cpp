#include "canvoy/worlds/bus_line/riders.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::uint64_t golden = 0x9E37'79B9'7F4A'7C15;
constexpr unsigned drawn_max = 500;  ///< people at one stop for one journey
constexpr unsigned cancel_tries = 10;
constexpr Duration retry = 1s;
/// Some people come later than the planned departure.
constexpr Duration come_after_max = 30s;
/// Beyond this time after its departure, a vehicle stands at no stop.
constexpr Duration stands_at_most = 10min;

/// In relation to an ordinary hour.
double busyness(Duration of_day) {
  const unsigned hour = hour_of(of_day) % 24;
  if ((hour >= 7 && hour < 9) || (hour >= 16 && hour < 18)) return 1.8;
  return hour < 6 || hour >= 20 ? 0.4 : 1;
}

}  // namespace

Riders::Riders(RiderOptions options, std::uint64_t seed, std::vector<DoorUse> doors,
               RiderHands hands)
    : options_(std::move(options)),
      seed_(seed),
      random_(seed),
      uses_(std::move(doors)),
      hands_(std::move(hands)),
      doors_(uses_.size()) {}

double Riders::uniform() {
  return static_cast<double>(random_.next() >> 11) * 0x1p-53;
}

Duration Riders::time_between(Duration least, Duration most) {
  return least + Duration(std::llround(uniform() * static_cast<double>((most - least).count())));
}

/// Number of events of a Poisson process in a time in which `mean` are expected.
unsigned Riders::poisson(double mean) {
  const double limit = std::exp(-mean);
  unsigned count = 0;
  for (double product = uniform(); product > limit && count < drawn_max; product *= uniform()) {
    ++count;
  }
  return count;
}

/// Draws in proportion to the weights; where all are 0, each is as likely as the others.
std::size_t Riders::draw_goal(const std::vector<std::size_t>& goals,
                              const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (sum <= 0) return goals[random_.below(static_cast<std::uint32_t>(goals.size()))];
  double left = uniform() * sum;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    left -= weights[i];
    if (left < 0) return goals[i];
  }
  return goals.back();
}

std::optional<VehicleAhead> Riders::ahead_at(const Journey& journey, std::size_t stop) const {
  return options_.ahead ? options_.ahead(journey.number, stop) : std::nullopt;
}

/// Expected number of people of a journey at a stop.
double Riders::mean_at(const Journey& journey, const BusRoute& route, std::size_t stop) const {
  const Duration at = journey.passings[stop].departure;
  if (!options_.demand) return options_.boarding_mean * busyness(at);
  return options_.demand->at(route.stops[stop].stop, route.is_backward, hour_of(at)).boarding;
}

/// Stops behind `stop` at which people get out, each with its share of those who get in.
Riders::Goals Riders::goals_behind(const Journey& journey, const BusRoute& route,
                                   std::size_t stop) const {
  Goals goals;
  for (std::size_t i = stop + 1; i < journey.passings.size(); ++i) {
    if (!journey.passings[i].alights) continue;
    goals.stops.push_back(i);
    if (!options_.demand) continue;
    const unsigned hour = hour_of(journey.passings[i].departure);
    goals.weights.push_back(
        options_.demand->at(route.stops[i].stop, route.is_backward, hour).alighting);
  }
  return goals;
}

/// Car in which the passenger with this number rides.
unsigned Riders::car_of(std::uint64_t number) const {
  const unsigned every = options_.behind_every;
  if (options_.cars == 1 || every == 0 || number % every != 0) return 1;
  return static_cast<unsigned>(2 + (number / every - 1) % (options_.cars - 1));
}

void Riders::add_person(std::size_t stop, const Goals& goals, const std::function<Time()>& comes) {
  Rider rider{.from = stop, .to = draw_goal(goals.stops, goals.weights)};
  rider.comes = comes();
  const std::uint32_t chance = random_.below(100);
  if (chance >= options_.pass_percent) {
    rider.ticket = chance % 2 == 0 ? Ticket::to_cancel : Ticket::from_driver;
  }
  rider.has_ticket = rider.ticket == Ticket::pass;
  rider.number = ++people_;
  rider.car = car_of(rider.number);
  waiting_.push_back(rider);
}

void Riders::draw_stop(const Journey& journey, const BusRoute& route, std::size_t stop, Time zero) {
  const Passing& passing = journey.passings[stop];
  const Goals goals = goals_behind(journey, route, stop);
  if (!passing.boards || goals.stops.empty() || ahead_at(journey, stop)) return;
  const unsigned count = poisson(mean_at(journey, route, stop));
  for (unsigned i = 0; i < count; ++i) {
    add_person(stop, goals, [&] {
      return zero + passing.departure - time_between(-come_after_max, options_.come_before_max);
    });
  }
}

/// Draws the people who come since the vehicle ahead has left the stop, if they come at random:
/// more where it left long ago.
void Riders::draw_at_random(Time now, std::size_t stop) {
  if (journey_ == nullptr || stop >= last_stop_) return;
  const Passing& passing = journey_->passings[stop];
  const std::optional<VehicleAhead> ahead = ahead_at(*journey_, stop);
  const Goals goals = goals_behind(*journey_, *route_, stop);
  const double mean = mean_at(*journey_, *route_, stop);
  if (!ahead || !passing.boards || goals.stops.empty() || mean <= 0) return;
  const auto time_to_next = [&] {
    const double share = -std::log(1 - uniform()) / mean;
    return Duration(std::llround(share * static_cast<double>(ahead->headway.count())));
  };
  const std::size_t before = waiting_.size();
  const Time until = std::max(now, zero_ + passing.departure) + stands_at_most;
  Time at = (ahead->left ? zero_ + *ahead->left : now) + time_to_next();
  for (; at < until && waiting_.size() < before + drawn_max; at += time_to_next()) {
    add_person(stop, goals, [&] { return at; });
  }
  statistics_.came += waiting_.size() - before;
}

void Riders::begin_journey(Time now, const Journey& journey, const BusRoute& route, Time zero) {
  statistics_.left_behind += waiting_.size();
  waiting_.clear();
  stop_.reset();
  random_ = Random(seed_ + golden * ++journeys_);
  last_stop_ = journey.passings.size() - 1;
  for (std::size_t i = 0; i + 1 < journey.passings.size(); ++i) draw_stop(journey, route, i, zero);
  statistics_.came += waiting_.size();
  if (options_.ahead) {
    journey_ = &journey;
    route_ = &route;
    zero_ = zero;
    draw_at_random(now, 0);
  }
  // No person is lost: each one waits, is at a door, has been aboard, or was left behind.
  check_invariant(statistics_.came ==
                  waiting_.size() + going_in_ + statistics_.in + statistics_.left_behind);
  std::stable_sort(waiting_.begin(), waiting_.end(),
                   [](const Rider& a, const Rider& b) { return a.comes < b.comes; });
  // People who could not get out at the end have their end here.
  for (Rider& rider : aboard_) rider.to = 0;
  advance(now);
}

void Riders::stand_at(Time now, std::size_t stop) {
  stop_ = stop;
  std::erase_if(errands_, [](const Errand& errand) { return errand.is_press; });
  advance(now);
}

void Riders::leave(Time now, std::size_t stop) {
  stop_.reset();
  const bool has_room = aboard() + going_in_ < options_.capacity;
  if (has_room) statistics_.ignored += waiting_at(stop, now - seen_after);
  if (journey_ != nullptr && ahead_at(*journey_, stop)) {
    // Those who come later are there for the next vehicle.
    statistics_.came -= std::erase_if(
        waiting_, [&](const Rider& rider) { return rider.from == stop && rider.comes > now; });
  }
  statistics_.left_behind +=
      std::erase_if(waiting_, [&](const Rider& rider) { return rider.from == stop; });
  for (Rider& rider : aboard_) {
    if (rider.to > stop) continue;
    ++statistics_.carried_past;
    rider.to = std::min(stop + 1, last_stop_);
  }
  std::erase_if(errands_, [](const Errand& errand) { return errand.is_press; });
  plan_presses(now, stop + 1);
  draw_at_random(now, stop + 1);
}

void Riders::plan_presses(Time now, std::size_t stop) {
  for (const Rider& rider : aboard_) {
    if (rider.to != stop) continue;
    errands_.push_back(
        {.when = now + time_between(1s, press_within), .rider = rider.number, .is_press = true});
  }
}

void Riders::door_changed(Time now, std::size_t door, bool is_open) {
  doors_[door].is_open = is_open;
  advance(now);
}

Time Riders::deadline() const {
  Time next = never;
  bool has_free_door = false;
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    next = std::min(next, doors_[i].until);
    has_free_door = has_free_door || (doors_[i].is_open && !doors_[i].who && uses_[i].boards);
  }
  for (const Errand& errand : errands_) next = std::min(next, errand.when);
  if (!stop_ || !has_free_door || aboard() + going_in_ >= options_.capacity) return next;
  // The next person at an open door.
  for (const Rider& rider : waiting_) {
    if (rider.from == *stop_) return std::min(next, rider.comes);
  }
  return next;
}

void Riders::advance(Time now) {
  for (std::size_t i = 0; i < doors_.size(); ++i) finish_passage(now, i);
  do_errands(now);
  for (std::size_t i = 0; i < doors_.size(); ++i) begin_passage(now, i);
}

Rider* Riders::find_aboard(std::uint64_t number) {
  const auto found = std::find_if(aboard_.begin(), aboard_.end(),
                                  [&](const Rider& each) { return each.number == number; });
  return found == aboard_.end() ? nullptr : &*found;
}

void Riders::do_errands(Time now) {
  for (std::size_t i = 0; i < errands_.size();) {
    if (errands_[i].when <= now && try_errand(now, errands_[i])) {
      errands_.erase(errands_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

/// True where it is done, or given up.
bool Riders::try_errand(Time now, Errand& errand) {
  errand.when = now + retry;
  Rider* const rider = find_aboard(errand.rider);
  if (rider == nullptr) return true;
  if (errand.is_press) return !hands_.press_stop || hands_.press_stop(now, *rider);
  if (try_to_cancel(now, *rider)) return true;
  if (++errand.tries < cancel_tries) return false;
  ++statistics_.without_ticket;
  return true;
}

bool Riders::try_to_cancel(Time now, Rider& rider) {
  if (hands_.cancel_ticket && !hands_.cancel_ticket(now, rider)) return false;
  rider.has_ticket = true;
  ++statistics_.cancelled;
  return true;
}

void Riders::finish_passage(Time now, std::size_t door) {
  Passage& passage = doors_[door];
  if (!passage.who || now < passage.until) return;
  Rider rider = *passage.who;
  passage.who.reset();
  passage.until = never;
  if (!passage.is_in) {
    check_invariant(going_out_ > 0);
    --going_out_;
    ++statistics_.out;
  } else {
    check_invariant(going_in_ > 0);
    --going_in_;
    ++statistics_.in;
    rider.boarded = now;
    if (rider.ticket == Ticket::from_driver) {
      rider.has_ticket = !hands_.buy_ticket || hands_.buy_ticket(now, rider);
      ++(rider.has_ticket ? statistics_.bought : statistics_.without_ticket);
    } else if (rider.ticket == Ticket::to_cancel) {
      errands_.push_back({.when = now + time_between(3s, 10s), .rider = rider.number});
    }
    aboard_.push_back(rider);
    statistics_.aboard_max = std::max(statistics_.aboard_max, aboard());
  }
  check_invariant(statistics_.in - statistics_.out == aboard());
  if (hands_.through) hands_.through(now, door, passage.is_in);
}

std::vector<Rider>::const_iterator Riders::next_out() const {
  return std::find_if(aboard_.begin(), aboard_.end(), [&](const Rider& rider) {
    return stop_ && (rider.to <= *stop_ || *stop_ == last_stop_);
  });
}

std::vector<Rider>::const_iterator Riders::next_in(Time now) const {
  if (aboard() + going_in_ >= options_.capacity) return waiting_.end();
  return std::find_if(waiting_.begin(), waiting_.end(), [&](const Rider& rider) {
    return stop_ && rider.from == *stop_ && rider.comes <= now;
  });
}

void Riders::begin_passage(Time now, std::size_t door) {
  Passage& passage = doors_[door];
  if (!passage.is_open || passage.who || !stop_) return;
  if (const auto out = next_out(); uses_[door].alights && out != aboard_.end()) {
    passage.who = *out;
    passage.is_in = false;
    passage.until = now + time_around(options_.alighting_time);
    aboard_.erase(out);
    ++going_out_;
    return;
  }
  const auto in = next_in(now);
  if (!uses_[door].boards || in == waiting_.end()) return;
  passage.who = *in;
  passage.is_in = true;
  passage.until = now + time_around(options_.boarding_time);
  if (in->ticket == Ticket::from_driver) {
    passage.until += time_between(options_.buying_time * 8 / 11, options_.buying_time * 14 / 11);
  }
  waiting_.erase(in);
  ++going_in_;
  check_invariant(aboard() + going_in_ <= options_.capacity);
}

unsigned Riders::waiting_at(std::size_t stop, Time now) const {
  return static_cast<unsigned>(
      std::count_if(waiting_.begin(), waiting_.end(),
                    [&](const Rider& rider) { return rider.from == stop && rider.comes <= now; }));
}

unsigned Riders::wanting_out_at(std::size_t stop) const {
  return static_cast<unsigned>(std::count_if(aboard_.begin(), aboard_.end(),
                                             [&](const Rider& rider) { return rider.to <= stop; }));
}

bool Riders::is_quiet(Time now) const {
  const bool has_out = next_out() != aboard_.end();
  const bool has_in = next_in(now) != waiting_.end();
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    if (doors_[i].who) return false;
    if (!doors_[i].is_open) continue;
    if ((has_out && uses_[i].alights) || (has_in && uses_[i].boards)) return false;
  }
  return true;
}

}  // namespace canvoy::bus_line
