#include "canvoy/worlds/charger/charger_network.hpp"

#include <algorithm>

namespace canvoy::charger {

ChargerNetwork::ChargerNetwork() : ChargerNetwork(ChargerOptions()) {}

ChargerNetwork::ChargerNetwork(const ChargerOptions& options)
    : bay_(world_, options,
           world_.add_bus({.bit_rate = options.bit_rate, .seed = options.faults.seed})),
      bus_watch_(bay_.devices().bus(),
                 [this](Time now, const BusEvent& event) { bay_.heard(now, event); }) {
  observe_bus();
  bay_.start();
}

void ChargerNetwork::observe_bus() {
  world_.bus().observe({.context = this,
                        .on_frame =
                            [](void* self, Time now, ControllerId, const Frame& frame) {
                              static_cast<ChargerNetwork*>(self)->bay_.hear(now, frame);
                            },
                        .on_state = nullptr});
  bus_watch_.name(charger_controller(), options().charger_id);
  bus_watch_.name(battery_controller(), options().battery_id);
  world_.bus().observe(bus_watch_.tap());
}

bool ChargerNetwork::all_hold() const {
  const std::vector<Invariant> all = invariants();
  return std::all_of(all.begin(), all.end(),
                     [](const Invariant& invariant) { return invariant.held; });
}

}  // namespace canvoy::charger
