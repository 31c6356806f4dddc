#include "canvoy/devices/cia417/drive/motion_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace canvoy::cia417 {

namespace {

using cia402::ProfileType;

/// Positions that differ by less are equal: for rounding when a ramp is planned again on its way.
constexpr double tolerance = 1e-9;

constexpr double square(double value) {
  return value * value;
}
constexpr double sign_of(double value) {
  return value < 0 ? -1 : 1;
}
/// Seconds for a change of the acceleration by one; 0 without a limit of the jerk.
constexpr double inverse(double jerk) {
  return jerk > 0 ? 1 / jerk : 0;
}

/// The two bends of one ramp, and the acceleration between them.
struct Bends {
  double acceleration;
  double start;  ///< inverse jerks
  double end;
};
Bends bends(const MotionLimits& limits, bool speeding_up) {
  const bool has_jerk = limits.type != ProfileType::linear;
  const MotionLimits::Jerks jerk = has_jerk ? limits.jerk : MotionLimits::Jerks{};
  if (speeding_up) {
    return {limits.acceleration, inverse(jerk.start_acceleration), inverse(jerk.end_acceleration)};
  }
  return {limits.deceleration, inverse(jerk.start_deceleration), inverse(jerk.end_deceleration)};
}

}  // namespace

/// From a velocity and an acceleration to another velocity without acceleration.
class MotionProfile::Ramp {
 public:
  Ramp(double velocity, double acceleration, double target, const MotionLimits& limits)
      : state_{0, velocity, acceleration} {
    const bool rises = target >= released(velocity, acceleration, limits);
    const double sign = rises ? 1 : -1;
    if (acceleration * sign < 0) release(limits);
    const Bends bend = bends(limits, sign * (state_.velocity + target) >= 0);
    const bool in_one_piece =
        limits.type == ProfileType::sine_squared || limits.type == ProfileType::jerk_free;
    if (in_one_piece && state_.acceleration == 0) {
      add_shape(limits.type, target - state_.velocity, bend);
    } else {
      change_velocity(std::abs(target - state_.velocity), sign, bend);
    }
    state_.velocity = target;
    state_.acceleration = 0;
  }

  /// The velocity after the acceleration has been reduced to 0.
  static double released(double velocity, double acceleration, const MotionLimits& limits) {
    const Bends bend = bends(limits, velocity * acceleration >= 0);
    return velocity + acceleration * std::abs(acceleration) / 2 * bend.end;
  }

  double distance() const { return state_.position; }
  double velocity() const { return state_.velocity; }
  std::span<const Piece> pieces() const { return std::span(pieces_).first(piece_count_); }

 private:
  void add(double duration, double acceleration, double jerk) {
    state_.acceleration = acceleration;
    if (!(duration > 0)) return;
    pieces_[piece_count_] = {duration, jerk, state_, Shape::polynomial};
    state_ = evaluate(pieces_[piece_count_++], duration);
  }
  /// Adds the end of a ramp that is given up.
  void release(const MotionLimits& limits) {
    const double acceleration = state_.acceleration;
    const Bends bend = bends(limits, state_.velocity * acceleration >= 0);
    const double seconds = std::abs(acceleration) * bend.end;
    if (seconds > 0) add(seconds, acceleration, -acceleration / seconds);
    state_.acceleration = 0;
  }
  /// Up to the highest acceleration, constant, and down to 0.
  void change_velocity(double change, double sign, const Bends& bend) {
    const double now = std::abs(state_.acceleration);
    const double both = bend.start + bend.end;
    double peak = bend.acceleration;
    if (both > 0) {
      peak = std::min(peak, std::sqrt((2 * change + square(now) * bend.start) / both));
    }
    // If the limits were lowered, the acceleration decreases to them by the bend of the end.
    const double bend_to_peak = now > peak ? -bend.end : bend.start;
    const double to_peak = (peak - now) * bend_to_peak;
    const double bent = (square(peak) - square(now)) / 2 * bend_to_peak;
    const double jerk = to_peak > 0 ? sign * (peak - now) / to_peak : 0;
    add(to_peak, sign * now, jerk);
    const double held = change - bent - square(peak) / 2 * bend.end;
    if (peak > 0) add(held / peak, sign * peak, 0);
    const double from_peak = peak * bend.end;
    if (from_peak > 0) add(from_peak, sign * peak, -sign * peak / from_peak);
  }
  /// The highest slope of the unit ramp is the acceleration, that of its slope the jerk.
  void add_shape(ProfileType type, double change, const Bends& bend) {
    if (change == 0) return;
    const bool is_sine = type == ProfileType::sine_squared;
    const double slope = is_sine ? std::numbers::pi / 2 : 15.0 / 8;
    const double curvature = is_sine ? square(std::numbers::pi) / 2 : 10 * std::numbers::inv_sqrt3;
    const double by_acceleration = slope * std::abs(change) / bend.acceleration;
    const double by_jerk = std::sqrt(curvature * std::abs(change) * std::max(bend.start, bend.end));
    const Shape shape = is_sine ? Shape::sine_squared : Shape::jerk_free;
    const double duration = std::max(by_acceleration, by_jerk);
    pieces_[piece_count_] = {duration, change, state_, shape};
    state_ = evaluate(pieces_[piece_count_++], duration);
  }

