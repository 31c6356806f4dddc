// Meaning of the words of a condition on values: objects, numbers with units, states.
#pragma once

#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_operand.hpp"
#include "canvoy/tools/filter/filter_value.hpp"

namespace canvoy::tools {

/// Reads `6010h`, `6010:01`, a name, or a part of one. Throws FilterError for an unknown name.
FilterObject filter_object(const FilterClause& clause, const FilterPhrase& phrase,
                           const FilterNames& names);
/// Reads a range: `6010..6FFF`.
FilterObject filter_objects(const FilterClause& clause, const FilterOperand& operand);

/// Sets the comparison of the clause. Throws FilterError if it is not valid, or can be true for no
/// value: an unknown state, another unit, beyond the range of the type.
void compare(FilterValue& value, const FilterClause& clause, const FilterNames& names);

}  // namespace canvoy::tools
