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

TEST(BusSettings, ATrainOfFourCarsIsWrittenDown) {
  const std::string lines =
      "[vehicle]\ncars = 4\n[third-gateway]\nheartbeat = \"250ms\"\n"
      "[fourth-next-stop]\ncolumns = 30\n[[device]]\nkind = \"generic-io\"\nnode = 60\ncar = 4\n";
  const std::string text = whole(lines);
  EXPECT_TRUE(has(text, "\ncars = 4")) << text;
  EXPECT_TRUE(has(text, "\n[third_bus]"));
  EXPECT_TRUE(has(text, "\n[third-gateway]  # node 41\nplayed = true\nheartbeat = \"250ms\"\n"));
  EXPECT_TRUE(has(text, "\n[fourth-next-stop]  # node 55\n"));
  EXPECT_TRUE(has(text, "\ncar = 4"));
  EXPECT_EQ(whole(text.substr(text.find("network = \"bus\"\n") + 16)), text);
  EXPECT_FALSE(has(whole("[vehicle]\ncars = 3\n"), "\n[fourth"));
  EXPECT_FALSE(has(whole(""), "\n[third"));
  EXPECT_EQ(whole("[third-announcer]\nplayed = true\n"),
            "bus.toml line 2: third-announcer: the bus has 2 cars");
  EXPECT_EQ(whole("[fourth_bus]\nreal = \"can3\"\n[vehicle]\ncars = 3\n"),
            "bus.toml line 2: fourth_bus: the bus has 3 cars");
  EXPECT_EQ(whole("[vehicle]\ncars = 5\n"), "bus.toml line 3: cars: 5 is not from 1 to 4");
  EXPECT_EQ(whole("[vehicle]\ncars = 3\n[[device]]\nkind = \"generic-io\"\nnode = 60\ncar = 4\n"),
            "bus.toml line 4: the bus has 3 cars");
  EXPECT_EQ(whole("[vehicle]\ncars = 3\n[[device]]\nkind = \"generic-io\"\nnode = 41\n"),
            "bus.toml line 4: node 41 is there already");
  EXPECT_FALSE(has(whole("[[device]]\nkind = \"generic-io\"\nnode = 41\n"), "already"));
  EXPECT_TRUE(has(whole("[vehicle]\ncars = 3\n[third-next-stop]\nplayed = false\n"),
                  "write real = \"can2\" in [third_bus]"));
  EXPECT_EQ(whole("faults = [\"lost-node:node=41@10min\"]\n"),
            "bus.toml line 2: faults: fault 'lost-node:node=41@10min': there are nodes 1, 2, 4, 5, "
            "6, 7, 8, 9, 10, 11, 12, 13, 16, 20, 21, 22, 30, 31, 34, 35, 39");
  EXPECT_TRUE(has(whole("faults = [\"lost-node:node=41@10min\"]\n[vehicle]\ncars = 3\n"),
                  "lost-node:node=41@10min"));
}

TEST(BusSettings, NodeIdsAreWrittenDown) {
  const std::string text = whole(
      "[next-stop]\nid = 15\n[vehicle-gateway]\nid = 17\n[ticket-canceller]\nid = 6\n"
      "[[device]]\nkind = \"generic-io\"\nnode = 5\n");
  EXPECT_TRUE(has(text, "\n[next-stop]  # node 15\nid = 15  # its node-ID; without it 5\n"))
      << text;
  EXPECT_TRUE(has(text, "\nmotion = 0x191"));
  EXPECT_TRUE(has(text, "\n[ticket-canceller]  # node 6\nplayed = true\n"));
  EXPECT_EQ(whole(text.substr(text.find("network = \"bus\"\n") + 16)), text);
  EXPECT_TRUE(
      has(whole("[messages]\nmotion = 0x18B\n[vehicle-gateway]\nid = 17\n"), "\nmotion = 0x18B"));
  EXPECT_EQ(whole("[next-stop]\nid = 128\n"), "bus.toml line 3: id: 128 is not from 1 to 127");
  EXPECT_EQ(whole("[next-stop]\nid = 0\n"), "bus.toml line 3: id: 0 is not from 1 to 127");
  EXPECT_EQ(whole("[announcer]\nheartbeat = \"1s\"\n[next-stop]\nid = 6\n"),
            "bus.toml line 4: next-stop: id: node 6 is ticket-canceller too");
  EXPECT_EQ(whole("[next-stop]\nid = 50\n[[device]]\nkind = \"generic-io\"\nnode = 50\n"),
            "bus.toml line 4: node 50 is there already");
  EXPECT_TRUE(has(whole("[messages]\nmotion = 0x18F\n[next-stop]\nid = 15\n"),
                  "18Fh is of a TPDO of node 15"));
  EXPECT_TRUE(has(whole("faults = [\"lost-node:node=15@10min\"]\n[next-stop]\nid = 15\n"),
                  "lost-node:node=15@10min"));
  EXPECT_TRUE(has(whole("faults = [\"lost-node:node=5@10min\"]\n[next-stop]\nid = 15\n"),
                  "there are nodes 1, 2, 4, 6, 7, 8, 9, 10, 11, 12, 13, 15, 16, 20"));
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
