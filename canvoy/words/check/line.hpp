// What a conformance test needs of a bus: somewhere to put frames, what comes, and a clock. A real
// bus and a simulated one fit, so that each case also runs at exact virtual times.
//
//     Line line{.send = ..., .next = ..., .now = ...};
#pragma once

#include <functional>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::conformance {

/// A frame, and when it was on the bus.
struct Heard {
  /// Of the clock of the line.
  Time time{};
  /// As it was on the bus.
  Frame frame{};
};

/// All three have to be there.
struct Line {
  /// False where the bus does not take it: bus-off, no interface, a full queue.
  std::function<bool(const Frame&)> send;
  /// The next frame of somebody else, in their order; nothing where `until` comes first. Then it is
  /// `until`.
  std::function<std::optional<Heard>(Time until)> next;
  /// The clock that `until` is of.
  std::function<Time()> now;
  /// Whether the test is to end early, with all put back; may be empty.
  std::function<bool()> is_interrupted = {};
};

}  // namespace canvoy::conformance
