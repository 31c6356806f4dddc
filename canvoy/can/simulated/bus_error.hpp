// A frame that was destroyed on the simulated bus: how, and who saw it (ISO 11898-1, error
// detection).
//
//     if (error.kind == BusErrorKind::acknowledgement) ...  // nobody was there
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

/// How an error shows first.
enum class BusErrorKind : std::uint8_t {
  bit,              ///< a transmitter reads another bit than it sends
  stuff,            ///< a receiver sees six equal bits
  acknowledgement,  ///< nobody has received the frame
};

/// A frame that was destroyed.
struct BusError {
  BusErrorKind kind = BusErrorKind::bit;
  ControllerId sender = no_controller;    ///< no_controller: it has gone
  ControllerId detector = no_controller;  ///< the first to see it; no_controller: the sender
  unsigned bit = 0;  ///< up to which the frame was sent, counted from 1 at the start of frame
  Frame frame{};
};

}  // namespace canvoy
