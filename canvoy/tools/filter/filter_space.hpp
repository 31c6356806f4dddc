// Whether a filter can hold for any frame: what contradicts itself is better said at once than
// after a log of hours.
//
//     find_contradiction(expression, conditions);  // "'bus=can0' and 'bus=can1' exclude each
//     other"
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

/// Why none of the conditions' combinations can be, or an empty text: that is so, too, where it is
/// not known, or would take long to find out.
std::string find_contradiction(const FilterExpression& expression,
                               const std::vector<FilterCondition>& conditions,
                               const FilterNames& names);

}  // namespace canvoy::tools
