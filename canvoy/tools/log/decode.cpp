// canvoy decode LOG: what the frames of a log mean, printed or as comments in another log.
#include <memory>

#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/log/decode_log.hpp"

namespace canvoy::tools {

void add_decode(Verb& app) {
  const auto options = std::make_shared<LogOptions>();
  Verb& command = app.add_verb(
      "decode", "Show what the frames of a log mean: services, objects, fields, units");
  command.add({
      {"log", options->log, log_argument_text, required},
      {"--count", options->count, "end after as many frames", above_zero},
      {"--out", options->out,
       "write a log in place of lines: .pcapng, with the meaning as comments of the "
       "packets, or .asc, .log"},
  });
  options->printer.add_to(command);
  command.add_examples(
      "  canvoy decode bus.log\n"
      "  canvoy decode bus.log --filter 'node=10 and temperature>40degC'\n"
      "  canvoy decode bus.log --filter 'time=1s..1min and not (heartbeat or SYNC)'\n"
      "  canvoy decode bus.log --transfers --json\n"
      "  canvoy decode bus.log --out words.pcapng");
  command.runs([options] { return decode_log(*options); });
}

}  // namespace canvoy::tools
