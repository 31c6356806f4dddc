#include "canvoy/tools/load/played_load.hpp"

#include <fmt/format.h>

namespace canvoy::tools {

std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration /*length*/) {
  table.refuse(
      "network",
      fmt::format("play it first: canvoy run {} --log run.log, and then canvoy load run.log",
                  path));
}

}  // namespace canvoy::tools
