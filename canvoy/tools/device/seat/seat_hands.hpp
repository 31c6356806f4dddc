// The hands of an operator environment: each axis, button, pedal, encoder and wheel that it has.
//
//     for (const DeviceHand& hand : seat_hands(elements)) ...   // joystick1.x, push-button-...
#pragma once

#include <vector>

#include "canvoy/profiles/cia852/operator_environment.hpp"
#include "canvoy/tools/device/hand/device_hand.hpp"

namespace canvoy::tools {

/// The hands act on a SeatState.
std::vector<DeviceHand> seat_hands(const cia852::OperatorEnvironment& elements);

}  // namespace canvoy::tools
