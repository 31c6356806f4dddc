// One condition of a filter: what its words stand for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_token.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

struct FilterPhrase {
  std::size_t position = 0;  ///< of its first byte in the filter
  std::string text = {};
  bool is_quoted = false;  ///< its first word: then it is none of the filter's own words
};

/// One of what stands behind a comparison: a value, or a range.
struct FilterOperand {
  FilterPhrase first;
  std::optional<FilterPhrase> last = {};
};

/// A condition as it is written.
struct FilterClause {
  std::string_view filter = {};
  std::string_view text = {};  ///< of the condition
  FilterPhrase subject = {};
  FilterToken::Kind comparison = FilterToken::Kind::end;  ///< `end`: there is none
  std::vector<FilterOperand> operands = {};
};

/// The condition, of `!=` that of `=` unless it is about values. Throws FilterError.
FilterCondition understand(const FilterClause& clause, const FilterNames& names);

/// The names of all services, with `#` for a number, as they are printed.
std::vector<std::string> filter_services();

}  // namespace canvoy::tools
