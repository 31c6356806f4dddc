// The destination of the passengers of a taxi, and the guidance to it by the navigation system: the
// driver enters it at the driver's unit, and enters it again where that has lost it.
//
//     RouteGuidance guidance(bus, places);
//     guidance.offer_display(site_of_the_drivers_unit);
//     guidance.offer_navigation(site_of_the_navigation);
//     guidance.choose(destination);
//     guidance.arrive();
#pragma once

#include <optional>
#include <span>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/navigation/navigation_client.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_client.hpp"
#include "canvoy/worlds/car/application.hpp"
#include "canvoy/worlds/car/car_bus.hpp"

namespace canvoy::taxi {

// Application of the driver's unit of a taxi, beside its virtual devices: it shows on display 2 of
// the terminal where the car is, where it goes, and the distance to there. The navigation system,
// which it has lead there, sends all of it over the bus.

/// Devices that it uses.
struct RouteDisplaySettings {
  NodeId terminal = 0;    ///< node-ID of the terminal
  NodeId navigation = 0;  ///< node-ID of the navigation system
};

/// The application of the driver's unit of a taxi, beside its virtual device.
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

class RouteGuidance {
 public:
  /// Both must outlive this object.
  RouteGuidance(car::CarBus& bus, std::span<const cia447::NamedPlace> places)
      : bus_(bus), places_(places) {}
  RouteGuidance(const RouteGuidance&) = delete;
  RouteGuidance& operator=(const RouteGuidance&) = delete;

  /// Adds the hardware of the driver's unit and of the navigation system.
  void provide_display(Environment& environment);
  /// Adds the hardware of the navigation system alone.
  void provide_navigation(Environment& environment);
  /// Call it before the driver's unit loses or gets its power.
  void lose_display() { display_ = nullptr; }
  /// Enters the destination again.
  void type_again();

  /// The driver enters where the passengers want to go.
  void choose(const cia447::GeoPosition& destination);
  /// Ends the guidance, by hand at the navigation system: there is no object for it.
  void arrive();
  /// Empty: there is no destination, or it is unknown.
  const std::optional<cia447::GeoPosition>& destination() const { return destination_; }
  /// The navigation system; made again when it gets power, so keep no reference.
  cia447::NavigationUnit& navigation() { return *navigation_; }

 private:
  RouteDisplaySettings display_settings();
  cia447::NavigationHardware navigation_hardware();

  car::CarBus& bus_;
  std::span<const cia447::NamedPlace> places_;
  cia447::NavigationUnit* navigation_ = nullptr;
  RouteDisplay* display_ = nullptr;  ///< of the driver's unit; null while that has no power
  std::optional<cia447::GeoPosition> destination_;
};

}  // namespace canvoy::taxi