  std::array<Piece, 4> pieces_{};
  std::size_t piece_count_ = 0;
  MotionState state_;
};

/// A distance in one direction: its highest velocity determines the rest.
struct MotionProfile::Way {
  Way(const MotionState& start, double to, const MotionLimits& given, double wanted_end)
      : from(start), target(to), limits(given), end_velocity(std::min(wanted_end, given.velocity)) {
    const double moving = from.velocity != 0 ? from.velocity : from.acceleration;
    sign = sign_of(moving != 0 ? moving : target - from.position);
    distance = sign * (target - from.position);
    released = sign * Ramp::released(from.velocity, from.acceleration, limits);
  }

  Ramp first(double peak) const { return {from.velocity, from.acceleration, sign * peak, limits}; }
  Ramp last(double peak) const { return {sign * peak, 0, sign * end_velocity, limits}; }
  /// Distance between the two ramps.
  double rest(double peak) const {
    return distance - sign * (first(peak).distance() + last(peak).distance());
  }
  bool is_possible() const {
    const double slowest = std::min(end_velocity, std::max(released, 0.0));
    return sign * first(slowest).distance() <= distance + tolerance;
  }
  /// Searches between a velocity with a rest and one without.
  template <class Rest>
  double search(double fits, double too_fast, Rest rest_of) const {
    while (std::abs(too_fast - fits) > 1e-13 * limits.velocity) {
      const double middle = fits + (too_fast - fits) / 2;
      if (middle == fits || middle == too_fast) break;
      (rest_of(middle) >= 0 ? fits : too_fast) = middle;
    }
    return fits;
  }
  double find_peak() {
    const auto rest_of = [this](double peak) { return rest(peak); };
    if (rest(limits.velocity) >= 0) return limits.velocity;
    const double low = std::clamp(std::max(released, end_velocity), 0.0, limits.velocity);
    if (rest(low) >= 0) return search(low, limits.velocity, rest_of);
    // It already slows down, and less than it could.
    if (rest(end_velocity) >= -tolerance) return search(end_velocity, low, rest_of);
    // Too short to reach the end velocity.
    end_velocity = search(std::max(released, 0.0), end_velocity,
                          [this](double end) { return distance - sign * first(end).distance(); });
    return end_velocity;
  }

  MotionState from;
  double target;
  MotionLimits limits;
  double end_velocity;
  double sign;
  double distance;
  double released;  ///< the velocity after its acceleration has been reduced to 0
};

MotionProfile MotionProfile::resting_at(double position) {
  MotionProfile profile;
  profile.end_.position = position;
  return profile;
}

