// canvoy convert-log IN OUT: converts the log of one CAN tool to that of another.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/json_event.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/watch/decode_log.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/log_writer.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"

namespace canvoy::tools {

namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
  bool json = false;
};

void refuse_same_file(const ConvertOptions& options) {
  if (is_log_itself(options.in, options.out))
    throw UsageError(options.out + ": it is the log that is read; name another");
}

/// The earliest frame may not be the first one, which is only known after all were read. If input
/// and output can be read and written twice, the conversion is repeated with that start time.
class Conversion {
 public:
  explicit Conversion(const ConvertOptions& options)
      : options_(options), format_(format_to_write(options.out)) {
    refuse_same_file(options);
  }

  void run() {
    convert(std::nullopt);
    if (out_->early() != 0 && is_repeatable()) convert(earliest_);
    refuse_log_without_frames(options_.in, *trace_);
    ok_or_throw(draft_->finish());
    show_shifted(options_.out, *out_);
  }

  void tell() const {
    if (options_.json) return tell_json();
    const std::string lost = out_->lost();
    fmt::print(
        "{} frames of {}; {} lines or blocks could not be read, {} CAN FD frames left out{}{}\n",
        trace_->frames(), format_in_words(*trace_), trace_->bad(), trace_->fd_frames(),
        lost.empty() ? "" : "; not kept: ", lost);
  }

 private:
  void convert(std::optional<Time> begin) {
    out_.reset();
    draft_.reset();
    trace_.emplace(value_or_throw(formats::TraceReader::open(options_.in)));
    draft_.emplace(value_or_throw(host::AtomicFile::begin(options_.out)));
    out_.emplace(value_or_throw(
        formats::TraceWriter::onto(draft_->descriptor(), options_.out, format_, begin)));
    TraceProgress progress(*trace_);
    formats::TraceFrame frame;
    for (formats::TraceRead read; (read = trace_->next(frame)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::frame) {
        ok_or_throw(out_->write(frame));
        earliest_ = std::min(earliest_, frame.time);
      }
      if (read == formats::TraceRead::bad && !begin) show_bad(options_.in, *trace_);
      progress.show(*trace_);
    }
    ok_or_throw(out_->finish());
  }

  bool is_repeatable() const {
    namespace fs = std::filesystem;
    std::error_code none;
    return options_.in != "-" && fs::is_regular_file(options_.in, none) &&
           (fs::is_regular_file(options_.out, none) || !fs::exists(options_.out, none));
  }

  void tell_json() const {
    JsonEvent event("converted");
    event->key("file").text(options_.out);
    event->key("format").text(trace_->format().name);
    event->key("frames").number(trace_->frames());
    event->key("bad").number(trace_->bad());
    event->key("fd_skipped").number(trace_->fd_frames());
    if (!out_->lost().empty()) event->key("not_kept").text(out_->lost());
    if (out_->early() != 0) event->key("early").number(out_->early());
    if (out_->late() != 0) event->key("late").number(out_->late());
    event.print();
  }

  const ConvertOptions& options_;
  formats::TraceFormat format_;
  std::optional<LogReader> trace_;
  std::optional<host::AtomicFile> draft_;
  std::optional<formats::TraceWriter> out_;
  Time earliest_ = Time::max();
};

int convert_log(const ConvertOptions& options) {
  Conversion conversion(options);
  conversion.run();
  conversion.tell();
  return exit_done;
}

}  // namespace

void add_convert_log(Verb& app) {
  const auto options = std::make_shared<ConvertOptions>();
  Verb& command = app.add_verb("convert-log", "Write the log of one CAN tool as that of another");
  command.add({
      {"in", options->in, log_argument_text(), required},
      {"out", options->out,
       "a file whose end says the format: " + formats::trace_format_list(true) +
           "; with .gz behind it, it is compressed",
       required},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy convert-log bus.log bus.asc\n"
      "  canvoy convert-log bus.log bus.blf\n"
      "  canvoy convert-log bus.log bus.asc.gz\n"
      "  canvoy convert-log bus.log bus.pcapng --json");
  command.runs([options] { return convert_log(*options); });
}

}  // namespace canvoy::tools
