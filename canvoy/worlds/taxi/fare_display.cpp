#include "canvoy/worlds/taxi/fare_display.hpp"

#include "canvoy/worlds/taxi/screen_text.hpp"

namespace canvoy::taxi {

FareDisplay::FareDisplay(cia447::CarNetwork& network, const car::NoHardware& /*hardware*/,
                         const FareDisplaySettings& settings)
    : settings_(settings), terminal_(network, {.terminal = settings.terminal}) {}

void FareDisplay::show(const cia447::TaximeterDisplay& display) {
  const std::string text = trip_text(display, settings_.currency);
  terminal_.want(cia447::TerminalPart::display_1, !text.empty());
  terminal_.show(cia447::TerminalText::text_1, text);
}

}  // namespace canvoy::taxi
