// The bus as a node sees it: somewhere to put frames, and the state of its CAN controller.
#pragma once

#include <cstdint>

#include "canvoy/can/frame.hpp"

namespace canvoy {

/// Fault confinement state of a CAN controller (ISO 11898-1), from the best to the worst.
enum class BusState : std::uint8_t {
  error_active,
  error_warning,  ///< error-active, but an error counter has reached 96
  error_passive,
  bus_off
};

constexpr bool is_error_active(BusState state) {
  return state <= BusState::error_warning;
}

/// What a node needs of a CAN controller: a table of functions, so that a driver, a socket and a
/// simulated bus all fit. What comes from the controller (frames, bus states) is handed to the node
/// by whoever owns both.
struct Port {
  void* context = nullptr;
  /// Queues a frame for transmission; false where the queue is full (the node keeps the frame and
  /// tries again).
  bool (*send)(void* context, const Frame& frame) = nullptr;
  /// Tells the acceptance filter whether frames with this 11-bit identifier are wanted. Optional:
  /// without it the node is handed all frames and drops what it does not want.
  void (*accept)(void* context, std::uint16_t id, bool wanted) = nullptr;
};

}  // namespace canvoy
