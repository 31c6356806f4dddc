// What a bus and a depot of them say in the same words.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/tools/run/world_text.hpp"

namespace canvoy::tools {

/// `ticket-canceller`; empty: no device of the bus has this node-ID.
std::string_view bus_device_name(NodeId id);

class BusNames : public WorldNames {
 public:
  /// `options` live as long as this.
  explicit BusNames(const bus::BusNetworkOptions& options) : options_(options) {}

  /// `sim0` in the first car, `sim1` in the second one.
  std::string bus(BusIndex index) const override { return "sim" + std::to_string(index); }
  std::string device(BusIndex, NodeId id) const override;
  std::string fault(std::size_t fault) const override;
  std::string_view emergency(std::uint16_t code) const override;

 private:
  const bus::BusNetworkOptions& options_;
};

/// `3 journeys, 22 stops, 16.5 km; 17 people in, ...; 88233 frames, 0 error frames`; of the bus the
/// frames count. `odometer` in m.
std::string service_text(const bus::BusNetworkStatistics& statistics,
                         const bus::RiderStatistics& riders, double odometer,
                         const BusSnapshot& bus);
/// The same as `statistics` of docs/json.md.
Json bus_statistics_json(const bus::BusNetworkStatistics& statistics,
                         const bus::RiderStatistics& riders);

}  // namespace canvoy::tools
