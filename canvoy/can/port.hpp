// The bus for a node: a function to send frames, and the state of its CAN controller.
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

/// True for the two states in which the controller sends active error flags.
constexpr bool is_error_active(BusState state) {
  return state <= BusState::error_warning;
}

/// A node's requirements on a CAN controller: a table of functions, which a driver, a socket and a
/// simulated bus can all supply. Frames and bus states of the controller are passed to the node by
/// the owner of both.
struct Port {
  void* context = nullptr;  ///< first argument of each call
  /// Queues a frame for transmission; false if the queue is full (the node keeps the frame and
  /// tries again).
  bool (*send)(void* context, const Frame& frame) = nullptr;
  /// Sets the acceptance filter for frames with this 11-bit identifier. Optional: without it the
  /// node receives all frames and drops those it does not need.
  void (*accept)(void* context, std::uint16_t id, bool wanted) = nullptr;
};

}  // namespace canvoy
