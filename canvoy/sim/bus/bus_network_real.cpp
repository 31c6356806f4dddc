// Devices of a bus that are not played here: real ones have their places on its cables. They are
// heard and supervised; what hangs on them, and is not seen here, is not judged.
#include <algorithm>

#include "canvoy/devices/cia407/door_state.hpp"
#include "canvoy/devices/cia407/motion_recognition.hpp"
#include "canvoy/sim/bus/bus_network.hpp"

namespace canvoy::bus {

namespace {

using Kind = InvariantKind;

/// Until it is missed: a real device starts when somebody turns it on.
constexpr Duration real_start_time = 1min;

constexpr NodeId master_of(NodeId id) {
  return car_of(id) == 1 ? computer_id : second_gateway_id;
}

}  // namespace

bool BusNetwork::is_played(NodeId id) const {
  return std::ranges::find(options_.real, id) == options_.real.end();
}

/// What cannot be known, or is up to who is not played.
InvariantSet BusNetwork::unknown_to_referees() const {
  InvariantSet set;
  const auto without = [&](std::initializer_list<NodeId> ids, std::initializer_list<Kind> kinds) {
    const bool is_played_by_none =
        std::ranges::none_of(ids, [this](NodeId id) { return is_played(id); });
    if (!is_played_by_none) return;
    for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  };
  if (!is_played(computer_id)) {  // whose line it is, only it knows
    set.set();
    set.reset(static_cast<std::size_t>(Kind::device_missing));
  }
  without({identification_id}, {Kind::next_stop, Kind::destination, Kind::information, Kind::lie,
                                Kind::announcements, Kind::tickets, Kind::pdo_tables, Kind::service,
                                Kind::second_car, Kind::second_announcements});
  // Its satellites say another place and time.
  without({positioning_id},
          {Kind::next_stop, Kind::lie, Kind::announcements, Kind::tickets, Kind::clock,
           Kind::pdo_tables, Kind::service, Kind::second_car, Kind::second_announcements});
  without({front_display_id, side_display_id}, {Kind::destination});
  without({next_stop_id}, {Kind::next_stop, Kind::stop_sign});
  without({next_stop_id, information_id}, {Kind::second_stop_sign});
  without({information_id}, {Kind::information, Kind::texts});
  without({canceller_id, printer_id}, {Kind::tickets});
  without({announcer_id}, {Kind::announcements});
  // It may lead the vehicle, and stand.
  without({vehicle_gateway_id}, {Kind::passengers, Kind::stop_sign, Kind::service,
                                 Kind::second_stop_sign, Kind::false_stop_sign});
  for (const NodeId id : {first_counter_id, counting_manager_id, second_counter_id}) {
    without({id}, {Kind::passengers});
  }
  // Whoever is behind it may press.
  without({train_gateway_id}, {Kind::second_car, Kind::second_announcements, Kind::second_stop_sign,
                               Kind::false_stop_sign});
  without({second_gateway_id}, {Kind::second_car, Kind::second_announcements, Kind::pdo_tables,
                                Kind::second_stop_sign, Kind::false_stop_sign});
  without({second_destination_id, second_next_stop_id}, {Kind::second_car});
  without({second_next_stop_id}, {Kind::second_stop_sign});
  without({second_announcer_id}, {Kind::second_announcements});
  return set;
}

BusWatch& BusNetwork::watch_of(NodeId id) {
  return bus_of(id) == bus_ ? bus_watch_ : second_watch_;
}

/// As far as can be known of one that is not played.
bool BusNetwork::is_at_work(NodeId id) {
  return canvoy::is_at_work(world_, node(id), watch_of(id), LineControl::node_time_out);
}

/// Where the vehicle gateway is real and says a speed, the vehicle goes by it, as the on-board
/// computer hears it.
void BusNetwork::lead_vehicle(Time now) {
  if (is_played(vehicle_gateway_id) || !is_played(computer_id)) return;
  std::optional<RealMotion> real;
  BusNode& computer = node(computer_id);
  if (is_at_work(vehicle_gateway_id) && computer.is_operational()) {
    cia407::VirtualDevice& heard = computer.device().virtual_device(1);
    if (const auto kmh = heard[cia407::wheel_based_vehicle_speed].value()) {
      real = RealMotion{.speed = *kmh / cia407::kmh_of_metres_per_second};
      const Dictionary& dictionary = computer.node().dictionary();
      for (unsigned i = 0; i < vehicle_->door_count(); ++i) {
        const cia407::DoorState door = cia407::door_state(dictionary, i + 1);
        real->known_doors |= (door.is_valid ? 1U : 0U) << i;
        real->open_doors |= (door.is_open ? 1U : 0U) << i;
      }
    }
  }
  vehicle_->follow(now, real);
  world_.wake(vehicle_plant_, vehicle_->deadline());
}

/// It may come yet; or who starts it is not played, and does as it likes.
bool BusNetwork::is_awaited(NodeId id, Time now) {
  const NodeId master = master_of(id);
  if (id != master && !is_played(master)) return true;
  return !is_played(id) && now < Time(real_start_time);
}

/// What it shows comes from devices that are played.
bool BusNetwork::is_led_by_us(NodeId display) const {
  return car_of(display) == 1 || (is_played(second_gateway_id) && is_played(train_gateway_id));
}

/// Nobody here sees the sign, or the button's wire ends at a real computer: the driver stops.
bool BusNetwork::has_unseen_sign() const {
  const bool is_out_of_sight = !is_played(next_stop_id) && !is_played(information_id);
  return is_stop_wanted() && (is_out_of_sight || !is_played(computer_id));
}

/// Of who has a heartbeat of 500 ms here; a real one may have the usual second.
Duration BusNetwork::heartbeat_time_out(NodeId id) const {
  return is_played(id) ? LineControl::short_time_out : LineControl::node_time_out;
}

}  // namespace canvoy::bus
