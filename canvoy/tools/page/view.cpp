// canvoy view SOURCE: a bus or a log as a page in the browser.
#include <fmt/format.h>

#include <memory>

#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/page/live_bus.hpp"
#include "canvoy/tools/page/live_log.hpp"
#include "canvoy/tools/page/serve.hpp"
#include "canvoy/tools/session/log_source.hpp"
#include "canvoy/tools/watch/log_writer.hpp"

namespace canvoy::tools {

namespace {

struct ViewOptions {
  std::string source;
  std::string record;
  ServeOptions serve;
  FramePrinterOptions decoding;
};

int view(const ViewOptions& options) {
  const std::unique_ptr<host::EventLoop> loop = value_or_throw(host::EventLoop::create());
  WritePermission permission = parse_write_permission(options.serve.allow_write);
  if (is_log_source(options.source)) {
    if (!options.record.empty()) throw UsageError("--record is of a bus: this is a log already");
    if (!options.serve.allow_record.empty()) {
      throw UsageError("--allow-record is of a bus: this is a log already");
    }
    if (!permission.is_empty()) throw UsageError("--allow-write is of a bus: this is a log");
    LiveLog log(options.source, options.decoding);
    return serve(log, *loop, options.serve);
  }
  LiveBus bus(options.source, options.record, options.decoding, std::move(permission), *loop);
  bus.allow_recording(options.serve.allow_record);
  return serve(bus, *loop, options.serve);
}

}  // namespace

void add_view(Verb& app) {
  const auto options = std::make_shared<ViewOptions>();
  Verb& command = app.add_verb("view", "Show a bus or a log as a page in the browser");
  command.add({
      {"source", options->source,
       "can0, vcan0, udp:239.74.163.2:43113, or a log: night.log, ./night", required},
      {"--web", options->serve.address,
       "where to listen: a port of this machine (default: a free one), or an "
       "address that others reach as well: they need the token that is printed"},
      {"--record", options->record, log_option_text("write all frames of the bus as a log")},
  });
  options->serve.add_to(command);
  options->decoding.add_nodes_to(command);
  command.add_examples(
      "  canvoy view can0\n"
      "  canvoy view can0 --web 8080 --allow-write 10:6010,nmt\n"
      "  canvoy view night.log --node 10=418");
  command.runs([options] { return view(*options); });
}

}  // namespace canvoy::tools
