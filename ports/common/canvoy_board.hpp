// A node on a board. Three functions are the whole port:
//
//     struct Board {
//       bool send(const canvoy::Frame& frame);  // into the controller; false where it has no room
//       bool receive(canvoy::Frame& frame);     // the next that has come; false where none has
//       canvoy::Time now();                     // microseconds since start; never goes back
//     };
//
//     Board board;
//     canvoy::board::BoardPort port(board);
//     canvoy::DeviceNode<layout> device(port.port(), 9);
//     device.node().start(board.now());
//     for (;;) wait_for_frame(port.turn(device.node()));
//
// A fourth one, `canvoy::BusState bus_state()`, reports when the controller is bus-off.
#pragma once

#include <algorithm>
#include <concepts>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::board {

/// Requirements on a board. All functions are called in one thread, that of turn().
template <class T>
concept Board = requires(T& board, const Frame& sent, Frame& received) {
  { board.send(sent) } -> std::same_as<bool>;
  { board.receive(received) } -> std::same_as<bool>;
  { board.now() } -> std::same_as<Time>;
};

/// Connects a node and its board, both of which must outlive it.
template <Board B>
class BoardPort {
 public:
  explicit BoardPort(B& board) : board_(&board) {}
  BoardPort(const BoardPort&) = delete;
  BoardPort& operator=(const BoardPort&) = delete;

  Port port() { return {this, send, nullptr}; }

  /// Hands received frames to the node, and does what is due. Returns how long the board may wait
  /// for a frame, `wait_max` at most; zero if there is more to do at once.
  template <class Node>
  Duration turn(Node& node, Duration wait_max = std::chrono::seconds(1)) {
    tell_bus_state(node);
    for (Frame frame; board_->receive(frame);) node.receive(frame, board_->now());
    const Time now = board_->now();
    if (is_full_) {
      is_full_ = false;
      node.tx_ready(now);
    }
    node.advance(now);
    // The controller does not report when it has room again.
    const Duration longest = is_full_ ? std::min(wait_max, Duration(1000)) : wait_max;
    const Time deadline = node.deadline();
    if (deadline <= now) return Duration(0);
    return deadline - now < longest ? deadline - now : longest;
  }

 private:
  static bool send(void* context, const Frame& frame) {
    auto& self = *static_cast<BoardPort*>(context);
    const bool is_sent = self.board_->send(frame);
    if (!is_sent) self.is_full_ = true;
    return is_sent;
  }

  template <class Node>
  void tell_bus_state(Node& node) {
    if constexpr (requires { BusState(board_->bus_state()); }) {
      const BusState state = board_->bus_state();
      if (state != state_) node.bus_state(state_ = state, board_->now());
    }
  }

  B* board_;
  bool is_full_ = false;
  BusState state_ = BusState::error_active;
};

}  // namespace canvoy::board
