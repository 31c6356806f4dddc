#include "canvoy/formats/trace/trace_fields.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace canvoy::formats {

namespace {

// In English, followed by the different German ones.
constexpr std::array<std::pair<std::string_view, unsigned>, 18> months = {{
    {"jan", 1},
    {"feb", 2},
    {"mar", 3},
    {"apr", 4},
    {"may", 5},
    {"jun", 6},
    {"jul", 7},
    {"aug", 8},
    {"sep", 9},
    {"oct", 10},
    {"nov", 11},
    {"dec", 12},
    {"m\xE4r", 3},
    {"m\xC3\xA4", 3},
    {"mrz", 3},
    {"mai", 5},
    {"okt", 10},
    {"dez", 12},
}};

bool begins_with(std::string_view word, std::string_view small_letters) {
  if (word.size() < small_letters.size()) return false;
  for (std::size_t at = 0; at < small_letters.size(); ++at) {
    const char letter = word[at];
    const bool capital = letter >= 'A' && letter <= 'Z';
    if ((capital ? static_cast<char>(letter - 'A' + 'a') : letter) != small_letters[at])
      return false;
  }
  return true;
}

unsigned month_of(std::string_view word) {
  for (const auto& [name, number] : months) {
    if (begins_with(word, name)) return number;
  }
  return 0;
}

bool read_clock(std::string_view text, std::string_view half, Duration& of_day) {
  const std::size_t first = text.find(':');
  const std::size_t second = text.find(':', first == std::string_view::npos ? first : first + 1);
  if (second == std::string_view::npos) return false;
  std::int64_t hours = 0;
  std::int64_t minutes = 0;
  std::int64_t microseconds = 0;
  if (!read_decimal(text.substr(0, first), hours) || hours > 23) return false;
  if (!read_decimal(text.substr(first + 1, second - first - 1), minutes) || minutes > 59)
    return false;
  if (!read_fixed(text.substr(second + 1), 6, microseconds) || microseconds >= 61'000'000)
    return false;
  if (!half.empty()) hours = hours % 12 + (begins_with(half, "pm") ? 12 : 0);
  of_day = std::chrono::hours{hours} + std::chrono::minutes{minutes} + Duration{microseconds};
  return true;
}

// ` 1E`, the form of nearly all bytes.
bool take_usual_byte(std::string_view& text, std::uint8_t& byte) {
  if (text.size() < 3 || text[0] != ' ' || (text.size() > 3 && !is_blank(text[3]))) return false;
  const unsigned high = hex_digit(text[1]);
  const unsigned low = hex_digit(text[2]);
  if ((high | low) > 15) return false;
  byte = static_cast<std::uint8_t>(high << 4 | low);
  text.remove_prefix(3);
  return true;
}

}  // namespace

std::string_view TraceChannel::change(std::int64_t number) {
  if (number < 1 || number > number_max) return {};
  name_ = "can" + std::to_string(number - 1);
  number_ = number;
  return name_;
}

std::size_t TraceChannelNumbers::change(std::string_view channel) {
  latest_ = channel;
  number_ = find(channel.empty() ? "can0" : channel);
  return number_;
}

std::size_t TraceChannelNumbers::find(std::string_view channel) {
  const auto known = std::ranges::find(names_, channel);
  if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin()) + 1;
  std::string_view digits = channel;
  const std::size_t letters = digits.find_last_not_of("0123456789");
  if (letters != std::string_view::npos) digits.remove_prefix(letters + 1);
  std::int64_t number = 0;
  const bool is_one = read_decimal(digits, number) && number < TraceChannel::number_max;
  const std::size_t wanted = is_one ? static_cast<std::size_t>(number) : 0;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    std::string& name = names_.at((wanted + i) % names_.size());
    if (!name.empty()) continue;
    name = channel;
    return (wanted + i) % names_.size() + 1;
  }
  return wanted + 1;  // more names than numbers: they share one
}

void take_fd_bytes(std::string_view& text, std::size_t count, bool hexadecimal,
                   TraceFdContent& content) {
  content.length = 0;
  for (; content.length < std::min(count, content.data.size()); ++content.length) {
    const std::string_view word = take_word(text);
    std::uint32_t value = 0x100;
    std::int64_t decimal = 0x100;
    if (hexadecimal ? !read_hex(word, value) : !read_decimal(word, decimal)) return;
    if (!hexadecimal) value = static_cast<std::uint32_t>(std::min<std::int64_t>(decimal, 0x100));
    if (value > 0xFF) return;
    content.data.at(content.length) = static_cast<std::uint8_t>(value);
  }
}

bool take_bytes(std::string_view& text, unsigned count, bool hexadecimal, Frame& frame) {
  if (count > Frame::length_max) return false;
  for (unsigned at = 0; at < count; ++at) {
    if (hexadecimal && take_usual_byte(text, frame.data[at])) continue;
    const std::string_view word = take_word(text);
    std::uint32_t value = 0x100;
    std::int64_t decimal = 0x100;
    if (hexadecimal && !read_hex(word, value)) return false;
    if (!hexadecimal && read_decimal(word, decimal) && decimal < 0x100)
      value = static_cast<std::uint32_t>(decimal);
    if (value > 0xFF) return false;
    frame.data[at] = static_cast<std::uint8_t>(value);
  }
  frame.length = static_cast<std::uint8_t>(count);
  return true;
}

bool read_clock_time(std::string_view text, Duration& of_day) {
  return read_clock(text, {}, of_day);
}

bool read_asc_date(std::string_view text, Duration& since_1970) {
  unsigned month = 0;
  for (int words = 0; words < 2 && month == 0; ++words) month = month_of(take_word(text));
  std::int64_t day = 0;
  std::int64_t year = 0;
  if (month == 0 || !read_decimal(take_word(text), day) || day > 31) return false;
  const std::string_view clock = take_word(text);
  std::string_view year_word = take_word(text);
  std::string_view half;
  if (begins_with(year_word, "am") || begins_with(year_word, "pm")) {
    half = year_word;
    year_word = take_word(text);
  }
  if (!read_decimal(year_word, year) || year < 1970 || year > 9999) return false;
  Duration of_day{};
  if (!read_clock(clock, half, of_day)) return false;
  const std::chrono::year_month_day date{std::chrono::year{static_cast<int>(year)},
                                         std::chrono::month{month},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) return false;
  since_1970 = std::chrono::sys_days{date}.time_since_epoch() + of_day;
  return true;
}

}  // namespace canvoy::formats
