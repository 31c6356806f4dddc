// A frame that was destroyed on the simulated bus: the kind of error, and the controllers that
// detected it (ISO 11898-1, error detection).
//
//     if (error.kind == BusErrorKind::acknowledgement) ...  // nobody was there
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

/// First visible form of an error.
enum class BusErrorKind : std::uint8_t {
  bit,              ///< a transmitter reads another bit than it sends
  stuff,            ///< a receiver sees six equal bits
  acknowledgement,  ///< no controller has received the frame
};

/// A frame that was destroyed.
struct BusError {
  BusErrorKind kind = BusErrorKind::bit;  ///< form of the error
  ControllerId sender = no_controller;    ///< no_controller: it is gone
  ControllerId detector = no_controller;  ///< first to detect it; no_controller: the sender
  unsigned bit = 0;  ///< last bit sent of the frame, counted from 1 at the start of frame
  Frame frame{};     ///< the frame that was destroyed
};

}  // namespace canvoy
