// canvoy run NETWORK: plays a network in virtual time, built-in or from a file.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools {

int run_network_file(const std::string& path, const RunOptions& options) {
  TomlFile file(path);
  TomlTable& table = file.table();
  std::string network;
  table.take("network", network);
  const auto world = std::ranges::find(worlds(), network, &WorldEntry::name);
  if (world != worlds().end()) {
    return world->play(table, std::filesystem::path(path).parent_path().string(), options);
  }
  if (!table.has("network")) table.refuse("write which network it is: network = \"lift\"");
  table.refuse("network", fmt::format("'{}' is not known; there are {}", network, world_names()));
}

std::vector<std::string> built_in_networks() {
  std::vector<std::string> names;
  for (const WorldEntry& world : worlds()) names.emplace_back(world.name);
  return names;
}

void add_networks(Verb& run) {
  for (const WorldEntry& world : worlds()) world.add_verb(run);
}

void add_run(Verb& app) {
  Verb& command = app.add_verb("run", "Play a network in virtual time");
  struct FileOptions {
    std::string path;
    RunOptions run;
  };
  const auto options = std::make_shared<FileOptions>();
  command.add({
      {"file", options->path, "a network that a file describes (see --print of the built-in ones)"},
  });
  add_run_options(command, options->run, "as the network has it; see canvoy run NETWORK --help");
  command.add({
      {"--report", options->run.taxi_report, "of a file of a taxi, as canvoy run taxi has it"},
      {"--receipts", options->run.taxi_receipts, "of a file of a taxi, as canvoy run taxi has it"},
  });
  add_networks(command);
  command.add_examples(
      "  canvoy run charger --for 10min\n"
      "  canvoy run charging.toml --for 10min");
  command.allow_verb();
  command.runs([options] {
    if (options->path.empty()) {
      throw UsageError(fmt::format("a network is missing: {}, or a file; see canvoy run --help",
                                   world_names(", ")));
    }
    if (!std::filesystem::exists(options->path)) {
      throw UsageError(
          fmt::format("'{}' is neither a built-in network nor a file{}; see canvoy run --help",
                      options->path, did_you_mean(options->path, built_in_networks())));
    }
    return run_network_file(options->path, options->run);
  });
}

}  // namespace canvoy::tools
