// Which SDO connections the manager of a vehicle has given or taken back since it was looked at
// last.
//
//     ConnectionWatch watch(events);
//     watch.look(now, manager.connections());    // whenever one may have changed
#pragma once

#include <array>
#include <span>
#include <vector>

#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/sim/charging/charging_event.hpp"

namespace canvoy::charging {

class ConnectionWatch {
 public:
  /// What is seen is noted in `events`, which must outlive this.
  explicit ConnectionWatch(std::vector<ChargingEvent>& events) : events_(&events) {}

  /// Of as many as there is room for: 4.
  void look(Time now, std::span<const SdoConnection> present);

 private:
  std::vector<ChargingEvent>* events_;
  std::array<SdoConnection, 4> told_;  ///< as they were told of
};

}  // namespace canvoy::charging
