// Text about a car and its network: names of states as in the profile.
//
//     taximeter_words(cia447::Taximeter::for_hire);         // "for hire"
//     car_event_words(cia447::CarEvent::Kind::lost, "node 5");  // "node 5 is lost"
#pragma once

#include <string>
#include <string_view>

#include "canvoy/devices/cia447/kit/car_master.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::tools {

std::string taximeter_words(cia447::Taximeter state);
std::string lamp_words(cia447::Lamp lamp);
/// Text of an event of the gateway; `device` is the device that it concerns, if any.
std::string car_event_words(cia447::CarEvent::Kind kind, std::string_view device);

}  // namespace canvoy::tools
