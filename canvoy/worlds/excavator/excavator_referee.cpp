#include "canvoy/worlds/excavator/excavator_referee.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "canvoy/worlds/excavator/machine_control.hpp"

namespace canvoy::excavator {

namespace {

using Kind = InvariantKind;

/// Time in which a valve closes, and what turns comes to rest.
constexpr Duration comes_to_rest = 400ms;
/// Time in which a heartbeat was due, with a margin.
constexpr Duration is_silent = heartbeat_ms * 1500us;
/// Time in which a press has its effect; most of it is that of a person who listens.
constexpr Duration has_effect_in = 600ms;
constexpr double moves_from = 0.005;

double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// A right state of at most this length ends no error: a lamp that is put out five times a second
/// gives no information, and an engine that is throttled as often does no work.
Duration lull_of(Kind kind) {
  const bool has_lulls =
      kind == Kind::indicators || kind == Kind::display || kind == Kind::throttle;
  return has_lulls ? Duration(500ms) : Duration(0);
}

double allowed_of(Kind kind) {
  switch (kind) {
    case Kind::unwanted_motion:
      // One position is lost, and two are late.
      return in_seconds(consumer_time + comes_to_rest) + 0.1;
    case Kind::lost_seat:
    case Kind::lost_host:
    case Kind::lost_armrest:
      return in_seconds(consumer_time + comes_to_rest);
    case Kind::presses:
      return 0;
    case Kind::axis_delta:
      // An event of another axis sends the position of this one as well, from which its own delta
      // does not count.
      return 2 * axis_delta;
    case Kind::indicators:
    case Kind::throttle:
      return 1;
    case Kind::display:
      return 2;
    case Kind::service:
      return 150;
    case Kind::spilled:
      return 10;
    case Kind::device_missing:
      return 5;
  }
  return 0;
}

}  // namespace

void ExcavatorReferee::fault_begins(const InvariantSet& kinds) {
  for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i].faults += kinds[i] ? 1U : 0U;
}

void ExcavatorReferee::fault_ends(const InvariantSet& kinds, Time now) {
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    if (!kinds[i]) continue;
    --kept_[i].faults;
    const auto kind = static_cast<Kind>(i);
    const bool is_service = kind == Kind::service || kind == Kind::spilled;
    kept_[i].excused_until =
        std::max(kept_[i].excused_until, now + (is_service ? service_returns : return_bound));
  }
}

/// All devices boot at the start.
bool ExcavatorReferee::is_excused(Kind kind, Time now) const {
  const Kept& kept = kept_[index(kind)];
  return kept.faults != 0 || now < kept.excused_until || now < Time(return_bound);
}

void ExcavatorReferee::measure(Kind kind, double value) {
  Kept& kept = kept_[index(kind)];
  kept.worst = std::max(kept.worst, value);
  ++kept.judged;
}

/// At each instant one invariant of motion is judged: that of the silent device, or that of the
/// hand; and the time since each device was heard.
void ExcavatorReferee::moves(Time now, const Excavator& machine,
                             const std::array<double, movements>& hands) {
  const bool has_host = now - host_heard_ <= is_silent;
  const bool has_seat = now - seat_heard_ <= is_silent;
  const bool has_armrest = !has_armrest_ || now - armrest_heard_ <= is_silent;
  if (!has_host || !has_seat || !has_armrest) heard_all_since_ = now;
  for (std::size_t i = 0; i < movements; ++i) {
    const auto movement = static_cast<Movement>(i);
    const double hand = hands[i];
    std::array<Time, 2>& wanted = hand_[i].wanted;
    if (hand < -contact_closes) wanted[0] = now;
    if (hand > contact_closes) wanted[1] = now;
    const double speed = machine.speed(movement);
    if (std::abs(speed) < moves_from) continue;
    if (!has_host) {
      measure(Kind::lost_host, in_seconds(now - host_heard_));
    } else if (!has_seat) {
      measure(Kind::lost_seat, in_seconds(now - seat_heard_));
    } else if (!has_armrest) {
      measure(Kind::lost_armrest, in_seconds(now - armrest_heard_));
    } else {
      measure(Kind::lost_host, in_seconds(now - host_heard_));
      measure(Kind::lost_seat, in_seconds(now - seat_heard_));
      if (has_armrest_) measure(Kind::lost_armrest, in_seconds(now - armrest_heard_));
      const Time since = std::max(wanted[speed < 0 ? 0 : 1], heard_all_since_);
      measure(Kind::unwanted_motion, in_seconds(now - since));
    }
  }
}

