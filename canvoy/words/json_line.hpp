// JSON, written at the end of a line: byte for byte what nlohmann::json dumps of the same, where
// nothing but the line is to be made, millions of times a second.
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

namespace canvoy::words {

/// It sees from the last character whether a comma is due: what stands in front of the JSON ends
/// with a line break, or there is nothing.
class JsonLine {
 public:
  /// `line` has to outlive it.
  explicit JsonLine(std::string& line) : line_(&line) {}

  void begin_object() { begin('{'); }
  void end_object() { *line_ += '}'; }
  void begin_list() { begin('['); }
  void end_list() { *line_ += ']'; }
  /// A value has to follow.
  JsonLine& key(std::string_view key);

  /// With what is no UTF-8 replaced by U+FFFD.
  void text(std::string_view text);
  void number(std::integral auto number) {
    if constexpr (std::signed_integral<decltype(number)>) {
      integer(std::int64_t{number});
    } else {
      integer(std::uint64_t{number});
    }
  }
  /// Null where it is none, or infinite.
  void number(double number);
  /// The double next to `number` / 10^places, of which 15 are the most: as number(double) writes
  /// it, in a fraction of the time.
  void decimal(std::int64_t number, unsigned places);
  void null();
  void truth(bool is_true);
  /// A text of two capital hexadecimal digits a byte.
  void hex(std::span<const std::uint8_t> bytes);
  /// Members of an object, or elements of a list, that are JSON already; none where it is empty.
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

}  // namespace canvoy::words
