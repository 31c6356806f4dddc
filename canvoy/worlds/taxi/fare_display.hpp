// Application of the taximeter of a taxi, beside its virtual device: it shows the fare on display 1
// of the terminal while there are passengers, and otherwise gives the display back.
#pragma once

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::taxi {

/// Where the fare is shown, and how.
struct FareDisplaySettings {
  NodeId terminal = 0;             ///< node-ID of the terminal
  cia447::Currency currency = {};  ///< of the fare
};

class FareDisplay {
 public:
  /// `network` must outlive this object; it acts once the node runs.
  FareDisplay(cia447::CarNetwork& network, const car::NoHardware& hardware,
              const FareDisplaySettings& settings);

  /// Shows what the meter has on its own display.
  void show(const cia447::TaximeterDisplay& display);

 private:
  FareDisplaySettings settings_;
  cia447::TerminalClient terminal_;
};

/// A CarUnit beside the virtual device of the taximeter; it is not in the catalogue.
struct FareDisplayKind : cia447::CarKind<FareDisplay, car::NoHardware, FareDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "fare-display", .title = "display of a fare"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// The keys of the terminal.
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::taxi
