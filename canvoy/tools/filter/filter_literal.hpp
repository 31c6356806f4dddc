// Meaning of the words of a condition on values: objects, numbers with units, states.
#pragma once

#include <optional>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/filter/filter_operand.hpp"
#include "canvoy/tools/filter/filter_value.hpp"

namespace canvoy::tools {

// Times in a filter.
//
//     parse_filter_time("1h30min");        // from the first frame on
//     parse_filter_time("1700000000.5");   // as lines have it

struct FilterTime {
  Duration time{};
  bool is_since_first = false;  ///< else since 1970, or since the start of a log without a date
};

/// Reads a duration (`10s`, `1h30min`), seconds without a unit, or `2026-11-21 12:00:00` (UTC).
/// Nothing if it is none of them.
std::optional<FilterTime> parse_filter_time(std::string_view text);

/// Reads `6010h`, `6010:01`, a name, or a part of one. Throws FilterError for an unknown name.
FilterObject filter_object(const FilterClause& clause, const FilterPhrase& phrase,
                           const FilterNames& names);
/// Reads a range: `6010..6FFF`.
FilterObject filter_objects(const FilterClause& clause, const FilterOperand& operand);

/// Sets the comparison of the clause. Throws FilterError if it is not valid, or can be true for no
/// value: an unknown state, another unit, beyond the range of the type.
void compare(FilterValue& value, const FilterClause& clause, const FilterNames& names);

}  // namespace canvoy::tools
