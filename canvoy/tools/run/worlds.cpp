// The table of the built-in networks: one row registers a world for `run`, `report`, files, data
// sheets and docs.
#include <array>

#include "canvoy/tools/run/world.hpp"

namespace canvoy::tools {

WorldEntry charger_world();
WorldEntry lift_world();
WorldEntry taxi_world();
WorldEntry police_world();
WorldEntry bus_world();
WorldEntry excavator_world();

std::span<const WorldEntry> worlds() {
  static const std::array all = {charger_world(), lift_world(), taxi_world(),
                                 police_world(),  bus_world(),  excavator_world()};
  return all;
}

std::string world_names(std::string_view last_comma) {
  std::string names;
  for (const WorldEntry& world : worlds()) {
    const bool is_last = &world == &worlds().back();
    names += fmt::format("{}{}", names.empty() ? "" : is_last ? last_comma : ", ", world.name);
  }
  return names;
}

}  // namespace canvoy::tools
