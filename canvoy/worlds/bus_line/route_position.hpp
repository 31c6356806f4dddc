// Position of a vehicle on its route, as an on-board computer determines it: by pulses of the
// wheels, contacts of the doors, and satellites. It starts from a satellite position, or from the
// first stop where a journey begins; from there on it counts, and corrects itself at each stop.
// Where positions contradict it, it is lost until later positions agree. It reports a position only
// if there is one place on the route to which positions and wheels lead. Where the vehicle may
// drive elsewhere, between the end of a journey and the start of the next one, positions and wheels
// must agree for some distance.
//
//     RoutePosition position({.odometer = odometer, .has_open_door = doors});
//     position.begin(route, now);
//     position.take_fix(point);
//     position.sense(now);                        // each 50 ms
//     if (position.locate()) ...                  // now it knows
//     position.follow();
//     route.stops[position.place()]               // the one at which it stands, or the next one
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/route_match.hpp"

namespace canvoy::bus_line {

class RoutePosition {
 public:
  /// What it counts.
  struct Sensors {
    Callback<double()> odometer = {};     ///< odometer in m, by pulses of the wheels
    Callback<bool()> has_open_door = {};  ///< true while a contact of the doors is open
  };

  /// Period at which pulses and doors are read.
  static constexpr Duration look_period = 50ms;

  /// Begins without a route, and without a position.
  explicit RoutePosition(const Sensors& sensors) : sensors_(sensors) {}

  /// Begins a journey on this route, which must outlive it. Where the journey before was driven to
  /// its end, the vehicle goes on to the first stop.
  void begin(const BusRoute& route, Time now);
  /// Call it when no journey is known.
  void lose_route();
  /// Call it when messages may be lost.
  void forget();
  /// Takes a position by satellites; empty: they are lost.
  void take_fix(const std::optional<GeoPoint>& point);

  /// Call it in each look_period.
  void sense(Time now);
  /// True if the position has just become known.
  bool locate();
  /// Follows the vehicle; call it while the position is known.
  void follow();

  /// True if a place on the route is known.
  bool is_located() const { return is_located_; }
  /// True also on the way to the first stop.
  bool knows_stop() const { return is_located_ || (route_ != nullptr && has_just_begun_); }
  /// Index of the stop in the route: the one at which it stands, or the next one.
  std::size_t place() const { return place_; }
  /// False while it is unknown, and while it still rolls to the first stop.
  bool has_reached_stop() const { return is_located_ && (is_exact_ || !is_at_stop_); }
  /// Index of the last stop that it has reached.
  std::size_t reached() const { return reached_; }

 private:
  struct Fix {
    GeoPoint point{};
    double odometer = 0;
  };

  bool find();
  bool find_first_stop();
  bool find_start();
  bool find_start_at_end();
  bool find_end_of_transfer();
  bool find_on_the_way();
  void set_place(double metres, double odometer);
  void stand_at_first_stop(double odometer);
  void refine();
  void doubt();
  void get_lost();
  void leave_end();
  bool has_open_door() const { return sensors_.has_open_door && sensors_.has_open_door(); }
  double metres() const { return base_metres_ + odometer_ - base_odometer_; }
  double metres_of(std::size_t place) const { return route_->stops[place].metres; }
  bool is_last() const { return place_ + 1 >= route_->stops.size(); }
  /// True at the last stop, or about to stand there.
  bool is_at_end() const;

  Sensors sensors_;
  const BusRoute* route_ = nullptr;  ///< null: no journey is known
  bool is_located_ = false;
  bool is_at_stop_ = false;
  bool is_exact_ = false;  ///< it has stood at a stop of this route
  Time journey_since_{};
  bool has_just_begun_ = false;       ///< the journey before was driven to its end
  bool has_changed_ = false;          ///< another route was set for some time, and then this one
  double transfer_m_ = 0;             ///< m from the end of the journey before to the first stop
  double begun_at_ = 0;               ///< the odometer at the end of the journey before
  std::optional<double> ended_at_{};  ///< like begun_at_, where no other journey has come since
  bool may_be_elsewhere_ = false;     ///< elsewhere than on its route
  RouteMatch match_;
  bool is_confirmed_ = false;  ///< by more than one position
  unsigned doubts_ = 0;        ///< consecutive positions at another place
  std::size_t place_ = 0;
  std::size_t reached_ = 0;
  double base_metres_ = 0;  ///< along the route, at base_odometer_
  double base_odometer_ = 0;
  double odometer_ = 0;
  Time moved_at_{};
  Duration stands_for_{};
  bool is_standing_ = false;
  std::array<double, 10> pulses_{};  ///< the odometer in the last periods
  double speed_ = 0;                 ///< m/s, in that time
  std::size_t looks_ = 0;
  bool is_slow_ = false;
  bool was_slow_ = false;  ///< at the stop of place_: it stood there, if only for a moment
  std::optional<Fix> fix_;
};

}  // namespace canvoy::bus_line
