// The crew of a police car on patrol, and the control room that calls it: what they do with car,
// terminal and radio, by the hour and by chance.
//
//     Crew crew(options, seed, drive, hands);
//     crew.step(now);     // each 100 ms, beside the drive
//
// They wish for light and sound, and press the key once more where they do not see and hear it. Who
// is not heard presses the key of the handset anew and says it again, until he is.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/sim/car/drive.hpp"
#include "canvoy/sim/police/operator_hands.hpp"
#include "canvoy/sim/police/signal_control.hpp"

namespace canvoy::police {

enum class Activity : std::uint8_t {
  off_duty,
  setting_out,  ///< unlocks the car, turns the key
  patrolling,
  conversing,     ///< with the control room, hands-free
  listening,      ///< to a call for help
  acknowledging,  ///< by radio
  responding,     ///< drives there with blue light and siren
  at_scene,
  reporting,  ///< by radio
  clearing,   ///< lights off, and on
  parking,    ///< the end of the patrol: until light and sound are off
};

/// What the crew wants to be so: by it light, sound and locks are judged.
struct Wish {
  bool is_blue = false;
  bool has_siren = false;
  bool is_locked = true;

  bool operator==(const Wish&) const = default;
};

/// What the crew does in the car, beside the number pad.
struct CrewHands {
  std::function<void(cia447::FunctionKey)> press;
  std::function<void(bool is_pressed)> press_handset;
  std::function<void()> press_hands_free;
  std::function<bool()> sees_led;  ///< beside that key: the radio is active
  std::function<void(bool is_on)> turn_ignition;
  std::function<void(bool is_locked)> turn_key;  ///< in the door
  std::function<Wish()> look;                    ///< how it really is
};

struct CrewOptions {
  Time begin = Time(2min);
  Time end = Time(7h);         ///< no call comes after it
  Duration quiet_max = 12min;  ///< from one call to the next
  double scene_min_metres = 800;
  double scene_max_metres = 7'000;
};

/// A call for help.
struct EmergencyCall {
  Time made{};
  unsigned destination = 0;  ///< as it is typed: 100 to 999
  double metres = 0;
  std::optional<Time> heard{};
  std::optional<Time> acknowledged{};  ///< heard in the control room
  std::optional<Time> arrived{};
  std::optional<Time> reported{};  ///< heard in the control room
  Duration age{};                  ///< without the time that a fault excuses
};

class Crew {
 public:
  static constexpr Duration step_time = 100ms;

  Crew(const CrewOptions& options, std::uint64_t seed, car::Drive& drive, CrewHands hands,
       const TerminalHands& terminal);

  /// `car_is_heard`: what is said in the car now is heard in the control room; `room_is_heard`: the
  /// other way round.
  void step(Time now, bool car_is_heard, bool room_is_heard);
  void on_change(std::function<void(Time, Activity, Activity)> changed) {
    changed_ = std::move(changed);
  }

  Activity activity() const { return activity_; }
  const Wish& wish() const { return wish_; }
  bool speaks() const { return speaks_; }            ///< somebody in the car, to the radio
  bool room_speaks() const { return room_speaks_; }  ///< somebody in the control room
  bool is_ignited() const { return is_ignited_; }
  bool is_over() const { return is_over_; }
  const std::vector<EmergencyCall>& calls() const { return calls_; }
  std::vector<EmergencyCall>& calls() { return calls_; }
  const Operator& driver() const { return driver_; }
  const Operator& partner() const { return partner_; }
  /// They do not answer calls any more.
  void fall_asleep() { is_deaf_ = true; }

 private:
  void enter(Time now, Activity activity, Duration lasts = {});
  void patrol(Time now);
  void converse(Time now);
  void hear_call(Time now, bool room_is_heard);
  void respond(Time now);
  void leave_scene(Time now);
  bool can_leave(Time now) const;
  void leave(Time now);
  bool say(Time now, bool is_heard, Duration takes);
  void want_light(Time now, bool is_blue, bool has_siren);
  void want_lock(Time now, bool is_locked);
  bool light_is_right(const Wish& is) const;
  void insist(Time now);
  TerminalHands with_one_finger(TerminalHands hands);
  void send_status(unsigned status);
  void type_destination(unsigned destination);
  void choose_sound();
  Duration between(Duration low, Duration high);
  double between(double low, double high);

  CrewOptions options_;
  Random random_;
  car::Drive& drive_;
  CrewHands hands_;
  std::function<void(Client)> open_;
  bool wants_menu_ = false;
  Operator driver_;
  Operator partner_;
  std::function<void(Time, Activity, Activity)> changed_;
  Activity activity_ = Activity::off_duty;
  Time until_{};
  Time next_call_{};
  Wish wish_;
  Time light_pressed_{};
  Time lock_pressed_{};
  bool has_new_light_ = false;  ///< no key was pressed for the wish
  bool has_new_lock_ = false;
  Time key_pressed_{};  ///< any of both
  Time hands_free_pressed_{};
  Time pause_until_{};  ///< of speech
  bool is_ignited_ = false;
  bool speaks_ = false;
  bool room_speaks_ = false;
  bool is_over_ = false;
  bool is_deaf_ = false;
  Duration said_{};     ///< and heard, of what is to be said
  Duration unheard_{};  ///< since it was heard last
  std::vector<EmergencyCall> calls_;
};

}  // namespace canvoy::police
