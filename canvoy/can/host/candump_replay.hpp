// Plays a log: hands out its frames at their times, on a loop or in a simulated world.
//
//     CandumpReplay replay(std::move(*reader), {.start = loop.now(), .speed = 1.0}, play);
//     loop.add(replay.task());
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/can/time.hpp"

namespace canvoy::host {

struct ReplayOptions {
  Time start{};        ///< when the first frame is due; the others keep their distance from it
  double speed = 1.0;  ///< above 0; 2 is twice as fast
};

/// Not movable: its task points to it. A time that goes back in the log is due at once. A malformed
/// line ends it.
class CandumpReplay {
 public:
  /// `play` gets each entry with the time at which it was due (its `time` stays that of the log).
  using Play = Callback<void(const LogEntry& entry, Time due)>;

  CandumpReplay(CandumpReader reader, const ReplayOptions& options, Play play);
  CandumpReplay(const CandumpReplay&) = delete;
  CandumpReplay& operator=(const CandumpReplay&) = delete;

  /// `never` when the log is at its end.
  Time deadline() const { return due_; }
  void advance(Time now);
  Task task();

  bool finished() const { return due_ == never; }
  const std::optional<Error>& error() const { return error_; }
  std::uint64_t played() const { return played_; }

 private:
  void fetch();

  CandumpReader reader_;
  ReplayOptions options_;
  Play play_;
  std::optional<LogEntry> entry_;
  std::optional<Error> error_;
  std::optional<Time> first_;
  Time due_{};
  std::uint64_t played_ = 0;
};

}  // namespace canvoy::host
