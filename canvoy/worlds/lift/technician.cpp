#include "canvoy/worlds/lift/technician.hpp"

#include <chrono>
#include <cmath>
#include <utility>

namespace canvoy::lift {

namespace {

/// The technician is in the house, as in a hospital or an office tower.
constexpr unsigned comes_least_s = 60;
constexpr unsigned comes_most_s = 150;
constexpr unsigned inspects_least_s = 20;
constexpr unsigned inspects_most_s = 40;
/// Passengers who have not left the car by then stay in it.
constexpr Duration lets_out_most = 3min;
/// Accuracy of a floor that is found by hand.
constexpr double level_m = 0.005;

Duration drawn(Random& random, unsigned least_s, unsigned most_s) {
  return std::chrono::seconds(least_s + random.below(most_s - least_s + 1));
}

}  // namespace

Technician::Technician(TechnicianHands hands, std::uint64_t seed)
    : hands_(std::move(hands)), random_(seed) {}

void Technician::call(Time now, TechnicianCause cause) {
  if (is_called()) return;
  enter(Step::coming, now + drawn(random_, comes_least_s, comes_most_s));
  hands_.tell(cause == TechnicianCause::trip ? TechnicianStep::called_for_trip
                                             : TechnicianStep::called_for_people,
              no_floor);
}

void Technician::look(Time now, const TechnicianView& car) {
  switch (step_) {
    case Step::away:
      return;
    case Step::coming:
      return now < until_ ? void() : arrive(now, car);
    case Step::cranking:
      if (now < until_) return;
      hands_.crank(0);
      return let_out(now, car);
    case Step::letting_out:
      if (!car.is_empty && now < until_) return;
      hands_.hold_door(false);
      return wait(now, car);
    case Step::waiting:
      return wait(now, car);
    case Step::inspecting:
      if (now >= until_) leave();
      return;
  }
}

/// Other people may have helped meanwhile.
void Technician::arrive(Time now, const TechnicianView& car) {
  if (!car.is_tripped && !car.is_shut_in) {
    enter(Step::away, never);
    return hands_.tell(TechnicianStep::leaves, no_floor);
  }
  hands_.tell(TechnicianStep::arrives, no_floor);
  hands_.stop_switch(true);
  if (!car.is_shut_in) return wait(now, car);
  const double way_m = car.to_floor_m;
  if (std::abs(way_m) <= level_m) return let_out(now, car);
  if (!hands_.crank(way_m > 0 ? crank_m_s : -crank_m_s)) return wait(now, car);
  hands_.tell(TechnicianStep::moves_car, car.nearest);
  const std::chrono::duration<double> takes(std::abs(way_m) / crank_m_s);
  enter(Step::cranking, now + std::chrono::duration_cast<Duration>(takes));
}

void Technician::let_out(Time now, const TechnicianView& car) {
  hands_.tell(TechnicianStep::lets_out, car.nearest);
  hands_.hold_door(true);
  enter(Step::letting_out, now + lets_out_most);
}

/// Waits until nothing is broken.
void Technician::wait(Time now, const TechnicianView& car) {
  if (!car.is_whole) return enter(Step::waiting, never);
  hands_.tell(TechnicianStep::inspects, no_floor);
  enter(Step::inspecting, now + drawn(random_, inspects_least_s, inspects_most_s));
}

void Technician::leave() {
  hands_.stop_switch(false);
  hands_.reset();
  hands_.tell(TechnicianStep::resets, no_floor);
  enter(Step::away, never);
  hands_.tell(TechnicianStep::leaves, no_floor);
}

}  // namespace canvoy::lift
