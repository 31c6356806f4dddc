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
  return car == 2 ? parts_.second_car.press_stop_button() : parts_.computer.press_stop_button();
}

bool StopRequests::is_wanted() const {
  return std::ranges::any_of(pressed_, [](const Pressed& pressed) { return pressed.times != 0; });
}

/// A passenger who has pressed the button, and sees no sign, presses it again; in the second car
/// they go to a button of the first car when that does not help, however often others press there
/// meanwhile.
void StopRequests::press_again(Time now, unsigned car) {
  const Pressed& pressed = pressed_.at(car - 1);
  if (pressed.times == 0) return;
  if (car == 2 && now >= pressed.since + goes_forward_after) {
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
  if (car == 2 && nodes_.is_played(second_next_stop_id)) return parts_.displays.is_sign_lit(car);
  return parts_.displays.is_sign_lit(1) || has_unseen_sign();
}

void StopRequests::look(Time now) {
  const bool is_driving = parts_.vehicle.state() == BusState::driving;
  if (is_sign_seen(1) && is_driving) parts_.vehicle.request_stop(now);
  for (unsigned car = 1; car <= pressed_.size(); ++car) {
    if (!is_sign_seen(car)) press_again(now, car);
    const bool is_lit = parts_.displays.is_sign_lit(car);
    if (std::exchange(told_signs_.at(car - 1), is_lit) != is_lit) {
      events_.note(now, StopSignLit{is_lit, car});
    }
  }
}

/// People who have pressed a button read in their car that the bus will stop, and so do those of
/// the other car. In the first car two displays have a sign: that of the next stop must be lit for
/// its own people, one of the two for those of the second car. Without a press, none is lit,
/// neither on the way nor before it.
void StopRequests::judge(Time now) {
  const BusDisplays& displays = parts_.displays;
  BusReferee& referee = parts_.referee;
  const bool is_first_lit = displays.at(next_stop_id).is_sign_lit();
  referee.judge(InvariantKind::stop_sign, now, is_first_lit, pressed_[0].times != 0);
  const bool is_told_forward = pressed_[1].times == 0 || displays.is_sign_lit(1);
  referee.judge(InvariantKind::second_stop_sign, now, displays.is_sign_lit(2) && is_told_forward,
                is_wanted());
  const bool is_on_the_way = parts_.vehicle.state() != BusState::at_stop || !has_stopped_;
  const bool is_any_lit = displays.is_sign_lit(1) || displays.is_sign_lit(2);
  referee.judge(InvariantKind::false_stop_sign, now, !is_any_lit, is_on_the_way && !is_wanted());
}

}  // namespace canvoy::bus_line
