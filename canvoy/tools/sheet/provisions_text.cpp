#include "canvoy/tools/sheet/provisions_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/provisions.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

std::string configured_text(const Profile& profile, const ConfiguredDevice& device) {
  const auto* found =
      std::ranges::find_if(profile.virtual_devices, [&device](const VirtualDeviceInfo& info) {
        return info.code == device.code && info.device_class == device.device_class &&
               info.subclass == device.subclass;
      });
  if (found != profile.virtual_devices.end()) return device_text(*found);
  return device_text(
      {.code = device.code, .device_class = device.device_class, .subclass = device.subclass});
}

/// Condition of a coding or a command: ` where 60EAh is 01h to 04h`.
std::string selected_text(std::uint16_t selector, std::int64_t first, std::int64_t last) {
  if (selector == 0) return "";
  std::string text = fmt::format(" where {:04X}h is {:02X}h", selector, first);
  if (last != first) text += fmt::format(" to {:02X}h", last);
  return text;
}

std::string words(const Profile& /*profile*/, const BitRateProvision& rate) {
  return fmt::format("{:>4} kbit/s, {}", rate.kilobits_per_second,
                     formats::category_name(rate.category));
}
std::string words(const Profile& /*profile*/, const IndexRangeProvision& range) {
  if (range.first == range.last)
    return fmt::format("{:04X}h          {}", range.first, range.owner);
  return fmt::format("{:04X}h to {:04X}h {}", range.first, range.last, range.owner);
}
std::string words(const Profile& profile, const ConfigurationProvision& configuration) {
  std::string text(configuration.name);
  for (const ConfiguredDevice& device : configuration.devices) {
    text += "\n    " + configured_text(profile, device);
  }
  return text;
}
std::string words(const Profile& /*profile*/, const AbortProvision& abort) {
  return fmt::format("{}: {}, where {}", text::object_text(abort.index, abort.sub),
                     text::abort_text(abort.code), abort.when);
}
std::string words(const Profile& /*profile*/, const FailureProvision& failure) {
  return std::string(failure.failure);
}
std::string words(const Profile& /*profile*/, const RuleProvision& rule) {
  return fmt::format("{}: {}", rule.subject, rule.rule);
}
std::string words(const Profile& /*profile*/, const CodingProvision& coding) {
  return fmt::format("{}{}: {}, {}", text::object_text(coding.index, coding.sub),
                     selected_text(coding.selector, coding.selected, coding.selected),
                     coding.content, coding.coding);
}
std::string words(const Profile& /*profile*/, const CommandProvision& command) {
  constexpr std::uint16_t one_byte_max = 0xFF;
  return fmt::format("{}{}: {:0{}X}h {}", text::object_text(command.index, command.sub),
                     selected_text(command.selector, command.first, command.last), command.bytes,
                     command.bytes > one_byte_max ? 4 : 2, command.command);
}

/// The clause is in the heading if all have the same one.
template <class Provision>
void append_kind(std::string& text, std::string_view heading, const Profile& profile,
                 const Items<Provision>& provisions) {
  if (provisions.empty()) return;
  const std::string_view clause = provisions[0].clause;
  const bool is_one_clause = std::ranges::all_of(
      provisions, [clause](const Provision& each) { return each.clause == clause; });
  const std::string behind = is_one_clause ? fmt::format(" ({})", clause) : std::string();
  fmt::format_to(std::back_inserter(text), "\n{}{}\n", heading, behind);
  for (const Provision& each : provisions) {
    std::string line = words(profile, each);
    if (!is_one_clause) {
      line.insert(std::min(line.find('\n'), line.size()), fmt::format(" ({})", each.clause));
    }
    fmt::format_to(std::back_inserter(text), "  {}\n", line);
  }
}

/// The provisions about one object.
template <class Provision>
void append_of(std::string& text, const Profile& profile, const ObjectInfo& object,
               std::string_view about, const Items<Provision>& provisions) {
  for (const Provision& each : provisions) {
    if (each.index < object.index || each.index >= object.index + object.count) continue;
    fmt::format_to(std::back_inserter(text), "  {}{} ({})\n", about, words(profile, each),
                   each.clause);
  }
}

}  // namespace

std::string device_text(const VirtualDeviceInfo& device) {
  std::string text = fmt::format("{:02X}h {}", device.code, device.name);
  if (device.device_class != 0) text += fmt::format(", class {}", device.device_class);
  if (!device.class_name.empty()) text += fmt::format(" {}", device.class_name);
  if (device.subclass != 0) text += fmt::format(", subclass {}", device.subclass);
  if (!device.subclass_name.empty()) text += fmt::format(" {}", device.subclass_name);
  return text;
}

std::string provisions_text(const Profile& profile) {
  std::string text;
  if (profile.provisions == nullptr) return text;
  const Provisions& all = *profile.provisions;
  append_kind(text, "bit rates", profile, all.bit_rates);
  append_kind(text, "index ranges", profile, all.index_ranges);
  append_kind(text, "devices that make up a network", profile, all.configurations);
  append_kind(text, "what is refused, and how", profile, all.aborts);
  append_kind(text, "serious failures: 1029h says what they bring about", profile, all.failures);
  append_kind(text, "rules", profile, all.rules);
  append_kind(text, "how bytes are coded", profile, all.codings);
  append_kind(text, "commands among these bytes", profile, all.commands);
  return text;
}

std::string provisions_text(const Profile& profile, const ObjectInfo& object) {
  std::string text;
  if (profile.provisions == nullptr) return text;
  const Provisions& all = *profile.provisions;
  append_of(text, profile, object, "refuses ", all.aborts);
  append_of(text, profile, object, "", all.codings);
  append_of(text, profile, object, "", all.commands);
  return text;
}

}  // namespace canvoy::tools
