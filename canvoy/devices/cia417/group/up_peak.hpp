// Sends several cars of a group at once for passengers who wait at the main floor. A hall call
// brings one car. If a call follows as soon as that car has left, and again after the next one,
// more passengers wait there than single cars can take, and those left behind would wait until the
// next one has opened, filled and left. Therefore further idle cars at the main floor open as well,
// which the classical calculation of up-peak traffic assumes (Barney and Al-Sharif, Elevator
// Traffic Handbook).
//
//     UpPeak up_peak(lifts, {.main_floor = 1});
//     up_peak.called(now, call);       // by people at a landing
//     up_peak.opened(2, {1, Direction::up});
//     if (const LiftMask wanted = up_peak.call_more(busy); wanted != 0) open(wanted);
#pragma once

#include <array>
#include <span>

#include "canvoy/devices/cia417/group/hall_dispatcher.hpp"

namespace canvoy::cia417 {

/// Settings of up-peak traffic.
struct UpPeakSettings {
  std::uint8_t main_floor = 1;  ///< from 1, where passengers come in
  /// Maximum number of cars that fill there at the same time; 0 or 1: each waits for a call after
  /// the last one has left.
  unsigned cars_max = 2;
  /// A call within this time after a car has left is by passengers for whom it had no room.
  Duration left_behind = 2s;
  /// Number of consecutive cars that leave passengers behind before others open as well. By chance,
  /// single cars do so even with little traffic, and passengers who share two cars cost more stops.
  unsigned in_a_row = 2;
};

/// The result depends only on the messages of the lifts, and not on chance. Each step visits each
/// lift once.
class UpPeak {
 public:
  /// `lifts` are lift 1 and up, and must outlive this.
  UpPeak(std::span<const GroupLift> lifts, const UpPeakSettings& settings)
      : lifts_(lifts), settings_(settings) {}

  /// Discards what has happened, after a reset.
  void reset();
  /// Takes a call: those at the main floor in direction up count.
  void called(Time now, const HallCall& call);
  /// Takes a stop: a lift opens there, and continues in that direction.
  void opened(unsigned lift, const Landing& landing);
  /// Takes a report of its position and direction.
  void told(Time now, unsigned lift, bool moving);

  /// True if passengers were left behind and cars fill.
  bool is_crowded() const { return left_people_ >= settings_.in_a_row; }
  /// The lifts that have to open at the main floor and have not done so yet, if there is a further
  /// one; otherwise none. `busy`: lifts that are occupied.
  LiftMask call_more(LiftMask busy);
  /// Call for these lifts: of low priority, so that all others come first, and of a kind that
  /// panels do not show.
  HallCall call() const;

 private:
  bool is_ready(unsigned lift) const;
  LiftMask serving() const;

  std::span<const GroupLift> lifts_;
  UpPeakSettings settings_;
  HallCall call_{};
  Time left_at_{};
  bool has_left_ = false;
  unsigned left_people_ = 0;  ///< consecutive cars
  LiftMask filling_ = 0;      ///< opened, and not left
  LiftMask called_ = 0;       ///< have to open
  LiftMask asked_ = 0;        ///< had to open since they came
};

}  // namespace canvoy::cia417
