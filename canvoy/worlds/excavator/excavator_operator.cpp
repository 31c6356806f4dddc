#include "canvoy/worlds/excavator/excavator_operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::excavator {

namespace {

constexpr Duration gives_up = 12s;  ///< time after which a pose is given up
constexpr Duration looks_each = 1s;
constexpr Duration looks_again = 2500ms;  ///< time from a press to the next look
constexpr Duration notices = 3s;          ///< time after which the operator notices that the
                                          ///< machine does not follow
constexpr Duration hands_off = 1500ms;
constexpr Duration drives_for = 6s;
constexpr double near_enough = 4;  ///< degrees
constexpr double full_aim = 15;    ///< degrees away: from there on the stick is at its end
constexpr double least_aim = 0.2;
constexpr double working_throttle = 0.9;

}  // namespace

ExcavatorOperator::ExcavatorOperator(OperatorOptions options, std::uint64_t seed, SeatPanel& panel,
                                     Excavator& machine, Hands hands)
    : options_(std::move(options)),
      random_(seed),
      panel_(panel),
      machine_(machine),
      hands_(std::move(hands)) {}

void ExcavatorOperator::step(Time now) {
  const std::uint64_t before = panel_.hand_changes();
  options_.recorded.empty() ? work(now) : play(now);
  if (panel_.hand_changes() != before) hands_.moved();
}

void ExcavatorOperator::work(Time now) {
  if (now >= options_.end && !is_over_) {
    is_over_ = true;
    enter(now, Activity::gets_off);
    rest(now);
  }
  if (held_back_) {
    since_ = moved_at_ = now;
    return let_go();
  }
  act(now);
  look_at_lamps(now);
  watch_machine(now);
  move_hands(now);
}

/// Plays all moves that are due; at one instant, positions come before presses.
void ExcavatorOperator::play(Time now) {
  const auto first = options_.recorded.begin() + static_cast<std::ptrdiff_t>(played_);
  auto last = first;
  for (; last != options_.recorded.end() && last->at <= now; ++last) move_hand(panel_, *last);
  played_ += static_cast<std::size_t>(last - first);
  for (auto move = first; move != last; ++move) {
    if (is_button(move->input)) {
      ++presses_;
      hands_.press(button_of(move->input),
                   std::chrono::round<Duration>(std::chrono::duration<double>(move->value)));
    } else if (move->input == HandInput::activity) {
      const auto next = static_cast<Activity>(move->value);
      if (activity_ == Activity::returns && next != Activity::gets_off) ++cycles_;
      if (activity_ == Activity::rests) machine_.refuel();
      enter(now, next);
    }
  }
}

void ExcavatorOperator::enter(Time now, Activity activity) {
  activity_ = activity;
  since_ = now;
  moved_at_ = now;
  aims_.fill(0);
  if (told_) told_(now, activity);
}

void ExcavatorOperator::rest(Time now) {
  wishes_ = {};
  panel_.turn_wheel(0, 0);
  resumes_at_ = now + options_.rest;
}

void ExcavatorOperator::begin_cycle(Time now) {
  play_with_switches(now);
  dump_at_ = Excavator::heap_at + static_cast<double>(random_.below(11)) - 5;
  enter(now, Activity::reaches);
}

