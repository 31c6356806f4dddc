#include "canvoy/tools/log/decode_log.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/log/line_output.hpp"
#include "canvoy/tools/log/trace_complaints.hpp"
#include "canvoy/tools/log/trace_progress.hpp"

namespace canvoy::tools {

namespace {

void show_left_out(const LogOptions& options, const formats::TraceReader& trace) {
  if (trace.bad() > 0) {
    fmt::print(stderr, "{}: {} lines or blocks could not be read\n", options.log, trace.bad());
  }
  if (trace.fd_skipped() > 0) {
    fmt::print(stderr, "{}: {} CAN FD frames are left out\n", options.log, trace.fd_skipped());
  }
}

void show_buses(const LogOptions& options, const FramePrinter& printer) {
  for (const std::string_view bus : printer.silent_buses()) {
    fmt::print(stderr, "{}: no frame in it is of a bus '{}'\n", options.log, bus);
  }
  if (printer.forgotten_buses() > 0) {
    fmt::print(stderr,
               "{}: it has more than {} buses: of those that were silent for longest, what "
               "was heard is forgotten\n",
               options.log, printer.buses_max());
  }
}

void show_without_match(const LogOptions& options, const FramePrinter& printer) {
  const std::string without_match = printer.without_match();
  if (!without_match.empty()) fmt::print(stderr, "{}: {}\n", options.log, without_match);
}

formats::TraceWriter create_log(const LogOptions& options) {
  if (options.printer.json) throw UsageError("--json prints lines, and --out writes a log");
  const std::optional<formats::TraceFormat> format = formats::trace_format_of(options.out);
  if (!format) {
    throw UsageError(fmt::format("'{}' ends like no log: .pcapng, .asc or .log", options.out));
  }
  std::error_code none;
  if (std::filesystem::equivalent(options.log, options.out, none)) {
    throw UsageError(fmt::format("'{}' is the log itself", options.out));
  }
  return value_or_throw(formats::TraceWriter::create(options.out, *format));
}

/// Where the meaning goes: to the standard output, or into another log.
class Output {
 public:
  explicit Output(const LogOptions& options)
      : printer_(options.printer), lines_(options.printer.json), out_(options.out) {
    if (!options.out.empty()) writer_.emplace(create_log(options));
  }

  /// Whether a filter wanted the frame.
  bool show(const formats::TraceFrame& heard) {
    if (!writer_) {
      const bool is_wanted = printer_.append(lines_.lines(), heard.time.time_since_epoch(),
                                             heard.channel, heard.frame);
      lines_.pass_on();
      return is_wanted;
    }
    const std::optional<std::string> meaning =
        printer_.describe(heard.time.time_since_epoch(), heard.channel, heard.frame);
    if (meaning) ok_or_throw(writer_->write(heard, *meaning));
    return meaning.has_value();
  }
  void finish() {
    if (writer_) {
      ok_or_throw(writer_->flush());
      show_early(out_, *writer_);
    }
    lines_.flush();
  }
  const FramePrinter& printer() const { return printer_; }

 private:
  FramePrinter printer_;
  LineOutput lines_;
  std::string out_;
  std::optional<formats::TraceWriter> writer_;
};

}  // namespace

int decode_log(const LogOptions& options) {
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(options.log));
  Output output(options);
  {
    TraceProgress progress(trace, options.out.empty());
    formats::TraceFrame heard;
    std::optional<Time> first;
    for (std::uint64_t shown = 0; options.count == 0 || shown < options.count;) {
      const formats::TraceRead read = trace.next(heard);
      if (read == formats::TraceRead::end) break;
      progress.show(trace);
      if (read == formats::TraceRead::bad) {
        progress.clear();
        show_bad(options.log, trace);
        continue;
      }
      if (!first) first = heard.time;
      if (options.limit && heard.time - *first > *options.limit) break;
      if (output.show(heard)) ++shown;
    }
  }
  output.finish();
  show_left_out(options, trace);
  show_buses(options, output.printer());
  show_without_match(options, output.printer());
  refuse_log_without_frames(options.log, trace);
  return exit_done;
}

}  // namespace canvoy::tools
