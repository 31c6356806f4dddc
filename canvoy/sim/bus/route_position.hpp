// Where a vehicle is on its route, as an on-board computer knows it: by pulses of the wheels,
// contacts of the doors, and satellites. It learns where it is from a position, or stands at the
// first stop where a journey begins; from then on it counts, and corrects itself at each stop.
// Where positions say another place it is lost, and finds itself again by the next ones. What it
// knows is certain enough to be told, or it knows nothing: there is one place on the route to which
// positions and wheels lead, and where it may drive elsewhere, on its way from the end of a journey
// to the start of the next one, they have to meet for some way.
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
#include "canvoy/sim/bus/bus_line.hpp"
#include "canvoy/sim/bus/route_match.hpp"

namespace canvoy::bus {

class RoutePosition {
 public:
  struct Sensors {
    Callback<double()> odometer = {};     ///< m, by pulses of the wheels
    Callback<bool()> has_open_door = {};  ///< the contacts of the doors
  };

  /// How often it looks at pulses and doors.
  static constexpr Duration look_period = 50ms;

  explicit RoutePosition(const Sensors& sensors) : sensors_(sensors) {}

  /// A journey on this route, which must outlive it; where one before was driven to its end, it
  /// goes on to the first stop.
  void begin(const BusRoute& route, Time now);
  /// No journey is known.
  void lose_route();
  /// It has missed what was told.
  void forget();
  /// A position by satellites; nothing: they are lost.
  void take_fix(const std::optional<GeoPoint>& point);

  /// In each look_period.
  void sense(Time now);
  /// True: it knows now where it is, and did not before.
  bool locate();
  /// While it is located.
  void follow();

  bool is_located() const { return is_located_; }
  /// Also on the way to the first stop.
  bool knows_stop() const { return is_located_ || (route_ != nullptr && has_just_begun_); }
  /// Of the stop in the route: at which it stands, or the next one.
  std::size_t place() const { return place_; }
  /// The last one.
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
  /// At the last stop, or about to stand there.
  bool is_at_end() const;

  Sensors sensors_;
  const BusRoute* route_ = nullptr;  ///< null: no journey is told
  bool is_located_ = false;
  bool is_at_stop_ = false;
  bool is_exact_ = false;  ///< it has stood at a stop of this route
  Time journey_since_{};
  bool has_just_begun_ = false;       ///< the one before was driven to its end
  bool has_changed_ = false;          ///< another one was told for some time, and then this one
  double transfer_m_ = 0;             ///< from the end of the one before to the first stop
  double begun_at_ = 0;               ///< the odometer at the end of the one before
  std::optional<double> ended_at_{};  ///< the same, where no other one was told since
  bool may_be_elsewhere_ = false;     ///< than on its route
  RouteMatch match_;
  bool is_confirmed_ = false;  ///< where it is, by more than one position
  unsigned doubts_ = 0;        ///< positions, one after the other, that say another place
  std::size_t place_ = 0;
  std::size_t reached_ = 0;
  double base_metres_ = 0;  ///< along the route, where the odometer was base_odometer_
  double base_odometer_ = 0;
  double odometer_ = 0;
  Time moved_at_{};
  Duration stands_for_{};
  bool is_standing_ = false;
  std::array<double, 10> pulses_{};  ///< the odometer at the last looks
  double speed_ = 0;                 ///< m/s, in that time
  std::size_t looks_ = 0;
  bool is_slow_ = false;
  bool was_slow_ = false;  ///< at the stop of place_: it stood there, were it for a moment
  std::optional<Fix> fix_;
};

}  // namespace canvoy::bus
