// The table of the built-in networks, and docs/settings.md, which is made from it: CANVOY_APPROVE=1
// writes it again.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools::worlds_test {
namespace {

std::string page() {
  std::string text =
      "# Keys of network files\n\n"
      "All that a file of `canvoy run FILE` may say, as the command reads and writes it ([networks "
      "in "
      "files](networks.md)). `canvoy run NAME --print` writes a file with all keys and their "
      "values by default; a key that is "
      "left out has this value, and one that is not listed is refused with its line.\n";
  for (const WorldEntry& world : worlds())
    text += fmt::format("\n## `{}`\n\n{}", world.name, world.keys());
  return text;
}

TEST(Worlds, KeysStandInTheDocs) {
  const auto path = std::filesystem::path(__FILE__).parent_path() / "../../../docs/settings.md";
  if (std::getenv("CANVOY_APPROVE") != nullptr) std::ofstream(path) << page();
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), page()) << "read what differs, and approve it: CANVOY_APPROVE=1";
}

TEST(Worlds, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const WorldEntry& world : worlds())
    EXPECT_TRUE(names.insert(world.name).second) << world.name;
  EXPECT_EQ(world_names(), "charger, lift, taxi, police, bus and excavator");
}

/// The error in a file of a world.
std::string refusal(const WorldEntry& world, const std::string& rest) {
  TomlFile file("net.toml", fmt::format("network = \"{}\"\n{}", world.name, rest));
  std::string network;
  file.table().take("network", network);
  try {
    return world.rewrite(file.table(), "") == "" ? "nothing is written" : "";
  } catch (const Failure& failure) {
    return failure.what();
  }
}

TEST(Worlds, RefuseInOneLineWhatTheyDoNotTake) {
  for (const WorldEntry& world : worlds()) {
    SCOPED_TRACE(world.name);
    EXPECT_TRUE(
        refusal(world, "speling = 1")
            .starts_with("net.toml line 2: speling: is not known here; there are network, "));
    EXPECT_EQ(refusal(world, "seed = -1").substr(0, 47),
              "net.toml line 2: seed: -1 is not from 0 to 1844");
    EXPECT_EQ(refusal(world, "for = 5"), "net.toml line 2: for: write a text in quotes");
    EXPECT_TRUE(
        refusal(world, "faults = [\"flood@1s\"]")
            .starts_with("net.toml line 2: faults: fault 'flood@1s': no such fault; there are "));
    EXPECT_TRUE(
        refusal(world, "faults = 1").starts_with("net.toml line 2: faults: write a list of texts"));
  }
}

}  // namespace
}  // namespace canvoy::tools::worlds_test