/// Does one thing after the other; what is not reached in time is given up, and the next one is
/// done.
void ExcavatorOperator::act(Time now) {
  constexpr double swing = 25;
  const auto next = [&](const Pose& pose, Activity then) {
    aim(pose);
    if (is_at(pose) || now - since_ > gives_up) enter(now, then);
  };
  switch (activity_) {
    case Activity::sits_down:
      lower_lever(now);
      if (now - since_ < 2s) return;
      wishes_ = {.is_unlocked = true, .has_light = true};
      panel_.turn_wheel(0, working_throttle);
      rest_at_ = now + options_.work;
      return begin_cycle(now);
    case Activity::reaches:
      return next({swing, -50, -5, 0}, Activity::lowers);
    case Activity::lowers:
      return next({0, -50, -5, 0}, Activity::digs);
    case Activity::digs:
      return next({6, -110, -75, 0}, Activity::lifts);
    case Activity::lifts:
      if (machine_.earth().in_bucket < 0.1 && machine_.earth_left() < 1) {
        return enter(now, Activity::drives);
      }
      return next({35, -110, -90, 0}, Activity::slews);
    case Activity::slews:
      next({35, -110, -90, dump_at_}, Activity::dumps);
      aims_[static_cast<std::size_t>(Movement::rotator)] = now - since_ < 1s ? turn_ : 0;
      return;
    case Activity::dumps:
      return next({35, -70, 0, dump_at_}, Activity::returns);
    case Activity::returns:
      aim({swing, -70, -5, 0});
      if (!is_at({swing, -70, -5, 0}) && now - since_ <= gives_up) return;
      ++cycles_;
      // The tank is filled meanwhile.
      if (now >= rest_at_ || is_lit(panel_.lit(), Lamp::low_fuel)) {
        enter(now, Activity::rests);
        return rest(now);
      }
      return begin_cycle(now);
    case Activity::drives:
      aims_[static_cast<std::size_t>(Movement::left_track)] = 0.8;
      aims_[static_cast<std::size_t>(Movement::right_track)] = 0.8;
      if (now - since_ > drives_for) begin_cycle(now);
      return;
    case Activity::rests:
      raise_lever(now);
      if (now < resumes_at_) return;
      machine_.refuel();
      return enter(now, Activity::sits_down);
    case Activity::gets_off:
      return raise_lever(now);
  }
}

void ExcavatorOperator::lower_lever(Time now) {
  if (panel_.is_lever_lowered() || now - since_ < 500ms) return;
  panel_.sit(true);
  panel_.set_lever(true);
}

/// Raises the lever: the hydraulics are locked.
void ExcavatorOperator::raise_lever(Time now) {
  if (!panel_.is_lever_lowered() || now - since_ < 1s) return;
  if (!is_lit(panel_.lit(), Lamp::locked)) return;
  panel_.set_lever(false);
  panel_.sit(false);
}

bool ExcavatorOperator::is_at(const Pose& pose) const {
  const auto is_near = [this](Movement movement, double goal) {
    return std::abs(std::remainder(machine_.angle(movement) - goal, 360)) <= near_enough;
  };
  return is_near(Movement::boom, pose.boom) && is_near(Movement::stick, pose.stick) &&
         is_near(Movement::bucket, pose.bucket) && is_near(Movement::slew, pose.slew);
}

void ExcavatorOperator::aim(const Pose& pose) {
  const auto one = [this](Movement movement, double goal) {
    const double way = std::remainder(goal - machine_.angle(movement), 360);
    double& to = aims_[static_cast<std::size_t>(movement)];
    to = 0;
    if (std::abs(way) <= near_enough / 2) return;
    to = std::copysign(std::clamp(std::abs(way) / full_aim, least_aim, 1.0), way);
  };
  one(Movement::boom, pose.boom);
  one(Movement::stick, pose.stick);
  one(Movement::bucket, pose.bucket);
  one(Movement::slew, pose.slew);
}

/// Where nothing moves in spite of a command, the operator releases the sticks and tries again.
void ExcavatorOperator::watch_machine(Time now) {
  bool is_meant = false;
  bool moves = false;
  for (std::size_t i = 0; i < movements; ++i) {
    is_meant = is_meant || std::abs(aims_[i]) > 0;
    moves = moves || std::abs(machine_.speed(static_cast<Movement>(i))) > 0.01;
  }
  if (!is_meant || moves || now < hands_off_until_) moved_at_ = now;
  if (now - moved_at_ > notices) hands_off_until_ = now + hands_off;
}

