// The meaning of one condition of a filter.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_token.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

struct FilterPhrase {
  std::size_t position = 0;  ///< of its first byte in the filter
  std::string text = {};
  bool is_quoted = false;  ///< the first word is quoted: it is no word of the filter grammar
};

/// An operand of a comparison: a value, or a range.
struct FilterOperand {
  FilterPhrase first;
  std::optional<FilterPhrase> last = {};
};

/// A condition as written.
struct FilterClause {
  std::string_view filter = {};
  std::string_view text = {};  ///< text of the condition
  FilterPhrase subject = {};
  FilterToken::Kind comparison = FilterToken::Kind::end;  ///< `end`: none
  std::vector<FilterOperand> operands = {};
};

/// The condition; for `!=` that of `=`, unless it is on values. Throws FilterError.
FilterCondition understand(const FilterClause& clause, const FilterNames& names);

/// Names of all services as printed, with `#` for a number.
std::vector<std::string> filter_services();

}  // namespace canvoy::tools
