#include "canvoy/worlds/bus_line/stop_requests.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::bus_line {

namespace {

constexpr Duration press_after = 2s;
/// After three presses without effect.
constexpr Duration goes_forward_after = 3 * press_after;

}  // namespace

bool StopRequests::press(Time now, unsigned car) {
  Pressed& pressed = pressed_.at(car - 1);
  if (pressed.times == 0) pressed.since = now;
  pressed.last = now;
  ++pressed.times;
  return car == 1 ? parts_.computer.press_stop_button() : parts_.following.press_stop_button(car);
}

bool StopRequests::is_wanted() const {
  return std::ranges::any_of(pressed_, [](const Pressed& pressed) { return pressed.times != 0; });
}

/// A passenger who has pressed the button, and sees no sign, presses it again; behind the first
/// car they go to a button of that when it does not help, however often others press there
/// meanwhile.
void StopRequests::press_again(Time now, unsigned car) {
  const Pressed& pressed = pressed_.at(car - 1);
  if (pressed.times == 0) return;
  if (car != 1 && now >= pressed.since + goes_forward_after) {
    if (pressed_.front().times == 0) press(now, 1);
  } else if (now >= pressed.last + press_after) {
    press(now, car);
  }
}

/// True where the sign cannot be seen here, or the button's wire ends at a real computer: the
/// driver stops.
bool StopRequests::has_unseen_sign() const {
  const bool is_out_of_sight = !nodes_.is_played(next_stop_id) && !nodes_.is_played(information_id);
  return is_wanted() && (is_out_of_sight || !nodes_.is_played(computer_id));
}

/// Sign as seen by a passenger who has pressed the button. A real display shows its last command.
bool StopRequests::is_sign_seen(unsigned car) const {
  if (car != 1 && nodes_.is_played(next_stop_of(car))) return parts_.displays.is_sign_lit(car);
  return parts_.displays.is_sign_lit(1) || has_unseen_sign();
}

void StopRequests::look(Time now) {
  const bool is_driving = parts_.vehicle.state() == BusState::driving;
  if (is_sign_seen(1) && is_driving) parts_.vehicle.request_stop(now);
  for (unsigned car = 1; car <= nodes_.cars(); ++car) {
    if (!is_sign_seen(car)) press_again(now, car);
    const bool is_lit = parts_.displays.is_sign_lit(car);
    if (std::exchange(told_signs_.at(car - 1), is_lit) != is_lit) {
      events_.note(now, StopSignLit{is_lit, car});
    }
  }
}

/// True where people who have pressed, or who read that others have, expect the sign in a car
/// behind the first. A press in another of those reaches it by the first car: whether it got there
/// is judged for the car where it was.
bool StopRequests::is_due_in(unsigned car) const {
  return has_pressed(1) || has_pressed(car) || (is_wanted() && parts_.displays.is_sign_lit(1));
}

/// People who have pressed a button read in their car that the bus will stop, and so do those of
/// the other cars. In the first car two displays have a sign: that of the next stop must be lit for
/// its own people, one of the two for those of another car. Without a press, none is lit, neither
/// on the way nor before it.
void StopRequests::judge(Time now) {
  const BusDisplays& displays = parts_.displays;
  BusReferee& referee = parts_.referee;
  const bool is_first_lit = displays.at(next_stop_id).is_sign_lit();
  referee.judge(InvariantKind::stop_sign, now, is_first_lit, has_pressed(1));
  bool is_any_lit = displays.is_sign_lit(1);
  for (unsigned car = 2; car <= nodes_.cars(); ++car) {
    const bool is_lit = displays.is_sign_lit(car);
    const bool is_told_forward = !has_pressed(car) || displays.is_sign_lit(1);
    referee.judge(stop_sign_in(car), now, is_lit && is_told_forward, is_due_in(car));
    is_any_lit = is_any_lit || is_lit;
  }
  const bool is_on_the_way = parts_.vehicle.state() != BusState::at_stop || !has_stopped_;
  referee.judge(InvariantKind::false_stop_sign, now, !is_any_lit, is_on_the_way && !is_wanted());
}

}  // namespace canvoy::bus_line
