// Application of the driver's unit of a taxi, beside its virtual devices: it shows on display 2 of
// the terminal where the car is, where it goes, and the distance to there. The navigation system,
// which it has lead there, sends all of it over the bus.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/navigation/navigation_client.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/worlds/car/application.hpp"

namespace canvoy::taxi {

struct RouteDisplaySettings {
  NodeId terminal = 0;
  NodeId navigation = 0;
};

class RouteDisplay {
 public:
  RouteDisplay(cia447::CarNetwork& network, const car::NoHardware& hardware,
               const RouteDisplaySettings& settings);
  RouteDisplay(const RouteDisplay&) = delete;
  RouteDisplay& operator=(const RouteDisplay&) = delete;

  /// Sets the destination of the passengers.
  void guide(const cia447::GeoPosition& destination) { navigation_.guide(destination); }
  void arrive() { navigation_.forget_destination(); }

 private:
  void answered();

  cia447::NavigationClient navigation_;
  cia447::TerminalClient terminal_;
};

struct RouteDisplayKind : cia447::CarKind<RouteDisplay, car::NoHardware, RouteDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "route-display", .title = "display of a route"};
  static constexpr const VirtualDeviceInfo& provides = car::no_virtual_device;
  static constexpr auto consumes = cia447::terminal_keys_objects;
};

}  // namespace canvoy::taxi
