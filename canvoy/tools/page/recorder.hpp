// Logs that viewers of the page begin and end, in the format of candump -l. Available only with a
// folder given at the start (`--allow-record`): viewers do not name files.
//
//     Recorder recorder;
//     recorder.allow("logs");
//     recorder.begin({});              // into logs/canvoy-1.log, or the next that is not there
//     recorder.hear(at, "can0", frame);
//     recorder.end();
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/host/candump_log.hpp"

namespace canvoy::tools {

class Recorder {
 public:
  /// Limits against filling the disk from the page: for one start of the command, and for one log.
  static constexpr unsigned logs_max = 100;
  static constexpr std::uint64_t frames_max = 20'000'000;

  /// Sets the folder; an empty name allows nothing. Throws UsageError if it is no folder.
  void allow(const std::string& folder);
  bool is_allowed() const { return !folder_.empty(); }
  /// `epoch`: added to all times. Throws Failure if it is not possible, or not allowed.
  void begin(Duration epoch);
  /// No effect without a log. Throws Failure if the log is not complete.
  void end();
  /// Records a frame. A log that cannot be written ends, and the error is reported.
  void hear(Time at, std::string_view bus, const Frame& frame);
  /// Like CandumpWriter; errors as for hear().
  void flush_each_second(Time clock);
  /// `on`, `file`, `frames`, `trouble`.
  nlohmann::ordered_json json() const;

 private:
  std::string folder_;
  std::string file_;  ///< of the last log
  std::string trouble_;
  std::optional<host::CandumpWriter> log_;
  std::uint64_t frames_ = 0;
  unsigned logs_ = 0;
};

}  // namespace canvoy::tools