MotionProfile MotionProfile::to_position(const MotionState& from, double target,
                                         const MotionLimits& limits, double end_velocity) {
  MotionProfile profile;
  profile.end_ = from;
  const Way way(from, target, limits, end_velocity);
  if (way.is_possible()) {
    profile.travel(way);
    return profile;
  }
  profile.append(Ramp(from.velocity, from.acceleration, 0, limits));
  profile.travel(Way(profile.end_, target, limits, end_velocity));
  return profile;
}

MotionProfile MotionProfile::to_velocity(const MotionState& from, double velocity,
                                         const MotionLimits& limits) {
  MotionProfile profile;
  profile.end_ = from;
  if (from.velocity * velocity < 0) {
    profile.append(Ramp(from.velocity, from.acceleration, 0, limits));
  }
  const MotionState turn = profile.end_;
  profile.append(Ramp(turn.velocity, turn.acceleration, velocity, limits));
  return profile;
}

bool MotionProfile::can_reach(const MotionState& from, double target, const MotionLimits& limits,
                              double end_velocity) {
  return Way(from, target, limits, end_velocity).is_possible();
}

double MotionProfile::stopping_distance(const MotionState& from, const MotionLimits& limits) {
  return Ramp(from.velocity, from.acceleration, 0, limits).distance();
}

MotionState MotionProfile::at(double seconds) const {
  if (seconds >= duration_) {
    return {end_.position + end_.velocity * (seconds - duration_), end_.velocity, 0};
  }
  double left = std::max(seconds, 0.0);
  for (const Piece& piece : std::span(pieces_).first(piece_count_)) {
    if (left < piece.duration) return evaluate(piece, left);
    left -= piece.duration;
  }
  return end_;
}

double MotionProfile::peak_velocity() const {
  double peak = end_.velocity;
  for (const Piece& piece : std::span(pieces_).first(piece_count_)) {
    if (std::abs(piece.start.velocity) > std::abs(peak)) peak = piece.start.velocity;
  }
  return peak;
}

MotionState MotionProfile::evaluate(const Piece& piece, double seconds) {
  const auto& [position, velocity, acceleration] = piece.start;
  const double t = seconds;
  const double part = t / piece.duration;
  const double change = piece.jerk;
  constexpr double pi = std::numbers::pi;
  switch (piece.shape) {
    case Shape::sine_squared:
      return {
          position + velocity * t + change * piece.duration * (part - std::sin(pi * part) / pi) / 2,
          velocity + change * (1 - std::cos(pi * part)) / 2,
          change / piece.duration * pi / 2 * std::sin(pi * part)};
    case Shape::jerk_free: {
      const double cube = part * part * part;
      return {position + velocity * t +
                  change * piece.duration * cube * part * (2.5 + part * (part - 3)),
              velocity + change * cube * (10 + part * (6 * part - 15)),
              change / piece.duration * 30 * square(part * (1 - part))};
    }
    case Shape::polynomial:
      break;
  }
  return {position + t * (velocity + t * (acceleration / 2 + t * piece.jerk / 6)),
          velocity + t * (acceleration + t * piece.jerk / 2), acceleration + t * piece.jerk};
}

void MotionProfile::append(const Ramp& ramp) {
  for (Piece piece : ramp.pieces()) {
    piece.start.position += end_.position;
    pieces_[piece_count_++] = piece;
    duration_ += piece.duration;
  }
  end_ = {end_.position + ramp.distance(), ramp.velocity(), 0};
}

void MotionProfile::cruise(double seconds) {
  if (!(seconds > 0)) return;
  pieces_[piece_count_++] = {seconds, 0, end_, Shape::polynomial};
  end_.position += end_.velocity * seconds;
  duration_ += seconds;
}

void MotionProfile::travel(const Way& given) {
  Way way = given;
  const double peak = way.find_peak();
  append(way.first(peak));
  const double rest = way.rest(peak);
  if (peak > 0) cruise(rest / peak);
  append(way.last(peak));
  end_.position = way.target;
}

}  // namespace canvoy::cia417
