// What a person does with a device of CiA 407 on the command line, and when: `ticket@2s`,
// `open:2@3s`, `log-in:driver=1234:line=23@1s`.
//
//     const BusPress press = parse_bus_press(units, "ticket@2s");
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia407/bus_device.hpp"

namespace canvoy::tools {

/// As it is written: with its numbers by their names; that of a number alone is empty.
struct BusPress {
  std::string_view what;  ///< of the table of all
  std::map<std::string, std::uint32_t, std::less<>> numbers{};
  Duration at{};

  std::optional<std::uint32_t> number(std::string_view name = "") const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
};

/// Throws UsageError for one that is none of these units, all that there are.
BusPress parse_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text);
/// Whether it is one of these units, by its name alone.
bool has_bus_press(std::span<const cia407::BusUnit* const> units, std::string_view text);

}  // namespace canvoy::tools
