// Writes JSON at the end of a line, byte for byte like the output of nlohmann::json, at a rate of
// millions per second.
//
//     JsonLine json(line);
//     json.begin_object();
//     json.key("node").number(10);
//     json.key("unit").text("°C");
//     json.end_object();  // {"node":10,"unit":"°C"}
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace canvoy::text {

/// The last character decides whether a comma is needed: text before the JSON must end with a line
/// break, or be empty.
class JsonLine {
 public:
  /// `line` must outlive this.
  explicit JsonLine(std::string& line) : line_(&line) {}

  /// Begins an object: as a value, or as the first thing of the line.
  void begin_object() { begin('{'); }
  /// Ends the innermost object.
  void end_object() { *line_ += '}'; }
  /// Begins a list.
  void begin_list() { begin('['); }
  /// Ends the innermost list.
  void end_list() { *line_ += ']'; }
  /// Writes a key; a value must follow.
  JsonLine& key(std::string_view key);

  /// Writes a string; invalid UTF-8 is replaced by U+FFFD.
  void text(std::string_view text);
  /// Writes a whole number of up to 64 bits.
  void number(std::integral auto number) {
    if constexpr (std::signed_integral<decltype(number)>) {
      integer(std::int64_t{number});
    } else {
      integer(std::uint64_t{number});
    }
  }
  /// Writes a number; null if it is NaN or infinite.
  void number(double number);
  /// Writes the double nearest to `number` / 10^places, with at most 15 places: like
  /// number(double), but in a fraction of the time.
  void decimal(std::int64_t number, unsigned places);
  /// Writes null.
  void null();
  /// Writes true or false.
  void truth(bool is_true);
  /// Writes a string of two upper-case hexadecimal digits for each byte.
  void hex(std::span<const std::uint8_t> bytes);
  /// Writes members of an object or elements of a list that are already JSON; nothing if empty.
  void written(std::string_view json);

 private:
  void begin(char bracket);
  void separate();
  void integer(std::int64_t number);
  void integer(std::uint64_t number);
  void quote(std::string_view text);
  void quote_plain(std::string_view text);

  std::string* line_;
};

}  // namespace canvoy::text
