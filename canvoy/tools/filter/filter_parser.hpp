// Reads a filter: conditions (`node=5`, `temperature>40degC`), joined by and, or, not, parentheses.
#pragma once

#include <string_view>
#include <vector>

#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

/// So many parentheses and `not` may stand in each other.
inline constexpr unsigned filter_depth_max = 64;
inline constexpr unsigned filter_conditions_max = 64;

/// The conditions are added to those that there are. Throws FilterError with the place and the
/// reason, and what may have been meant; also where a condition can hold for no frame.
FilterExpression parse_filter(std::string_view filter, const FilterNames& names,
                              std::vector<FilterCondition>& conditions);

}  // namespace canvoy::tools
