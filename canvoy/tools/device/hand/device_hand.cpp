#include "canvoy/tools/device/hand/device_hand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "canvoy/can/real_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"

namespace canvoy::tools {

namespace {

std::string joined_words(const DeviceHand& hand) {
  std::string text;
  for (const HandWord& word : hand.words) {
    // Other words have the same code.
    if (word.meaning == Meaning::do_not_care) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", word.word);
  }
  return text;
}

std::optional<double> number_in_hand(std::string_view text) {
  if (text.starts_with("0x")) {
    std::uint64_t bits = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 2, end, bits, 16);
    return error == std::errc{} && stop == end ? std::optional(static_cast<double>(bits))
                                               : std::nullopt;
  }
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = real_from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end || text.empty()) return std::nullopt;
  return number;
}

[[noreturn]] void refuse_value(const DeviceHand& hand, std::string_view value) {
  std::vector<std::string> words;
  words.reserve(hand.words.size());
  for (const HandWord& word : hand.words) words.push_back(word.word);
  throw UsageError(fmt::format("'{}={}': {} takes {}{}", hand.name, value, hand.name,
                               hand_values_text(hand), did_you_mean(value, words)));
}

}  // namespace

std::string hand_name_text(const DeviceHand& hand) {
  switch (hand.count) {
    case 0:
      return hand.name;
    case 1:
      return hand.name + "1";
    default:
      return fmt::format("{}1 to {}{}", hand.name, hand.name, hand.count);
  }
}

std::string hand_values_text(const DeviceHand& hand) {
  switch (hand.form) {
    case HandForm::action:
      return "";
    case HandForm::text:
      return fmt::format("a text, as {}", hand.example);
    case HandForm::number: {
      const std::string range = fmt::format("{} to {}{}{}", hand.least, hand.most,
                                            hand.unit.empty() ? "" : " ", hand.unit);
      return hand.words.empty() ? range : fmt::format("{}, {}", range, joined_words(hand));
    }
    default:
      return joined_words(hand);
  }
}

HandValue parse_hand_value(const DeviceHand& hand, std::string_view value) {
  for (const HandWord& word : hand.words) {
    if (word.word != value) continue;
    const Meaning meaning = word.meaning == Meaning::do_not_care ? Meaning::state : word.meaning;
    return {.code = word.code, .meaning = meaning, .text = std::string(value)};
  }
  if (hand.form == HandForm::text && !value.empty()) {
    HandValue told{.text = std::string(value)};
    if (hand.check != nullptr) hand.check(told);
    return told;
  }
  if (hand.form != HandForm::number) refuse_value(hand, value);
  const std::optional<double> number = number_in_hand(value);
  if (!number || !(*number >= hand.least && *number <= hand.most)) refuse_value(hand, value);
  return {.number = *number, .text = std::string(value)};
}

HandValue hand_key_value(bool is_pressed) {
  return {.code = is_pressed ? 1U : 0U, .text = is_pressed ? "pressed" : "released"};
}

std::string hand_word(std::string_view name) {
  std::string word;
  for (const char letter : name) {
    const bool is_upper = letter >= 'A' && letter <= 'Z';
    const bool is_kept = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    if (is_upper) {
      word += static_cast<char>(letter - 'A' + 'a');
    } else if (is_kept) {
      word += letter;
    } else if (!word.empty() && word.back() != '-') {
      word += '-';
    }
  }
  while (word.ends_with('-')) word.pop_back();
  return word;
}

std::string why_refused(const DeviceHand& hand, const HandTarget& target) {
  const std::string why = hand.why == nullptr ? "" : hand.why(target);
  return why.empty() ? "not in this state" : why;
}

}  // namespace canvoy::tools
