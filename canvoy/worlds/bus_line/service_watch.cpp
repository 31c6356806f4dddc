#include "canvoy/worlds/bus_line/service_watch.hpp"

namespace canvoy::bus_line {

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
  const auto excuse = [&](InvariantKind kind) {
    parts_.referee.excuse(kind, now + BusReferee::return_bound);
  };
  for (unsigned car = 1; car <= nodes_.cars(); ++car) excuse(announcements_in(car));
  for (unsigned car = 2; car <= nodes_.cars(); ++car) excuse(car_kind(car));
  excuse(InvariantKind::next_stop);
  excuse(InvariantKind::service);
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
    const DeviceKey key = node->place().key;
    const bool is_excused = parts_.faults.is_without_power(key) ||
                            referee.is_excused(InvariantKind::device_missing, now);
    referee.judge_device(node->place().id, now,
                         nodes_.is_at_work(key) || is_excused || nodes_.is_awaited(key));
  }
}

}  // namespace canvoy::bus_line
