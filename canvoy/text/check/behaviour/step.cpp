#include "canvoy/text/check/behaviour/step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t first_application_object = 0x2000;

bool is_done(const Step& step) {
  return step.act != Act::none && step.act < Act::refuse;
}

std::string command_text(const Step& step) {
  return fmt::format("NMT {:02X}h", static_cast<std::uint64_t>(step.number));
}

std::string shortened(std::string_view text) {
  constexpr std::size_t shown = 24;
  if (text.size() <= shown) return std::string(text);
  return fmt::format("{}... ({} bytes)", text.substr(0, shown), text.size());
}

std::string value_of(const Step& step) {
  std::string number = number_text(step.place, step.number);
  if (step.mask == 0) return "any value";
  if (step.mask == ~0ULL) return number;
  return fmt::format("{} in bits {:X}h", number, step.mask);
}

template <class Picks>
std::string joined(const BehaviourRow& row, Picks picks) {
  std::string text;
  for (const Step& step : row.steps) {
    if (step.act == Act::none || !picks(step)) continue;
    if (!text.empty()) text += "; ";
    text += step_text(step);
  }
  return text;
}

}  // namespace

bool moves(const BehaviourRow& row) {
  return std::ranges::any_of(row.steps, [](const Step& step) {
    constexpr Act writing[] = {Act::put, Act::put_text, Act::feed, Act::refuse, Act::refuse_text};
    const bool writes = std::ranges::find(writing, step.act) != std::end(writing);
    return writes && step.place.index() >= first_application_object;
  });
}

std::string number_text(const Place& place, std::int64_t number) {
  const EntryInfo* const entry = place.object == nullptr ? nullptr : place.entry();
  if (entry == nullptr) return fmt::format("{}", number);
  if (is_signed(entry->type)) return fmt::format("{}", number);
  const unsigned digits = std::max(2U, byte_length(entry->type) * 2);
  return fmt::format("{:0{}X}h", static_cast<std::uint64_t>(number), digits);
}

std::string step_text(const Step& step) {
  const std::string object = step.place.object == nullptr
                                 ? std::string()
                                 : text::object_text(step.place.index(), step.place.sub);
  const auto time = step.time / 1ms;
  switch (step.act) {
    case Act::none:
      return "";
    case Act::enter:
      return command_text(step);
    case Act::put:
      return fmt::format("{} = {}", object, value_of(step));
    case Act::feed:
      return fmt::format("an RPDO with {} = {}", object, value_of(step));
    case Act::lose:
      return "the heartbeat that it watches stays away";
    case Act::hand:
      return fmt::format("by hand: {}", step.words);
    case Act::wait:
      return fmt::format("{} ms", time);
    case Act::refuse:
      return fmt::format("{} = {} is aborted", object, value_of(step));
    case Act::put_text:
      return fmt::format("{} = \"{}\"", object, shortened(step.words));
    case Act::refuse_text:
      return fmt::format("{} = \"{}\" is aborted", object, shortened(step.words));
    case Act::is_text:
      return fmt::format("{} is \"{}\" within {} ms", object, shortened(step.words), time);
    case Act::is:
      return fmt::format("{} is {} within {} ms", object, value_of(step), time);
    case Act::stays:
      return fmt::format("{} is {} for {} ms", object, value_of(step), time);
    case Act::tells:
      return fmt::format("a TPDO with {} = {} within {} ms", object, value_of(step), time);
    case Act::is_silent:
      return fmt::format("no TPDO with {} for {} ms", object, time);
    case Act::alarm:
      return fmt::format("EMCY {:04X}h within {} ms", static_cast<std::uint64_t>(step.number),
                         time);
    case Act::no_alarm:
      return fmt::format("no EMCY {:04X}h for {} ms", static_cast<std::uint64_t>(step.number),
                         time);
    case Act::see:
      return fmt::format("to be seen: {}", step.words);
  }
  return "";
}

std::string sends_text(const BehaviourRow& row) {
  const std::string text = joined(row, [](const Step& step) { return is_done(step); });
  return text.empty() ? "uploads, and downloads that are to be aborted" : text;
}

std::string expects_text(const BehaviourRow& row) {
  const std::string text = joined(row, [](const Step& step) { return !is_done(step); });
  return text.empty() ? "no abort" : text;
}

}  // namespace canvoy::conformance
