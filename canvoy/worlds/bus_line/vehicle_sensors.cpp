#include "canvoy/worlds/bus_line/vehicle_sensors.hpp"

#include <algorithm>
#include <string_view>

#include "canvoy/devices/cia407/kit/motion_recognition.hpp"

namespace canvoy::bus_line {

namespace {

constexpr double ambient = 11.5;
constexpr double hdop = 1.1;
constexpr std::string_view driver_card = "D  1234567890123456";

}  // namespace

void VehicleSensors::add_nodes() {
  add_vehicle_devices();
  add_counters();
}

void VehicleSensors::add_vehicle_devices() {
  using namespace cia407;
  Environment& gateway = nodes_.add_site();
  gateway.provide(Callback<VehicleGatewayHardware()>::to<&VehicleSensors::gateway_hardware>(*this));
  nodes_.add(vehicle_gateway_id, gateway);
  Environment& tachograph = nodes_.add_site();
  tachograph.provide(
      Callback<TachographHardware()>::to<&VehicleSensors::tachograph_hardware>(*this));
  nodes_.add(tachograph_id, tachograph);
  nodes_.add(driver_display_id, nodes_.add_site());
  Environment& satellites = nodes_.add_site();
  satellites.provide(
      Callback<PositioningHardware()>::to<&VehicleSensors::positioning_hardware>(*this));
  satellites.provide(Callback<TimeFixingHardware()>::to<&VehicleSensors::time_hardware>(*this));
  nodes_.add(positioning_id, satellites);
}

void VehicleSensors::add_counters() {
  using namespace cia407;
  counters_.push_back({.key = first_counter_id, .door = 1});
  counters_.push_back({.key = second_counter_id, .door = 2});
  for (const AddedDevice& added : nodes_.design().added) {
    if (added.door == 0) continue;
    counters_.push_back({.key = key_of(nodes_.design(), added.id), .door = added.door});
  }
  const auto site_of = [this](DoorCounter& counter) -> Environment& {
    Environment& environment = nodes_.add_site();
    environment.provide(callback<&DoorCounter::settings>(counter));
    environment.watch(counter.unit);
    return environment;
  };
  nodes_.add(first_counter_id, site_of(counters_[0]));
  Environment& manager = nodes_.add_site();
  if (nodes_.design().capacity) {
    manager.provide(callback<&VehicleSensors::manager>(*this));
  }
  manager.watch(counting_);
  nodes_.add(counting_manager_id, manager);
  nodes_.add(second_counter_id, site_of(counters_[1]));
  for (const AddedDevice& added : nodes_.design().added) {
    const DeviceKey key = key_of(nodes_.design(), added.id);
    const auto counter = std::ranges::find(counters_, key, &DoorCounter::key);
    nodes_.add(added, counter == counters_.end() ? nodes_.add_site() : site_of(*counter));
  }
}

void VehicleSensors::passed(std::size_t door, bool is_in) {
  const auto counter = std::ranges::find(counters_, door + 1, &DoorCounter::door);
  if (counter == counters_.end() || (door == 0 && sabotage_.blind_counter)) return;
  nodes_.node(counter->key).with([&] {
    is_in ? counter->unit->count_in() : counter->unit->count_out();
  });
}

void VehicleSensors::clear_counts() {
  nodes_.node(counting_manager_id).with([this] { counting_->clear(); });
}

bool VehicleSensors::count_passengers() {
  return nodes_.is_at_work(counting_manager_id) && nodes_.is_at_work(vehicle_gateway_id) &&
         std::ranges::all_of(counters_, [this](const DoorCounter& counter) {
           return nodes_.is_at_work(counter.key);
         });
}

cia407::VehicleGatewayHardware VehicleSensors::gateway_hardware() {
  return {.read = callback<&VehicleSensors::read_vehicle>(*this)};
}

cia407::VehicleReading VehicleSensors::read_vehicle() {
  cia407::VehicleReading reading;
  reading.speed_kmh = vehicle_.speed() * cia407::kmh_of_metres_per_second;
  reading.mileage_metres = vehicle_.odometer();
  reading.bearing_degrees = vehicle_.heading();
  reading.ambient_celsius = ambient;
  reading.direction = cia407::Direction::forward;
  const std::size_t doors = std::min<std::size_t>(vehicle_.door_count(), reading.doors_max);
  for (std::size_t i = 0; i < doors; ++i) {
    reading.doors[i] = {.is_valid = true, .is_open = !vehicle_.door(i).is_closed()};
    // All doors are on the right, and a door that opens has been released.
    reading.right_released = reading.right_released || reading.doors[i].is_open;
  }
  return reading;
}

cia407::TachographHardware VehicleSensors::tachograph_hardware() {
  return {.read = callback<&VehicleSensors::read_tachograph>(*this)};
}

cia407::TachographReading VehicleSensors::read_tachograph() {
  return {.speed_kmh = vehicle_.speed() * cia407::kmh_of_metres_per_second,
          .direction = cia407::Direction::forward,
          .distance_metres = vehicle_.odometer(),
          .utc = satellite_time(),
          .cards = {driver_card, ""}};
}

cia407::PositioningHardware VehicleSensors::positioning_hardware() {
  return {.read = callback<&VehicleSensors::read_position>(*this)};
}

cia447::GpsReading VehicleSensors::read_position() {
  if (satellites_are_lost_) return {.fix = cia447::GpsFix::none};
  const GeoPoint place = vehicle_.position();
  return {.fix = cia447::GpsFix::fix_3d,
          .latitude = place.latitude,
          .longitude = place.longitude,
          .velocity = vehicle_.speed(),
          .heading = vehicle_.heading(),
          .hdop = hdop};
}

cia407::TimeFixingHardware VehicleSensors::time_hardware() {
  return {.utc = callback<&VehicleSensors::satellite_time>(*this),
          .local_offset = callback<&VehicleSensors::local_offset>(*this)};
}

std::optional<cia407::CivilTime> VehicleSensors::satellite_time() {
  if (satellites_are_lost_) return std::nullopt;
  constexpr std::int64_t slow = 600;
  return cia447::civil_time(clock_.utc() - (sabotage_.slow_clocks ? slow : 0));
}

}  // namespace canvoy::bus_line
