// The table of the built-in networks; docs/settings.md, which is made from it (CANVOY_APPROVE=1
// writes it again); and that a network runs alike whether it is looked at or not.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/tools/play/lift_world.hpp"
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

const Duration look_period = std::chrono::microseconds(tries_all() ? 34'567 : 134'567);

/// Hashes the frames of a bus, with their times.
struct BusHash {
  static void hear(void* bus, Time now, ControllerId /*sender*/, const Frame& frame) {
    BusHash& self = *static_cast<BusHash*>(bus);
    self.add(static_cast<std::uint64_t>((now - Time{}).count()));
    self.add(frame.id);
    for (const std::uint8_t byte : frame.payload()) self.add(byte);
  }
  void add(std::uint64_t part) { value = (value ^ part) * 1'099'511'628'211U; }
  bool operator==(const BusHash&) const = default;

  std::uint64_t value = 14'695'981'039'346'656'037U;  // FNV-1a
};

using Look = std::function<void(PlayedNetwork&)>;

/// Runs for a minute in which one more person comes; `look` is called in each look_period.
void run_minute(PlayedNetwork& network, const Look& look) {
  const auto from = static_cast<unsigned>((network.world().now() - Time{}) / 1min % 5 + 1);
  if (network.has_way(from, from + 1)) network.visit(from, from + 1);
  const Time end = network.world().now() + 1min;
  while (look && network.world().now() + look_period < end) {
    network.run_until(network.world().now() + look_period);
    look(network);
  }
  network.run_until(end);
}

/// Plays the network of a file.
std::vector<BusHash> frames_of(const WorldEntry& world, const std::string& text, int minutes,
                               const Look& look) {
  TomlFile file("net.toml", text);
  std::string name;
  file.table().take("network", name);
  const HeardWorld made = world.make(file.table(), "");
  PlayedNetwork& network = *made.network;
  std::vector<BusHash> hashes(network.bus_names().size());
  for (std::size_t bus = 0; bus < hashes.size(); ++bus) {
    const BusTap tap{.context = &hashes[bus], .on_frame = BusHash::hear};
    EXPECT_TRUE(network.world().bus(static_cast<BusIndex>(bus)).observe(tap));
  }
  while (minutes-- > 0) run_minute(network, look);
  return hashes;
}

/// All that a page, a terminal or a report asks for.
void look_at_all(PlayedNetwork& network) {
  EXPECT_FALSE(network.snapshot().empty());
  EXPECT_FALSE(network.picture(1).empty());
  static_cast<void>(network.judged());
  // Slow to make; once a second or so does.
  if ((network.world().now() - Time{}) % 1s >= look_period) return;
  EXPECT_FALSE(network.summary_json().empty());
  EXPECT_FALSE(network.summary_text().empty());
}

/// Two lifts that also move empty, to a floor exactly; one slips on its ropes, and stops by its
/// brake, not by its drive.
std::string troubled_lifts() {
  LiftRun run;
  run.network = lift::standard_lift_network({.lifts = 2, .floors = 6, .seed = 7});
  run.network.traffic.percent_in_5_minutes = 0;
  add_fault<LiftWorld>(run, "rope-slip:lift=2@10s+2min");
  add_fault<LiftWorld>(run, "door-lock:lift=2@47s+3s");
  return run_text<LiftWorld>(run);
}

TEST(Worlds, RunAlikeWhetherLookedAtOrNot) {
  for (const WorldEntry& world : worlds()) {
    const int minutes = world.name == "lift" ? 5 : 1;
    SCOPED_TRACE(world.name);
    const std::string text =
        world.name == "lift" ? troubled_lifts() : fmt::format("network = \"{}\"\n", world.name);
    EXPECT_EQ(frames_of(world, text, minutes, look_at_all),
              frames_of(world, text, minutes, nullptr));
  }
}

}  // namespace
}  // namespace canvoy::tools::worlds_test
