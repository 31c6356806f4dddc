#include "canvoy/tools/network/program_text.hpp"

#include <fmt/format.h>

#include <string_view>

#include "canvoy/profiles/cia302/program.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

std::string_view step_text(ProgramStep step) {
  switch (step) {
    case ProgramStep::stop:
      return "the program could not be stopped";
    case ProgramStep::clear:
    case ProgramStep::wait_cleared:
      return "its place could not be cleared";
    case ProgramStep::date:
      return "date and time could not be written";
    case ProgramStep::download:
      return "the download failed";
    case ProgramStep::wait_programmed:
      return "the node has not taken the program";
    case ProgramStep::identify:
      return "the node has another program than the file";
    case ProgramStep::start:
      return "the program could not be started";
    case ProgramStep::done:
      break;
  }
  return "done";
}

std::string reason_text(const ProgramOutcome& outcome) {
  if (outcome.end.is_silence() && outcome.step == ProgramStep::clear) {
    return "no answer; is the node on the bus, with power and this node-ID?";
  }
  if (!outcome.end) return text::end_text(outcome.end);
  const auto error = static_cast<std::int64_t>(outcome.status.error());
  for (const NamedValue& named : cia302::flash_errors) {
    if (named.first == error) return std::string(named.name);
  }
  return fmt::format("flash error {}", error);
}

}  // namespace

std::string program_failure_text(const ProgramOutcome& outcome) {
  return fmt::format("{}: {}", step_text(outcome.step), reason_text(outcome));
}

}  // namespace canvoy::tools
