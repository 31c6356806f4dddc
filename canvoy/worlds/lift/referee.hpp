// A referee of a building: it receives what really happens, from the plants and the lamps and not
// from the controllers, and judges the invariants.
//
//     Referee referee(building);
//     referee.observe(now, 1, facts);               // at each event of the plants
//     referee.button_pressed(now, call);
//     referee.lamp_changed(now, call, true);
//     referee.lamp_changed(now, call, false, CallEnd::served);
//     for (const Invariant& invariant : referee.invariants(now)) ok = ok && invariant.held;
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/invariant.hpp"

namespace canvoy::lift {

/// State of a door of a car, with the landing door that it moves.
struct DoorFacts {
  double open_m = 0;   ///< distance between the edges
  bool locked = true;  ///< its lock holds
};

/// Service for a fire, by the keys.
enum class FireMode : std::uint8_t {
  none,
  recall,   ///< the key of the alarm is turned: all people leave, at the fire floor
  brigade,  ///< the key in the car as well: the fire brigade drives
};

/// True state of one lift at one time.
struct LiftFacts {
  double position_m = 0;                     ///< of the car's floor, above floor 1
  double speed_m_s = 0;                      ///< upward is positive
  double acceleration_m_s2 = 0;              ///< upward is positive
  std::array<DoorFacts, doors_max> doors{};  ///< door 1 first
  double load_kg = 0;                        ///< of people and goods
  /// The safety chain, a fault or a fast stop has applied the brake: comfort does not count.
  bool emergency_stop = false;
  bool is_cut = false;  ///< the safety chain is open: motor and brake have no current
  bool drifts = false;  ///< it moves although its brake is closed
  /// Its motor runs away, or its brake holds nothing: then the buffers must stop it.
  bool is_unheld = false;
  bool is_cranked = false;                     ///< moved by hand
  bool brake_slips = false;                    ///< under the load of its self-test
  bool is_inspected = false;                   ///< a switch of its inspection control is on
  Direction inspection_way = Direction::none;  ///< button that is held there
  bool opens_by_hand = false;                  ///< the button in the car is held
  FireMode fire = FireMode::none;              ///< by the keys
  FloorNumber fire_floor = 1;                  ///< floor of a recall
  /// Time since when a display of position has named another floor than the one in whose door zone
  /// the car is; never: all name it; empty: all are dark, or it is in none.
  std::optional<Time> misnamed_since{};
  /// Distance between the true position and that of a real position unit; empty: none was received.
  std::optional<double> position_lie_m{};
  /// A fault is present, or has just ended: its possible delays are not judged.
  bool hindered = false;
};

/// A button of a landing (lift 0) or of a car (direction none), or a destination entered at one.
struct CallKey {
  LiftNumber lift = 0;                    ///< 0: of a landing
  FloorNumber floor = 1;                  ///< of the landing, or destination in a car
  Direction direction = Direction::none;  ///< none: in a car
  FloorNumber to = no_floor;  ///< destination entered at a landing; no_floor: a direction
  auto operator<=>(const CallKey&) const = default;
};

/// Reason why the lamp of a call goes out.
enum class CallEnd : std::uint8_t {
  served,        ///< a car stands there, and opens a door soon
  fire_service,  ///< all calls are withdrawn
  out_of_order,  ///< the lift is, or its controller has booted
  cancelled,     ///< by the passenger, or with the car's other calls at the end of its way
  unexplained,
};

/// Bounds of the judgements; the clause stands where a standard gives it.
struct RefereeLimits {
  /// A car that opens its doors is at most this far from its floor.
  double floor_tolerance_m = 0.010;
  double moving_m_s = 0.001;      ///< below it, a car stands
  double tolerance = 0.05;        ///< share of speed, acceleration and jerk
  double buffer_gap_m = 0.001;    ///< a car at this distance is at the buffers
  double emergency_m_s2 = 9.81;   ///< the greatest deceleration of a safety gear (EN 81-20)
  double emergency_speed = 1.25;  ///< share of the rated speed, where a governor has acted
  double levelled_m = 0.020;      ///< a car stays within this distance of its floor (EN 81-20,
                                  ///< 5.12.1.1.4)
  Duration levels_within = 10s;   ///< while a door is open, until the car is level again
  /// Time in which a car with an unlocked door may still move when the safety chain has cut it off.
  Duration cut_stop_most = 1s;
  Duration gear_stop_most = 2s;    ///< like cut_stop_most, where its brake does not hold the car
  Duration acknowledge_most = 2s;  ///< from the finger to the lamp
  Duration serve_most = 30min;     ///< from the lit lamp until a car stands open there
  Duration wait_most = 30min;      ///< from arrival until boarding
  Duration ride_most = 15min;      ///< from boarding until the destination
  /// Time in which a lift may stand while a person waits for longer than it takes to come.
  Duration idle_most = 2min;
  /// Longest time for people behind shut doors. EN 81-28 requires help within an hour; where
  /// nothing is broken, no help must be necessary.
  Duration trapped_most = 2min;
  /// Like trapped_most, but whatever is broken (EN 81-28).
  Duration rescued_within = 1h;
  double position_lie_m = 0.2;  ///< of a real position unit; a greater one is outside of a floor's
                                ///< door zone
  /// Time from the lamp that goes out to a door that people can walk through.
  Duration opens_within = 20s;
  double walkable_share = 0.8;   ///< share of a door's width
  Duration recall_most = 3min;   ///< from the key until the car stands open at the fire floor
  double inspection_m_s = 0.63;  ///< under inspection control (EN 81-20, 5.12.1.5.2.1)
  /// Time for a car to stop, or to turn, when the button of an inspection control is released.
  Duration inspection_stops_within = 2s;
  /// A car that stands for less time, and moves again, has not stopped.
  Duration inspection_rests = 1s;
  /// Trips with a brake that holds too little: the one at the end of which its self-test finds it.
  unsigned weak_brake_trips = 1;
  /// Time from the button of the fire brigade until its car is at their floor, beside the flight:
  /// doors close slowly in smoke.
  Duration brigade_waits_most = 80s;
  double between_floors_m = 0.35;     ///< outside of any door zone (EN 81-20, 5.3.8.1)
  Duration stops_between_least = 2s;  ///< a car that turns stands for less
  Duration display_most = 3s;         ///< for displays to name the floor where the car stands
  /// Time from a key to its panel, the controller and its latest command: then the rules of a fire
  /// service hold.
  Duration heeds_key_within = 200ms;
};

class Referee {
 public:
  /// `building` must outlive this object.
  explicit Referee(const Building& building, const RefereeLimits& limits = {});

