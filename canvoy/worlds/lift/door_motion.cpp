#include "canvoy/worlds/lift/door_motion.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::lift {

namespace {

/// Within this distance it is at the position.
constexpr double nothing_m = 1e-9;

Duration rounded_up(double seconds) {
  return Duration(static_cast<Duration::rep>(std::ceil(seconds * 1e6 - 1e-3)));
}

}  // namespace

double DoorMotion::seconds_of(Time at) const {
  return std::chrono::duration<double>(at - start_).count();
}

Time DoorMotion::start_of(std::size_t part) const {
  return start_ + rounded_up(parts_[part].seconds);
}

const DoorMotion::Part& DoorMotion::part_at(double seconds) const {
  std::size_t part = 0;
  while (part < count_ && parts_[part + 1].seconds <= seconds) ++part;
  return parts_[part];
}

double DoorMotion::position_m(Time at) const {
  if (at >= end()) return parts_[count_].position_m;
  const double seconds = seconds_of(at);
  const Part& part = part_at(seconds);
  const double passed = seconds - part.seconds;
  return part.position_m + (part.speed_m_s + part.acceleration_m_s2 / 2 * passed) * passed;
}

double DoorMotion::speed_m_s(Time at) const {
  if (at >= end()) return 0;
  const double seconds = seconds_of(at);
  const Part& part = part_at(seconds);
  return part.speed_m_s + part.acceleration_m_s2 * (seconds - part.seconds);
}

void DoorMotion::rest(Time now, double position_m) {
  start_ = now;
  count_ = 0;
  parts_[0] = {.seconds = 0, .position_m = position_m, .speed_m_s = 0, .acceleration_m_s2 = 0};
}

/// Begins at the present state.
void DoorMotion::begin(Time now) {
  const double position = position_m(now);
  const double speed = speed_m_s(now);
  rest(now, position);
  parts_[0].speed_m_s = speed;
}

/// Adds the part that begins where the last one ends.
void DoorMotion::add(double duration_s, double acceleration_m_s2) {
  if (duration_s <= 0 || count_ + 1 == parts_max) return;
  Part& part = parts_[count_];
  part.acceleration_m_s2 = acceleration_m_s2;
  parts_[++count_] = {
      .seconds = part.seconds + duration_s,
      .position_m =
          part.position_m + (part.speed_m_s + acceleration_m_s2 / 2 * duration_s) * duration_s,
      .speed_m_s = part.speed_m_s + acceleration_m_s2 * duration_s,
      .acceleration_m_s2 = 0};
}

void DoorMotion::stop(Time now, double deceleration_m_s2) {
  begin(now);
  const double speed = parts_[0].speed_m_s;
  add(std::abs(speed) / deceleration_m_s2, std::copysign(deceleration_m_s2, -speed));
  parts_[count_].speed_m_s = 0;
}

void DoorMotion::go(Time now, const Way& way) {
  begin(now);
  const double acceleration = way.acceleration_m_s2;
  const double first = parts_[0].speed_m_s;
  const double first_way = way.target_m - parts_[0].position_m;
  // On a way in the wrong direction it turns first.
  if (first * first_way < 0) {
    add(std::abs(first) / acceleration, std::copysign(acceleration, -first));
    parts_[count_].speed_m_s = 0;
  }
  const double distance = std::abs(way.target_m - parts_[count_].position_m);
  const double sign = std::copysign(1.0, way.target_m - parts_[count_].position_m);
  const double speed = std::abs(parts_[count_].speed_m_s);
  const double stopping = speed * speed / (2 * acceleration);
  if (distance > nothing_m && stopping >= distance) {
    add(2 * distance / speed, -sign * speed * speed / (2 * distance));
  } else if (distance > nothing_m) {
    const double reachable = std::sqrt(acceleration * distance + speed * speed / 2);
    const double peak = std::min(way.speed_m_s, reachable);
    const double change = std::abs(peak * peak - speed * speed) / (2 * acceleration);
    const double constant = distance - change - peak * peak / (2 * acceleration);
    add(std::abs(peak - speed) / acceleration, sign * std::copysign(acceleration, peak - speed));
    add(constant / peak, 0);
    add(peak / acceleration, -sign * acceleration);
  }
  parts_[count_].position_m = way.target_m;
  parts_[count_].speed_m_s = 0;
}

Time DoorMotion::time_at(double position_m, Time after) const {
  Time earliest = never;
  for (std::size_t i = 0; i < count_; ++i) {
    const Part& part = parts_[i];
    const double length = parts_[i + 1].seconds - part.seconds;
    const double way = position_m - part.position_m;
    // way = speed t + acceleration/2 t t
    const double half = part.acceleration_m_s2 / 2;
    std::array<double, 2> roots = {-1, -1};
    if (half == 0) {
      if (part.speed_m_s != 0) roots[0] = way / part.speed_m_s;
    } else {
      const double inner = part.speed_m_s * part.speed_m_s + 4 * half * way;
      if (inner >= 0) {
        roots[0] = (-part.speed_m_s + std::sqrt(inner)) / (2 * half);
        roots[1] = (-part.speed_m_s - std::sqrt(inner)) / (2 * half);
      }
    }
    for (const double root : roots) {
      if (root < 0 || root > length) continue;
      const Time at = start_ + rounded_up(part.seconds + root);
      if (at > after) earliest = std::min(earliest, at);
    }
  }
  return earliest;
}

}  // namespace canvoy::lift
