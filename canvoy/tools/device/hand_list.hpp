// Lists the hands of devices, for people and programs, from the tables of hands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// Prints a line for each hand of these devices, by catalogue name or as `taximeter+printer`; none
/// given: all devices. Throws UsageError for an unknown device.
void print_hand_list(const std::vector<std::string>& devices, bool json);
/// The hands of a device of the catalogue, in the middle of a building.
std::vector<DeviceHand> device_hands(std::string_view device);
/// The page docs/hands.md, which includes what has no hand, with the reason.
std::string hand_page();

}  // namespace canvoy::tools
