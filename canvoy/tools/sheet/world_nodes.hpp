// The nodes of the built-in networks that stand in their files by their names alone: those of cars,
// buses and excavators, with the CAN-IDs of PDOs that a network gives them when it boots.
//
//     describe_world("taxi.toml");  // 8 of them; none: it is another network
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line for what `canvoy run FILE` refuses as well.
std::vector<DescribedNode> describe_world(const std::string& path);

/// What a network writes there. A mapping that has become longer has entries as its first.
void set_entry(formats::DataSheet& sheet, std::uint16_t index, std::uint8_t sub,
               std::uint32_t value);

/// The PDOs of a car as each node has them when the gateway has found it
/// (canvoy/devices/cia447/car_network.hpp).
void place_car_pdos(std::vector<DescribedNode>& nodes, const cia447::PdoOffsets& offsets);

/// Of a network of `canvoy/sim` whose nodes have a device_name().
template <class Network>
std::vector<DescribedNode> describe_network(const Network& network) {
  std::vector<DescribedNode> nodes;
  for (const auto& node : network.nodes()) {
    DescribedNode& made =
        nodes.emplace_back(describe_device(node->device_name(), node->place().id));
    made.name = node->place().name;
    // Of two cars each has a bus, as in the log of a run.
    if constexpr (requires { node->bus(); }) made.bus = fmt::format("sim{}", node->bus());
    if constexpr (requires { node->presets(); }) {
      for (const auto& preset : node->presets()) {
        set_entry(made.sheet, preset.index, preset.sub, preset.value);
      }
    }
  }
  return nodes;
}

template <class Network, class Options>
std::vector<DescribedNode> describe_car(const Options& options, const cia447::PdoOffsets& offsets) {
  std::vector<DescribedNode> nodes = describe_network(*std::make_unique<Network>(options));
  place_car_pdos(nodes, offsets);
  return nodes;
}

}  // namespace canvoy::tools
