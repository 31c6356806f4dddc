// Logs that verbs write while they do something else, in the format that the end of the name says;
// any other name is a candump log.
//
//     LogWriter log = value_or_throw(LogWriter::create("night.mf4", loop.epoch()));
//     ok_or_throw(log.write(now, "can0", frame));
//     ok_or_throw(log.finish());
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::tools {

/// By the end of the name; throws UsageError where it says none that is written.
formats::TraceFormat format_to_write(const std::string& path);

/// What an option for a log says of its argument.
std::string log_option_text(std::string_view what);

/// The first failure is returned once; after it everything is ignored.
class LogWriter {
 public:
  /// Replaces the file. `epoch` is added to all times: the wall clock at Time{}, since 1970.
  static host::Result<LogWriter> create(const std::string& path, Duration epoch = {});

  host::Result<void> write(Time time, std::string_view bus, const Frame& frame);
  /// As CandumpWriter has it, by any steady clock.
  host::Result<void> flush_each_second(Time clock);
  /// The end of the log.
  host::Result<void> finish();

 private:
  struct Other {
    formats::TraceWriter writer;
    Duration epoch;
    Time next_flush{};
  };
  template <class Writer>
  explicit LogWriter(Writer writer) : writer_(std::move(writer)) {}

  std::variant<host::CandumpWriter, Other> writer_;
};

}  // namespace canvoy::tools
