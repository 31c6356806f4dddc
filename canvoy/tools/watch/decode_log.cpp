#include "canvoy/tools/watch/decode_log.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/can/host/atomic_file.hpp"
#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/interruption.hpp"
#include "canvoy/tools/terminal/message.hpp"
#include "canvoy/tools/watch/line_output.hpp"
#include "canvoy/tools/watch/log_reader.hpp"
#include "canvoy/tools/watch/log_writer.hpp"
#include "canvoy/tools/watch/trace_complaints.hpp"
#include "canvoy/tools/watch/trace_progress.hpp"
#include "canvoy/tools/watch/value_table.hpp"

namespace canvoy::tools {

namespace {

void show_left_out(const LogOptions& options, const LogReader& trace) {
  if (trace.bad() > 0) {
    print_message(
        fmt::format("{}: {} lines or blocks could not be read", options.log, trace.bad()));
  }
  if (trace.fd_frames() > 0 && !options.out.empty()) {
    print_message(fmt::format("{}: {} CAN FD frames are left out", options.log, trace.fd_frames()));
  }
}

void show_buses(const LogOptions& options, const FramePrinter& printer) {
  for (const std::string_view bus : printer.silent_buses()) {
    print_message(fmt::format("{}: no frame in it is of a bus '{}'", options.log, bus));
  }
  if (printer.forgotten_buses() > 0) {
    print_message(
        fmt::format("{}: it has more than {} buses: of those that were silent for longest, what "
                    "was heard is forgotten",
                    options.log, printer.buses_max()));
  }
}

void show_without_match(const LogOptions& options, const FramePrinter& printer) {
  const std::string without_match = printer.without_match();
  if (!without_match.empty()) print_message(fmt::format("{}: {}", options.log, without_match));
}

void show_unknown_pdos(const LogOptions& options, FramePrinter& printer) {
  const bool has_values_only = options.printer.csv || !options.parquet.empty();
  const char* const fate = has_values_only ? "left out" : "shown as bytes";
  print_unknown_pdos(options.log, printer, {.fate = fate});
}

void refuse_log_itself(const LogOptions& options) {
  if (!is_log_itself(options.log, options.out)) return;
  throw UsageError(fmt::format("'{}' is the log itself", options.out));
}

/// `--csv --out a.csv` is a table, and `--json --out a.pcapng` is neither.
void refuse_log_of_lines(const LogOptions& options) {
  const auto format = formats::trace_format_of(options.out);
  const bool is_table = options.printer.csv && format == formats::TraceFormat::python_can_csv;
  if (!format || is_table) return;
  throw UsageError(fmt::format("--{} prints lines, and --out {} is a log: leave one of them out",
                               options.printer.json ? "json" : "csv", options.out));
}

formats::TraceFormat format_of_other_log(const LogOptions& options) {
  const formats::TraceFormat format = format_to_write(options.out);
  refuse_log_itself(options);
  return format;
}

/// A log that replaces the existing one when it is complete.
class OtherLog {
 public:
  explicit OtherLog(const LogOptions& options)
      : OtherLog(options.out, format_of_other_log(options)) {}

  void write(const formats::TraceFrame& frame, std::string_view meaning) {
    ok_or_throw(writer_.write(frame, meaning));
  }
  void finish() {
    ok_or_throw(writer_.finish());
    ok_or_throw(draft_.finish());
    show_shifted(path_, writer_);
  }

 private:
  OtherLog(const std::string& path, const formats::TraceFormat& format)
      : path_(path),
        draft_(value_or_throw(host::AtomicFile::begin(path))),
        writer_(value_or_throw(formats::TraceWriter::onto(draft_.descriptor(), path, format))) {}

  std::string path_;
  host::AtomicFile draft_;
  formats::TraceWriter writer_;
};

/// Output of the meaning: the standard output, or another log.
class Output {
 public:
  explicit Output(const LogOptions& options)
      : printer_(options.printer), lines_(options.printer.json) {
    if (!options.out.empty()) log_.emplace(options);
    if (options.parquet.empty()) return;
    if (is_log_itself(options.log, options.parquet)) {
      throw UsageError(fmt::format("'{}' is the log itself", options.parquet));
    }
    table_.emplace(options.parquet);
  }

