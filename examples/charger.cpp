// A complete CiA 419 charger on a CAN interface. Replace the hardware by your own, and it is yours.
//
//     charger can0 5
#include <cstdio>
#include <cstdlib>

#include "canvoy/can/host/attachment.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"

using namespace canvoy;

/// Your power stage: here one that obeys at once.
struct PowerStage {
  double ampere = 0;

  void deliver(double wanted) { ampere = wanted; }
  double current() { return ampere; }
  bool pilot_signal() { return true; }
};

int main(int count, char** arguments) {
  if (count != 3) return std::puts("usage: charger INTERFACE NODE-ID"), 2;
  auto loop = host::EventLoop::create();
  if (!loop) return std::puts(loop.error().line().c_str()), 1;
  auto bus = host::open_bus(**loop, arguments[1]);
  if (!bus) return std::puts(bus.error().line().c_str()), 1;

  PowerStage stage;
  const cia419::ChargerHardware hardware{
      .deliver = Callback<void(double)>::to<&PowerStage::deliver>(stage),
      .current = Callback<double()>::to<&PowerStage::current>(stage),
      .pilot_signal = Callback<bool()>::to<&PowerStage::pilot_signal>(stage)};
  host::Attachment attachment(**loop, **bus);
  cia419::ChargerDevice<> charger(attachment.port(), static_cast<NodeId>(std::atoi(arguments[2])),
                                  hardware, {.limits = {.current_max_ampere = 40}});
  attachment.serve(charger.node());
  charger.node().start((*loop)->now());
  (*loop)->run();
}
