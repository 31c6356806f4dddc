// Application of the driver's unit of a taxi, beside its virtual devices: it shows on display 2 of
// the terminal where the car is, where it goes, and the distance to there. The navigation system,
// which it has lead there, sends all of it over the bus.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/navigation/navigation_client.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::taxi {

/// Devices that it uses.
struct RouteDisplaySettings {
  NodeId terminal = 0;    ///< node-ID of the terminal
  NodeId navigation = 0;  ///< node-ID of the navigation system
};

class RouteDisplay {
 public:
  /// `network` must outlive this object; it acts once the node runs.
  RouteDisplay(cia447::CarNetwork& network, const car::NoHardware& hardware,
               const RouteDisplaySettings& settings);
  RouteDisplay(const RouteDisplay&) = delete;
  RouteDisplay& operator=(const RouteDisplay&) = delete;

  /// Sets the destination of the passengers.
  void guide(const cia447::GeoPosition& destination) { navigation_.guide(destination); }
  /// Ends the guidance here; the navigation system goes on until a hand ends it there.
  void arrive() { navigation_.forget_destination(); }

 private:
  void answered();

  cia447::NavigationClient navigation_;
  cia447::TerminalClient terminal_;
};

/// A CarUnit beside the virtual devices of the driver's unit; it is not in the catalogue.
struct RouteDisplayKind : cia447::CarKind<RouteDisplay, car::NoHardware, RouteDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "route-display", .title = "display of a route"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  /// The keys of the terminal.
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::taxi