  /// True if the filters pass the frame.
  bool show(const formats::TraceFrame& heard) {
    if (table_) return add_values(heard);
    if (!log_) {
      const bool is_wanted = printer_.append(lines_.lines(), heard.time.time_since_epoch(),
                                             heard.channel, heard.frame);
      lines_.pass_on();
      return is_wanted;
    }
    const std::optional<std::string> meaning =
        printer_.describe(heard.time.time_since_epoch(), heard.channel, heard.frame);
    if (meaning) log_->write(heard, *meaning);
    return meaning.has_value();
  }
  bool show_fd(const formats::TraceFrame& heard) {
    if (log_ || table_) return false;
    const bool is_wanted = printer_.append_fd(lines_.lines(), heard);
    lines_.pass_on();
    return is_wanted;
  }
  void flush() { lines_.flush(); }
  /// Called if the input was usable.
  void finish() {
    if (log_) log_->finish();
    if (table_) table_->finish();
  }
  FramePrinter& printer() { return printer_; }

 private:
  bool add_values(const formats::TraceFrame& heard) {
    const Duration time = heard.time.time_since_epoch();
    const text::FrameWords* const words = printer_.look(time, heard.channel, heard.frame);
    if (words == nullptr) return false;
    const std::string_view bus = printer_.bus_name(heard.channel);
    for (const decoder::DecodedValue& value : words->values) {
      table_->add({time, bus, words->node, value});
    }
    return true;
  }

  FramePrinter printer_;
  LineOutput lines_;
  std::optional<ParquetTable> table_;
  std::optional<OtherLog> log_;
};

/// Frames of a command line as a log.
std::string log_of(const std::vector<std::string>& frames) {
  std::string log;
  for (const std::string& frame : frames) log += fmt::format("(0.000000) can0 {}\n", frame);
  return log;
}

int decode_into(const LogOptions& options) {
  // Of a pipe that is what ends it, and what has come is to be kept.
  const bool writes_file = !options.out.empty() || !options.parquet.empty();
  if (writes_file) heed_interruption();
  const std::string typed = log_of(options.frames);
  LogReader trace(value_or_throw(options.frames.empty() ? formats::TraceReader::open(options.log)
                                                        : formats::TraceReader::of(typed)));
  Output output(options);
  {
    TraceProgress progress(trace, !writes_file);
    formats::TraceFrame heard;
    std::optional<Time> first;
    for (std::uint64_t shown = 0; options.count == 0 || shown < options.count;) {
      if (is_interrupted()) break;
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
      const bool is_shown =
          read == formats::TraceRead::fd ? output.show_fd(heard) : output.show(heard);
      if (is_shown) ++shown;
    }
  }
  if (is_interrupted() && options.log != "-") throw Failure("interrupted");
  output.flush();
  show_left_out(options, trace);
  show_buses(options, output.printer());
  show_without_match(options, output.printer());
  show_unknown_pdos(options, output.printer());
  refuse_log_without_frames(options.log, trace);
  output.finish();
  return exit_done;
}

}  // namespace

std::string log_argument_text() {
  return "a log: " + formats::trace_format_list() + ", each also as .gz; - for standard input";
}

int decode_log(const LogOptions& options) {
  const bool is_text = !options.out.empty() && (options.printer.json || options.printer.csv);
  if (!is_text) return decode_into(options);
  // What would be printed is written into the file in place of the standard output.
  refuse_log_of_lines(options);
  refuse_log_itself(options);
  heed_interruption();
  host::AtomicFile draft = value_or_throw(host::AtomicFile::begin(options.out));
  std::fflush(stdout);
  ::dup2(draft.descriptor(), STDOUT_FILENO);
  LogOptions printed = options;
  printed.out.clear();
  const int status = decode_into(printed);
  ok_or_throw(draft.finish());
  return status;
}

}  // namespace canvoy::tools
