// A bus on its line for a day: it drives its block by the timetable, stops where passengers want to
// get in or out, opens its doors, waits for the time of departure, and may be late. A plant without
// devices, which provides the truth that displays must show.
//
//     BusVehicle bus(line, 0, {.seed = 1});
//     while (!bus.is_over()) bus.advance(bus.deadline());
//     bus.truth().stop->name;
//
// The driver looks for people at the stop and for the stop button, and leaves no timing point
// early.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/bus_line/bus_door.hpp"
#include "canvoy/worlds/bus_line/bus_drive.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/fare_position.hpp"
#include "canvoy/worlds/bus_line/riders.hpp"

namespace canvoy::bus_line {

/// What the vehicle does.
enum class BusState : std::uint8_t {
  at_stop,
  driving,       ///< along its route, or standing at lights
  transferring,  ///< from the end of one journey to the start of the next one
  over,          ///< the block is done
};

/// A vehicle, its driver and its passengers.
struct BusOptions {
  std::uint64_t seed = 1;  ///< of traffic lights and passengers
  /// From the front: people get in at all, and out from the second on.
  std::vector<DoorUse> doors = {{.boards = true, .alights = false}, {.boards = true}};
  RiderOptions riders{};  ///< of the passengers
  /// Time of the day of service at time 0; before the first departure.
  Duration start = Duration::min();  ///< default: five minutes before the first departure
  double speed_max = 13.9;           ///< m/s in town; more where the timetable needs it
  unsigned red_light_percent = 30;   ///< share of the ways between stops that have a red light
  Duration late{};                   ///< lateness at the start of the first journey
  /// Delays by which the vehicle arrives at stops, as far as roads and speed_max allow; null: it
  /// arrives a little before its time.
  std::shared_ptr<const Delays> delays{};
  bool has_hasty_driver = false;   ///< the driver waits for the first departure alone
  bool has_unkind_driver = false;  ///< the driver opens only for passengers who get out
};

/// What happens to the vehicle, as on_event() reports it.
enum class BusEvent : std::uint8_t {
  journey_begins,
  arrives,  ///< stands at a stop
  leaves,   ///< its wheels turn
  passes,   ///< a stop without standing there
  door_changes,
  stop_requested,
  block_ends,
};

/// True state of the bus, which displays and others must show.
struct BusTruth {
  const Block* block = nullptr;      ///< its work of the day
  const Journey* journey = nullptr;  ///< the present one, or the next one at a transfer
  const BusRoute* route = nullptr;   ///< of that journey
  std::size_t place = 0;  ///< index of the stop in the route: the one at which it stands, or the
                          ///< next one
  const BusStop* stop = nullptr;  ///< the stop at `place`
  bool is_at_stop = false;        ///< it stands there
  bool stop_requested = false;    ///< since the last stop
  FarePosition fare{};            ///< for tickets
  unsigned aboard = 0;            ///< people in both cars

  /// Index in the route of the last stop that it has reached; of the first stop before that.
  std::size_t reached() const { return is_at_stop || place == 0 ? place : place - 1; }
};

/// Motion that a real vehicle reports.
struct RealMotion {
  double speed = 0;               ///< m/s
  std::uint32_t known_doors = 0;  ///< one bit for each door; the first door is bit 0
  std::uint32_t open_doors = 0;   ///< of the known ones
};

/// Beginning of the world, as time of the day of service; `block` must have a journey.
Duration start_of(const Block& block, const BusOptions& options);

class BusVehicle {
 public:
  static constexpr Duration step_time = 100ms;  ///< between two calls while it moves

  /// `line` must outlive this object; `block` must have a journey.
  BusVehicle(const BusLine& line, std::size_t block, const BusOptions& options,
             RiderHands hands = {});
  BusVehicle(const BusVehicle&) = delete;
  BusVehicle& operator=(const BusVehicle&) = delete;

