// Parses a filter: conditions (`node=5`, `temperature>40degC`), combined with and, or, not,
// parentheses.
#pragma once

#include <string_view>
#include <vector>

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

/// Maximum nesting of parentheses and `not`.
inline constexpr unsigned filter_depth_max = 64;
inline constexpr unsigned filter_conditions_max = 64;

/// Adds the conditions to the existing ones. Throws FilterError with position, reason and
/// suggestions; also if a condition can be true for no frame.
FilterExpression parse_filter(std::string_view filter, const FilterNames& names,
                              std::vector<FilterCondition>& conditions);

}  // namespace canvoy::tools
