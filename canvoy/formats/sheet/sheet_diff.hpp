// Compares two data sheets: values, not their notation.
#pragma once

#include <string>
#include <vector>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats {

/// A difference; an empty side does not have the value.
struct Difference {
  std::string place;   ///< `6000sub1`, `DeviceInfo`
  std::string key;     ///< `DefaultValue`; empty: the whole section
  std::string first;   ///< value in the first sheet
  std::string second;  ///< value in the second sheet
};

/// Lists the differences in the order of the objects. Ignores dates, times and file names.
std::vector<Difference> compare_sheets(const DataSheet& first, const DataSheet& second);

}  // namespace canvoy::formats
