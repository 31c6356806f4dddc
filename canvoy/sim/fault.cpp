#include "canvoy/sim/fault.hpp"

#include <algorithm>
#include <charconv>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy {

namespace {

/// `a, b, c`
template <class Names>
std::string list_of(const Names& names) {
  std::string list;
  for (const auto& each : names) list += (list.empty() ? "" : ", ") + std::string(each.name);
  return list;
}

std::string sign_of(const FaultPlaceName& place) {
  return std::string(place.name) + (place.most == 0 ? "" : "=");
}

/// Returns what is wrong; empty: nothing.
std::string take_place(const FaultGrammar& grammar, std::string_view word, AnyFault& fault,
                       std::vector<std::uint8_t AnyFault::*>& taken) {
  const std::size_t sign = std::min(word.find('='), word.size());
  const std::string_view digits = word.substr(std::min(sign + 1, word.size()));
  const auto found = std::ranges::find(grammar.places, word.substr(0, sign), &FaultPlaceName::name);
  if (found == grammar.places.end() || (found->most == 0 && sign != word.size())) {
    std::string known;
    for (const FaultPlaceName& place : grammar.places) {
      known += (known.empty() ? "" : ", ") + sign_of(place);
    }
    return "'" + std::string(word) + "' is no place; there " +
           (known.empty() ? "are none here" : "are " + known);
  }
  if (std::ranges::find(taken, found->member) != taken.end()) {
    return "'" + std::string(word) + "': another place of the kind is named before";
  }
  taken.push_back(found->member);
  unsigned number = 0;
  if (found->most != 0) {
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc{} || stop != end || number == 0 || number > found->most) {
      return "'" + std::string(digits) + "' is no number from 1 to " + std::to_string(found->most);
    }
  }
  fault.*(found->member) = static_cast<std::uint8_t>(number);
  return {};
}

/// Takes `20min` or `20min+30s`. Returns what is wrong; empty: nothing.
std::string take_times(std::string_view text, AnyFault& fault) {
  const std::size_t plus = text.find('+');
  const std::string units(duration_units);
  const auto start = parse_duration(text.substr(0, plus));
  if (!start) return "the start is a number and " + units + ", as in @20min";
  fault.start = Time(*start);
  if (plus == std::string_view::npos) return {};
  const auto duration = parse_duration(text.substr(plus + 1));
  if (!duration || *duration == Duration(0)) {
    return "the duration is a number above 0 and " + units + ", as in +30s";
  }
  fault.duration = *duration;
  return {};
}

/// Returns what is wrong; empty: nothing.
std::string take(const FaultGrammar& grammar, std::string_view text, AnyFault& fault) {
  const std::size_t at = text.find('@');
  std::string_view places = text.substr(0, at);
  const std::size_t colon = std::min(places.find(':'), places.size());
  const std::string name(places.substr(0, colon));
  const auto known = std::ranges::find(grammar.kinds, name, &FaultRow::name);
  if (known == grammar.kinds.end()) return "no such fault; there are " + list_of(grammar.kinds);
  fault.kind = static_cast<std::size_t>(known - grammar.kinds.begin());
  if (at == std::string_view::npos) {
    return "when? write " + name + "@20min or " + name + "@20min+30s";
  }
  std::vector<std::uint8_t AnyFault::*> taken;
  for (places.remove_prefix(colon); !places.empty();) {
    places.remove_prefix(1);
    const std::string_view word = places.substr(0, std::min(places.find(':'), places.size()));
    std::string wrong = take_place(grammar, word, fault, taken);
    if (!wrong.empty()) return wrong;
    places.remove_prefix(word.size());
  }
  return take_times(text.substr(at + 1), fault);
}

}  // namespace

FaultParse parse_fault(const FaultGrammar& grammar, std::string_view text) {
  AnyFault fault;
  const std::string wrong = take(grammar, text, fault);
  if (wrong.empty()) return {fault, {}};
  return {std::nullopt, "fault '" + std::string(text) + "': " + wrong};
}

std::string fault_text(const FaultGrammar& grammar, const AnyFault& fault) {
  std::string text(grammar.kinds[fault.kind].name);
  for (const FaultPlaceName& place : grammar.places) {
    const unsigned number = fault.*(place.member);
    const bool is_said =
        place.most == 0 ? number == 0 : number != 0 && number != AnyFault{}.*(place.member);
    if (!is_said) continue;
    text += ":" + sign_of(place);
    if (place.most != 0) text += std::to_string(number);
  }
  text += "@" + written(fault.start - Time{});
  if (fault.duration != for_the_rest) text += "+" + written(fault.duration);
  return text;
}

std::string fault_help(const FaultGrammar& grammar) {
  std::string text = "NAME@START or NAME@START+DURATION, ";
  if (!grammar.places.empty()) {
    text += "with places behind the name where it matters (";
    for (const FaultPlaceName& place : grammar.places) {
      if (&place != grammar.places.data()) text += ", ";
      text += ":" + sign_of(place) + (place.most == 0 ? "" : "NUMBER");
    }
    text += "), ";
  }
  text += "any number of:\n";
  for (const FaultRow& kind : grammar.kinds) {
    text.append("  ").append(kind.name).append(": ").append(kind.description).append("\n");
  }
  return text;
}

}  // namespace canvoy
