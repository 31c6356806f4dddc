// The bus of a conformance test: sends frames, receives frames, and has a clock. It may be real or
// simulated, so that each case also runs at exact virtual times.
//
//     Line line{.send = ..., .next = ..., .now = ...};
#pragma once

#include <functional>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::conformance {

/// A frame and its time on the bus.
struct Heard {
  /// Time by the clock of the line.
  Time time{};
  /// Frame as on the bus.
  Frame frame{};
};

/// `send`, `next` and `now` are required.
struct Line {
  /// Sends a frame. False if the bus does not accept it: bus-off, no interface, a full queue.
  std::function<bool(const Frame&)> send;
  /// Returns the next frame of another node, in order. Nothing if `until` comes first; the time is
  /// then `until`.
  std::function<std::optional<Heard>(Time until)> next;
  /// The clock of `until`.
  std::function<Time()> now;
  /// True if the test is to end early, after restoring; may be empty.
  std::function<bool()> is_interrupted = {};
};

}  // namespace canvoy::conformance