  /// Judges the true state of a lift; call it at each change, and often while something moves.
  void observe(Time now, LiftNumber lift, const LiftFacts& facts);
  /// `is_answered`: the lamp is lit, or a car stands there already.
  void button_pressed(Time now, const CallKey& call, bool is_answered = false);
  /// The lamp of a call is lit, or goes out for the reason `end`.
  void lamp_changed(Time now, const CallKey& call, bool lit, CallEnd end = CallEnd::served);
  /// Longest time of all people who wait or ride at present, without those who were hindered
  /// meanwhile.
  void waited(Duration longest, bool hindered);
  /// See waited().
  void rode(Duration longest, bool hindered);
  /// Time for which a lift, which is not hindered, has stood while it was wanted.
  void idled(LiftNumber lift, Duration time);
  /// Like idled(): time for which people in it have not been able to get out.
  void trapped(LiftNumber lift, Duration time);
  /// Like trapped(), but for a lift that may be hindered.
  void shut_in(LiftNumber lift, Duration time);
  /// Time for which the fire brigade in the car has waited for it to obey, and has not arrived.
  void brigade_waits(LiftNumber lift, Duration time);
  /// A person was carried, and has not taken the stairs.
  void stayed();
  /// A person takes the stairs, with no cause other than the lifts.
  void gave_up();
  /// Judges calls that are not answered: from time to time, for example each second.
  void look_at_calls(Time now, bool hindered);

  /// Verdicts at present. Those on a fire service, inspection control, a weak brake and a real
  /// position unit are among them once there was one.
  std::vector<Invariant> invariants() const;
  /// The invariants broken since the last call, each once.
  std::vector<Invariant> take_broken();

