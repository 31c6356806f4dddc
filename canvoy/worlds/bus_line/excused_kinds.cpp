#include "canvoy/worlds/bus_line/excused_kinds.hpp"

#include <algorithm>
#include <initializer_list>

#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

namespace {

using Kind = InvariantKind;

InvariantSet set_of(std::initializer_list<Kind> kinds) {
  InvariantSet set;
  for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

/// All invariants except honest displays, complete texts, and what depends on the driver.
InvariantSet all_services() {
  InvariantSet set;
  set.set();
  return set & ~set_of({Kind::lie, Kind::texts, Kind::early_departure, Kind::left_behind,
                        Kind::overcrowded});
}

/// Services that the gateways carry from car to car.
InvariantSet train_services() {
  return set_of({Kind::second_car, Kind::second_announcements, Kind::second_stop_sign});
}

InvariantSet affected_by_loss_of(NodeId node) {
  switch (node) {
    case computer_id:
      return all_services();  // no device starts the others
    case identification_id:
      return set_of({Kind::next_stop, Kind::destination, Kind::information, Kind::announcements,
                     Kind::tickets, Kind::pdo_tables, Kind::service, Kind::second_car,
                     Kind::second_announcements});
    case front_display_id:
    case side_display_id:
      return set_of({Kind::destination});
    case next_stop_id:
      return set_of({Kind::next_stop, Kind::stop_sign, Kind::second_stop_sign});
    case information_id:
      return set_of({Kind::information});
    case canceller_id:
    case printer_id:
      return set_of({Kind::service});
    case announcer_id:
      return set_of({Kind::announcements});
    case vehicle_gateway_id:
      return set_of(
          {Kind::passengers, Kind::stop_sign, Kind::second_stop_sign, Kind::false_stop_sign});
    case first_counter_id:
    case counting_manager_id:
    case second_counter_id:
      return set_of({Kind::passengers});
    case train_gateway_id:
      return train_services();
    case second_gateway_id:  // no device starts the others of its segment
      return train_services() | set_of({Kind::device_missing});
    case second_destination_id:
      return set_of({Kind::second_car});
    case second_next_stop_id:
      return set_of({Kind::second_car, Kind::second_stop_sign});
    case second_announcer_id:
      return set_of({Kind::second_announcements});
    default:
      return {};
  }
}

}  // namespace

InvariantSet affected_by(FaultKind kind, NodeId node) {
  switch (kind) {
    case FaultKind::lost_node:
    case FaultKind::restart:
      return affected_by_loss_of(node);
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
      return all_services();
    case FaultKind::broken_door:
    case FaultKind::blocked_door:
      return set_of({Kind::service, Kind::left_behind});
    case FaultKind::no_paper:
      return set_of({Kind::service});
    case FaultKind::train_bus_cut:
      return train_services();
    default:
      return {};
  }
}

InvariantSet unknown_without(std::span<const NodeId> real) {
  const auto is_played = [real](NodeId id) { return std::ranges::find(real, id) == real.end(); };
  InvariantSet set;
  const auto without = [&](std::initializer_list<NodeId> ids, std::initializer_list<Kind> kinds) {
    const bool is_played_by_none = std::ranges::none_of(ids, is_played);
    if (!is_played_by_none) return;
    for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  };
  if (!is_played(computer_id)) {  // it alone has the line
    set.set();
    set &= ~set_of(
        {Kind::device_missing, Kind::early_departure, Kind::left_behind, Kind::overcrowded});
  }
  without({identification_id}, {Kind::next_stop, Kind::destination, Kind::information, Kind::lie,
                                Kind::announcements, Kind::tickets, Kind::pdo_tables, Kind::service,
                                Kind::second_car, Kind::second_announcements});
  // Its satellites have another place and time.
  without({positioning_id},
          {Kind::next_stop, Kind::lie, Kind::announcements, Kind::tickets, Kind::clock,
           Kind::pdo_tables, Kind::service, Kind::second_car, Kind::second_announcements});
  without({front_display_id, side_display_id}, {Kind::destination});
  without({next_stop_id}, {Kind::next_stop, Kind::stop_sign});
  without({next_stop_id, information_id}, {Kind::second_stop_sign});
  without({information_id}, {Kind::information});
  without({canceller_id, printer_id}, {Kind::tickets});
  without({announcer_id}, {Kind::announcements});
  // It may lead the vehicle, and stop it.
  without({vehicle_gateway_id},
          {Kind::passengers, Kind::stop_sign, Kind::service, Kind::second_stop_sign,
           Kind::false_stop_sign, Kind::early_departure, Kind::left_behind});
  for (const NodeId id : {first_counter_id, counting_manager_id, second_counter_id}) {
    without({id}, {Kind::passengers});
  }
  // Passengers behind it may press at any time.
  without({train_gateway_id}, {Kind::second_car, Kind::second_announcements, Kind::second_stop_sign,
                               Kind::false_stop_sign});
  without({second_gateway_id}, {Kind::second_car, Kind::second_announcements, Kind::pdo_tables,
                                Kind::second_stop_sign, Kind::false_stop_sign});
  without({second_destination_id, second_next_stop_id}, {Kind::second_car});
  without({second_next_stop_id}, {Kind::second_stop_sign});
  without({second_announcer_id}, {Kind::second_announcements});
  return set;
}

}  // namespace canvoy::bus_line
