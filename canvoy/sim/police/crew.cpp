#include "canvoy/sim/police/crew.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "canvoy/can/must_hold.hpp"

namespace canvoy::police {

namespace {

using cia447::NumberPadKey;

constexpr double patrol_speed = 12;     ///< m/s
constexpr double emergency_speed = 28;  ///< m/s
constexpr Duration speak_again = 5s;    ///< where nobody has heard it
constexpr Duration pause_of_speech = 500ms;
constexpr Duration insist_after = 3s;
constexpr Duration between_keys = 600ms;  ///< two at once are none
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

/// The client that is opened by a function key waits for its turn: two keys at once are none.
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

/// A key was pressed for it, and it is so.
bool Crew::light_is_right(const Wish& is) const {
  return !has_new_light_ && is.is_blue == wish_.is_blue && is.has_siren == wish_.has_siren;
}

/// Presses the key for what is not as it is wished, and again; one key at a time.
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
  if (!wants_light && !wants_lock && !wants_menu_) return;
  key_pressed_ = now;
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

/// Speaks into the handset until it was heard for so long. True: it was.
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

// A patrol.

void Crew::patrol(Time now) {
  if (now >= options_.end && drive_.is_standing()) return enter(now, Activity::parking, 5s);
  if (now >= next_call_ && now < options_.end) {
    const double metres = between(options_.scene_min_metres, options_.scene_max_metres);
    calls_.push_back({.made = now, .destination = 100 + random_.below(900), .metres = metres});
    return enter(now, Activity::listening);
  }
  if (now >= until_ && next_call_ - now > 2min) return enter(now, Activity::conversing, 15s);
  if (drive_.is_standing()) drive_.go(between(200, 1500), patrol_speed);
}

/// As long as the LED says that they can.
void Crew::converse(Time now) {
  const bool has_ended = now >= until_;
  speaks_ = !has_ended && hands_.sees_led();
  if (has_ended) enter(now, Activity::patrolling, between(3min, 10min));
}

/// The room says it again until the crew has heard it.
void Crew::hear_call(Time now, bool room_is_heard) {
  must_hold(!calls_.empty());
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
  must_hold(call.acknowledged.has_value());
  call.arrived = now;
  want_light(now, true, false);
  send_status(4);
  enter(now, Activity::at_scene, between(2min, 8min));
}

void Crew::leave_scene(Time now) {
  const bool was_locked = wish_.is_locked;
  // First all get out, then the car is locked; before they leave, the other way round.
  if (!was_locked && now >= until_ - 90s && now < until_ - 30s) return want_lock(now, true);
  if (was_locked && now >= until_ - 10s) return want_lock(now, false);
  if (now >= until_) enter(now, Activity::reporting);
}

/// Who has waited long enough for a terminal that does not answer gives up what he was going to
/// type; but nobody goes home from a car that flashes.
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
      want_light(now, true, true);
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
      want_light(now, false, false);
      send_status(1);
      next_call_ = now + between(3min, options_.quiet_max);
      enter(now, Activity::clearing, 5s);
      break;
    case Activity::clearing:
      if (now >= until_) enter(now, Activity::patrolling, between(2min, 8min));
      break;
    case Activity::parking:
      if (can_leave(now)) leave(now);
      break;
  }
  insist(now);
}

}  // namespace canvoy::police