 private:
  struct Judged {
    double worst = 0;
    double bound = 0;
    std::uint64_t count = 0;
    bool is_told = false;
    void judge(double value) {
      worst = count != 0 && worst > value ? worst : value;
      ++count;
    }
    bool held() const { return count == 0 || worst <= bound; }
  };
  struct Lift {
    std::optional<LiftFacts> last{};
    Time last_at{};
    Duration open_movement{0};
    Duration cut_for{0};
    bool was_unheld = false;  ///< and is where that has brought it
    Duration off_for{0};      ///< its floor, with an open door
    unsigned chain_stops = 0;
    Duration between_for{0};          ///< it has stood between floors, with no excuse
    bool is_excused_between = false;  ///< until it moves: it stood there while it was hindered
    Time fire_since = never;          ///< beginning of the present fire mode
    unsigned doors_freed_before = 0;  ///< unlocked since before that; bit 0 is door 1
    Time recall_since = never;        ///< plus the time for the way to the fire floor
    bool is_recalled = false;
    FloorNumber open_floor = no_floor;  ///< floor where a door is wide open
    bool is_returning = false;          ///< the brigade has turned its key back, elsewhere
    unsigned doors_opened_in_recall = 0;
    unsigned doors_opened_by_themselves = 0;
    unsigned calls_taken = 0;
    bool has_stood = false;            ///< at a floor, with a brake that holds too little
    unsigned weak_trips = 0;           ///< since its brake holds too little
    Time inspected_since = never;      ///< or, after that, since the button was changed
    Duration rests{0};                 ///< under inspection control
    Duration unasked{0};               ///< motion without the button for it
    unsigned calls_in_inspection = 0;  ///< taken
    Time stands_since = never;         ///< at a floor; never: it does not
    bool is_display_old = false;       ///< a fault was present when the car came to where it stands
    std::map<InvariantKind, Judged> judged{};
  };
  struct Call {
    Time pressed_at = never;
    Time lit_at = never;
    bool was_open = false;  ///< a door was open there, since its lamp was lit
    Time asked_at = never;  ///< when its lamp was lit that has gone out before a door was open
    Time opens_by = never;  ///< time until which a car must be open there
  };

  void judge_motion(Lift& lift, const LiftDesign& design, const LiftFacts& facts, Duration passed);
  void judge_doors(Lift& lift, const LiftDesign& design, const LiftFacts& facts, Duration passed);
  void judge_chain(Lift& lift, const LiftFacts& facts, Duration passed);
  void judge_stop_on_the_way(Lift& lift, const LiftFacts& facts, Duration passed);
  void judge_level(Lift& lift, const LiftDesign& design, const LiftFacts& facts, Duration passed);
  void note_open_door(Time now, LiftNumber number, const LiftDesign& design,
                      const LiftFacts& facts);
  void look_for_door(Time now, Call& call, bool hindered);
  void judge_departure(Lift& lift, const LiftDesign& design, const LiftFacts& facts);
  void judge_brake(Lift& lift, const LiftFacts& facts, bool leaves) const;
  void judge_inspection(Time now, Lift& lift, const LiftFacts& facts, Duration passed) const;
  void judge_displays(Time now, Lift& lift, const LiftFacts& facts) const;
  void judge_call_in_inspection(Time now, const CallKey& call);
  void judge_fire(Time now, Lift& lift, const LiftFacts& facts);
  void judge_recall(Time now, Lift& lift, const LiftFacts& facts, bool opens);
  void note_fire_mode(Time now, Lift& lift, const LiftFacts& facts);
  void judge_fire_call(Time now, const CallKey& call);
  bool refuses(Time now, const Lift& lift, const CallKey& call) const;
  static unsigned opening_doors(const Lift& lift, const LiftFacts& facts);
  double distance_to_floor_m(double position_m) const;
  template <class Visit>
  void visit_all(const Visit& visit);

  const Building* building_;
  RefereeLimits limits_;
  std::vector<Lift> lifts_;
  std::map<CallKey, Call> calls_;
  std::map<InvariantKind, Judged> common_;
};

}  // namespace canvoy::lift
