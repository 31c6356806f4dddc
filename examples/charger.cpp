// A complete charger on a CAN interface. Replace the power stage to adapt it (CiA 419).
//
//     charger can0 5
#include <cstdio>

#include "canvoy/canopen/host/program.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"

using namespace canvoy;

/// The power stage: here one that follows its setpoints at once.
struct PowerStage {
  double ampere = 0;

  void deliver(double wanted) { ampere = wanted; }
  double current() const { return ampere; }
  bool pilot_signal() const { return true; }
};

int main(int count, char** arguments) {
  if (count != 3) return std::puts("usage: charger INTERFACE NODE-ID"), 2;
  auto bus = canvoy::open(arguments[1]);
  if (!bus) return canvoy::fail(bus.error());
  const auto node_id = canvoy::read_node_id(arguments[2]);
  if (!node_id) return canvoy::fail(node_id.error());

  PowerStage stage;
  cia419::ChargerDevice<> charger(bus->port(), *node_id, stage,
                                  {.limits = {.current_max_ampere = 40}});
  const auto watch = charger.on(cia419::battery_temperature, [](auto value) {
    if (const auto celsius = value.value()) std::printf("battery: %.1f °C\n", *celsius);
  });
  return bus->run(charger);
}
