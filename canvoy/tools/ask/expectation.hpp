// What is expected of an object of a node: `temperature > 20degC within 2s`.
//
//     const Expectation expected = parse_expectation("temperature > 20degC within 2s");
//     expected.holds(entry, bytes);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::tools {

struct Expectation {
  enum class Comparison : std::uint8_t { equal, unequal, less, at_most, greater, at_least };

  std::string object;
  Comparison comparison = Comparison::equal;
  std::string value;      ///< for `=`, `!=` and `in` also a range with both ends: `20..30degC`
  bool is_range = false;  ///< it was written with `in`: the value has to be one
  std::optional<Duration> within = {};   ///< it is to come true until then
  std::optional<Duration> holding = {};  ///< it is to be true all the time (`for 5s`)

  /// Throws UsageError where the value is none that this entry can have. An entry that nobody knows
  /// (null) is an unsigned number.
  bool holds(const EntryInfo* entry, std::span<const std::uint8_t> bytes) const;
};

/// `OBJECT = VALUE`, with `!=`, `<`, `<=`, `>` or `>=` in place of `=`, or `OBJECT in FROM..TO`,
/// and with `within 2s` or `for 2s` behind it. Throws UsageError.
Expectation parse_expectation(std::string_view text);

/// `within 2s` at the end of a text, behind all that is in quotes, which is taken from it. Throws
/// UsageError where the time is none.
std::optional<Duration> take_span(std::string& text, std::string_view word);

}  // namespace canvoy::tools
