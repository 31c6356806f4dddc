// A charger, as its maker would put it on a board: no operating system, no exceptions, no RTTI.
#pragma once

#include "canvoy/can/frame.hpp"

namespace board {

/// The frame that a charger with node-ID 5 sends at power-on.
canvoy::Frame boot_up();

}  // namespace board
