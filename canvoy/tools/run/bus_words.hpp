// What a bus and a depot of them say in the same words.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/tools/run/world_text.hpp"

namespace canvoy::tools {

/// `ticket-canceller`; empty: no device of the bus has this node-ID.
std::string_view bus_device_name(NodeId id);

/// `sim0` is in the first car, `sim1` in the second one.
class BusNames : public PlanNames<bus::FaultKind> {
 public:
  /// `options` live as long as this.
  explicit BusNames(const bus::BusNetworkOptions& options) : PlanNames(options.faults) {}

  std::string device(BusIndex, NodeId id) const override;
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
