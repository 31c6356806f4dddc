#include "canvoy/tools/play/shift_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/play/excavator_text.hpp"

namespace canvoy::tools {

namespace {

using excavator::HandInput;
using excavator::HandMove;
using excavator::RecordedShift;

constexpr std::size_t moves_max = 10'000'000;
constexpr double shift_seconds_max = 1e6;
constexpr double clicks_max = 1000;
constexpr double held_min = 0.001;
constexpr double held_max = 60;

constexpr std::string_view input_texts[] = {
    "left_x", "left_y", "right_x", "right_y", "left_pedal", "right_pedal", "throttle", "rotator",
    "knob",   "lever",  "horn",    "light",   "beacon",     "travel",      "lock",     "operator"};
static_assert(std::size(input_texts) == excavator::hand_inputs);

std::string_view take_field(std::string_view& line) {
  const std::size_t comma = line.find(',');
  const std::string_view field = formats::trimmed(line.substr(0, comma));
  line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  return field;
}

/// Text for a message: the file may be binary.
std::string printable(std::string_view field) {
  constexpr std::size_t shown_max = 40;
  std::string text(field.substr(0, shown_max));
  std::ranges::replace_if(
      text, [](char each) { return each < ' ' || each > '~'; }, '?');
  return text;
}

double shift_number(std::string_view field, double least, double most) {
  double value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = real_from_chars(field.data(), end, value);
  // Written so that it refuses what is not a number as well.
  if (error != std::errc{} || stop != end || !(value >= least && value <= most)) {
    throw UsageError(fmt::format("'{}' is no number from {} to {}", printable(field), least, most));
  }
  return value;
}

double whole_number(std::string_view field, double least, double most) {
  const double value = shift_number(field, least, most);
  if (value != std::round(value)) {
    throw UsageError(fmt::format("'{}' is no whole number", printable(field)));
  }
  return value;
}

double activity_number(std::string_view field) {
  constexpr auto last = static_cast<unsigned>(excavator::Activity::gets_off);
  for (unsigned i = 0; i <= last; ++i) {
    if (activity_text(static_cast<excavator::Activity>(i)) == field) return i;
  }
  throw UsageError(fmt::format("'{}' is nothing that an operator does", printable(field)));
}

HandInput input_of(std::string_view field) {
  const auto* const found = std::ranges::find(input_texts, field);
  if (found != std::end(input_texts)) return static_cast<HandInput>(found - input_texts);
  throw UsageError(
      fmt::format("'{}' is none of {}", printable(field), fmt::join(input_texts, ", ")));
}

double value_of(HandInput input, std::string_view field) {
  if (excavator::is_place(input)) return shift_number(field, -1, 1);
  if (excavator::is_button(input)) return shift_number(field, held_min, held_max);
  if (input == HandInput::knob) return whole_number(field, -clicks_max, clicks_max);
  if (input == HandInput::lever) return whole_number(field, 0, 1);
  return activity_number(field);
}

HandMove parse_move(std::string_view line) {
  HandMove move;
  const double seconds = shift_number(take_field(line), 0, shift_seconds_max);
  move.at = Time(std::chrono::round<Duration>(std::chrono::duration<double>(seconds)));
  move.input = input_of(take_field(line));
  move.value = value_of(move.input, take_field(line));
  if (!line.empty()) throw UsageError("a line is: seconds,input,value");
  return move;
}

}  // namespace

RecordedShift parse_shift(std::string_view name, std::string_view text) {
  RecordedShift shift;
  for (std::size_t count = 1; !text.empty(); ++count) {
    const std::size_t end = text.find('\n');
    const std::string_view with_comment = text.substr(0, end);
    const std::string_view line = formats::trimmed(with_comment.substr(0, with_comment.find('#')));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    if (line.empty() || (count == 1 && line.starts_with("seconds"))) continue;
    try {
      if (shift.size() == moves_max) throw UsageError("more than ten million lines");
      const HandMove move = parse_move(line);
      if (!shift.empty() && move.at < shift.back().at) {
        throw UsageError("its time is before that of the line above");
      }
      shift.push_back(move);
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{} line {}: {}", name, count, failure.what()));
    }
  }
  if (shift.empty()) throw Failure(fmt::format("{}: nobody does anything", name));
  return shift;
}

RecordedShift read_shift(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw Failure(fmt::format("{}: cannot be read", path));
  return parse_shift(path, text.str());
}

std::string shift_text(const RecordedShift& shift) {
  std::string text = "seconds,input,value\n";
  for (const HandMove& move : shift) {
    const auto microseconds = move.at.time_since_epoch().count();
    constexpr int million = 1'000'000;
    fmt::format_to(std::back_inserter(text), "{}.{:06},{},", microseconds / million,
                   microseconds % million, input_texts[static_cast<std::size_t>(move.input)]);
    if (move.input == HandInput::activity) {
      text += activity_text(static_cast<excavator::Activity>(move.value));
    } else {
      fmt::format_to(std::back_inserter(text), "{}", move.value);
    }
    text += '\n';
  }
  return text;
}

void write_shift(const std::string& path, const RecordedShift& shift) {
  const std::string text = shift_text(shift);
  write_value_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace canvoy::tools
