#include "canvoy/sim/bus/vehicle_sensors.hpp"

#include <algorithm>
#include <string_view>

#include "canvoy/devices/cia407/motion_recognition.hpp"

namespace canvoy::bus {

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
  Site& gateway = nodes_.add_site();
  gateway.offer(Callback<VehicleGatewayHardware()>::to<&VehicleSensors::gateway_hardware>(*this));
  nodes_.add(vehicle_gateway_id, gateway);
  Site& tachograph = nodes_.add_site();
  tachograph.offer(Callback<TachographHardware()>::to<&VehicleSensors::tachograph_hardware>(*this));
  nodes_.add(tachograph_id, tachograph);
  nodes_.add(driver_display_id, nodes_.add_site());
  Site& satellites = nodes_.add_site();
  satellites.offer(
      Callback<PositioningHardware()>::to<&VehicleSensors::positioning_hardware>(*this));
  satellites.offer(Callback<TimeFixingHardware()>::to<&VehicleSensors::time_hardware>(*this));
  nodes_.add(positioning_id, satellites);
}

void VehicleSensors::add_counters() {
  using namespace cia407;
  using Settings = PassengerCounterSettings;
  using Unit = PassengerCounterUnit;
  Site& first = nodes_.add_site();
  first.offer(Callback<Settings()>::to<&VehicleSensors::first_counter>(*this));
  first.watch(Callback<void(Unit&, Node&)>::to<&VehicleSensors::is_first_counter>(*this));
  nodes_.add(first_counter_id, first);
  Site& manager = nodes_.add_site();
  manager.watch(
      Callback<void(CountingManagerUnit&, Node&)>::to<&VehicleSensors::is_counting_manager>(*this));
  nodes_.add(counting_manager_id, manager);
  Site& second = nodes_.add_site();
  second.offer(Callback<Settings()>::to<&VehicleSensors::second_counter>(*this));
  second.watch(Callback<void(Unit&, Node&)>::to<&VehicleSensors::is_second_counter>(*this));
  nodes_.add(second_counter_id, second);
}

void VehicleSensors::passed(std::size_t door, bool is_in) {
  if (door >= counters_.size() || (door == 0 && sabotage_.blind_counter)) return;
  nodes_.node(door == 0 ? first_counter_id : second_counter_id).with([&] {
    is_in ? counters_.at(door)->count_in() : counters_.at(door)->count_out();
  });
}

void VehicleSensors::clear_counts() {
  nodes_.node(counting_manager_id).with([this] { counting_->clear(); });
}

bool VehicleSensors::count_passengers() {
  return nodes_.is_at_work(counting_manager_id) && nodes_.is_at_work(first_counter_id) &&
         nodes_.is_at_work(second_counter_id) && nodes_.is_at_work(vehicle_gateway_id);
}

cia407::VehicleGatewayHardware VehicleSensors::gateway_hardware() {
  return {.read = Callback<cia407::VehicleReading()>::to<&VehicleSensors::read_vehicle>(*this)};
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
  return {.read =
              Callback<cia407::TachographReading()>::to<&VehicleSensors::read_tachograph>(*this)};
}

cia407::TachographReading VehicleSensors::read_tachograph() {
  return {.speed_kmh = vehicle_.speed() * cia407::kmh_of_metres_per_second,
          .direction = cia407::Direction::forward,
          .distance_metres = vehicle_.odometer(),
          .utc = satellite_time(),
          .cards = {driver_card, ""}};
}

cia407::PositioningHardware VehicleSensors::positioning_hardware() {
  return {.read = Callback<cia447::GpsReading()>::to<&VehicleSensors::read_position>(*this)};
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
  return {
      .utc =
          Callback<std::optional<cia407::CivilTime>()>::to<&VehicleSensors::satellite_time>(*this),
      .local_offset = Callback<std::chrono::minutes()>::to<&VehicleSensors::local_offset>(*this)};
}

std::optional<cia407::CivilTime> VehicleSensors::satellite_time() {
  if (satellites_are_lost_) return std::nullopt;
  constexpr std::int64_t slow = 600;
  return cia447::civil_time(clock_.utc() - (sabotage_.slow_clocks ? slow : 0));
}

}  // namespace canvoy::bus
