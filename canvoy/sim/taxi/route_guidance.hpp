// Where the passengers of a taxi want to go, and how the driver has the navigation system lead
// there: he types it into his unit, and types it anew where that has forgotten it.
//
//     RouteGuidance guidance(bus, places);
//     guidance.offer_display(site_of_the_drivers_unit);
//     guidance.offer_navigation(site_of_the_navigation);
//     guidance.choose(destination);
//     guidance.arrive();
#pragma once

#include <optional>
#include <span>

#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/sim/car/car_bus.hpp"
#include "canvoy/sim/taxi/route_display.hpp"

namespace canvoy::taxi {

class RouteGuidance {
 public:
  /// Both must outlive this.
  RouteGuidance(car::CarBus& bus, std::span<const cia447::NamedPlace> places)
      : bus_(bus), places_(places) {}
  RouteGuidance(const RouteGuidance&) = delete;
  RouteGuidance& operator=(const RouteGuidance&) = delete;

  /// What the driver's unit and the navigation system find.
  void offer_display(Site& site);
  void offer_navigation(Site& site);
  /// The driver's unit is about to lose or get its power.
  void lose_display() { display_ = nullptr; }
  /// It has it again.
  void type_again();

  void choose(const cia447::GeoPosition& destination);
  /// No object ends a guidance: the driver does so at the navigation system.
  void arrive();
  /// Nothing: nobody wants to go anywhere, or nobody knows where.
  const std::optional<cia447::GeoPosition>& destination() const { return destination_; }
  cia447::NavigationUnit& navigation() { return *navigation_; }

 private:
  RouteDisplaySettings display_settings();
  void is_display(RouteDisplay& display, Node& /*node*/) { display_ = &display; }
  cia447::NavigationHardware navigation_hardware();
  void is_navigation(cia447::NavigationUnit& unit, Node& /*node*/) { navigation_ = &unit; }

  car::CarBus& bus_;
  std::span<const cia447::NamedPlace> places_;
  cia447::NavigationUnit* navigation_ = nullptr;
  RouteDisplay* display_ = nullptr;  ///< of the driver's unit; null while that has no power
  std::optional<cia447::GeoPosition> destination_;
};

}  // namespace canvoy::taxi
