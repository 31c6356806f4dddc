// Hands of the catalogue devices that are not of a car, a bus or an operator environment: one table
// for each, by what its hardware senses and how that can fail.
//
//     for (const DeviceHand& hand : wired_hands("lift-load", environment)) ...
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia417/sensor/sensor_place.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// The hands of a device at its place: a panel of the highest floor has no `up`. They act on a
/// WiredThings. Empty: the device depends on the bus alone.
std::vector<DeviceHand> wired_hands(std::string_view device, const Environment& environment);

/// Names for cia417::sensors_at().
inline constexpr std::array<std::string_view, cia417::PlacedSensors{}.size()> wired_sensor_names = {
    "glass", "smoke", "damage", "pressure", "temperature"};

/// The condition for `defective`, `not-installed` and `working`; nothing for other values.
template <class Condition>
std::optional<Condition> wired_condition(const HandValue& value) {
  switch (value.meaning) {
    case Meaning::failure:
      return Condition::defective;
    case Meaning::not_implemented:
      return Condition::not_installed;
    case Meaning::padding:
      return Condition{};
    default:
      return std::nullopt;
  }
}

}  // namespace canvoy::tools
