// Logs that people at the page begin and end, as candump -l writes them. Only where a folder was
// given for them at the start (`--allow-record`): who looks on names no file.
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
  /// So that nobody fills a disk by a button: of one start of the command, and of one log.
  static constexpr unsigned logs_max = 100;
  static constexpr std::uint64_t frames_max = 20'000'000;

  /// An empty name allows nothing. Throws UsageError where it is no folder.
  void allow(const std::string& folder);
  bool is_allowed() const { return !folder_.empty(); }
  /// `epoch`: what is added to all times. Throws Failure where it cannot be, or is not allowed.
  void begin(Duration epoch);
  /// Nothing where there is none. Throws Failure where the log is not whole.
  void end();
  /// A log that cannot be written any more ends, and its trouble is told.
  void hear(Time at, std::string_view bus, const Frame& frame);
  /// As CandumpWriter has it; trouble as of hear().
  void flush_each_second(Time clock);
  /// `on`, `file`, `frames`, `trouble`.
  nlohmann::ordered_json json() const;

 private:
  std::string folder_;
  std::string file_;  ///< the latest
  std::string trouble_;
  std::optional<host::CandumpWriter> log_;
  std::uint64_t frames_ = 0;
  unsigned logs_ = 0;
};

}  // namespace canvoy::tools
