// canvoy convert-log IN OUT: the log of one CAN tool as that of another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "canvoy/can/host/file_draft.hpp"
#include "canvoy/formats/trace/trace_writer.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/help/verb_help.hpp"
#include "canvoy/tools/json_event.hpp"
#include "canvoy/tools/log/decode_log.hpp"
#include "canvoy/tools/log/trace_complaints.hpp"
#include "canvoy/tools/log/trace_progress.hpp"

namespace canvoy::tools {

namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
  bool json = false;
};

formats::TraceFormat format_to_write(const std::string& out) {
  const std::optional<formats::TraceFormat> format = formats::trace_format_of(out);
  if (!format || *format == formats::TraceFormat::trc || *format == formats::TraceFormat::pcap)
    throw UsageError(out + ": name it .log (as of candump), .asc or .pcapng");
  return *format;
}

void refuse_same_file(const ConvertOptions& options) {
  if (is_log_itself(options.in, options.out))
    throw UsageError(options.out + ": it is the log that is read; name another");
}

void tell(const ConvertOptions& options, const formats::TraceReader& trace) {
  JsonEvent event("converted");
  event->key("file").text(options.out);
  event->key("format").text(formats::name_of(trace.format()));
  event->key("frames").number(trace.frames());
  event->key("bad").number(trace.bad());
  event->key("fd_skipped").number(trace.fd_skipped());
  event.print();
}

int convert_log(const ConvertOptions& options) {
  const formats::TraceFormat format = format_to_write(options.out);
  refuse_same_file(options);
  formats::TraceReader trace = value_or_throw(formats::TraceReader::open(options.in));
  host::FileDraft draft = value_or_throw(host::FileDraft::begin(options.out));
  formats::TraceWriter out =
      value_or_throw(formats::TraceWriter::onto(draft.descriptor(), options.out, format));
  {
    TraceProgress progress(trace);
    formats::TraceFrame frame;
    for (formats::TraceRead read; (read = trace.next(frame)) != formats::TraceRead::end;) {
      if (read == formats::TraceRead::frame) ok_or_throw(out.write(frame));
      if (read == formats::TraceRead::bad) show_bad(options.in, trace);
      progress.show(trace);
    }
  }
  refuse_log_without_frames(options.in, trace);
  ok_or_throw(out.flush());
  ok_or_throw(draft.finish());
  if (options.json) {
    tell(options, trace);
    return exit_done;
  }
  fmt::print("{} frames of a {}; {} lines or blocks could not be read, {} CAN FD frames left out\n",
             trace.frames(), formats::name_of(trace.format()), trace.bad(), trace.fd_skipped());
  return exit_done;
}

}  // namespace

void add_convert_log(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert-log", "Write the log of one CAN tool as that of another");
  command->add_option("in", options->in, log_argument_text)->required();
  command->add_option("out", options->out, "a file that ends in .log (candump), .asc or .pcapng")
      ->required();
  command->add_flag("--json", options->json, "one JSON object a line");
  add_examples(*command,
               "  canvoy convert-log bus.log bus.asc\n"
               "  canvoy convert-log bus.log bus.pcapng --json");
  command->callback([options, &action] { action = [options] { return convert_log(*options); }; });
}

}  // namespace canvoy::tools
