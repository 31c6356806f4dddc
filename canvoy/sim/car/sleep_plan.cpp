#include "canvoy/sim/car/sleep_plan.hpp"

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::car {

void plan_sleep(CarBus& bus, const SleepPlan& plan) {
  World& world = bus.world();
  world.at(plan.sleep, [&bus](Time) {
    if (cia447::CarMaster* master = bus.master()) master->send_to_sleep();
    bus.touched(cia447::gateway_node_id);
  });
  if (plan.stranger_speaks) {
    const ControllerId stranger = bus.bus().attach({});
    world.at(*plan.stranger_speaks,
             [&bus, stranger](Time) { bus.bus().send(stranger, {.id = 0x7DF, .length = 8}); });
  }
  world.at(plan.wake, [&bus](Time) {
    if (cia447::CarMaster* master = bus.master()) master->wake_up();
    bus.touched(cia447::gateway_node_id);
  });
}

}  // namespace canvoy::car
