#include "canvoy/gateway/answer.hpp"

#include <cstdio>

#include "canvoy/canopen/protocol/abort_reason.hpp"

namespace canvoy::gateway {

namespace {

constexpr std::string_view end_of_line = "\r\n";

template <class... Arguments>
std::string print(const char* format, Arguments... arguments) {
  char text[96];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

/// Explanation as ` #text` or ` (text)`, or nothing.
std::string explanation(std::string_view text, const Style& style) {
  if (text.empty()) return {};
  if (style.version == Version::v2_1) return " (" + std::string(text) + ")";
  return style.explain ? " #" + std::string(text) : std::string();
}

std::string error_text(const Answer& answer, const Style& style) {
  const bool old = style.version == Version::v2_1;
  if (answer.abort != AbortCode::none) {
    return print(old ? "ERROR: %08X" : "ERROR:0x%08X", static_cast<unsigned>(answer.abort)) +
           explanation(abort_reason(answer.abort), style);
  }
  return print(old ? "ERROR: %u" : "ERROR:%u", static_cast<unsigned>(answer.error)) +
         explanation(text_of(answer.error), style);
}

std::string emergency_text(const Emergency& emergency) {
  const auto& info = emergency.info;
  return print("EMCY %04X %02X %u %u %u %u %u", unsigned{emergency.code},
               unsigned{emergency.register_bits}, unsigned{info[0]}, unsigned{info[1]},
               unsigned{info[2]}, unsigned{info[3]}, unsigned{info[4]});
}

/// Text `USER BOOT D`, or the state in which the slave was left.
std::string booted_text(const Event& event, const Style& style) {
  const std::string begin = "USER BOOT ";
  if (event.boot_error != BootError::none) {
    return begin + letter(event.boot_error) + explanation(text_of(event.boot_error), style);
  }
  switch (event.state) {
    case NmtState::stopped:
      return begin + "STOP";
    case NmtState::operational:
      return begin + "OPER";
    case NmtState::pre_operational:
    case NmtState::initialisation:
      break;
  }
  return begin + "PREOP";
}

std::string event_text(const Event& event, const Style& style) {
  switch (event.kind) {
    case Event::Kind::emergency:
      return emergency_text(event.emergency);
    case Event::Kind::boot_up:
      return "BOOT_UP";
    case Event::Kind::booted:
      return booted_text(event, style);
    case Event::Kind::error:
    case Event::Kind::pdo:
      break;
  }
  return print("ERROR %u", static_cast<unsigned>(event.error)) +
         explanation(text_of(event.error), style);
}

}  // namespace

std::string answer_line(std::uint32_t sequence, const Answer& answer, const Style& style) {
  std::string line = print("[%u] ", static_cast<unsigned>(sequence));
  line += answer.good() ? answer.text : error_text(answer, style);
  return line.append(end_of_line);
}

std::string event_line(const Event& event, const Style& style) {
  std::string line =
      event.kind == Event::Kind::pdo
          ? pdo_text(event.net, event.pdo, event.values)
          : print("%u %u ", unsigned{event.net}, unsigned{event.node}) + event_text(event, style);
  return line.append(end_of_line);
}

std::string pdo_text(std::uint16_t net, std::uint16_t pdo, std::span<const std::uint64_t> values) {
  std::string text =
      print("%u pdo %u %u", unsigned{net}, unsigned{pdo}, static_cast<unsigned>(values.size()));
  for (const std::uint64_t value : values) {
    text += print(" 0x%llx", static_cast<unsigned long long>(value));
  }
  return text;
}

}  // namespace canvoy::gateway
