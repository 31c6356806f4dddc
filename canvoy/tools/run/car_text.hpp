// What happens in the network of a car, in words and as JSON: the same in a taxi and in a police
// car.
#pragma once

#include <fmt/format.h>

#include <string>

#include "canvoy/sim/car/network_changed.hpp"
#include "canvoy/tools/run/world_text.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

/// Of a world with one car, which has nodes() and options().
template <class Network>
class CarNames : public WorldNames {
 public:
  explicit CarNames(const Network& network) : network_(network) {}

  std::string bus(BusIndex) const override { return "sim0"; }
  std::string device(BusIndex, NodeId id) const override {
    if (id == 0) return "all";
    const auto nodes = network_.nodes();
    return id <= nodes.size() ? fmt::format("{} ({})", nodes[id - 1U]->place().name, id)
                              : words::node_text(id);
  }
  std::string fault(std::size_t fault) const override {
    return std::string(fault_name(network_.options().faults.faults.at(fault).kind));
  }
  std::string_view emergency(std::uint16_t code) const override {
    return words::emergency_text(code);
  }

 private:
  const Network& network_;
};

Told told(const WorldNames& names, const car::NetworkChanged& event);

}  // namespace canvoy::tools
