#include "canvoy/worlds/police/crew.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::police {

namespace {

using cia447::NumberPadKey;

constexpr double patrol_speed = 12;      ///< m/s
constexpr double emergency_speed = 28;   ///< m/s
constexpr double station_metres = 2500;  ///< to the station, from anywhere
constexpr Duration speak_again = 5s;     ///< where the words were not heard
constexpr Duration pause_of_speech = 500ms;
constexpr Duration insist_after = 3s;
constexpr Duration between_keys = 600ms;  ///< two keys at once count as none
constexpr std::size_t calls_to_rest = 3;  ///< calls until the crew has a break
constexpr Duration rest = 10min;
constexpr Duration call_takes = 5s;
constexpr Duration pause_after_call = 10s;

NumberPadKey key_of(unsigned digit) {
  return digit == 0 ? NumberPadKey::key_0 : static_cast<NumberPadKey>(digit);
}

}  // namespace

Crew::Crew(const CrewOptions& options, std::uint64_t seed, car::Drive& drive, CrewHands hands,
           const TerminalHands& terminal)
    : options_(options),
      random_(seed),
      drive_(drive),
      hands_(std::move(hands)),
      open_(terminal.open),
      driver_(with_one_finger(terminal)),
      partner_(with_one_finger(terminal)),
      until_(options.begin) {}

/// The client that a function key opens waits for its turn: two keys at once count as none.
TerminalHands Crew::with_one_finger(TerminalHands hands) {
  hands.open = [this](Client client) {
    if (client == Client::signals) {
      wants_menu_ = true;
    } else {
      open_(client);
    }
  };
  return hands;
}

Duration Crew::between(Duration low, Duration high) {
  const auto width = static_cast<std::uint32_t>((high - low) / 1s);
  return low + 1s * static_cast<std::int64_t>(random_.below(width + 1));
}
double Crew::between(double low, double high) {
  constexpr std::uint32_t steps = 1'000'000;
  return low + (high - low) * static_cast<double>(random_.below(steps)) / steps;
}

void Crew::enter(Time now, Activity activity, Duration lasts) {
  until_ = now + lasts;
  said_ = unheard_ = {};
  const Activity before = std::exchange(activity_, activity);
  if (changed_) changed_(now, before, activity);
}

// Hands.

void Crew::want_light(Time now, bool is_blue, bool has_siren) {
  wish_.is_blue = is_blue;
  wish_.has_siren = has_siren;
  light_pressed_ = now - insist_after;
  has_new_light_ = true;
}

void Crew::want_lock(Time now, bool is_locked) {
  wish_.is_locked = is_locked;
  lock_pressed_ = now - insist_after;
  has_new_lock_ = true;
}

/// True if a key was pressed for it, and the light is as wanted.
bool Crew::light_is_right(const Wish& is) const {
  return !has_new_light_ && is.is_blue == wish_.is_blue && is.has_siren == wish_.has_siren;
}

/// Presses the key for what is not as wanted, and again; one key at a time.
void Crew::insist(Time now) {
  const bool talks = activity_ == Activity::conversing;
  if (hands_.sees_led() != talks && now >= hands_free_pressed_ + insist_after) {
    hands_free_pressed_ = now;
    hands_.press_hands_free();
  }
  if (!is_ignited_) return;
  if (now < key_pressed_ + between_keys) return;
  const Wish is = hands_.look();
  const bool lock_is_right = !has_new_lock_ && is.is_locked == wish_.is_locked;
  const bool wants_light = !light_is_right(is) && now >= light_pressed_ + insist_after;
  const bool wants_lock = !lock_is_right && now >= lock_pressed_ + insist_after;
  const bool wants_work =
      is.has_work_light != wish_.has_work_light && now >= work_pressed_ + insist_after;
  if (!wants_light && !wants_lock && !wants_work && !wants_menu_) return;
  key_pressed_ = now;
  if (!wants_light && !wants_lock && wants_work) {
    work_pressed_ = now;
    return hands_.press(SignalControl::work_key);
  }
  if (!wants_light && !wants_lock) {
    wants_menu_ = false;
    return open_(Client::signals);
  }
  if (wants_light && (!wants_lock || light_pressed_ < lock_pressed_)) {
    light_pressed_ = now;
    has_new_light_ = false;
    return hands_.press(wish_.has_siren ? SignalControl::siren_key
                        : wish_.is_blue ? SignalControl::blue_key
                                        : SignalControl::off_key);
  }
  lock_pressed_ = now;
  has_new_lock_ = false;
  hands_.press(wish_.is_locked ? SignalControl::lock_key : SignalControl::unlock_key);
}

