// Text and JSON of events in the network of a car, common to a taxi and a police car.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "canvoy/text/text.hpp"
#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/worlds/car/network_changed.hpp"

namespace canvoy::tools {

/// Kind of fault of a network.
template <class Network>
using KindOf = std::remove_cvref_t<
    decltype(std::declval<const Network&>().options().faults.faults.front().kind)>;

/// For a world with one car, which has nodes() and options().
template <class Network>
class CarNames : public PlanNames<KindOf<Network>> {
 public:
  explicit CarNames(const Network& network)
      : PlanNames<KindOf<Network>>(network.options().faults), network_(network) {}

  std::string device(BusIndex, NodeId id) const override {
    if (id == 0) return "all";
    const auto nodes = network_.nodes();
    return id <= nodes.size() ? fmt::format("{} ({})", nodes[id - 1U]->place().name, id)
                              : text::node_text(id);
  }

 private:
  const Network& network_;
};

Told told(const WorldNames& names, const car::NetworkChanged& event);

}  // namespace canvoy::tools
