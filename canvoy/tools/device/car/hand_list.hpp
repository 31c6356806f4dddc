// What can be pressed and set of devices of CiA 447, for people and programs: the tables of hands.
#pragma once

#include <string>
#include <vector>

namespace canvoy::tools {

/// A line for each hand of these devices, by their names in the catalogue, also as
/// `taximeter+printer`; none: of all. Throws UsageError for one that has no hands.
void print_hand_list(const std::vector<std::string>& devices, bool json);
/// The same as a page, with what has no hand, and why: docs/hands.md.
std::string hand_page();

}  // namespace canvoy::tools