void ExcavatorReferee::pressed(Time now, Button button) {
  Pressed& it = pressed_[static_cast<std::size_t>(button)];
  if (is_excused(Kind::presses, now)) return;
  ++kept_[index(Kind::presses)].judged;
  if (it.open++ == 0) it.since = now;
}

void ExcavatorReferee::has_effect(Time now, Button button) {
  Pressed& it = pressed_[static_cast<std::size_t>(button)];
  if (it.open != 0) {
    --it.open;
    it.since = now;
  } else if (!is_excused(Kind::presses, now)) {
    ++kept_[index(Kind::presses)].worst;
  }
}

void ExcavatorReferee::look_at_presses(Time now) {
  for (Pressed& it : pressed_) {
    if (is_excused(Kind::presses, now)) it.open = 0;
    if (it.open == 0 || now - it.since <= has_effect_in) continue;
    kept_[index(Kind::presses)].worst += it.open;
    it.open = 0;
  }
}

void ExcavatorReferee::has_earth(Time now, double dug, double spilled, bool pours) {
  constexpr double percent = 100;
  const double more = spilled - std::exchange(spilled_before_, spilled);
  if (is_excused(Kind::spilled, now)) {
    spilled_excused_ += more;
  } else if (pours) {
    measure(Kind::spilled, (spilled - spilled_excused_) / std::max(dug, earth_least) * percent);
  }
}

void ExcavatorReferee::compare(Time now, double digits_apart) {
  if (!is_excused(Kind::axis_delta, now)) measure(Kind::axis_delta, digits_apart);
}

void ExcavatorReferee::judge(Kind kind, Time now, bool is_right) {
  Kept& kept = kept_[index(kind)];
  if (!is_excused(kind, now)) return judge_always(kind, now, is_right);
  kept.right_at = is_right ? now : kept.right_at + (now - kept.looked_at);
  kept.looked_at = now;
}

void ExcavatorReferee::judge_always(Kind kind, Time now, bool is_right) {
  Kept& kept = kept_[index(kind)];
  kept.looked_at = now;
  if (!is_right) kept.wrong_at = now;
  if (is_right && now - kept.wrong_at > lull_of(kind)) kept.right_at = now;
  measure(kind, is_right ? 0 : in_seconds(now - kept.right_at));
}

void ExcavatorReferee::judge_device(NodeId id, Time now, bool is_there) {
  Time& at = there_at_.at(id);
  const bool is_excused_now = is_excused(Kind::device_missing, now);
  if (is_there || is_excused_now) at = now;
  if (is_excused_now) return;
  measure(Kind::device_missing, in_seconds(now - at));
}

bool ExcavatorReferee::is_broken(std::size_t kind) const {
  return !undecided_[kind] && kept_[kind].worst > allowed_of(static_cast<Kind>(kind)) + 1e-9;
}

bool ExcavatorReferee::has_news() {
  InvariantSet broken;
  for (std::size_t i = 0; i < kept_.size(); ++i) broken[i] = is_broken(i);
  return std::exchange(broken_, broken) != broken;
}

std::vector<Invariant> ExcavatorReferee::verdicts() const {
  std::vector<Invariant> all;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const auto kind = static_cast<Kind>(i);
    if (kind == Kind::lost_armrest && !has_armrest_) continue;
    all.push_back({.kind = kind,
                   .worst = kept_[i].worst,
                   .allowed = allowed_of(kind),
                   .held = !is_broken(i),
                   .judged = undecided_[i] ? 0 : kept_[i].judged});
  }
  return all;
}

}  // namespace canvoy::excavator
