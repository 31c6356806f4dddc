// Finds filters that no frame can pass: a contradiction is reported at once, not after hours of a
// log.
//
//     // "'bus=can0' and 'bus=can1' exclude each other"
//     find_contradiction(expression, conditions, names);
#pragma once

#include <string>
#include <vector>

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_tree.hpp"

namespace canvoy::tools {

/// Reason why no combination of the conditions is possible; empty if one is, or if it is unknown or
/// too expensive to decide.
std::string find_contradiction(const FilterExpression& expression,
                               const std::vector<FilterCondition>& conditions,
                               const FilterNames& names);

}  // namespace canvoy::tools
