#include "canvoy/worlds/car/sleep_plan.hpp"

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::car {

namespace {

constexpr Duration look_period = 1s;

/// A gateway without power learns of the opened door when power returns.
void wake(CarBus& bus, Time now) {
  cia447::CarMaster* master = bus.master();
  if (master == nullptr) return;
  if (!bus.has_power(cia447::gateway_node_id)) {
    return bus.world().at(now + look_period, [&bus](Time then) { wake(bus, then); });
  }
  master->wake_up();
  bus.touched(cia447::gateway_node_id);
}

}  // namespace

void plan_sleep(CarBus& bus, const SleepPlan& plan) {
  World& world = bus.world();
  world.at(plan.sleep, [&bus](Time) {
    cia447::CarMaster* master = bus.master();
    if (master == nullptr || !bus.has_power(cia447::gateway_node_id)) return;
    master->send_to_sleep();
    bus.touched(cia447::gateway_node_id);
  });
  if (plan.stranger_speaks) {
    const ControllerId stranger = bus.bus().attach({});
    world.at(*plan.stranger_speaks,
             [&bus, stranger](Time) { bus.bus().send(stranger, {.id = 0x7DF, .length = 8}); });
  }
  world.at(plan.wake, [&bus](Time now) { wake(bus, now); });
}

}  // namespace canvoy::car
