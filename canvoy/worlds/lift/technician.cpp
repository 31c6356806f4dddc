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
/// Time in which a car obeys the button: its doors close first, and a fault ends.
constexpr Duration obeys_within = 30s;
constexpr Duration ride_time = 4s;
constexpr Duration pause_time = 3s;
constexpr Duration boot_time = 15s;

Duration drawn(Random& random, unsigned least_s, unsigned most_s) {
  return std::chrono::seconds(least_s + random.below(most_s - least_s + 1));
}

TechnicianStep call_for(TechnicianCause cause) {
  switch (cause) {
    case TechnicianCause::trip:
      return TechnicianStep::called_for_trip;
    case TechnicianCause::trapped:
      return TechnicianStep::called_for_people;
    case TechnicianCause::fault:
      return TechnicianStep::called_for_fault;
    case TechnicianCause::complaint:
      break;
  }
  return TechnicianStep::called_for_complaint;
}

constexpr Direction opposite(Direction way) {
  return way == Direction::up ? Direction::down : Direction::up;
}

}  // namespace

Technician::Technician(TechnicianHands hands, std::uint64_t seed)
    : hands_(std::move(hands)), random_(seed) {}

void Technician::call(Time now, TechnicianCause cause) {
  if (is_called()) return;
  cause_ = cause;
  has_restarted_ = has_given_up_ = false;
  enter(Step::coming, now + drawn(random_, comes_least_s, comes_most_s));
  hands_.tell(call_for(cause), no_floor);
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
      return now < until_ ? void() : reset(now, car);
    case Step::riding:
      return ride(now, car);
    case Step::pausing:
      return now < until_ ? void() : pause(now);
    case Step::restarting:
      return now < until_ ? void() : begin_rides(now, way_);
  }
}

/// Other people may have helped meanwhile; a car that moves is not stopped.
void Technician::arrive(Time now, const TechnicianView& car) {
  const bool is_needed = car.is_tripped || car.is_shut_in || car.is_out;
  if (!is_needed && cause_ != TechnicianCause::complaint) {
    enter(Step::away, never);
    return hands_.tell(TechnicianStep::leaves, no_floor);
  }
  if (!car.stands) return;
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

/// No ride on the roof of a car with people in it, or of one that broke again meanwhile.
void Technician::reset(Time now, const TechnicianView& car) {
  if (!car.is_whole) return enter(Step::waiting, never);
  hands_.stop_switch(false);
  hands_.reset();
  hands_.tell(TechnicianStep::resets, no_floor);
  if (!car.is_empty) return leave();
  hands_.tell(TechnicianStep::rides, no_floor);
  begin_rides(now, car.is_low ? Direction::up : Direction::down);
}

/// One ride away from the end of the travel, and one back.
void Technician::begin_rides(Time now, Direction first) {
  way_ = first;
  rides_left_ = 2;
  hands_.inspection(true);
  hold_button(now);
}

void Technician::hold_button(Time now) {
  has_moved_ = false;
  hands_.drive(way_);
  enter(Step::riding, now + obeys_within);
}

void Technician::ride(Time now, const TechnicianView& car) {
  if (!has_moved_ && !car.stands) {
    has_moved_ = true;
    until_ = now + ride_time;
  }
  if (now < until_) return;
  hands_.drive(Direction::none);
  if (!has_moved_) return end_in_vain(now);
  enter(Step::pausing, now + pause_time);
}

void Technician::pause(Time now) {
  if (--rides_left_ != 0) {
    way_ = opposite(way_);
    return hold_button(now);
  }
  hands_.inspection(false);
  leave();
}

void Technician::end_in_vain(Time now) {
  hands_.inspection(false);
  if (std::exchange(has_restarted_, true)) {
    has_given_up_ = true;
    hands_.tell(TechnicianStep::gives_up, no_floor);
    return leave();
  }
  hands_.restart();
  hands_.tell(TechnicianStep::restarts, no_floor);
  enter(Step::restarting, now + boot_time);
}

void Technician::leave() {
  enter(Step::away, never);
  hands_.tell(TechnicianStep::leaves, no_floor);
}

}  // namespace canvoy::lift
