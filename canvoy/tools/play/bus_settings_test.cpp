// The file of a bus: settings of a fleet are read, written again, and refused if invalid.
#include "canvoy/tools/play/bus_settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools::bus_settings_test {
namespace {

/// The complete file for a few lines; or the reason of the refusal.
std::string whole(const std::string& lines) {
  TomlFile file("bus.toml", "network = \"bus\"\n" + lines);
  std::string network;
  file.table().take("network", network);
  for (const WorldEntry& world : worlds()) {
    if (world.name != "bus") continue;
    try {
      return world.rewrite(file.table(), "");
    } catch (const Failure& failure) {
      return failure.what();
    }
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(BusSettings, AFleetsBusIsWrittenDown) {
  const std::string text = whole(
      "[vehicle]\ncapacity = 140\ndoors = [\"in\", \"both\", \"out\"]\n"
      "[messages]\nmotion = 0x1C8\nstop_request = 461\n"
      "[next-stop]\nheartbeat = \"250ms\"\ncolumns = 30\n"
      "[[device]]\nkind = \"passenger-counter\"\nnode = 23\ndoor = 3\n"
      "[[device]]\nkind = \"generic-io\"\nnode = 50\ncar = 2\n");
  EXPECT_TRUE(has(text, "\ncapacity = 140")) << text;
  EXPECT_TRUE(has(text, "\ndoors = [\"in\", \"both\", \"out\"]"));
  EXPECT_TRUE(has(text, "\nmotion = 0x1C8"));
  EXPECT_TRUE(has(text, "\nmileage = 0x28B"));
  EXPECT_TRUE(has(text, "\nstop_request = 0x1CD"));
  EXPECT_TRUE(has(text, "\nheartbeat = \"250ms\"\ncolumns = 30\nlines = 2\n"));
  EXPECT_TRUE(has(text, "\n[[device]]"));
  EXPECT_TRUE(has(text, "\nkind = \"passenger-counter\""));
  EXPECT_TRUE(has(text, "\nkind = \"generic-io\""));
  EXPECT_EQ(whole(text.substr(text.find("network = \"bus\"\n") + 16)), text);
}

TEST(BusSettings, ADispatchersDayIsWrittenDown) {
  const std::string text = whole(
      "[[short_turn]]\njourney = 1\nstop = \"School\"\n"
      "[[detour]]\njourney = 3\nwithout = [\"Town Hall\"]\nvia = [0.0165, 0.0139]\n"
      "[depot]\nplace = [0.008, 0.008]\nsign = \"Off duty\"\n"
      "[[driver]]\njourney = 2\nnumber = 4711\n");
  EXPECT_TRUE(has(text, "\n[[short_turn]]")) << text;
  EXPECT_TRUE(has(text, "\nstop = \"School\""));
  EXPECT_TRUE(has(text, "\nwithout = [\"Town Hall\"]"));
  EXPECT_TRUE(has(text, "\nvia = [0.0165, 0.0139]"));
  EXPECT_TRUE(has(text, "\nplace = [0.008, 0.008]"));
  EXPECT_TRUE(has(text, "\nname = \"Depot\""));
  EXPECT_TRUE(has(text, "\nsign = \"Off duty\""));
  EXPECT_TRUE(has(text, "\nnumber = 4711"));
  EXPECT_EQ(whole(text.substr(text.find("network = \"bus\"\n") + 16)), text);
  EXPECT_EQ(whole("[[short_turn]]\njourney = 1\nstop = \"Zoo\"\n"),
            "bus.toml line 2: the journey does not call at 'Zoo' between its ends");
  EXPECT_EQ(whole("[[detour]]\njourney = 1\nwithout = [\"School\"]\nvia = [1]\n"),
            "bus.toml line 5: via: each place has a latitude and a longitude");
  EXPECT_EQ(whole("[depot]\nsign = \"Off duty\"\n"), "bus.toml line 3: sign: a depot has a place");
  EXPECT_EQ(whole("[[driver]]\njourney = 99\nnumber = 1\n"),
            "bus.toml line 2: the block has no journey 99");
}

TEST(BusSettings, WhatIsPrintedByDefaultIsReadAsTheSame) {
  const std::string text = whole("");
  EXPECT_TRUE(has(text, "\n# capacity = 60")) << text;
  EXPECT_TRUE(has(text, "\ndoors = [\"in\", \"both\"]"));
  EXPECT_EQ(whole(text.substr(text.find("network = \"bus\"\n") + 16)), text);
}

TEST(BusSettings, WhatMakesNoBusIsRefusedInOneLine) {
  EXPECT_EQ(whole("[vehicle]\ncapacity = 0\n"),
            "bus.toml line 3: capacity: 0 is not from 1 to 500");
  EXPECT_EQ(whole("[vehicle]\ndoors = [\"up\"]\n"),
            "bus.toml line 3: doors: 'up' is none of in, out, both");
  EXPECT_EQ(whole("[vehicle]\ndoors = []\n"), "bus.toml line 3: doors: 1 to 4 doors");
  EXPECT_EQ(whole("[next-stop]\nheartbeat = \"2s\"\n"),
            "bus.toml line 3: heartbeat: 2s is not from 100ms to 1s");
  EXPECT_EQ(whole("[on-board-computer]\nheartbeat = \"1s\"\n"),
            "bus.toml line 3: heartbeat: 1s is not from 100ms to 500ms");
  EXPECT_TRUE(has(whole("[ticket-printer]\ncolumns = 3\n"), "columns: is not known here"));
  EXPECT_TRUE(has(whole("[messages]\nmotion = 0x181\n"), "8.1.4.3"));
  EXPECT_TRUE(has(whole("[[device]]\nkind = \"charger\"\nnode = 50\n"), "no device of CiA 407"));
  EXPECT_TRUE(has(whole("[[device]]\nkind = \"generic-io\"\nnode = 1\n"), "is there already"));
}

}  // namespace
}  // namespace canvoy::tools::bus_settings_test
