// Splits a filter into words and signs.
//
//     for (const FilterToken& token : filter_tokens("temperature > 40")) ...
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

/// An error in a filter, with its position: `filter '...', character 3: ...`.
class FilterError : public UsageError {
 public:
  /// `position` is a byte index into `filter`; the message gives it as a character number.
  FilterError(std::string_view filter, std::size_t position, std::string_view problem);
};

struct FilterToken {
  enum class Kind : std::uint8_t {
    end,
    word,
    quoted,
    open,
    close,
    comma,
    to,  ///< `..`
    equal,
    unequal,
    less,
    less_or_equal,
    greater,
    greater_or_equal,
    and_,
    or_,
    not_,
  };
  Kind kind = Kind::end;
  std::size_t position = 0;    ///< index of the first byte
  std::size_t behind = 0;      ///< index after the last byte
  std::string_view text = {};  ///< without quotes; part of the filter
};

using FilterTokenKind = FilterToken::Kind;

/// The last token is `end`. Throws FilterError: a missing closing quote, more than 4096 bytes.
std::vector<FilterToken> filter_tokens(std::string_view filter);

}  // namespace canvoy::tools
