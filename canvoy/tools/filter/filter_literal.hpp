// What the words of a condition about values stand for: objects, numbers with units, states.
#pragma once

#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_operand.hpp"
#include "canvoy/tools/filter/filter_value.hpp"

namespace canvoy::tools {

/// `6010h`, `6010:01`, a name, or a part of one. Throws FilterError where nothing is called so.
FilterObject filter_object(const FilterClause& clause, const FilterPhrase& phrase,
                           const FilterNames& names);
/// `6010..6FFF`
FilterObject filter_objects(const FilterClause& clause, const FilterOperand& operand);

/// Has the value compared as the clause says. Throws FilterError where it makes no sense, or can
/// hold for no value: an unknown state, another unit, more than the type can hold.
void compare(FilterValue& value, const FilterClause& clause, const FilterNames& names);

}  // namespace canvoy::tools