  /// Next call of advance() that has something to do; never: the block is over.
  Time deadline() const;
  /// Drives, opens doors and moves passengers up to `now`.
  void advance(Time now);
  /// Sets the function that receives each event, with the index of its stop in the route.
  void on_event(std::function<void(Time, BusEvent, std::size_t stop)> told) {
    told_ = std::move(told);
  }
  /// Presses the stop button.
  void request_stop(Time now);
  /// Breaks or repairs a door.
  void break_door(Time now, std::size_t door, bool is_broken);
  /// Makes wheels and doors follow the report of a real vehicle; empty: the driver. The bus moves
  /// along its route. It is at a stop where it halts at most 30 m from it and a door opens, or
  /// nothing is reported of the doors, or where it halts at most 3 m from it.
  void follow(Time now, const std::optional<RealMotion>& real);
  /// Puts a thing into the doorway, or removes it.
  void obstruct_door(Time now, std::size_t door, bool is_obstructed);

  /// The truth at present; its pointers are valid as long as the line.
  BusTruth truth() const;
  /// What it does.
  BusState state() const { return state_; }
  /// True if the block is done.
  bool is_over() const { return state_ == BusState::over; }
  /// Where it is on the earth.
  GeoPoint position() const { return drive_.place(); }
  /// Degrees clockwise from north.
  double heading() const { return drive_.heading(); }
  double speed() const { return drive_.speed(); }        ///< m/s
  double odometer() const { return drive_.odometer(); }  ///< m
  /// Distance along the path of the route, or of the transfer.
  double metres_on_route() const { return drive_.metres(); }
  /// `number` from 0.
  const BusDoor& door(std::size_t number) const { return doors_[number]; }
  /// Number of doors.
  std::size_t door_count() const { return doors_.size(); }
  /// True if each door is closed.
  bool all_doors_closed() const { return std::ranges::all_of(doors_, &BusDoor::is_closed); }
  /// Its passengers.
  const Riders& riders() const { return riders_; }
  /// Delay at the last arrival, departure or passing; negative: early.
  Duration delay() const { return delay_; }
  /// Time of the day of service.
  Duration time_of_day(Time now) const { return now - zero_; }

 private:
  const Journey& journey() const { return block_->journeys[journey_]; }
  const BusRoute& route() const { return line_->routes[journey().route]; }
  const Passing& passing() const { return journey().passings[place_]; }
  bool is_last_stop() const { return place_ + 1 == journey().passings.size(); }
  Time departure() const { return zero_ + passing().departure; }
  /// True while the driver has not come: late for the first journey, whatever the timetable says.
  bool is_to_come(Time now) const {
    return journey_ == 0 && place_ == 0 && now < departure() + options_.late;
  }

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
  double seconds_left(Time now) const;

  const BusLine* line_;
  const Block* block_;
  BusOptions options_;
  Random random_;
  Time zero_;  ///< beginning of the day of service
  BusDrive drive_;
  Path transfer_;
  std::vector<BusDoor> doors_;
  std::vector<DoorState> seen_;  ///< last reported states of the doors
  std::vector<bool> has_thing_;  ///< true: a thing lies in the doorway
  std::optional<RealMotion> real_;
  Riders riders_;
  std::function<void(Time, BusEvent, std::size_t)> told_;
  BusState state_ = BusState::at_stop;
  std::size_t journey_ = 0;
  std::size_t place_ = 0;  ///< index of the stop at which it stands, or of the next one
  FarePosition fare_;
  bool stop_requested_ = false;
  bool wants_to_go_ = false;  ///< the doors shall close
  bool is_passing_ = false;   ///< it does not halt at the next stop
  Time quiet_since_ = never;  ///< time since when no passenger passes a door
  Time next_look_{};          ///< time at which the driver looks again
  Time leg_began_{};
  Time green_at_ = never;  ///< end of the red light at which it stands; never: it has not come
                           ///< there
  double light_ = -1;      ///< position of the red light, in m along the route; below 0: none
  Time last_{};            ///< time up to which it has driven
  Duration delay_{};
};

}  // namespace canvoy::bus_line
