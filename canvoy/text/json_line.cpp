#include "canvoy/text/json_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/json_number.hpp"

namespace canvoy::text {

namespace {

constexpr std::size_t integer_length = 24;

bool is_ascii(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

/// Characters that are not simply copied.
constexpr std::array<bool, 256> is_special = [] {
  std::array<bool, 256> made{};
  for (unsigned i = 0; i < made.size(); ++i) {
    made.at(i) = i < 0x20 || i >= 0x80 || i == '"' || i == '\\';
  }
  return made;
}();

/// Position of the first of them from `from` on, or the end. Eight are tested at a time: a bit is
/// set in each byte below 20h, above 7Fh, or equal to one of the two.
std::size_t find_special(std::string_view text, std::size_t from) {
  constexpr std::uint64_t ones = 0x0101'0101'0101'0101;
  constexpr std::uint64_t highest = ones * 0x80;
  std::uint64_t eight = 0;
  for (; from + sizeof eight <= text.size(); from += sizeof eight) {
    std::memcpy(&eight, text.data() + from, sizeof eight);
    const std::uint64_t quote = eight ^ ones * '"';
    const std::uint64_t backslash = eight ^ ones * '\\';
    const std::uint64_t zeros = (eight - ones * 0x20) | (quote - ones) | (backslash - ones);
    if (((zeros | eight) & highest) != 0) break;
  }
  while (from < text.size() && !is_special[static_cast<unsigned char>(text[from])]) ++from;
  return from;
}

void append_escape(std::string& line, char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  constexpr std::string_view escaped = "\b\t\n\f\r\"\\";
  constexpr std::string_view letters = "btnfr\"\\";
  line += '\\';
  const std::size_t place = escaped.find(c);
  if (place != std::string_view::npos) {
    line += letters[place];
    return;
  }
  const auto code = static_cast<unsigned char>(c);
  line.append("u00");
  line += digits[code >> 4];
  line += digits[code & 0xF];
}

void append_hex(std::string& line, std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::size_t piece = 32;
  std::array<char, 2 * piece> text{};
  while (!bytes.empty()) {
    const auto part = bytes.first(std::min(bytes.size(), piece));
    char* at = text.data();
    for (const std::uint8_t byte : part) {
      *at++ = digits[byte >> 4];
      *at++ = digits[byte & 0xF];
    }
    line.append(text.data(), at);
    bytes = bytes.subspan(part.size());
  }
}

template <class Number>
void append_integer(std::string& line, Number number) {
  std::array<char, integer_length> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  check_invariant(error == std::errc{});
  line.append(digits.data(), end);
}

}  // namespace

void JsonLine::separate() {
  if (line_->empty()) return;
  const char last = line_->back();
  if (last != '{' && last != '[' && last != ':' && last != '\n') *line_ += ',';
}

void JsonLine::begin(char bracket) {
  separate();
  *line_ += bracket;
}

JsonLine& JsonLine::key(std::string_view key) {
  separate();
  quote(key);
  *line_ += ':';
  return *this;
}

void JsonLine::text(std::string_view text) {
  separate();
  quote(text);
}

void JsonLine::quote(std::string_view text) {
  if (find_special(text, 0) == text.size()) return quote_plain(text);
  const std::size_t start = line_->size();
  *line_ += '"';
  std::size_t done = 0;
  bool is_utf8 = false;
  for (std::size_t i = find_special(text, 0); i < text.size(); i = find_special(text, i + 1)) {
    if (is_utf8 && !is_ascii(text[i])) continue;
    if (!is_ascii(text[i])) {
      is_utf8 = formats::is_plain_text(text);
      if (is_utf8) continue;
      // Rare: the library repairs it, though slowly.
      line_->resize(start);
      *line_ += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
      return;
    }
    line_->append(text, done, i - done);
    append_escape(*line_, text[i]);
    done = i + 1;
  }
  line_->append(text, done);
  *line_ += '"';
}

/// In one piece, the common case.
void JsonLine::quote_plain(std::string_view text) {
  constexpr std::size_t short_length = 62;
  if (text.size() > short_length) {
    *line_ += '"';
    *line_ += text;
    *line_ += '"';
    return;
  }
  std::array<char, short_length + 2> quoted;
  quoted[0] = '"';
  std::memcpy(quoted.data() + 1, text.data(), text.size());
  quoted[text.size() + 1] = '"';
  line_->append(quoted.data(), text.size() + 2);
}

void JsonLine::number(double number) {
  if (!std::isfinite(number)) return null();
  separate();
  append_json_number(*line_, number);
}

void JsonLine::decimal(std::int64_t number, unsigned places) {
  separate();
  append_json_decimal(*line_, number, places);
}

void JsonLine::integer(std::int64_t number) {
  separate();
  append_integer(*line_, number);
}

void JsonLine::integer(std::uint64_t number) {
  separate();
  append_integer(*line_, number);
}

void JsonLine::null() {
  separate();
  *line_ += "null";
}

void JsonLine::truth(bool is_true) {
  separate();
  *line_ += is_true ? "true" : "false";
}

void JsonLine::hex(std::span<const std::uint8_t> bytes) {
  separate();
  *line_ += '"';
  append_hex(*line_, bytes);
  *line_ += '"';
}

void JsonLine::written(std::string_view json) {
  if (json.empty()) return;
  separate();
  *line_ += json;
}

}  // namespace canvoy::text
