// The words and signs of a filter.
//
//     for (const FilterToken& token : filter_tokens("temperature > 40")) ...
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

/// What is wrong with a filter, and where: the message has `filter '...', character 3: ...`.
class FilterError : public UsageError {
 public:
  /// `position` is that of a byte of `filter`, which is told as the number of its character.
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
  std::size_t position = 0;    ///< of its first byte
  std::size_t behind = 0;      ///< of the first byte behind it
  std::string_view text = {};  ///< without quotes; part of the filter
};

using FilterTokenKind = FilterToken::Kind;

/// The last one is `end`. Throws FilterError: a quote without an end, more than 4096 bytes.
std::vector<FilterToken> filter_tokens(std::string_view filter);

}  // namespace canvoy::tools
