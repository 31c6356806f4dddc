// What two data sheets say differently: values are compared, not the way in which they are written.
#pragma once

#include <string>
#include <vector>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats {

/// An empty side does not have it.
struct Difference {
  std::string place;  ///< `6000sub1`, `DeviceInfo`
  std::string key;    ///< `DefaultValue`; empty: all of the place
  std::string first;
  std::string second;
};

/// In the order of the objects. Dates, times and names of the files do not count.
std::vector<Difference> compare_sheets(const DataSheet& first, const DataSheet& second);

}  // namespace canvoy::formats
