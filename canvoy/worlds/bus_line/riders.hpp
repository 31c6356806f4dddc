// The passengers of a bus: they come to their stops, get in and out by its doors, press the button
// for the stop, and buy or cancel tickets. They are drawn by a seed, each journey separately, so
// that they do not depend on what the bus does. Where vehicles follow each other at short times,
// people come at random, from when the vehicle ahead has left on: who is late has more of them.
//
//     Riders riders({}, seed, doors, hands);
//     riders.begin_journey(now, journey, route, of_day);
//     riders.stand_at(now, 0);  riders.door_changed(now, 0, true);
//     riders.advance(now);          // when riders.deadline() has come
//
// Passengers who get out go first; a door passes one person at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/bus_line/bus_line.hpp"
#include "canvoy/worlds/bus_line/demand.hpp"

namespace canvoy::bus_line {

/// What a person does for a valid ticket.
enum class Ticket : std::uint8_t {
  pass,         ///< nothing to do
  to_cancel,    ///< at a ticket canceller, when aboard
  from_driver,  ///< bought at the door
};

/// A passenger with a way on the present journey.
struct Rider {
  std::size_t from = 0;          ///< stops of the route
  std::size_t to = 0;            ///< index of the stop to get out at
  Time comes{};                  ///< time of arrival at the first stop
  Ticket ticket = Ticket::pass;  ///< how the passenger pays
  bool has_ticket = false;       ///< one that is valid
  Time boarded = never;          ///< time of getting in; never: waits still
  std::uint64_t number = 0;      ///< number since the beginning, from 1 on
  unsigned car = 1;              ///< car in which the passenger rides, 1 to 4
};

/// Use of a door, in the order of the doors from the front.
struct DoorUse {
  bool boards = true;   ///< people get in here
  bool alights = true;  ///< people get out here
};

/// Actions of passengers at devices. An empty function stands for success. False: the device did
/// not obey, and the passenger tries again.
struct RiderHands {
  std::function<bool(Time, const Rider&)> press_stop{};               ///< asks for the next stop
  std::function<bool(Time, const Rider&)> cancel_ticket{};            ///< at a canceller
  std::function<bool(Time, const Rider&)> buy_ticket{};               ///< from the driver's printer
  std::function<void(Time, std::size_t door, bool is_in)> through{};  ///< a passenger has got in or
                                                                      ///< out
};

/// The vehicle ahead at a stop where people come at random.
struct VehicleAhead {
  /// Its departure from the stop, as time of the day of service; empty: it has not left yet.
  std::optional<Duration> left{};
  Duration headway{};  ///< planned time between its departure and that of this vehicle; above 0
};
/// Returns the vehicle ahead at a stop of a journey, by the number of the journey (6195h) and the
/// index of the stop in the route; nothing where people come by the timetable.
using FindAhead = std::function<std::optional<VehicleAhead>(std::uint32_t, std::size_t)>;

/// How many people come, and how they move.
struct RiderOptions {
  double boarding_mean = 2.5;              ///< people of a journey at each stop, at an ordinary
                                           ///< hour
  std::shared_ptr<const Demand> demand{};  ///< replaces the means; null: none
  // Mean times. A person takes three to five quarters of them in a door; buying a ticket takes 8 to
  // 14 elevenths of its time in addition.
  Duration boarding_time = 2s;       ///< of one who gets in
  Duration alighting_time = 1600ms;  ///< of one who gets out
  Duration buying_time = 11s;        ///< of one who buys a ticket
  unsigned capacity = 75;            ///< most people aboard
  unsigned pass_percent = 60;        ///< share of riders with a pass; half of the others buy from
                                     ///< the driver
  Duration come_before_max = 8min;   ///< a person comes at most this much before the departure
  FindAhead ahead{};  ///< empty: people come by the timetable; else lines and journeys that riders
                      ///< get must outlive them
  unsigned cars = 1;  ///< of the train
  unsigned behind_every = 0;  ///< of several cars, every so-many-th passenger rides in one behind
                              ///< the first, in turns; 0: all in the first
};

/// Counts since the beginning.
struct RiderStatistics {
  std::uint64_t came = 0;         ///< people who came to a stop
  std::uint64_t in = 0;           ///< people who got in
  std::uint64_t out = 0;          ///< people who got out
  std::uint64_t left_behind = 0;  ///< the bus was full, gone, or did not open
  /// People left behind who had stood there for 15 s when it went, and for whom there was room.
  std::uint64_t ignored = 0;
  std::uint64_t carried_past = 0;    ///< people who wanted to get out, and could not
  std::uint64_t bought = 0;          ///< tickets from the driver
  std::uint64_t cancelled = 0;       ///< tickets at the canceller
  std::uint64_t without_ticket = 0;  ///< people who gave it up
  unsigned aboard_max = 0;           ///< most people in the bus at a time
};

class Riders {
 public:
  /// Time after a stop within which all passengers for the next one have pressed the button.
  static constexpr Duration press_within = 6s;
  /// Time after which the driver must have seen a person: doors that close, and a bus that brakes
  /// for the stop, take less.
  static constexpr Duration seen_after = 15s;

