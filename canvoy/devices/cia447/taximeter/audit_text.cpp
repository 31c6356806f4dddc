#include "canvoy/devices/cia447/taximeter/audit_text.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::string_view words[] = {"nothing",
                                      "write refused",
                                      "parameter refused",
                                      "error",
                                      "pulses while the engine stands",
                                      "clock set",
                                      "clock refused in a trip",
                                      "seal opened",
                                      "seal closed",
                                      "service mode entered",
                                      "sealed",
                                      "k set",
                                      "k calibrated",
                                      "tariff changed",
                                      "trip ended by loss of power",
                                      "mode set"};
static_assert(std::size(words) == static_cast<std::size_t>(AuditEvent::mode_set) + 1);

void add_time(AuditText& text, std::uint32_t at) {
  if (at == AuditEntry::no_time) {
    text.add("no time");
  } else {
    text.add_second(at).add(" UTC");
  }
}

void add_who(AuditText& text, std::uint8_t who) {
  if (who == by_meter) return;
  if (who == by_default_channel) {
    text.add(", default channel");
  } else {
    text.add(", node ").add(who);
  }
}

void add_seconds(AuditText& text, std::uint32_t value) {
  const auto seconds = std::int64_t{static_cast<std::int32_t>(value)};
  text.add(seconds < 0 ? ", -" : ", +");
  text.add(static_cast<std::uint64_t>(seconds < 0 ? -seconds : seconds)).add(" s");
}

void add_change(AuditText& text, std::uint32_t from, std::uint32_t to) {
  text.add(", ").add(from).add(" to ").add(to);
}

void add_details(AuditText& text, const AuditEntry& entry) {
  constexpr unsigned sub_bits = 8;
  switch (entry.what) {
    case AuditEvent::write_refused:
    case AuditEvent::settings_refused:
      text.add(", ").add_hexadecimal(entry.detail >> sub_bits, 4).add(":");
      text.add_hexadecimal(entry.detail & 0xFF, 2).add(" = ").add_hexadecimal(entry.value, 1);
      return;
    case AuditEvent::error:
      text.add(" ").add(entry.detail);
      return;
    case AuditEvent::clock_step:
    case AuditEvent::clock_refused:
      return add_seconds(text, entry.value);
    case AuditEvent::sealed:
      text.add(", k ").add(entry.value);
      return;
    case AuditEvent::calibrated:
      text.add(", ").add(entry.detail).add(" pulses: k ").add(entry.value);
      return;
    case AuditEvent::k_set:
    case AuditEvent::mode_set:
    case AuditEvent::tariff_changed:
      return add_change(text, entry.detail, entry.value);
    case AuditEvent::trip_cut:
      text.add(", ").add(entry.value);
      return;
    default:
      return;
  }
}

}  // namespace

AuditText audit_text(const AuditEntry& entry) {
  AuditText text;
  const auto number = static_cast<std::size_t>(entry.what);
  add_time(text, entry.at);
  text.add(": ").add(number < std::size(words) ? words[number] : "unknown");
  add_who(text, entry.who);
  add_details(text, entry);
  if (entry.times == 1) return text;
  text.add("; ").add(entry.times).add(" times until ");
  add_time(text, entry.until);
  return text;
}

}  // namespace canvoy::cia447
