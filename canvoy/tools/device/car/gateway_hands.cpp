// Hands of the IVN gateway (CiA 447-3, 4.2.2 to 4.2.4): sensors of the car take a number here; its
// states, such as doors, lights and ignition, take the words of the clause.
#include <fmt/format.h>

#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/car/switched_hands.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"

namespace canvoy::tools {

namespace gateway_hand_rows {
namespace {

using namespace hand_rows;
using namespace cia447;

constexpr WithoutHand gateway_without[] = {
    {0x601C, 0, 14, "the sign of steering-wheel-angle"},
    {0x6050, 0, 14, "follows engine-revolutions"},
    {0x6054, WithoutHand::all, WithoutHand::all, "the maker's: where wheel pulses come from"},
    {0x6055, 0, 0, "counts how far the car drives"},
    {0x6056, WithoutHand::all, WithoutHand::all, "the maker's: where 6055h begins anew"},
    {0x6057, WithoutHand::all, WithoutHand::all, "the maker's: pulses of a turn"},
    {0x605C, 0, 8, "follows tank-level"},
    {0x605D, 0, 16, "follows fuel-consumption"},
    {0x605D, 0, 18, "the maker's: litres or kilograms"}};

/// A number from a sensor of the car.
DeviceHand sensor(const char* name, std::vector<FieldPlace> changes, CarSense sense,
                  const HandRange& range) {
  DeviceHand hand = number<IvnGatewayUnit>(
      name, changes.front(), range,
      [sense](IvnGatewayUnit& /*unit*/, const HandValue& value, const HandTarget& target) {
        const bool fails = value.meaning == Meaning::failure;
        target.car->sense(sense, fails ? std::nullopt : std::optional(value.number));
        return true;
      });
  hand.words = {{"failure", 0, Meaning::failure}};
  hand.changes = std::move(changes);
  return around(std::move(hand));
}

/// A sensor of what the car drives by itself can only fail.
DeviceHand failing_sensor(const char* name, std::vector<FieldPlace> changes, CarSense sense) {
  DeviceHand hand = choice<IvnGatewayUnit>(
      name, changes.front(), {"working", "failure"},
      [sense](IvnGatewayUnit& /*unit*/, const HandValue& value, const HandTarget& target) {
        target.car->sense(sense, value.code == 1 ? std::nullopt : std::optional(0.0));
        return true;
      });
  hand.changes = std::move(changes);
  return around(std::move(hand));
}

DeviceHand speed_hand() {
  DeviceHand hand = number<IvnGatewayUnit>(
      "speed", place_of(displayed_vehicle_speed), {0, DeviceCar::kmh_max, "km/h"},
      [](IvnGatewayUnit& /*unit*/, const HandValue& value, const HandTarget& target) {
        if (value.meaning == Meaning::failure) {
          target.car->sense(CarSense::speed, std::nullopt);
          return true;
        }
        target.car->sense(CarSense::speed, 0);
        return target.car->drive(value.number);
      });
  hand.words = {{"failure", 0, Meaning::failure}};
  hand.changes = {place_of(displayed_vehicle_speed), place_of(wheel_rpm)};
  return around(std::move(hand));
}

DeviceHand vin_hand() {
  return around(text<IvnGatewayUnit>(
      "vin", {place_of(vin_data)}, "WDB12345678901234",
      [](const HandValue& value) {
        constexpr std::string_view letters = "0123456789ABCDEFGHJKLMNPRSTUVWXYZ";
        const bool is_vin =
            value.text.size() == 17 && value.text.find_first_not_of(letters) == std::string::npos;
        if (is_vin) return;
        throw UsageError(fmt::format("'{}' is no VIN: it has 17 digits and capitals but I, O and Q",
                                     value.text));
      },
      [](IvnGatewayUnit& /*unit*/, const HandValue& value, const HandTarget& target) {
        target.car->set_vin(value.text);
        return true;
      }));
}

/// The driver does not change what a hand has set.
void report_gateway(const HandTarget& target, const FieldPlace& place, const HandValue& value) {
  auto& gateway = target.as<IvnGatewayUnit>();
  const bool has_driver = target.car != nullptr;
  if (has_driver && value.meaning == Meaning::state) target.car->set_by_hand(place);
  // Seats have no sensors of their own: 6019h gives the reported value.
  if (place.index == seat_adjustment_status_object.index) {
    return gateway.report(place, value.code);
  }
  report_status(gateway, place, value);
}

CarHandTable table_of_rows() {
  CarHandTable table{.device = IvnGatewayKind::info.name, .without = gateway_without};
  table.rows = {
      speed_hand(),
      failing_sensor("odometer", {place_of(odometer), place_of(wheel_pulse_counter_valid)},
                     CarSense::distance),
      sensor("engine-revolutions", {place_of(actual_engine_revolutions)},
             CarSense::engine_revolutions, {0, 16'000, "rpm"}),
      sensor("tank-level", {place_of(tank_level)}, CarSense::tank_level, {0, 200, "l"}),
      sensor("fuel-consumption", {place_of(current_average_fuel_consumption)},
             CarSense::fuel_consumption, {0, 30, "l/s"}),
      sensor("steering-wheel-angle", {place_of(steering_wheel_angle)},
             CarSense::steering_wheel_angle, {-1433, 1433, "degrees, left above 0"}),
      sensor("outside-temperature", {place_of(displayed_outside_air_temperature)},
             CarSense::outside_temperature, {-50, 76, "degrees Celsius"}),
      sensor("inside-temperature", {place_of(displayed_inside_air_temperature)},
             CarSense::inside_temperature, {-50, 76, "degrees Celsius"}),
      sensor("light-intensity", {place_of(environment_light_intensity)}, CarSense::light_intensity,
             {0, 100, "%"}),
      sensor("mirror-dimming", {place_of(mirror_anti_dazzle_position)}, CarSense::mirror_dimming,
             {0, 100, "%"}),
      vin_hand()};
  table.tell = report_gateway;
  return table;
}

}  // namespace
}  // namespace gateway_hand_rows

CarHandTable gateway_hands() {
  return gateway_hand_rows::table_of_rows();
}

}  // namespace canvoy::tools
