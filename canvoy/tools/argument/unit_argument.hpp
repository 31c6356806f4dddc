// Units after a number, and conversion between units.
//
//     std::optional<FilterUnit> unit = find_filter_unit("mV");  // {Unit::volt, 0.001}
//     conversion(Unit::hour, Unit::second);                     // 3600
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/model/unit.hpp"

namespace canvoy::tools {

/// A multiple (`count`) of a unit that profiles use.
struct FilterUnit {
  Unit unit = Unit::none;
  double count = 1;
};

/// Reads a unit as in profiles (`°C`, `Ah`), in letters of every keyboard (`degC`, `us`), or with a
/// common prefix (`mV`, `kWh`). Case is significant only where two units differ in nothing else.
std::optional<FilterUnit> find_filter_unit(std::string_view text);
/// All units that are accepted, as far as they can be typed, for a hint.
std::vector<std::string> filter_unit_names();

/// Number of `to` in one `from`; nothing if they measure different quantities.
std::optional<double> conversion(Unit from, Unit to);

}  // namespace canvoy::tools
