#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"

#include "canvoy/devices/cia407/kit/turn.hpp"

namespace canvoy::cia407 {

namespace {

constexpr std::uint16_t doors_index = state_of_doors_object.index;
constexpr unsigned doors_of_byte = 4;
constexpr unsigned open_bit = 7;
constexpr unsigned left_bit = 6;
constexpr unsigned right_bit = 5;

/// The code of SAE J1939 for an error: FEh in the highest byte.
template <class Raw>
constexpr Raw error_code() {
  return static_cast<Raw>(Raw{0xFE} << (sizeof(Raw) * 8 - 8));
}

/// Speeds are positive backward as well (9.2.15.1).
std::optional<double> absolute(std::optional<double> value) {
  return value ? std::optional(std::abs(*value)) : std::nullopt;
}

}  // namespace

VehicleGatewayUnit::VehicleGatewayUnit(VirtualDevice& device,
                                       const VehicleGatewayHardware& hardware,
                                       const VehicleGatewaySettings& settings)
    : device_(device),
      hardware_(hardware),
      settings_(settings),
      timer_(callback<&VehicleGatewayUnit::look>(*this)) {
  device.on_reset = callback<&VehicleGatewayUnit::reset>(*this);
}

template <class Handle>
void VehicleGatewayUnit::tell(const Handle& handle, const Measured& measured) {
  if (measured.has_failed) {
    device_.values()[handle].set_raw(error_code<typename Handle::Reference::Raw>());
    device_.announce_at(handle.index(), handle.sub());
  } else if (!measured.value || std::isnan(*measured.value)) {
    device_.tell(handle, std::nullopt);
  } else {
    device_.tell(handle, *measured.value);
  }
}

void VehicleGatewayUnit::look(Time now) {
  device_.node().timers().arm(timer_, now + settings_.period);
  const VehicleReading reading = hardware_.read ? hardware_.read() : VehicleReading{};
  tell(wheel_based_vehicle_speed, reading.speed_kmh.changed(&absolute));
  tell(vehicle_mileage, reading.mileage_metres);
  tell(compass_bearing, reading.bearing_degrees.changed(&within_turn));
  tell(ambient_air_temperature, reading.ambient_celsius);
  const std::optional<double> kmh = reading.speed_kmh.value;
  recognition_.take(
      kmh ? std::optional(std::abs(*kmh) / kmh_of_metres_per_second * settings_.pulses_per_metre)
          : std::nullopt,
      now);
  device_.tell(drive_flag, reading.speed_kmh.has_failed ? Motion::error : recognition_.motion());
  device_.tell(direction_flag, reading.direction);
  device_.tell(brake_switch, reading.brake);
  report_clock(device_, local_clock, reading.local_time);
  report_doors(reading);
  report_engine(reading);
}

void VehicleGatewayUnit::report_doors(const VehicleReading& reading) {
  Dictionary& dictionary = device_.node().dictionary();
  bool is_open = false;
  std::array<std::uint8_t, VehicleReading::doors_max / doors_of_byte> bytes{};
  for (unsigned door = 1; door <= VehicleReading::doors_max; ++door) {
    const DoorState& state = reading.doors[door - 1];
    is_open = is_open || (state.is_valid && state.is_open);
    bytes[(door - 1) / doors_of_byte] |= door_bits(door, state);
  }
  // Single doors first: a receiver of the general state may then read which one it is.
  for (unsigned i = 0; i < bytes.size(); ++i) {
    dictionary.set_number(doors_index, static_cast<std::uint8_t>(i + 2), bytes[i]);
  }
  const unsigned general = (is_open ? 1U << open_bit : 0U) |
                           (reading.left_released ? 1U << left_bit : 0U) |
                           (reading.right_released ? 1U << right_bit : 0U);
  dictionary.set_number(doors_index, 1, general);
  // Consumers of single doors in this physical device are notified of each door.
  device_.tell(all_doors, is_open ? Doors::open : Doors::all_closed);
  for (unsigned i = 0; i < bytes.size(); ++i) {
    device_.announce_at(doors_index, static_cast<std::uint8_t>(i + 2));
  }
}

void VehicleGatewayUnit::report_engine(const VehicleReading& reading) {
  tell(fuel_rate, reading.fuel_rate_l_per_h);
  tell(instantaneous_fuel_economy, reading.economy_km_per_l);
  tell(average_fuel_economy, reading.average_economy_km_per_l);
  tell(total_fuel_used, reading.fuel_used_l);
  tell(trip_fuel, reading.trip_fuel_l);
  tell(total_idle_fuel_used, reading.idle_fuel_l);
  tell(engine_coolant_temperature, reading.coolant_celsius);
  tell(total_idle_hours, reading.idle_hours);
  tell(total_vehicle_hours, reading.vehicle_hours);
  tell(total_engine_hours, reading.engine_hours);
  tell(total_power_takeoff_hours, reading.takeoff_hours);
}

}  // namespace canvoy::cia407
