// The table of the built-in networks: one row registers a world for `run`, `report`, files, data
// sheets and docs.
#include <algorithm>
#include <array>
#include <filesystem>

#include "canvoy/tools/play/world.hpp"

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

std::vector<DescribedNode> describe_world(const std::string& path) {
  TomlFile file(path);
  TomlTable& table = file.table();
  std::string network;
  table.take("network", network);
  const auto world = std::ranges::find(worlds(), network, &WorldEntry::name);
  if (world == worlds().end() || world->describe == nullptr) return {};
  return world->describe(table, std::filesystem::path(path).parent_path().string());
}

}  // namespace canvoy::tools
