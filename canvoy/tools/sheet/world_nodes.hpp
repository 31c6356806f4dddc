// The nodes of the built-in networks that stand in their files by their names alone: those of cars,
// buses and excavators, with the CAN-IDs of PDOs that a network gives them when it boots.
//
//     describe_world("taxi.toml");  // 8 of them; none: it is another network
#pragma once

#include <vector>

#include "canvoy/tools/sheet/described_nodes.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line for what `canvoy run FILE` refuses as well.
std::vector<DescribedNode> describe_world(const std::string& path);

}  // namespace canvoy::tools
