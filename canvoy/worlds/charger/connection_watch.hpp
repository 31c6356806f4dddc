// Reports the SDO connections that the manager of a vehicle has given or withdrawn since the last
// look.
//
//     ConnectionWatch watch(events);
//     watch.look(now, manager.connections());    // whenever one may have changed
#pragma once

#include <array>
#include <span>
#include <vector>

#include "canvoy/canopen/manager/sdo_manager.hpp"
#include "canvoy/worlds/charger/charger_event.hpp"

namespace canvoy::charger {

class ConnectionWatch {
 public:
  /// Changes are noted in `events`, which must outlive this object.
  explicit ConnectionWatch(std::vector<ChargerEvent>& events) : events_(&events) {}

  /// Compares with the present connections, at most 4.
  void look(Time now, std::span<const SdoConnection> present);

 private:
  std::vector<ChargerEvent>* events_;
  std::array<SdoConnection, 4> told_;  ///< last reported connections
};

}  // namespace canvoy::charger
