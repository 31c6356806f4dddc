#include "canvoy/worlds/taxi/route_guidance.hpp"

#include "canvoy/worlds/taxi/taxi_options.hpp"

namespace canvoy::taxi {

void RouteGuidance::provide_display(Environment& environment) {
  environment.provide(
      Callback<RouteDisplaySettings()>::to<&RouteGuidance::display_settings>(*this));
  environment.watch(Callback<void(RouteDisplay&, Node&)>::to<&RouteGuidance::is_display>(*this));
}

void RouteGuidance::provide_navigation(Environment& environment) {
  environment.provide(
      Callback<cia447::NavigationHardware()>::to<&RouteGuidance::navigation_hardware>(*this));
  environment.watch(
      Callback<void(cia447::NavigationUnit&, Node&)>::to<&RouteGuidance::is_navigation>(*this));
}

RouteDisplaySettings RouteGuidance::display_settings() {
  return {.terminal = terminal_id, .navigation = navigation_id};
}

cia447::NavigationHardware RouteGuidance::navigation_hardware() {
  return {.gazetteer = cia447::Gazetteer(places_)};
}

void RouteGuidance::type_again() {
  if (display_ != nullptr && destination_) display_->guide(*destination_);
}

void RouteGuidance::choose(const cia447::GeoPosition& destination) {
  destination_ = destination;
  if (display_ != nullptr) display_->guide(*destination_);
  bus_.touched(driver_id);
}

void RouteGuidance::arrive() {
  destination_.reset();
  if (display_ != nullptr) display_->arrive();
  bus_.touched(driver_id);
  if (bus_.has_power(navigation_id)) navigation_->cancel();
  bus_.touched(navigation_id);
}

}  // namespace canvoy::taxi
