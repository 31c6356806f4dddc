#include "canvoy/worlds/bus_line/service_watch.hpp"

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

namespace {

/// A driver who passes a stop cannot match the time to the second.
constexpr Duration early_from = 10s;

constexpr std::size_t place_of_kind(InvariantKind kind) {
  return static_cast<std::size_t>(kind);
}

}  // namespace

/// Devices that hold the position of the bus must find it again.
void ServiceWatch::fault_begins(const InvariantSet& kinds) {
  if (kinds[place_of_kind(InvariantKind::passengers)]) counts_are_lost_ = true;
  const bool is_blinded = kinds[place_of_kind(InvariantKind::announcements)] &&
                          kinds[place_of_kind(InvariantKind::next_stop)];
  needs_fix_ = needs_fix_ || is_blinded;
}

/// The on-board computer receives the identification device.
bool ServiceWatch::can_log_in() {
  return nodes_.is_at_work(computer_id) && nodes_.is_at_work(identification_id) &&
         !parts_.faults.cable_is_broken();
}

/// True if position and time reach the devices that need them.
bool ServiceWatch::can_tell_satellites() {
  return parts_.sensors.has_satellites() && nodes_.is_at_work(positioning_id);
}

void ServiceWatch::journey_begins() {
  if (parts_.vehicle.truth().aboard == 0) {
    parts_.sensors.clear_counts();
    counts_are_lost_ = !parts_.sensors.count_passengers() || !nodes_.is_at_work(computer_id) ||
                       parts_.faults.cable_is_broken();
  }
  if (can_log_in()) needs_fix_ = false;
}

void ServiceWatch::ticket_issued(const cia407::TicketData& ticket, bool is_printed) {
  const Time now = nodes_.world().now();
  events_.note(now, TicketIssued{is_printed, ticket.fare_zone, ticket.route_segment_number});
  const bool is_right = parts_.truth.is_true(now, [&](const TrueData& data) {
    return ticket.fare_zone == data.fare_zone &&
           ticket.route_segment_number == data.route_segment && ticket.line_id == data.line &&
           ticket.block_id == data.block &&
           (!is_printed || ticket.stop_point_id == data.stop_point);
  });
  parts_.referee.judge_one(InvariantKind::tickets, now, is_right);
}

void ServiceWatch::step(Time now) {
  judge_people(now);
  judge_counts(now);
  excuse_blindness(now);
  excuse_clock(now);
}

/// Judges people who are carried past their stop, or have no ticket that they wanted.
void ServiceWatch::judge_people(Time now) {
  const RiderStatistics& riders = parts_.vehicle.riders().statistics();
  const std::uint64_t badly = riders.carried_past + riders.without_ticket;
  const std::uint64_t well = riders.out + riders.bought + riders.cancelled;
  const auto judge = [&](std::uint64_t& told, std::uint64_t all, bool is_right) {
    for (; told < all; ++told) parts_.referee.judge_one(InvariantKind::service, now, is_right);
  };
  judge(badly_served_, badly, false);
  judge(well_served_, well, true);
  for (; boarded_ < riders.in; ++boarded_) {
    parts_.referee.judge_one(InvariantKind::left_behind, now, true);
  }
  for (; ignored_ < riders.ignored; ++ignored_) {
    parts_.referee.judge_one(InvariantKind::left_behind, now, false);
  }
  parts_.referee.judge(InvariantKind::overcrowded, now,
                       parts_.vehicle.riders().aboard() <= parts_.capacity);
}

void ServiceWatch::stop_left(const Passing& passing, Duration late) {
  if (!passing.is_timing_point) return;
  parts_.referee.judge_one(InvariantKind::early_departure, nodes_.world().now(),
                           late > -early_from);
}

void ServiceWatch::judge_counts(Time now) {
  const BusVehicle& vehicle = parts_.vehicle;
  if (counts_are_lost_) parts_.referee.excuse(InvariantKind::passengers, now + 1s);
  const bool can_tell = vehicle.all_doors_closed();
  parts_.referee.judge(InvariantKind::passengers, now,
                       parts_.computer.counted() == vehicle.riders().aboard(), can_tell);
}

/// An on-board computer that boots finds its position by satellites, or when a journey begins.
void ServiceWatch::excuse_blindness(Time now) {
  if (!needs_fix_) return;
  for (const auto kind :
       {InvariantKind::next_stop, InvariantKind::announcements, InvariantKind::service,
        InvariantKind::second_car, InvariantKind::second_announcements}) {
    parts_.referee.excuse(kind, now + BusReferee::return_bound);
  }
  if (can_tell_satellites() && can_log_in()) needs_fix_ = false;
}

/// Without satellites, the on-board computer has only its own clock.
void ServiceWatch::excuse_clock(Time now) {
  if (!parts_.computer.has_wrong_clock() || can_tell_satellites()) return;
  parts_.referee.excuse(InvariantKind::clock, now + BusReferee::return_bound);
}

/// A device without power by plan is missing, and so are all devices on a broken bus.
void ServiceWatch::judge_devices(Time now) {
  BusReferee& referee = parts_.referee;
  for (const auto& node : nodes_.all()) {
    const NodeId id = node->place().id;
    const bool is_excused = parts_.faults.is_without_power(id) ||
                            referee.is_excused(InvariantKind::device_missing, now);
    referee.judge_device(id, now, nodes_.is_at_work(id) || is_excused || nodes_.is_awaited(id));
  }
}

}  // namespace canvoy::bus_line
