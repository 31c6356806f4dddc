// The hands of each virtual device of CiA 447-3: one table, from which command line, help, pages
// and completion have them.
//
//     for (const CarHand& hand : car_hands(cia447::car_unit<cia447::PrinterKind>)) ...
//
// A status that a device reports by a table of its own has a hand by the words of its clause; what
// is sensed, pressed or breaks elsewhere has a row.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/car_device.hpp"
#include "canvoy/tools/device/car/car_hand.hpp"

namespace canvoy::tools {

/// Why a status of a device has no hand: what it follows from.
struct WithoutHand {
  static constexpr std::uint8_t all = 0xFF;

  std::uint16_t index = 0;
  std::uint8_t sub = all;
  std::uint8_t first_bit = all;  ///< of the field
  std::string_view why{};
};

/// The table of a device: by the name of its unit in the catalogue.
struct CarHandTable {
  std::string_view device;
  std::vector<CarHand> rows{};             ///< those that are no status of the unit's own table
  std::span<const WithoutHand> without{};  ///< statuses that have none
  /// Of a status of the unit's own table: says what it is from now on, or what its sensor says.
  /// Null: the unit has no such table.
  void (*tell)(const HandTarget& target, const cia447::FieldPlace& status,
               const HandValue& value) = nullptr;
  /// Objects of which only the sensors can be told: the unit itself says what they are.
  std::vector<cia447::FieldPlace> sensed_only{};
  /// Names by another rule than that of the field; empty: by that.
  std::string (*name)(const cia447::FieldPlace& status) = nullptr;
};

/// Empty for a unit that is none of CiA 447-3's.
const std::vector<CarHand>& car_hands(const cia447::CarUnit& unit);
/// Those of its statuses that have no hand.
std::span<const WithoutHand> without_hands(const cia447::CarUnit& unit);

/// Calls `each` with the place of every status that the device provides: fields, or whole entries
/// that have none.
void each_car_status(const cia447::CarUnit& unit,
                     const std::function<void(const cia447::FieldPlace&)>& each);

// The tables, by what the devices are for.

CarHandTable gateway_hands();
std::vector<CarHandTable> taxi_hands();    ///< meter, printer, clock, driver, sign, alarm
std::vector<CarHandTable> add_on_hands();  ///< terminal, positions, radio, and what switches

}  // namespace canvoy::tools