/// FMS: 1 free, 2 at the station, 3 on the way, 4 there, 5 request to speak, 6 not ready, 7 takes a
/// person along, 8 at the station with that person, 9 signs on; 0 is the emergency key.
void Crew::send_status(unsigned status) {
  partner_.want({Client::radio, {key_of(status)}, {"status " + std::to_string(status)}});
}

void Crew::type_destination(unsigned destination) {
  TerminalTask task{Client::navigation, {NumberPadKey::star}, {"to ?"}};
  std::string typed;
  for (const char digit : std::to_string(destination)) {
    typed += digit;
    task.keys.push_back(key_of(static_cast<unsigned>(digit - '0')));
    task.answers.push_back("to " + typed);
  }
  task.keys.push_back(NumberPadKey::hash);
  task.answers.push_back("to " + typed + ": ");
  partner_.want(std::move(task));
}

void Crew::choose_sound() {
  const unsigned sound = 1 + random_.below(4);
  driver_.want({Client::signals, {key_of(sound)}, {"sound " + std::to_string(sound)}});
}

/// Speaks into the handset until the words were heard for this time. True: they were.
bool Crew::say(Time now, bool is_heard, Duration takes) {
  if (now < pause_until_) return false;
  if (!std::exchange(speaks_, true)) hands_.press_handset(true);
  said_ = is_heard ? said_ + step_time : Duration{};
  unheard_ = is_heard ? Duration{} : unheard_ + step_time;
  const bool is_said = said_ >= takes;
  if (!is_said && unheard_ < speak_again) return false;
  hands_.press_handset(false);
  speaks_ = false;
  said_ = unheard_ = {};
  pause_until_ = now + pause_of_speech;
  return is_said;
}

// Steps of a patrol.

void Crew::patrol(Time now) {
  if (now >= options_.end && drive_.is_standing()) {
    send_status(2);
    return enter(now, Activity::parking, 5s);
  }
  if (now >= next_call_ && now < options_.end) {
    const double metres = between(options_.scene_min_metres, options_.scene_max_metres);
    EmergencyCall call{.made = now, .destination = 100 + random_.below(900), .metres = metres};
    Random chance(call.destination);
    call.has_siren = chance.below(4) != 0;
    call.is_dark = chance.below(2) == 0;
    call.is_threatened = chance.below(4) == 0;
    call.brings_somebody = chance.below(3) == 0;
    calls_.push_back(call);
    return enter(now, Activity::listening);
  }
  if (now >= until_ && next_call_ - now > 2min) {
    send_status(5);
    return enter(now, Activity::conversing, 15s);
  }
  if (drive_.is_standing()) drive_.go(between(200, 1500), patrol_speed);
}

/// As long as the LED shows that they can.
void Crew::converse(Time now) {
  const bool has_ended = now >= until_;
  speaks_ = !has_ended && hands_.sees_led();
  if (has_ended) enter(now, Activity::patrolling, between(3min, 10min));
}

/// The control room repeats it until the crew has heard it.
void Crew::hear_call(Time now, bool room_is_heard) {
  check_invariant(!calls_.empty());
  room_speaks_ = (now - until_) % (call_takes + pause_after_call) < call_takes;
  if (!room_speaks_) {
    said_ = {};
    return;
  }
  said_ = room_is_heard && !is_deaf_ ? said_ + step_time : Duration{};
  if (said_ < call_takes - 2s) return;
  room_speaks_ = false;
  calls_.back().heard = now;
  enter(now, Activity::acknowledging);
}

void Crew::respond(Time now) {
  EmergencyCall& call = calls_.back();
  if (!drive_.is_standing()) return;
  check_invariant(call.acknowledged.has_value());
  call.arrived = now;
  want_light(now, true, false);
  wish_.has_work_light = call.is_dark;
  send_status(4);
  enter(now, Activity::at_scene, between(2min, 8min));
}

/// Presses the key again and again, until it is heard.
void Crew::be_threatened(Time now) {
  constexpr Duration after = 30s;
  constexpr Duration again = 5s;
  EmergencyCall& call = calls_.back();
  const bool is_due = call.is_threatened && !call.emergency_heard &&
                      now >= call.arrived.value_or(now) + after && now >= emergency_again_;
  if (!is_due) return;
  if (!call.emergency_pressed) call.emergency_pressed = now;
  emergency_again_ = now + again;
  hands_.press_emergency();
}

