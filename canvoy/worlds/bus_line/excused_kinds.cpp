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

/// Services in a car behind the first, which the gateways carry there.
InvariantSet services_in(unsigned car) {
  return set_of({car_kind(car), announcements_in(car), stop_sign_in(car)});
}
/// This service in each car behind the first.
InvariantSet in_each_car(InvariantKind (*kind)(unsigned)) {
  InvariantSet set;
  for (unsigned car = 2; car <= cars_max; ++car) set |= set_of({kind(car)});
  return set;
}
InvariantSet train_services() {
  return in_each_car(car_kind) | in_each_car(announcements_in) | in_each_car(stop_sign_in);
}

/// Of a device behind the first car.
InvariantSet affected_behind(DeviceKey device) {
  const unsigned car = car_of(device);
  if (device == gateway_of(car)) {  // no device starts the others of its segment
    return services_in(car) | set_of({Kind::device_missing});
  }
  if (device == destination_of(car)) return set_of({car_kind(car)});
  if (device == next_stop_of(car)) return set_of({car_kind(car), stop_sign_in(car)});
  return set_of({announcements_in(car)});
}

InvariantSet affected_by_loss_of(DeviceKey device) {
  if (car_of(device) != 1) return affected_behind(device);
  switch (device) {
    case computer_id:
      return all_services();  // no device starts the others
    case identification_id:
      return set_of({Kind::next_stop, Kind::destination, Kind::information, Kind::announcements,
                     Kind::tickets, Kind::pdo_tables, Kind::service}) |
             in_each_car(car_kind) | in_each_car(announcements_in);
    case front_display_id:
    case side_display_id:
      return set_of({Kind::destination});
    case next_stop_id:
      return set_of({Kind::next_stop, Kind::stop_sign}) | in_each_car(stop_sign_in);
    case information_id:
      return set_of({Kind::information});
    case canceller_id:
    case printer_id:
      return set_of({Kind::service});
    case announcer_id:
      return set_of({Kind::announcements});
    case vehicle_gateway_id:
      return set_of({Kind::passengers, Kind::stop_sign, Kind::false_stop_sign}) |
             in_each_car(stop_sign_in);
    case first_counter_id:
    case counting_manager_id:
    case second_counter_id:
      return set_of({Kind::passengers});
    case train_gateway_id:
      return train_services();
    default:
      return {};
  }
}

}  // namespace

InvariantSet affected_by(FaultKind kind, DeviceKey device) {
  switch (kind) {
    case FaultKind::lost_node:
    case FaultKind::restart:
      return affected_by_loss_of(device);
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

InvariantSet unknown_without(std::span<const DeviceKey> real) {
  const auto is_played = [real](NodeId id) { return std::ranges::find(real, id) == real.end(); };
  InvariantSet set;
  const auto without = [&](std::initializer_list<NodeId> ids, const InvariantSet& kinds) {
    if (std::ranges::none_of(ids, is_played)) set |= kinds;
  };
  const InvariantSet told_behind = in_each_car(car_kind) | in_each_car(announcements_in);
  const InvariantSet signs_behind = in_each_car(stop_sign_in);
  if (!is_played(computer_id)) {  // it alone has the line
    set.set();
    set &= ~set_of(
        {Kind::device_missing, Kind::early_departure, Kind::left_behind, Kind::overcrowded});
  }
  without(
      {identification_id},
      told_behind | set_of({Kind::next_stop, Kind::destination, Kind::information, Kind::lie,
                            Kind::announcements, Kind::tickets, Kind::pdo_tables, Kind::service}));
  // Its satellites have another place and time.
  without({positioning_id},
          told_behind | set_of({Kind::next_stop, Kind::lie, Kind::announcements, Kind::tickets,
                                Kind::clock, Kind::pdo_tables, Kind::service}));
  without({front_display_id, side_display_id}, set_of({Kind::destination}));
  without({next_stop_id}, set_of({Kind::next_stop, Kind::stop_sign}));
  without({next_stop_id, information_id}, signs_behind);
  without({information_id}, set_of({Kind::information}));
  without({canceller_id, printer_id}, set_of({Kind::tickets}));
  without({announcer_id}, set_of({Kind::announcements}));
  // It may lead the vehicle, and stop it.
  without({vehicle_gateway_id},
          signs_behind | set_of({Kind::passengers, Kind::stop_sign, Kind::service,
                                 Kind::false_stop_sign, Kind::early_departure, Kind::left_behind}));
  for (const NodeId id : {first_counter_id, counting_manager_id, second_counter_id}) {
    without({id}, set_of({Kind::passengers}));
  }
  // Passengers behind it may press at any time.
  without({train_gateway_id}, train_services() | set_of({Kind::false_stop_sign}));
  for (unsigned car = 2; car <= cars_max; ++car) {
    without({gateway_of(car)},
            services_in(car) | set_of({Kind::pdo_tables, Kind::false_stop_sign}));
    without({destination_of(car), next_stop_of(car)}, set_of({car_kind(car)}));
    without({next_stop_of(car)}, set_of({stop_sign_in(car)}));
    without({announcer_of(car)}, set_of({announcements_in(car)}));
  }
  return set;
}

}  // namespace canvoy::bus_line