  /// The same seed draws the same people, whatever the bus does.
  Riders(RiderOptions options, std::uint64_t seed, std::vector<DoorUse> doors,
         RiderHands hands = {});

  /// Draws the passengers of a journey. `zero` is the beginning of the day of service in the
  /// world's time. People who still wait for the journey before go away; those aboard stay.
  void begin_journey(Time now, const Journey& journey, const BusRoute& route, Time zero);
  /// The bus stands at a stop of its route; at the last one all get out.
  void stand_at(Time now, std::size_t stop);
  /// The bus leaves the stop, or passes it: people who still wait are left behind.
  void leave(Time now, std::size_t stop);
  /// A door lets people pass, or stops to.
  void door_changed(Time now, std::size_t door, bool is_open);

  /// Next call of advance() that has something to do; never: all wait for the bus.
  Time deadline() const;
  /// Moves people who are due by `now`.
  void advance(Time now);

  /// Number of people aboard, including those on the way out.
  unsigned aboard() const { return static_cast<unsigned>(aboard_.size()) + going_out_; }
  /// Number of people who wait at a stop at `now`.
  unsigned waiting_at(std::size_t stop, Time now) const;
  /// People aboard who want to get out at this stop, by its index in the route.
  unsigned wanting_out_at(std::size_t stop) const;
  /// True while a person passes the door.
  bool is_in_doorway(std::size_t door) const { return doors_[door].who.has_value(); }
  /// True while no person passes a door, nor would pass one that is open.
  bool is_quiet(Time now) const;
  /// Counts since the beginning.
  const RiderStatistics& statistics() const { return statistics_; }
  /// People in the bus, without those on the way out.
  const std::vector<Rider>& riders_aboard() const { return aboard_; }

 private:
  /// Passage of a person through a door.
  struct Passage {
    bool is_open = false;
    Time until = never;
    std::optional<Rider> who{};
    bool is_in = false;
  };
  /// Planned action of a person aboard.
  struct Errand {
    Time when{};
    std::uint64_t rider = 0;
    bool is_press = false;  ///< of the stop button; false: of the canceller
    unsigned tries = 0;
  };

  /// Stops at which people get out, with weights; without any weight, each is as likely.
  struct Goals {
    std::vector<std::size_t> stops;
    std::vector<double> weights;
  };

  double uniform();
  Duration time_between(Duration least, Duration most);
  Duration time_around(Duration mean) { return time_between(mean * 3 / 4, mean * 5 / 4); }
  unsigned poisson(double mean);
  std::optional<VehicleAhead> ahead_at(const Journey& journey, std::size_t stop) const;
  double mean_at(const Journey& journey, const BusRoute& route, std::size_t stop) const;
  void draw_stop(const Journey& journey, const BusRoute& route, std::size_t stop, Time zero);
  void draw_at_random(Time now, std::size_t stop);
  Goals goals_behind(const Journey& journey, const BusRoute& route, std::size_t stop) const;
  unsigned car_of(std::uint64_t number) const;
  void add_person(std::size_t stop, const Goals& goals, const std::function<Time()>& comes);
  std::size_t draw_goal(const std::vector<std::size_t>& goals, const std::vector<double>& weights);
  void plan_presses(Time now, std::size_t stop);
  void do_errands(Time now);
  bool try_errand(Time now, Errand& errand);
  bool try_to_cancel(Time now, Rider& rider);
  void finish_passage(Time now, std::size_t door);
  void begin_passage(Time now, std::size_t door);
  std::vector<Rider>::const_iterator next_out() const;
  std::vector<Rider>::const_iterator next_in(Time now) const;
  Rider* find_aboard(std::uint64_t number);

  RiderOptions options_;
  std::uint64_t seed_;
  Random random_;
  std::vector<DoorUse> uses_;
  RiderHands hands_;
  std::vector<Rider> waiting_;  ///< of this journey, in the order in which they come
  std::vector<Rider> aboard_;
  std::vector<Passage> doors_;
  std::vector<Errand> errands_;
  std::optional<std::size_t> stop_{};  ///< the stop at which it stands
  std::size_t last_stop_ = 0;
  const Journey* journey_ = nullptr;  ///< the present one
  const BusRoute* route_ = nullptr;   ///< of that journey
  Time zero_{};                       ///< beginning of the day of service
  std::uint64_t journeys_ = 0;
  std::uint64_t people_ = 0;
  unsigned going_in_ = 0;
  unsigned going_out_ = 0;
  RiderStatistics statistics_;
};

}  // namespace canvoy::bus_line
