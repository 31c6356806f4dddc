// Who sits in an excavator: hands and feet that dig, lift, slew, dump and return, drive on when
// there is no earth left, toot, switch lights, turn wheels and the knob, take breaks; and eyes that
// see the machine, the lamps and the display.
//
//     ExcavatorOperator driver(options, seed, panel, machine, hands);
//     driver.step(now);    // each step_time
//
// Nobody told him what the network does: where a lamp is not as he wants it, he presses again, and
// where the machine does not follow he lets go of the sticks. Of a shift that was recorded he does
// again what was done, whatever he sees.
#pragma once

#include <functional>
#include <optional>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/excavator/recorded_shift.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"

namespace canvoy::excavator {

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

/// What the person wants of switches.
struct Wishes {
  bool is_unlocked = false;
  bool has_light = false;
  bool has_beacon = false;
  bool is_fast = false;

  friend bool operator==(const Wishes&, const Wishes&) = default;
};

/// How hands reach what is outside of the panel.
struct Hands {
  /// A button is down for so long, and then up.
  std::function<void(Button, Duration)> press;
  /// Sticks, pedals, wheels or the knob were moved.
  std::function<void()> moved;
};

struct OperatorOptions {
  Time end = Time(8h);     ///< of the shift
  Duration work = 100min;  ///< between two breaks, about
  Duration rest = 12min;
  RecordedShift recorded{};  ///< played again in place of all of this, where there is one
};

class ExcavatorOperator {
 public:
  static constexpr Duration step_time = 20ms;
  /// Of a stick in one step: a hand is not faster.
  static constexpr double step_of_hand = 0.08;

  /// All must outlive this.
  ExcavatorOperator(OperatorOptions options, std::uint64_t seed, SeatPanel& panel,
                    Excavator& machine, Hands hands);
  ExcavatorOperator(const ExcavatorOperator&) = delete;
  ExcavatorOperator& operator=(const ExcavatorOperator&) = delete;

  void step(Time now);

  Activity activity() const { return activity_; }
  const Wishes& wishes() const { return wishes_; }
  bool is_working() const {
    return activity_ >= Activity::reaches && activity_ <= Activity::drives;
  }
  unsigned cycles() const { return cycles_; }
  unsigned presses() const { return presses_; }
  /// Once for each change.
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
  Time looks_at_{};    ///< next, at lamps
  Time pressed_at_{};  ///< last
  Time moved_at_{};    ///< last that the machine followed, or was not meant to
  Time hands_off_until_{};
  std::array<double, movements> aims_{};  ///< where the hand goes
  double dump_at_ = Excavator::heap_at;
  double turn_ = 0;  ///< of the thumbwheel, while it slews
  unsigned cycles_ = 0;
  unsigned presses_ = 0;
  bool is_over_ = false;
  std::size_t played_ = 0;  ///< moves of a recorded shift
};

}  // namespace canvoy::excavator
