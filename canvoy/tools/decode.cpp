// canvoy decode LOG: what the frames of a log mean, printed or as comments in another log.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "canvoy/formats/trace.hpp"
#include "canvoy/formats/trace_writer.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/frame_printer.hpp"

namespace canvoy::tools {

namespace {

/// More of them say no more of a log.
constexpr std::uint64_t bad_shown_max = 20;

struct DecodeOptions {
  std::string log;
  std::string out;
  std::uint64_t count = 0;
  FramePrinterOptions printer;
};

void show_bad(const DecodeOptions& options, const formats::TraceReader& trace) {
  if (trace.bad() > bad_shown_max) return;
  fmt::print(stderr, "{}, {}: {}\n", options.log, trace.where(), trace.problem());
}

void show_left_out(const DecodeOptions& options, const formats::TraceReader& trace) {
  if (trace.bad() > 0) {
    fmt::print(stderr, "{}: {} lines or blocks could not be read\n", options.log, trace.bad());
  }
  if (trace.fd_skipped() > 0) {
    fmt::print(stderr, "{}: {} CAN FD frames are left out\n", options.log, trace.fd_skipped());
  }
}

/// Where the meaning goes: to the terminal, or into another log.
class Output {
 public:
  explicit Output(const DecodeOptions& options) : printer_(options.printer) {
    if (options.out.empty()) return;
    if (options.printer.json) throw UsageError("--json prints lines, and --out writes a log");
    const std::optional<formats::TraceFormat> format = formats::trace_format_of(options.out);
    if (!format) {
      throw UsageError(fmt::format("'{}' ends like no log: .pcapng, .asc or .log", options.out));
    }
    std::error_code none;
    if (std::filesystem::equivalent(options.log, options.out, none)) {
      throw UsageError(fmt::format("'{}' is the log itself", options.out));
    }
    writer_.emplace(value_or_throw(formats::TraceWriter::create(options.out, *format)));
  }

  /// Whether a filter wanted the frame.
  bool show(const formats::TraceFrame& heard) {
    if (!writer_) {
      return printer_.print(heard.time.time_since_epoch(), heard.channel, heard.frame);
    }
    const std::optional<std::string> meaning = printer_.describe(heard.frame);
    if (meaning) ok_or_throw(writer_->write(heard, *meaning));
    return meaning.has_value();
  }
  void finish() {
    if (writer_) ok_or_throw(writer_->flush());
  }

 private:
  FramePrinter printer_;
  std::optional<formats::TraceWriter> writer_;
};

int decode(const DecodeOptions& options) {
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(options.log));
  Output output(options);
  formats::TraceFrame heard;
  for (std::uint64_t shown = 0; options.count == 0 || shown < options.count;) {
    const formats::TraceRead read = trace.next(heard);
    if (read == formats::TraceRead::end) break;
    if (read == formats::TraceRead::bad) {
      show_bad(options, trace);
    } else if (output.show(heard)) {
      ++shown;
    }
  }
  output.finish();
  show_left_out(options, trace);
  return exit_done;
}

}  // namespace

void add_decode(CLI::App& app, Action& action) {
  const auto options = std::make_shared<DecodeOptions>();
  CLI::App* command = app.add_subcommand(
      "decode", "Show what the frames of a log mean: services, objects, fields, units");
  command
      ->add_option("log", options->log,
                   "a log of candump, Vector (ASC), PEAK (TRC), or pcapng; - for standard input")
      ->required();
  command->add_option("--count", options->count, "end after as many frames")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", options->out,
                      "write a log in place of lines: .pcapng, with the meaning as comments of the "
                      "packets, or .asc, .log");
  options->printer.add_to(*command);
  command->callback([options, &action] { action = [options] { return decode(*options); }; });
}

}  // namespace canvoy::tools
