#include "canvoy/tools/lift_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "canvoy/sim/fault.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/network_text.hpp"

namespace canvoy::tools {

namespace {

using lift::fault_names;
using lift::FaultName;
using lift::ScheduledFault;

[[noreturn]] void refuse(std::string_view text, std::string_view what) {
  throw UsageError(fmt::format("fault '{}': {}", text, what));
}

const FaultName& find(std::string_view text, std::string_view name) {
  std::string known;
  for (const FaultName& each : fault_names()) {
    if (each.name == name) return each;
    known += (known.empty() ? "" : ", ") + std::string(each.name);
  }
  refuse(text, "no such fault; there are " + known);
}

std::uint8_t place_number(std::string_view text, std::string_view digits, unsigned most) {
  unsigned number = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number);
  if (error != std::errc{} || stop != end || number > most) {
    refuse(text, fmt::format("'{}' is no number up to {}", digits, most));
  }
  return static_cast<std::uint8_t>(number);
}

/// `lift=2`
void set_place(ScheduledFault& fault, std::string_view text, std::string_view word) {
  constexpr unsigned node_id_max = 127;
  const std::size_t sign = std::min(word.find('='), word.size());
  const std::string_view key = word.substr(0, sign);
  const std::string_view digits = word.substr(std::min(sign + 1, word.size()));
  if (word == "group") {
    fault.lift = 0;
  } else if (key == "lift") {
    fault.lift = place_number(text, digits, lift::lifts_max);
  } else if (key == "node") {
    fault.node = place_number(text, digits, node_id_max);
  } else if (key == "floor") {
    fault.floor = place_number(text, digits, lift::floors_max);
  } else {
    refuse(text, fmt::format("'{}' is no place; there are lift=, group, node= and floor=", word));
  }
}

}  // namespace

ScheduledFault parse_lift_fault(std::string_view text) {
  const std::size_t at = text.find('@');
  std::string_view places = text.substr(0, at);
  const std::size_t colon = std::min(places.find(':'), places.size());
  const FaultName& known = find(text, places.substr(0, colon));
  if (at == std::string_view::npos) {
    refuse(text, fmt::format("when? write {0}@20min or {0}@20min+30s", known.name));
  }
  ScheduledFault fault{.kind = known.kind};
  places.remove_prefix(colon);
  while (!places.empty()) {
    places.remove_prefix(1);
    const std::size_t end = std::min(places.find(':'), places.size());
    set_place(fault, text, places.substr(0, end));
    places.remove_prefix(end);
  }
  const FaultTimesParse times = parse_fault_times(text.substr(at + 1));
  if (!times.times) refuse(text, times.error);
  fault.start = times.times->start;
  fault.duration = times.times->duration;
  return fault;
}

std::string lift_fault_text(const ScheduledFault& fault) {
  std::string text(lift::fault_name(fault.kind));
  if (fault.lift == 0) text += ":group";
  if (fault.lift > 1) text += fmt::format(":lift={}", fault.lift);
  if (fault.node != 0) text += fmt::format(":node={}", fault.node);
  if (fault.floor != lift::no_floor) text += fmt::format(":floor={}", fault.floor);
  text += "@" + duration_value(fault.start - Time{});
  if (fault.duration != lift::for_the_rest) text += "+" + duration_value(fault.duration);
  return text;
}

std::string lift_fault_help() {
  std::string text =
      "NAME@START or NAME@START+DURATION, with :lift=2 or :group, :node=6, :floor=5 behind the "
      "name "
      "where it matters; any number of:\n";
  for (const FaultName& fault : fault_names()) {
    text += fmt::format("  {}: {}\n", fault.name, fault.description);
  }
  return text;
}

}  // namespace canvoy::tools
