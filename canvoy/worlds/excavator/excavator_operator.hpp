// The operator of an excavator: hands and feet that dig, lift, slew, dump and return, drive on when
// there is no earth left, sound the horn, switch lights, turn wheels and the knob, take breaks; and
// eyes that see the machine, the lamps and the display.
//
//     ExcavatorOperator driver(options, seed, panel, machine, hands);
//     driver.step(now);    // each step_time
//
// The operator acts by what can be seen alone, not by the network: where a lamp is not as wanted,
// the operator presses again, and where the machine does not follow, releases the sticks. Of a
// recorded shift, the recorded actions are repeated, whatever the operator sees.
#pragma once

#include <functional>
#include <optional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/excavator/recorded_shift.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

/// What the operator does.
enum class Activity : std::uint8_t {
  sits_down,
  reaches,
  lowers,
  digs,
  lifts,
  slews,
  dumps,
  returns,
  drives,
  rests,
  gets_off
};

/// Switch states that the operator wants.
struct Wishes {
  bool is_unlocked = false;  ///< the seat's button "lock": the pilot pressure is on
  bool has_light = false;    ///< work lights
  bool has_beacon = false;   ///< rotating light on the roof
  bool is_fast = false;      ///< travels at the higher speed

  friend bool operator==(const Wishes&, const Wishes&) = default;
};

/// Actions of hands beyond the panel.
struct Hands {
  /// Holds a button down for this time.
  std::function<void(Button, Duration)> press;
  /// Called after sticks, pedals, wheels or the knob were moved.
  std::function<void()> moved;
};

/// The shift of an operator.
struct OperatorOptions {
  Time end = Time(8h);       ///< of the shift
  Duration work = 100min;    ///< between two breaks, on average
  Duration rest = 12min;     ///< duration of a break
  RecordedShift recorded{};  ///< a recorded shift to play in place of the rest
};

class ExcavatorOperator {
 public:
  static constexpr Duration step_time = 20ms;  ///< between two steps
  /// Greatest change of a stick in one step, the speed of a hand.
  static constexpr double step_of_hand = 0.08;

  /// All must outlive this object.
  ExcavatorOperator(OperatorOptions options, std::uint64_t seed, SeatPanel& panel,
                    Excavator& machine, Hands hands);
  ExcavatorOperator(const ExcavatorOperator&) = delete;
  ExcavatorOperator& operator=(const ExcavatorOperator&) = delete;

  /// Sees, decides and moves the hands; call it in each step_time.
  void step(Time now);
  /// Lets go of all sticks and pedals, but for that of the boom, which goes to this place, and does
  /// nothing else; empty: goes on.
  void hold_back(std::optional<double> boom) { held_back_ = boom; }

  /// What the operator does at present.
  Activity activity() const { return activity_; }
  /// Switch states that the operator wants.
  const Wishes& wishes() const { return wishes_; }
  /// True while it works with sticks or pedals.
  bool is_working() const {
    return activity_ >= Activity::reaches && activity_ <= Activity::drives;
  }
  /// Number of dumped buckets.
  unsigned cycles() const { return cycles_; }
  /// Number of buttons pressed.
  unsigned presses() const { return presses_; }
  /// Sets the function that is called once for each change of the activity.
  void on_change(std::function<void(Time, Activity)> told) { told_ = std::move(told); }

 private:
  struct Pose {
    double boom = 0;
    double stick = 0;
    double bucket = 0;
    double slew = 0;
  };

  void work(Time now);
  void play(Time now);
  void act(Time now);
  void enter(Time now, Activity activity);
  void lower_lever(Time now);
  void raise_lever(Time now);
  void begin_cycle(Time now);
  bool is_at(const Pose& pose) const;
  void aim(const Pose& pose);
  void move_hands(Time now);
  void let_go();
  void watch_machine(Time now);
  void look_at_lamps(Time now);
  bool press_if_other(Time now, Lamp lamp, bool is_wished, Button button);
  void press(Time now, Button button);
  void play_with_switches(Time now);
  void rest(Time now);
  bool happens(unsigned per_mille) { return random_.below(1000) < per_mille; }

  OperatorOptions options_;
  Random random_;
  SeatPanel& panel_;
  Excavator& machine_;
  Hands hands_;
  std::function<void(Time, Activity)> told_;
  Activity activity_ = Activity::sits_down;
  Wishes wishes_;
  Time since_{};  ///< of the activity
  Time rest_at_ = never;
  Time resumes_at_{};  ///< after a break
  Time looks_at_{};    ///< next look at the lamps
  Time pressed_at_{};  ///< last press
  Time moved_at_{};    ///< last time that the machine followed, or had no command
  Time hands_off_until_{};
  std::array<double, movements> aims_{};  ///< targets of the hands
  double dump_at_ = Excavator::heap_at;
  double turn_ = 0;  ///< of the thumbwheel, while it slews
  unsigned cycles_ = 0;
  unsigned presses_ = 0;
  bool is_over_ = false;
  std::optional<double> held_back_{};
  std::size_t played_ = 0;  ///< moves played of a recorded shift
};

}  // namespace canvoy::excavator
