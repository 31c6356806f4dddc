// What happens in the network of a car, in words and as JSON: the same in a taxi and in a police
// car.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "canvoy/sim/car/network_changed.hpp"
#include "canvoy/tools/run/world_text.hpp"
#include "canvoy/words/text.hpp"

namespace canvoy::tools {

/// The kind of fault of a network.
template <class Network>
using KindOf = std::remove_cvref_t<
    decltype(std::declval<const Network&>().options().faults.faults.front().kind)>;

/// Of a world with one car, which has nodes() and options().
template <class Network>
class CarNames : public PlanNames<KindOf<Network>> {
 public:
  explicit CarNames(const Network& network)
      : PlanNames<KindOf<Network>>(network.options().faults), network_(network) {}

  std::string device(BusIndex, NodeId id) const override {
    if (id == 0) return "all";
    const auto nodes = network_.nodes();
    return id <= nodes.size() ? fmt::format("{} ({})", nodes[id - 1U]->place().name, id)
                              : words::node_text(id);
  }

 private:
  const Network& network_;
};

Told told(const WorldNames& names, const car::NetworkChanged& event);

}  // namespace canvoy::tools