void ExcavatorOperator::move_hands(Time now) {
  const bool lets_go = now < hands_off_until_ || !is_working();
  const auto follow = [&](Movement movement, double place) {
    const double goal = lets_go ? 0 : aims_[static_cast<std::size_t>(movement)];
    return place + std::clamp(goal - place, -step_of_hand, step_of_hand);
  };
  constexpr std::pair<Stick, Movement> levers[] = {{Stick::left_x, Movement::slew},
                                                   {Stick::left_y, Movement::stick},
                                                   {Stick::right_x, Movement::bucket},
                                                   {Stick::right_y, Movement::boom}};
  for (const auto& [stick, movement] : levers) {
    panel_.move_stick(stick, follow(movement, panel_.stick(stick)));
  }
  panel_.move_pedal(0, follow(Movement::left_track, panel_.pedal(0)));
  panel_.move_pedal(1, follow(Movement::right_track, panel_.pedal(1)));
  panel_.turn_wheel(1, follow(Movement::rotator, panel_.wheel(1)));
}

void ExcavatorOperator::let_go() {
  const auto towards = [](double place, double goal) {
    return place + std::clamp(goal - place, -step_of_hand, step_of_hand);
  };
  for (std::size_t i = 0; i < stick_count; ++i) {
    const auto stick = static_cast<Stick>(i);
    const double goal = stick == Stick::right_y ? held_back_.value_or(0) : 0;
    panel_.move_stick(stick, towards(panel_.stick(stick), goal));
  }
  panel_.move_pedal(0, towards(panel_.pedal(0), 0));
  panel_.move_pedal(1, towards(panel_.pedal(1), 0));
  panel_.turn_wheel(1, towards(panel_.wheel(1), 0));
}

// Switches.

/// Looks for lamps that are not as wanted. A dark seat has no information.
void ExcavatorOperator::look_at_lamps(Time now) {
  if (now < looks_at_) return;
  looks_at_ = now + looks_each;
  if (!is_lit(panel_.lit(), Lamp::ready) || now < pressed_at_ + looks_again) return;
  static_cast<void>(press_if_other(now, Lamp::locked, !wishes_.is_unlocked, Button::lock) ||
                    press_if_other(now, Lamp::light, wishes_.has_light, Button::light) ||
                    press_if_other(now, Lamp::beacon, wishes_.has_beacon, Button::beacon) ||
                    press_if_other(now, Lamp::fast, wishes_.is_fast, Button::travel));
}

bool ExcavatorOperator::press_if_other(Time now, Lamp lamp, bool is_wished, Button button) {
  if (is_lit(panel_.lit(), lamp) == is_wished) return false;
  press(now, button);
  return true;
}

/// Holds the button for a time from 5 ms, like a quick finger, to a second.
void ExcavatorOperator::press(Time now, Button button) {
  pressed_at_ = now;
  ++presses_;
  const auto up_to = [this](Duration least, Duration most) {
    return least + Duration(1ms) *
                       random_.below(static_cast<std::uint32_t>((most - least) / Duration(1ms)));
  };
  const bool is_quick = happens(300);
  const bool is_long = happens(100);
  hands_.press(button, is_quick  ? up_to(5ms, 25ms)
                       : is_long ? up_to(600ms, 1s)
                                 : up_to(30ms, 330ms));
}

void ExcavatorOperator::play_with_switches(Time now) {
  if (happens(150)) press(now, Button::horn);
  if (happens(30)) wishes_.has_light = !wishes_.has_light;
  if (happens(40)) wishes_.has_beacon = !wishes_.has_beacon;
  if (happens(40)) wishes_.is_fast = !wishes_.is_fast;
  if (happens(60)) panel_.turn_wheel(0, working_throttle - 0.01 * random_.below(20));
  if (happens(60)) panel_.turn_knob(happens(500) ? 1 : -1);
  turn_ = happens(200) ? (happens(500) ? 0.5 : -0.5) : 0;
}

}  // namespace canvoy::excavator
