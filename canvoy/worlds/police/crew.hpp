// The crew of a police car on patrol, and the control room that calls it: their actions at car,
// terminal and radio, by the hour and by chance.
//
//     Crew crew(options, seed, drive, hands);
//     crew.step(now);     // each 100 ms, beside the drive
//
// They want light and sound, and press the key once more where they do not see and hear it. A
// person who is not heard presses the key of the handset again and repeats the words, until they
// are heard.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "canvoy/can/random.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/worlds/car/drive.hpp"
#include "canvoy/worlds/police/operator_hands.hpp"
#include "canvoy/worlds/police/signal_control.hpp"

namespace canvoy::police {

/// What the crew does.
enum class Activity : std::uint8_t {
  off_duty,
  setting_out,  ///< unlocks the car, turns the key
  patrolling,
  conversing,     ///< with the control room, hands-free
  listening,      ///< to a call for help
  acknowledging,  ///< by radio
  responding,     ///< drives there with blue light, and mostly with siren
  at_scene,
  reporting,  ///< by radio
  bringing,   ///< drives a person to the station
  resting,    ///< not ready to be sent
  clearing,   ///< lights off, and on
  parking,    ///< the end of the patrol: until light and sound are off
};

/// State that the crew wants: the reference for light, sound and locks.
struct Wish {
  bool is_blue = false;         ///< blue light
  bool has_siren = false;       ///< siren; only with blue light
  bool has_work_light = false;  ///< search lamp and alley lights
  bool is_locked = true;        ///< the doors

  bool operator==(const Wish&) const = default;
};

/// Actions of the crew in the car, beside the number pad.
struct CrewHands {
  std::function<void(cia447::FunctionKey)> press;      ///< a function key of the terminal
  std::function<void(bool is_pressed)> press_handset;  ///< the contact of the handset
  std::function<void()> press_hands_free;              ///< the key of the hands-free system
  std::function<bool()> sees_led;                      ///< LED beside that key: the radio is active
  std::function<void(bool is_on)> turn_ignition;       ///< the key of the car
  std::function<void(bool is_locked)> turn_key;        ///< in the door
  std::function<void()> press_emergency;               ///< the key at the terminal
  std::function<Wish()> look;                          ///< true state
};

/// The patrol of a crew.
struct CrewOptions {
  Time begin = Time(2min);
  Time end = Time(7h);              ///< no call comes after this time
  Duration quiet_max = 12min;       ///< longest time from one call to the next
  double scene_min_metres = 800;    ///< shortest distance of a scene
  double scene_max_metres = 7'000;  ///< longest distance of a scene
};

/// A call for help.
struct EmergencyCall {
  Time made{};               ///< by the control room
  unsigned destination = 0;  ///< number to type: 100 to 999
  double metres = 0;         ///< distance of the scene
  // Drawn by chance.
  bool has_siren = true;               ///< it is urgent enough for the siren
  bool is_dark = false;                ///< at the scene: search lamp and alley lights are needed
  bool is_threatened = false;          ///< the crew, at the scene: it presses the emergency key
  bool brings_somebody = false;        ///< takes a person to the station
  std::optional<Time> heard{};         ///< by the crew
  std::optional<Time> acknowledged{};  ///< heard in the control room
  std::optional<Time> arrived{};       ///< at the scene
  std::optional<Time> emergency_pressed{};  ///< first press
  std::optional<Time> emergency_heard{};    ///< in the control room
  std::optional<Time> reported{};           ///< heard in the control room
  Duration age{};                           ///< without the time that a fault excuses
};

class Crew {
 public:
  static constexpr Duration step_time = 100ms;  ///< between two steps

  /// All must outlive this object; the same seed gives the same patrol.
  Crew(const CrewOptions& options, std::uint64_t seed, car::Drive& drive, CrewHands hands,
       const TerminalHands& terminal);

  /// `car_is_heard`: the control room hears what is said in the car at present; `room_is_heard`:
  /// the car hears the control room.
  void step(Time now, bool car_is_heard, bool room_is_heard);
  /// Sets the function that is called at a change, with the activity before and the new one.
  void on_change(std::function<void(Time, Activity, Activity)> changed) {
    changed_ = std::move(changed);
  }

  /// What the crew does at present.
  Activity activity() const { return activity_; }
  /// What the crew wants at present.
  const Wish& wish() const { return wish_; }
  bool speaks() const {
    return speaks_;
  }                                                  ///< true: a person in the car speaks to the
                                                     ///< radio
  bool room_speaks() const { return room_speaks_; }  ///< true: a person in the control room speaks
  /// True while the key of the car is turned.
  bool is_ignited() const { return is_ignited_; }
  /// True when the car is parked after the patrol.
  bool is_over() const { return is_over_; }
  /// All calls, the oldest first.
  const std::vector<EmergencyCall>& calls() const { return calls_; }
  /// The same, for the referee that adds excused times.
  std::vector<EmergencyCall>& calls() { return calls_; }
  /// The driver at the terminal, who chooses the sound.
  const Operator& driver() const { return driver_; }
  /// The other person, who types destinations and status messages.
  const Operator& partner() const { return partner_; }
  /// The control room has received this status message.
  void status_is_heard(Time now, int status);
  /// True if the emergency key was pressed, and the control room has not received it.
  bool waits_for_help() const;
  /// Makes the crew ignore calls.
  void fall_asleep() { is_deaf_ = true; }

 private:
  void enter(Time now, Activity activity, Duration lasts = {});
  void patrol(Time now);
  void converse(Time now);
  void hear_call(Time now, bool room_is_heard);
  void respond(Time now);
  void leave_scene(Time now);
  void be_threatened(Time now);
  void bring(Time now);
  void be_free(Time now);
  void leave_with(Time now, bool somebody);
  void go_on(Time now);
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
  Time work_pressed_{};
  Time emergency_again_{};
  bool has_new_light_ = false;  ///< wanted light that no key was pressed for
  bool has_new_lock_ = false;
  Time key_pressed_{};  ///< last press of either key
  Time hands_free_pressed_{};
  Time pause_until_{};  ///< of speech
  bool is_ignited_ = false;
  bool speaks_ = false;
  bool room_speaks_ = false;
  bool is_over_ = false;
  bool is_deaf_ = false;
  bool has_rested_ = false;
  Duration said_{};     ///< part of the message that was said and heard
  Duration unheard_{};  ///< time since it was last heard
  std::vector<EmergencyCall> calls_;
};

}  // namespace canvoy::police
