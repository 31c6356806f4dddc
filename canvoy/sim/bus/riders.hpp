// The passengers of a bus: they come to their stops, get in and out by its doors, press the button
// for the stop, and buy or cancel tickets. They are drawn by a seed, each journey for itself, so
// that who comes does not hang on what the bus does.
//
//     Riders riders({}, seed, doors, hands);
//     riders.begin_journey(now, journey, of_day);
//     riders.stand_at(now, 0);  riders.door_changed(now, 0, true);
//     riders.advance(now);          // when riders.deadline() has come
//
// Those who want out go first; one at a time goes through a door.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/bus/bus_line.hpp"

namespace canvoy::bus {

enum class Ticket : std::uint8_t {
  pass,         ///< nothing to do
  to_cancel,    ///< at a ticket canceller, when he is in
  from_driver,  ///< bought in the door
};

struct Rider {
  std::size_t from = 0;  ///< stops of the route
  std::size_t to = 0;
  Time comes{};  ///< to his stop
  Ticket ticket = Ticket::pass;
  bool has_ticket = false;  ///< that is valid
  Time boarded = never;
  std::uint64_t number = 0;  ///< since the beginning, from 1 on
  unsigned car = 1;          ///< in which he rides
};

/// What a door is for, in the order of the doors from the front.
struct DoorUse {
  bool boards = true;
  bool alights = true;
};

/// What passengers do with devices; what is empty obeys. False: it has not obeyed, and they try
/// again.
struct RiderHands {
  std::function<bool(Time, const Rider&)> press_stop{};               ///< asks for the next stop
  std::function<bool(Time, const Rider&)> cancel_ticket{};            ///< at a canceller
  std::function<bool(Time, const Rider&)> buy_ticket{};               ///< from the driver's printer
  std::function<void(Time, std::size_t door, bool is_in)> through{};  ///< somebody is in, or out
};

struct RiderOptions {
  double boarding_mean = 2.5;  ///< of a journey at each stop, at an ordinary hour
  unsigned capacity = 75;      ///< nobody gets in beyond
  unsigned pass_percent = 60;  ///< of riders; half of the others buy from the driver
  Duration come_before_max = 8min;
  unsigned second_car_every = 0;  ///< each so many-th rides in the second car; 0: nobody does
};

/// Since the beginning.
struct RiderStatistics {
  std::uint64_t came = 0;
  std::uint64_t in = 0;
  std::uint64_t out = 0;
  std::uint64_t left_behind = 0;  ///< it was full, gone or did not open
  /// Of these who stood there for 15 s when it went, and for whom there was room.
  std::uint64_t ignored = 0;
  std::uint64_t carried_past = 0;  ///< wanted out, and could not
  std::uint64_t bought = 0;
  std::uint64_t cancelled = 0;
  std::uint64_t without_ticket = 0;  ///< gave it up
  unsigned aboard_max = 0;
};

class Riders {
 public:
  /// How long after a stop everybody who wants out at the next one has pressed the button.
  static constexpr Duration press_within = 6s;
  /// Whom the driver must have seen: doors that close, and a bus that brakes for the stop, take
  /// less.
  static constexpr Duration seen_after = 15s;

  Riders(const RiderOptions& options, std::uint64_t seed, std::vector<DoorUse> doors,
         RiderHands hands = {});

  /// Draws who comes. `zero` is the beginning of the day of service in the world's time. Those who
  /// still wait for the journey before go away; those aboard stay.
  void begin_journey(Time now, const Journey& journey, Time zero);
  /// The bus stands at a stop of its route; the last one is the last for all.
  void stand_at(Time now, std::size_t stop);
  /// It leaves it, or goes past it: whoever still waits is left behind.
  void leave(Time now, std::size_t stop);
  /// It is open to pass, or not any more.
  void door_changed(Time now, std::size_t door, bool is_open);

  Time deadline() const;
  void advance(Time now);

  /// Those on the way out included: who is in, less who is out.
  unsigned aboard() const { return static_cast<unsigned>(aboard_.size()) + going_out_; }
  /// Who is there at `now`.
  unsigned waiting_at(std::size_t stop, Time now) const;
  unsigned wanting_out_at(std::size_t stop) const;
  /// Somebody is on the way through a door.
  bool is_in_doorway(std::size_t door) const { return doors_[door].who.has_value(); }
  /// Nobody goes through a door, nor would through one that is open.
  bool is_quiet(Time now) const;
  const RiderStatistics& statistics() const { return statistics_; }
  const std::vector<Rider>& riders_aboard() const { return aboard_; }

 private:
  /// Somebody on the way through it.
  struct Passage {
    bool is_open = false;
    Time until = never;
    std::optional<Rider> who{};
    bool is_in = false;
  };
  /// What somebody aboard is about to do.
  struct Errand {
    Time when{};
    std::uint64_t rider = 0;
    bool is_press = false;  ///< of the stop button; else of the canceller
    unsigned tries = 0;
  };

  double uniform();
  Duration time_between(Duration least, Duration most);
  unsigned poisson(double mean);
  void draw_stop(const Journey& journey, std::size_t stop, Time zero);
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
  std::optional<std::size_t> stop_{};  ///< at which it stands
  std::size_t last_stop_ = 0;
  std::uint64_t journeys_ = 0;
  std::uint64_t people_ = 0;
  unsigned going_in_ = 0;
  unsigned going_out_ = 0;
  RiderStatistics statistics_;
};

}  // namespace canvoy::bus
