#include "canvoy/worlds/taxi/route_guidance.hpp"

#include "canvoy/worlds/taxi/screen_text.hpp"
#include "canvoy/worlds/taxi/taxi_options.hpp"

namespace canvoy::taxi {

RouteDisplay::RouteDisplay(cia447::CarNetwork& network, const car::NoHardware& /*hardware*/,
                           const RouteDisplaySettings& settings)
    : navigation_(network, {.navigation = settings.navigation,
                            .changed = callback<&RouteDisplay::answered>(*this)}),
      terminal_(network, {.terminal = settings.terminal}) {}

/// Where nothing is known, the car may have its display back.
void RouteDisplay::answered() {
  const std::string text = place_text({.street = navigation_.street(),
                                       .city = navigation_.city(),
                                       .destination = navigation_.destination_street(),
                                       .metres_to_go = navigation_.metres()});
  terminal_.want(cia447::TerminalPart::display_2, !text.empty());
  terminal_.show(cia447::TerminalText::text_2, text);
}

void RouteGuidance::provide_display(Environment& environment) {
  environment.provide(callback<&RouteGuidance::display_settings>(*this));
  environment.watch(display_);
}

void RouteGuidance::provide_navigation(Environment& environment) {
  environment.provide(callback<&RouteGuidance::navigation_hardware>(*this));
  environment.watch(navigation_);
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
