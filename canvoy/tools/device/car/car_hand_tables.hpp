// The hands of each virtual device of CiA 447-3, in one table for command line, help, pages and
// completion.
//
//     for (const DeviceHand& hand : car_hands(cia447::car_unit<cia447::PrinterKind>)) ...
//
// A status that a device reports from a table of its own has a hand named by the words of its
// clause; what is sensed, pressed or fails elsewhere has a row.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// Reason why a status of a device has no hand: where it comes from.
struct WithoutHand {
  static constexpr std::uint8_t all = 0xFF;

  std::uint16_t index = 0;
  std::uint8_t sub = all;
  std::uint8_t first_bit = all;  ///< of the field
  std::string_view why{};
};

/// The table of a device, by the name of its unit in the catalogue.
struct CarHandTable {
  std::string_view device;
  std::vector<DeviceHand> rows{};          ///< hands that are no status of the table of the unit
  std::span<const WithoutHand> without{};  ///< statuses without a hand
  /// Sets a status of the table of the unit, or the value of its sensor. Null: the unit has no such
  /// table.
  void (*tell)(const HandTarget& target, const cia447::FieldPlace& status,
               const HandValue& value) = nullptr;
  /// Objects of which only the sensor values can be set: the unit itself determines their values.
  std::vector<cia447::FieldPlace> sensed_only{};
  /// Name of a hand; null: from the name of the field.
  std::string (*name)(const cia447::FieldPlace& status) = nullptr;
};

/// The hands of a unit; empty for a unit that is not of CiA 447-3.
const std::vector<DeviceHand>& car_hands(const cia447::CarUnit& unit);
/// The statuses of a unit that have no hand.
std::span<const WithoutHand> without_hands(const cia447::CarUnit& unit);

/// Calls `each` with every status that the device provides: a field, or a whole entry without
/// fields.
void each_car_status(const cia447::CarUnit& unit,
                     const std::function<void(const cia447::FieldPlace&)>& each);

// The tables, by group of devices.

CarHandTable gateway_hands();
std::vector<CarHandTable> taxi_hands();    ///< taximeter, printer, clock, driver, roof sign, alarm
std::vector<CarHandTable> add_on_hands();  ///< terminal, positions, radio, and switching devices

}  // namespace canvoy::tools
