// Application of the taximeter of a taxi, beside its virtual device: it shows the fare on display 1
// of the terminal while there are passengers, and otherwise gives the display back.
#pragma once

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::taxi {

struct FareDisplaySettings {
  NodeId terminal = 0;
  cia447::Currency currency = {};
};

class FareDisplay {
 public:
  FareDisplay(cia447::CarNetwork& network, const car::NoHardware& hardware,
              const FareDisplaySettings& settings);

  /// Shows what the meter has on its own display.
  void show(const cia447::TaximeterDisplay& display);

 private:
  FareDisplaySettings settings_;
  cia447::TerminalClient terminal_;
};

struct FareDisplayKind : cia447::CarKind<FareDisplay, car::NoHardware, FareDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "fare-display", .title = "display of a fare"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::taxi
