#include "canvoy/worlds/taxi/route_display.hpp"

#include "canvoy/worlds/taxi/screen_text.hpp"

namespace canvoy::taxi {

RouteDisplay::RouteDisplay(cia447::CarNetwork& network, const car::NoHardware& /*hardware*/,
                           const RouteDisplaySettings& settings)
    : navigation_(network, {.navigation = settings.navigation,
                            .changed = Callback<void()>::to<&RouteDisplay::answered>(*this)}),
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

}  // namespace canvoy::taxi
