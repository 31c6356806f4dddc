// An action of a person on a device of CiA 407, with its time, on the command line: `ticket@2s`,
// `open2@3s`, `in=3@2s`, `log-in=driver:1234,line:23@1s`.
//
//     const BusPress press = parse_bus_press(units, "ticket@2s");
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// An action with its numbers by name; a single number has an empty name.
struct BusPress {
  std::string_view what;  ///< from the table of all actions
  std::map<std::string, std::uint32_t, std::less<>> numbers{};
  Duration at{};

  std::optional<std::uint32_t> number(std::string_view name = "") const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
};

/// Throws UsageError if none of these units, which are all units of the device, has this action.
BusPress parse_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text);
/// All actions of a unit as hands, for lists.
std::vector<DeviceHand> bus_press_hands(const cia407::BusUnit& unit);
/// True if one of these units has an action with this name.
bool has_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text);

}  // namespace canvoy::tools
