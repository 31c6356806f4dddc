#include "canvoy/tools/network/boot_text.hpp"

#include <fmt/format.h>

#include <array>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

struct StepWords {
  std::string_view word;
  std::string_view text;
};
/// In order of BootStep.
constexpr std::array<StepWords, 12> steps = {{
    {"waiting", "waits for its turn"},
    {"device-type", "is asked for its device type (1000h)"},
    {"vendor-id", "is asked for its vendor-ID (1018h:01h)"},
    {"product-code", "is asked for its product code (1018h:02h)"},
    {"revision-number", "is asked for its revision number (1018h:03h)"},
    {"serial-number", "is asked for its serial number (1018h:04h)"},
    {"node-state", "is to be kept alive: its NMT state is awaited"},
    {"reset", "is reset, and its boot-up message awaited"},
    {"program", "has its software checked"},
    {"configuration", "has its configuration checked"},
    {"error-control", "is watched from now on"},
    {"done", "is done"},
}};

constexpr std::array<std::string_view, 11> events = {"step",   "no-boot-up", "restarted", "retried",
                                                     "failed", "booted",     "started",   "lost",
                                                     "slowed", "given-up",   "unknown"};

struct ErrorWords {
  BootError error;
  std::string_view text;
  std::string_view advice;
};
constexpr auto errors = std::to_array<ErrorWords>({
    {BootError::not_in_list, "it is not among the slaves", "name it, or give it another node-ID"},
    {BootError::no_answer, "no answer", "check its power, cable, bit rate and node-ID"},
    {BootError::device_type, "another device type (1000h)",
     "another kind of device has this node-ID: exchange it, or correct device="},
    {BootError::vendor_id, "another vendor-ID (1018h:01h)",
     "a device of another maker has this node-ID: exchange it, or correct vendor="},
    {BootError::no_heartbeat, "no heartbeat, by which to see whether it is operational",
     "set its producer heartbeat time (1017h) below heartbeat="},
    {BootError::no_guarding_answer,
     "no answer to node guarding, by which to see whether it is operational",
     "check that it can be guarded (100Ch), or give heartbeat= instead of guard="},
    {BootError::no_program_data, "the data to check its software are missing or contradict",
     "give program-id= or program-date=, which it must have (1F56h, 1F52h), and program="},
    {BootError::program_not_allowed, "it needs other software, and an update is not allowed",
     "update it by hand, or allow it with update (1F81h bit 6)"},
    {BootError::program_download, "the download of its software failed",
     "look at its flash status (1F57h), and try again with canvoy program"},
    {BootError::configuration, "the download of its configuration failed",
     "see which object it refused; the configuration may be of another revision"},
    {BootError::no_error_control, "no heartbeat after error control began",
     "set its producer heartbeat time (1017h) below heartbeat=, or leave that out"},
    {BootError::already_operational, "it was operational, and was left so", "nothing"},
    {BootError::product_code, "another product code (1018h:02h)",
     "another product of the maker has this node-ID: exchange it, or correct product="},
    {BootError::revision_number, "another revision (1018h:03h)",
     "exchange the device, or correct revision="},
    {BootError::serial_number, "another serial number (1018h:04h)",
     "the device was exchanged: correct serial=, or leave it out"},
});

const ErrorWords* find(BootError error) {
  for (const ErrorWords& words : errors) {
    if (words.error == error) return &words;
  }
  return nullptr;
}

bool compares(BootError error) {
  return error == BootError::device_type || error == BootError::vendor_id ||
         error == BootError::product_code || error == BootError::revision_number ||
         error == BootError::serial_number;
}

}  // namespace

std::string_view boot_step_text(BootStep step) {
  return steps[static_cast<std::size_t>(step)].text;
}
std::string_view boot_step_word(BootStep step) {
  return steps[static_cast<std::size_t>(step)].word;
}
std::string_view boot_event_word(BootEvent event) {
  return events[static_cast<std::size_t>(event)];
}

std::string_view boot_error_text(BootError error) {
  const ErrorWords* words = find(error);
  return words == nullptr ? "" : words->text;
}
std::string_view boot_advice(BootError error) {
  const ErrorWords* words = find(error);
  return words == nullptr ? "" : words->advice;
}

std::string boot_reason(const BootReport& report) {
  const BootError error = report.outcome.error;
  std::string text = fmt::format("{}: {}", letter(error), boot_error_text(error));
  // "No answer" appears once.
  if (error == BootError::no_answer && report.outcome.end.is_silence()) return text;
  if (!report.outcome.end) {
    return fmt::format("{} ({})", text, text::end_text(report.outcome.end));
  }
  if (!compares(error)) return text;
  return fmt::format("{}: expected {:08X}h, found {:08X}h", text, report.expected, report.found);
}

std::string configuration_line(const ConfigurationOutcome& outcome) {
  using Kind = ConfigurationOutcome::Kind;
  const auto entries =
      fmt::format("{} {}", outcome.written, outcome.written == 1 ? "entry" : "entries");
  switch (outcome.kind) {
    case Kind::up_to_date:
      return "has the expected configuration: nothing was written";
    case Kind::downloaded:
      return fmt::format("is configured: {} written", entries);
    case Kind::nothing_known:
      return "there is no configuration for it";
    case Kind::failed:
      break;
  }
  if (outcome.index == 0) {
    return outcome.end.abort() == AbortCode::no_data
               ? "has not the expected configuration, and there is none to give it"
               : fmt::format("its concise DCF cannot be used: {}",
                             text::abort_text(outcome.end.abort()));
  }
  return fmt::format("{} was not taken ({}); {} written before",
                     text::object_text(outcome.index, outcome.sub), text::end_text(outcome.end),
                     entries);
}

std::string boot_line(const BootReport& report) {
  switch (report.event) {
    case BootEvent::step:
      return std::string(boot_step_text(report.step));
    case BootEvent::no_boot_up:
      return "was reset and sent no boot-up message within the time: is asked again";
    case BootEvent::restarted:
      return report.step == BootStep::done
                 ? "has restarted: is booted again"
                 : fmt::format(
                       "has restarted in the middle of its boot-up, after \"{}\": begins anew",
                       boot_step_text(report.step));
    case BootEvent::retried:
      return fmt::format("{}; the next attempt follows", boot_reason(report));
    case BootEvent::failed:
      return fmt::format("failed, {}; {}", boot_reason(report), boot_advice(report.outcome.error));
    case BootEvent::booted:
      return report.outcome.error == BootError::none
                 ? "is up"
                 : fmt::format("is up, {}", boot_reason(report));
    case BootEvent::started:
      return "is started";
    case BootEvent::lost:
      return "is lost: nothing was heard of it within its time";
    case BootEvent::slowed:
      return fmt::format("restarts again and again, after \"{}\": the next attempt follows in {} s",
                         boot_step_text(report.step), report.delay / 1s);
    case BootEvent::given_up:
      return fmt::format(
          "is given up, as it restarts each time, after \"{}\"; look what its watchdog or supply "
          "does then, and switch it off and on",
          boot_step_text(report.step));
    case BootEvent::unknown:
      return fmt::format("has booted, {}; {}", boot_reason(report),
                         boot_advice(report.outcome.error));
  }
  return {};
}

}  // namespace canvoy::tools
