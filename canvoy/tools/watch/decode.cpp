// canvoy decode LOG: meaning of the frames of a log, printed or as comments in another log.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/watch/decode_log.hpp"

namespace canvoy::tools {

namespace {

/// A log, frames, or the input of a pipe.
void take_words(const std::vector<std::string>& words, LogOptions& options) {
  if (words.empty()) {
    if (::isatty(STDIN_FILENO) == 1) {
      throw UsageError(
          "decode what? a log: canvoy decode bus.log; a frame: canvoy decode 18A#AC0001; or a "
          "pipe: "
          "candump -L can0 | canvoy decode");
    }
    options.log = "-";
    return;
  }
  std::error_code none;
  const bool are_frames =
      words.front().find('#') != std::string::npos && !std::filesystem::exists(words.front(), none);
  if (!are_frames) {
    if (words.size() > 1) {
      throw UsageError(fmt::format("one log at a time: canvoy decode {}", words.front()));
    }
    options.log = words.front();
    return;
  }
  for (const std::string& word : words) {
    const ParsedFrame frame = parse_frame(word);
    if (frame || frame.error == FrameTextError::fd) continue;
    throw UsageError(
        fmt::format("'{}' is no frame: {}; as 18A#AC0001", word, describe(frame.error)));
  }
  options.log = "the command line";
  options.frames = words;
}

}  // namespace

void add_decode(Verb& app) {
  const auto options = std::make_shared<LogOptions>();
  Verb& command = app.add_verb(
      "decode", "Show what the frames of a log mean: services, objects, fields, units");
  const auto words = std::make_shared<std::vector<std::string>>();
  const std::string about =
      log_argument_text() +
      "; none: standard input, where it is no terminal; or frames: 18A#AC0001";
  command.add({
      {"log", *words, about},
      {"--count", options->count, "end after as many frames", above_zero},
      {"--out", options->out,
       "write a log in place of lines: .pcapng, with the meaning as comments of the packets, or "
       "another that convert-log writes: " +
           formats::trace_ending_list(true) +
           "; with --json or --csv, their lines; a .csv is the table of --csv"},
  });
  options->printer.add_to(command);
  command.add({
      {"--csv", options->printer.csv, csv_text, excludes("--json")},
      {"--parquet", options->parquet,
       "write the same table as Apache Parquet, for pandas and others: FILE.parquet",
       excludes("--csv", "--json", "--out")},
  });
  command.add_examples(
      "  canvoy decode bus.log\n"
      "  canvoy decode 18A#AC0001 701#05 --node 10=418\n"
      "  canvoy decode bus.log --csv\n"
      "  canvoy decode bus.log --parquet values.parquet\n"
      "  canvoy decode bus.log --filter 'node=10 and temperature>40degC'\n"
      "  canvoy decode bus.log --filter 'time=1s..1min and not (heartbeat or SYNC)'\n"
      "  canvoy decode bus.log --transfers --json\n"
      "  canvoy decode bus.log --out words.pcapng");
  command.runs([options, words] {
    take_words(*words, *options);
    // The same frames as CSV are for convert-log.
    const bool is_table = options->out.ends_with(".csv") && !options->printer.json;
    options->printer.csv = options->printer.csv || is_table;
    return decode_log(*options);
  });
}

}  // namespace canvoy::tools
