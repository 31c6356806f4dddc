// A bus on its line for a day: it drives its block on the timetable, stops where somebody wants in
// or out, opens its doors, waits for the time of departure, and is late as buses are. A plant: no
// device is in it, and it knows the truth that displays have to show.
//
//     BusVehicle bus(line, 0, {.seed = 1});
//     while (!bus.is_over()) bus.advance(bus.deadline());
//     bus.truth().stop->name;
//
// The driver does what a driver does: he looks for people at the stop and for the stop button, and
// leaves no timing point early.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/bus/bus_door.hpp"
#include "canvoy/sim/bus/bus_drive.hpp"
#include "canvoy/sim/bus/bus_line.hpp"
#include "canvoy/sim/bus/fare_position.hpp"
#include "canvoy/sim/bus/riders.hpp"

namespace canvoy::bus {

enum class BusState : std::uint8_t {
  at_stop,
  driving,       ///< along its route, at lights as well
  transferring,  ///< from the end of one journey to the start of the next one
  over,          ///< the block is done
};

struct BusOptions {
  std::uint64_t seed = 1;
  std::vector<DoorUse> doors = {{.boards = true, .alights = false}, {.boards = true}};
  RiderOptions riders{};
  /// The time of day, of the day of service, at time 0; below the first departure.
  Duration start = Duration::min();  ///< as it is: five minutes before the first departure
  double speed_max = 13.9;           ///< m/s in town; more where the timetable asks for it
  unsigned red_light_percent = 30;   ///< of ways between stops, with one
  bool has_hasty_driver = false;     ///< he waits for the first departure alone
  bool has_unkind_driver = false;    ///< he opens for those who want out alone
};

enum class BusEvent : std::uint8_t {
  journey_begins,
  arrives,  ///< stands at a stop
  leaves,   ///< its wheels turn
  passes,   ///< a stop without standing
  door_changes,
  stop_requested,
  block_ends,
};

/// What passengers have to be told, and others.
struct BusTruth {
  const Block* block = nullptr;
  const Journey* journey = nullptr;
  const BusRoute* route = nullptr;
  std::size_t place = 0;  ///< of the stop in the route: at which it stands, or the next one
  const BusStop* stop = nullptr;
  bool is_at_stop = false;
  bool stop_requested = false;
  FarePosition fare{};
  unsigned aboard = 0;
};

/// What a real vehicle says of itself.
struct RealMotion {
  double speed = 0;               ///< m/s
  std::uint32_t known_doors = 0;  ///< a bit each, the first is bit 0
  std::uint32_t open_doors = 0;   ///< of the known ones
};

/// When the world begins, of the day of service; `block` has a journey.
Duration start_of(const Block& block, const BusOptions& options);

class BusVehicle {
 public:
  static constexpr Duration step_time = 100ms;

  /// `line` outlives this; `block` has a journey.
  BusVehicle(const BusLine& line, std::size_t block, const BusOptions& options,
             RiderHands hands = {});
  BusVehicle(const BusVehicle&) = delete;
  BusVehicle& operator=(const BusVehicle&) = delete;

  Time deadline() const;
  void advance(Time now);
  /// Told of each event from now on, with the stop of the route that it is about.
  void on_event(std::function<void(Time, BusEvent, std::size_t stop)> told) {
    told_ = std::move(told);
  }
  /// The stop button, or who stands for it.
  void request_stop(Time now);
  /// A fault of a door, or its end.
  void break_door(Time now, std::size_t door, bool is_broken);
  /// From now on wheels and doors do as a real vehicle says; nothing: as the driver wants. It goes
  /// along its route; where it comes to stand at most 30 m from a stop and a door opens, or says
  /// nothing of its doors, or at most 3 m from it, it is at the stop.
  void follow(Time now, const std::optional<RealMotion>& real);
  /// Something lies in it.
  void obstruct_door(Time now, std::size_t door, bool is_obstructed);

  BusTruth truth() const;
  BusState state() const { return state_; }
  bool is_over() const { return state_ == BusState::over; }
  GeoPoint position() const { return drive_.place(); }
  double heading() const { return drive_.heading(); }
  double speed() const { return drive_.speed(); }        ///< m/s
  double odometer() const { return drive_.odometer(); }  ///< m
  double metres_on_route() const { return drive_.metres(); }
  const BusDoor& door(std::size_t number) const { return doors_[number]; }
  std::size_t door_count() const { return doors_.size(); }
  bool all_doors_closed() const { return std::ranges::all_of(doors_, &BusDoor::is_closed); }
  const Riders& riders() const { return riders_; }
  /// Behind the timetable at the last arrival, departure or passing; early is negative.
  Duration delay() const { return delay_; }
  /// The time of the day of service.
  Duration time_of_day(Time now) const { return now - zero_; }

 private:
  const Journey& journey() const { return block_->journeys[journey_]; }
  const BusRoute& route() const { return line_->routes[journey().route]; }
  const Passing& passing() const { return journey().passings[place_]; }
  bool is_last_stop() const { return place_ + 1 == journey().passings.size(); }
  Time departure() const { return zero_ + passing().departure; }

  RiderHands with_button(RiderHands hands);
  void tell(Time now, BusEvent event, std::size_t stop) const;
  void begin_journey(Time now);
  void arrive(Time now);
  void stand(Time now);
  void stand_open(Time now);
  void end_journey(Time now);
  void leave(Time now);
  void begin_leg(Time now);
  void go_on(Time now);
  void end_transfer(Time now);
  void drive(Time now, Duration step);
  void look_ahead(Time now);
  bool may_pass(Time now) const;
  void pass(Time now);
  void wait_for_green(Time now);
  void stand_as_real(Time now);
  void drive_as_real(Time now, Duration step);
  bool stands_at_stop(double beyond) const;
  void move_doors(Time now);
  bool are_closed() const;
  bool wants_doors(Time now) const;
  double leg_speed(Time now) const;

  const BusLine* line_;
  const Block* block_;
  BusOptions options_;
  Random random_;
  Time zero_;  ///< the beginning of the day of service
  BusDrive drive_;
  Path transfer_;
  std::vector<BusDoor> doors_;
  std::vector<DoorState> seen_;  ///< what was told of the doors
  std::vector<bool> has_thing_;  ///< in it, beside passengers
  std::optional<RealMotion> real_;
  Riders riders_;
  std::function<void(Time, BusEvent, std::size_t)> told_;
  BusState state_ = BusState::at_stop;
  std::size_t journey_ = 0;
  std::size_t place_ = 0;  ///< of the stop at which it stands, or the next one
  FarePosition fare_;
  bool stop_requested_ = false;
  bool wants_to_go_ = false;  ///< the doors shall close
  bool is_passing_ = false;   ///< it does not stand at the next stop
  Time quiet_since_ = never;  ///< nobody goes through a door
  Time next_look_{};          ///< when the driver looks again
  Time leg_began_{};
  Time green_at_ = never;  ///< of the lights at which it stands; never: it has not come there
  double light_ = -1;      ///< where lights are red, in m along the route; below 0: nowhere
  Time last_{};            ///< up to when it has been driven
  Duration delay_{};
};

}  // namespace canvoy::bus
