// canvoy decode LOG: what the frames of a log mean.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "canvoy/formats/trace.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/frame_printer.hpp"

namespace canvoy::tools {

namespace {

/// More of them say no more of a log.
constexpr std::uint64_t bad_shown_max = 20;

struct DecodeOptions {
  std::string log;
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

int decode(const DecodeOptions& options) {
  FramePrinter printer(options.printer);
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(options.log));
  formats::TraceFrame heard;
  std::uint64_t shown = 0;
  while (options.count == 0 || shown < options.count) {
    const formats::TraceRead read = trace.next(heard);
    if (read == formats::TraceRead::end) break;
    if (read == formats::TraceRead::bad) {
      show_bad(options, trace);
      continue;
    }
    const bool printed = printer.print(heard.time.time_since_epoch(), heard.channel, heard.frame);
    if (printed) ++shown;
  }
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
  options->printer.add_to(*command);
  command->callback([options, &action] { action = [options] { return decode(*options); }; });
}

}  // namespace canvoy::tools
