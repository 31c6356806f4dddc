// An expectation on an object of a node: `temperature > 20degC within 2s`.
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
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::tools {

struct Expectation {
  enum class Comparison : std::uint8_t { equal, unequal, less, at_most, greater, at_least };

  std::string object;
  Comparison comparison = Comparison::equal;
  std::string value;      ///< for `=`, `!=` and `in` also a range, inclusive: `20..30degC`
  bool is_range = false;  ///< written with `in`: the value must be a range
  std::optional<Duration> within = {};   ///< must become true within this time
  std::optional<Duration> holding = {};  ///< must be true all the time (`for 5s`)

  /// True if the value meets the expectation. Throws UsageError if the expected value is not valid
  /// for this entry. An unknown entry (null) is an unsigned number.
  bool holds(const EntryInfo* entry, std::span<const std::uint8_t> bytes) const;
};

/// Reads `OBJECT = VALUE`, with `!=`, `<`, `<=`, `>` or `>=` for `=`, or `OBJECT in FROM..TO`,
/// optionally followed by `within 2s` or `for 2s`. Throws UsageError.
Expectation parse_expectation(std::string_view text);

/// Removes `within 2s` from the end of a text, after all that is quoted, and returns the time.
/// Throws UsageError if the time is not valid.
std::optional<Duration> take_span(std::string& text, std::string_view word);

}  // namespace canvoy::tools
