#include "canvoy/devices/cia447/kit/car_device.hpp"

#include <algorithm>

namespace canvoy::cia447 {

namespace {

DictionaryTables with_codes(DictionaryTables tables) {
  tables.check_number = &check_car_number;
  return tables;
}

}  // namespace

std::vector<Part> car_parts(std::span<const CarUnit* const> units, Duration heartbeat) {
  return CarParts<std::vector<Part>>(units, heartbeat).make();
}

CarDevice::CarDevice(std::span<const CarUnit* const> units, const Port& port, NodeId node_id,
                     const Environment& environment)
    : port_(port),
      tables_(car_parts(units, environment.get<CarNetworkSettings>().heartbeat)),
      device_(with_codes(tables_.tables()), port_.port(), node_id,
              CarNetwork::routes + CarSleep::routes + CarMaster::routes + catalogue_routes),
      network_(device_.node(), environment.get<CarNetworkSettings>()),
      sleep_(network_, port_, environment.get<CarSleepSettings>()) {
  const bool is_gateway = std::ranges::any_of(
      units, [](const CarUnit* unit) { return unit->provides == &ivn_gateway_device; });
  if (is_gateway && environment.manages_network) {
    master_.emplace(network_, sleep_, environment.get<CarMemory>(),
                    environment.get<CarMasterSettings>());
    environment.made<CarMaster>(*master_, device_.node());
  }
  environment.made<CarNetwork>(network_, device_.node());
  for (const CarUnit* kind : units) units_.make(*kind, network_, environment);
}

}  // namespace canvoy::cia447