void Crew::status_is_heard(Time now, int status) {
  if (status == 0 && waits_for_help()) calls_.back().emergency_heard = now;
}

bool Crew::waits_for_help() const {
  return activity_ == Activity::at_scene && calls_.back().emergency_pressed &&
         !calls_.back().emergency_heard;
}

void Crew::leave_with(Time now, bool somebody) {
  want_light(now, false, false);
  if (!somebody) return be_free(now);
  send_status(7);
  drive_.go(station_metres, patrol_speed);
  enter(now, Activity::bringing);
  until_ = Time::max();
}

/// Has a break once, after some calls.
void Crew::go_on(Time now) {
  const bool rests = calls_.size() == calls_to_rest && !has_rested_ && now < options_.end;
  if (!rests) return enter(now, Activity::patrolling, between(2min, 8min));
  has_rested_ = true;
  send_status(6);
  enter(now, Activity::resting, rest);
}

/// A person who is taken to the station is handed over there.
void Crew::bring(Time now) {
  constexpr Duration handing_over = 2min;
  if (!drive_.is_standing()) return;
  if (until_ == Time::max()) {
    send_status(8);
    until_ = now + handing_over;
  } else if (now >= until_) {
    be_free(now);
  }
}

void Crew::be_free(Time now) {
  send_status(1);
  next_call_ = now + between(3min, options_.quiet_max);
  enter(now, Activity::clearing, 5s);
}

void Crew::leave_scene(Time now) {
  const bool was_locked = wish_.is_locked;
  be_threatened(now);
  if (now >= until_ - 20s) wish_.has_work_light = false;
  // First all get out, then the car is locked; before they leave, in the opposite order.
  if (!was_locked && now >= until_ - 90s && now < until_ - 30s) return want_lock(now, true);
  if (was_locked && now >= until_ - 10s) return want_lock(now, false);
  if (now >= until_) enter(now, Activity::reporting);
}

/// A crew that has waited long enough for a terminal without an answer gives up its entries; but it
/// does not go home from a car that flashes.
bool Crew::can_leave(Time now) const {
  const bool has_typed = partner_.is_idle() && driver_.is_idle();
  const bool has_patience = now < until_ + 2min;
  return now >= until_ && (has_typed || !has_patience) && light_is_right(hands_.look());
}

void Crew::leave(Time now) {
  partner_.give_up();
  driver_.give_up();
  hands_.turn_ignition(false);
  is_ignited_ = false;
  hands_.turn_key(true);
  wish_ = {};
  is_over_ = true;
  enter(now, Activity::off_duty);
}

void Crew::step(Time now, bool car_is_heard, bool room_is_heard) {
  driver_.step(now);
  partner_.step(now);
  switch (activity_) {
    case Activity::off_duty:
      if (is_over_ || now < until_) break;
      hands_.turn_key(false);
      wish_.is_locked = false;
      hands_.turn_ignition(true);
      is_ignited_ = true;
      enter(now, Activity::setting_out, 20s);
      break;
    case Activity::setting_out:
      if (now < until_) break;
      send_status(9);
      send_status(1);
      next_call_ = now + between(2min, options_.quiet_max);
      enter(now, Activity::patrolling, between(1min, 5min));
      break;
    case Activity::patrolling:
      patrol(now);
      break;
    case Activity::conversing:
      converse(now);
      break;
    case Activity::listening:
      hear_call(now, room_is_heard);
      break;
    case Activity::acknowledging:
      if (!say(now, car_is_heard, 3s)) break;
      calls_.back().acknowledged = now;
      want_light(now, true, calls_.back().has_siren);
      send_status(3);
      type_destination(calls_.back().destination);
      if (random_.below(2) == 0) choose_sound();
      drive_.go(calls_.back().metres, emergency_speed);
      enter(now, Activity::responding);
      break;
    case Activity::responding:
      respond(now);
      break;
    case Activity::at_scene:
      leave_scene(now);
      break;
    case Activity::reporting:
      if (!say(now, car_is_heard, 6s)) break;
      calls_.back().reported = now;
      leave_with(now, calls_.back().brings_somebody);
      break;
    case Activity::bringing:
      bring(now);
      break;
    case Activity::resting:
      if (now >= until_) be_free(now);
      break;
    case Activity::clearing:
      if (now >= until_) go_on(now);
      break;
    case Activity::parking:
      if (can_leave(now)) leave(now);
      break;
  }
  insist(now);
}

}  // namespace canvoy::police
