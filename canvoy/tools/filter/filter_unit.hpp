// Units as people write them behind a number, and how many of one are one of another.
//
//     std::optional<FilterUnit> unit = find_filter_unit("mV");  // {Unit::volt, 0.001}
//     conversion(Unit::hour, Unit::second);                     // 3600
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/unit.hpp"

namespace canvoy::tools {

/// So many (`count`) of a unit that profiles use.
struct FilterUnit {
  Unit unit = Unit::none;
  double count = 1;
};

/// A unit as profiles write it (`°C`, `Ah`), in letters that every keyboard has (`degC`, `us`), or
/// with a usual prefix (`mV`, `kWh`). Case matters only where two units differ by nothing else.
std::optional<FilterUnit> find_filter_unit(std::string_view text);
/// All that is understood, as far as it can be typed, for those who meant another.
std::vector<std::string> filter_unit_names();

/// How many `to` one `from` is; nothing where they do not measure the same.
std::optional<double> conversion(Unit from, Unit to);

}  // namespace canvoy::tools
