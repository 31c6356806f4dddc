// The nodes of built-in networks with files that give only names of nodes: those of cars, buses and
// excavators, with the CAN-IDs of PDOs that a network assigns at boot.
//
//     describe_world("taxi.toml");  // 8 of them; none: it is another network
#pragma once

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/tools/sheet/described_nodes.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line for what `canvoy run FILE` refuses. Defined in
/// canvoy/tools/play/worlds.cpp, since worlds depend on sheets.
std::vector<DescribedNode> describe_world(const std::string& path);

/// Sets an entry as a network writes it. A lengthened mapping has entries like its first.
void set_entry(formats::DataSheet& sheet, std::uint16_t index, std::uint8_t sub,
               std::uint32_t value);

/// Sets the PDOs of a car for each node found by the gateway
/// (canvoy/devices/cia447/kit/car_network.hpp).
void place_car_pdos(std::vector<DescribedNode>& nodes, const cia447::PdoOffsets& offsets);

/// For a network of `canvoy/sim` with nodes that have a device_name().
template <class Network>
std::vector<DescribedNode> describe_network(const Network& network) {
  std::vector<DescribedNode> nodes;
  for (const auto& node : network.nodes()) {
    DescribedNode& made =
        nodes.emplace_back(describe_device(node->device_name(), node->place().id));
    made.name = node->place().name;
    // With two cars, each has its own bus, as in the log of a run.
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
