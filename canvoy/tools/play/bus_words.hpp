// Common texts of a bus and a depot.
#pragma once

#include <string>
#include <string_view>

#include "canvoy/tools/player/world_text.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"

namespace canvoy::tools {

/// Names of a bus: `sim0` is in the first car, `sim1` in the second, and so on.
class BusNames : public PlanNames<bus_line::FaultKind> {
 public:
  /// `options` must outlive this.
  explicit BusNames(const bus_line::BusNetworkOptions& options)
      : PlanNames(options.faults), design_(options.design) {}

  std::string device(BusIndex, NodeId id) const override;
  /// Name without the node-ID, such as `ticket-canceller`; empty: no device of the bus has it.
  std::string_view name(NodeId id) const { return bus_line::name_of(design_, id); }
  /// Car of a device of the bus, 1 the first.
  unsigned car(NodeId id) const { return bus_line::car_of(bus_line::key_of(design_, id)); }

 private:
  const bus_line::BusDesign& design_;
};

/// `3 journeys, 22 stops, 16.5 km; 17 people in, ...; 88233 frames, 0 error frames`; frames are
/// those of `bus`. `odometer` in m.
std::string service_text(const bus_line::BusNetworkStatistics& statistics,
                         const bus_line::RiderStatistics& riders, double odometer,
                         const BusSnapshot& bus);
/// The statistics as `statistics` of docs/json.md.
Json bus_statistics_json(const bus_line::BusNetworkStatistics& statistics,
                         const bus_line::RiderStatistics& riders);

}  // namespace canvoy::tools
