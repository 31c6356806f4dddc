#include "canvoy/tools/play/lift_world.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::lift_file_test {
namespace {

LiftRun read(std::string_view text) {
  TomlFile file("house.toml", text);
  std::string network;
  file.table().take("network", network);
  return read_run<LiftWorld>(file.table(), ".");
}

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(read(text));
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

constexpr std::string_view small_house = R"(
network = "lift"
[building]
heights_m = [0, 3.5, 7]
populations = [0, 20, 30]
[[lift]]
[[bus]]
name = "lift1"
[[node]]
bus = "lift1"
id = 2
device = "lift-drive"
)";

TEST(LiftFile, WhatIsWrittenIsReadAsTheSame) {
  LiftRun run;
  run.network = lift::standard_lift_network(
      {.lifts = 2, .floors = 12, .destination_control = true, .seed = 7});
  run.network.building.floors[3].name = "a \"quoted\" \\ name";
  run.network.building.lifts[1].doors = 0b0101;
  run.network.building.lifts[1].speed_m_s = 2.5;
  run.duration = 90s;
  add_fault<LiftWorld>(run, "lost-node:lift=2:node=6@10s+5s");
  add_fault<LiftWorld>(run, "stuck-button:floor=5@1min");
  run.real = {{1, "can0"}};
  const std::string text = run_text<LiftWorld>(run);
  const LiftRun again = read(text);
  EXPECT_EQ(run_text<LiftWorld>(again), text);
  EXPECT_EQ(again.network.nodes, run.network.nodes);
  EXPECT_EQ(again.network.faults.faults, run.network.faults.faults);
  EXPECT_EQ(again.network.people.seed, 7U);
  EXPECT_EQ(again.network.building.floors[3].name, "a \"quoted\" \\ name");
  EXPECT_EQ(again.network.building.lifts[1].doors, 0b0101U);
  EXPECT_TRUE(again.network.people.destination_control);
  EXPECT_EQ(again.duration, 90s);
  ASSERT_EQ(again.real.size(), 1U);
  EXPECT_EQ(again.real[0].bus, 1U);
}

TEST(LiftFile, ZonesFloorsKeysAndPanelsAreWrittenAndReadAsTheSame) {
  const std::string text = R"(
network = "lift"
[building]
heights_m = [0, 3.5, 7, 10.5]
populations = [0, 20, 30, 10]
[[zone]]
name = "low \"rise\""
floors = [1, 2, 3]
[[lift]]
zone = "low \"rise\""
doors = [1, 2]
floors = [1, 2, 3, 4]
floors_of_door_2 = [1]
locked_by_key_1 = [3]
locked_by_key_4 = [2, 3]
[[bus]]
name = "lift1"
[[node]]
bus = "lift1"
id = 16
device = "lift-car-panel"
keys = ["door-open", "vip-service"]
displays = ["arrival", "overload"]
parameters = true
[[node]]
bus = "lift1"
id = 21
device = "landing-panel"
floors = [1]
keys = []
)";
  const LiftRun run = read(text);
  const lift::LiftDesign& design = run.network.building.lifts[0];
  EXPECT_EQ(run.network.building.zones[0].floors, (lift::FloorList{1, 2, 3}));
  EXPECT_EQ(design.floors_of_door[1], lift::FloorList{1});
  EXPECT_EQ(design.locked_by_key[3], (lift::FloorList{2, 3}));
  EXPECT_EQ(run.network.building.doors_at(1, 1), 0b11U);
  EXPECT_EQ(run.network.building.doors_at(1, 3), 0b01U);
  EXPECT_EQ(run.network.building.doors_at(1, 4), 0U) << "not of its zone";
  const lift::PanelDescription& panel = run.network.nodes[0].panel;
  EXPECT_EQ(panel.keys->at(1), cia417::SpecialFunction::vip_service);
  EXPECT_EQ(panel.displays->at(0).function, cia417::BasicFunction::arrival_indication);
  EXPECT_TRUE(panel.parameters);
  EXPECT_TRUE(run.network.nodes[1].panel.keys->empty());
  EXPECT_FALSE(run.network.nodes[1].panel.displays);
  const std::string written = run_text<LiftWorld>(run);
  const LiftRun again = read(written);
  EXPECT_EQ(run_text<LiftWorld>(again), written);
  EXPECT_EQ(again.network.nodes, run.network.nodes);
  EXPECT_EQ(again.network.building.lifts[0].locked_by_key, design.locked_by_key);
  EXPECT_EQ(again.network.building.lifts[0].zone, "low \"rise\"");
}

TEST(LiftFile, KeepsWhereCarsWithoutACallGo) {
  LiftRun run;
  lift::StandardLifts options;
  options.traffic.pattern = lift::TrafficPattern::up_peak;
  run.network = lift::standard_lift_network(options);
  const LiftRun again = read(run_text<LiftWorld>(run));
  EXPECT_EQ(again.network.service.parking_floor, 1);
  EXPECT_EQ(again.network.service.parking_after, 1s);
  EXPECT_EQ(run_text<LiftWorld>(again), run_text<LiftWorld>(run));
}

TEST(LiftFile, ANodeIsGivenValuesInTheirOrder) {
  const LiftRun run = read(std::string(small_house) + R"(values = [
  "1017 0 u16 500", "1904 1 u32 0x80000194", "1904 1 u32 0x194", "1008 0 vs \"a b\""])");
  const std::vector<NodeValue> wanted = {{0x1017, 0, {0xF4, 0x01}},
                                         {0x1904, 1, {0x94, 0x01, 0x00, 0x80}},
                                         {0x1904, 1, {0x94, 0x01, 0x00, 0x00}},
                                         {0x1008, 0, {'a', ' ', 'b'}}};
  ASSERT_EQ(run.network.nodes.size(), 1U);
  EXPECT_EQ(run.network.nodes[0].values, wanted);
  const LiftRun again = read(run_text<LiftWorld>(run));
  EXPECT_EQ(again.network.nodes[0].values, wanted);
}

TEST(LiftFile, AValueThatCannotBeReadIsToldWithItsLine) {
  EXPECT_EQ(refusal(std::string(small_house) + R"(values = ["1017 0 u16 500", "1017 0 u99 1"])"),
            "house.toml line 13: values: values line 2: 'u99' is no data type: b, i8 to i64, u8 "
            "to u64, r32, r64, vs, os, us, d");
}

TEST(LiftFile, ARealDeviceIsGivenNoValues) {
  std::string text = std::string(small_house) + "played = false\nvalues = [\"1017 0 u16 500\"]";
  text.replace(text.find("name = \"lift1\""), 14, "name = \"lift1\"\nreal = \"can0\"");
  EXPECT_EQ(refusal(text),
            "house.toml line 15: values: who is not played is configured by whoever plays it");
}

TEST(LiftFile, AFloorWithoutANameHasItsNumber) {
  const LiftRun run = read(small_house);
  EXPECT_EQ(run.network.building.floors[2].name, "3");
  EXPECT_EQ(run.network.building.floors[2].height_m, 7);
  EXPECT_EQ(run.network.nodes.size(), 1U);
}

TEST(LiftFile, ADeviceThatIsNotPlayedNeedsARealBus) {
  const std::string text = std::string(small_house) + "played = false\n";
  EXPECT_EQ(refusal(text),
            "house.toml line 13: played: who is not played is on a real bus: write real = "
            "\"can0\" at its bus");
  std::string with_bus = text;
  with_bus.replace(with_bus.find("name = \"lift1\""), 14, "name = \"lift1\"\nreal = \"can0\"");
  const LiftRun run = read(with_bus);
  ASSERT_EQ(run.network.nodes.size(), 1U) << "its node-ID stays in the network";
  EXPECT_EQ(run.network.nodes[0].id, 2);
  EXPECT_FALSE(run.network.nodes[0].played);
  const std::string written = run_text<LiftWorld>(run);
  EXPECT_NE(written.find("played = false"), std::string::npos);
  EXPECT_EQ(read(written).network.nodes, run.network.nodes);
  EXPECT_EQ(
      refusal("faults = [\"lost-node@1s\"]" + with_bus),
      "house.toml line 1: fault lost-node: lift-drive with node-ID 2 is a real one, and is not "
      "broken here");
}

TEST(LiftFile, TellsTheLineOfWhatIsWrong) {
  const std::string house(small_house);
  EXPECT_EQ(
      refusal(house + "speed = 5"),
      "house.toml line 13: speed: is not known here; there are bus, id, device, lift, floors, "
      "doors, keys, displays, calls, parameters, played, configuration, values");
  EXPECT_EQ(refusal(house + "keys = [\"bell\"]").substr(0, 60),
            "house.toml line 13: keys: 'bell' is none; there are fan-1, f");
  EXPECT_EQ(refusal(house + "displays = [\"arrival\", \"arrival\"]"),
            "house.toml line 13: displays: 'arrival' is given twice");
  EXPECT_EQ(refusal(house + "keys = [\"fan-1\"]"),
            "house.toml line 1: lift-drive with node-ID 2 is no panel");
  std::string zoned = house;
  zoned.replace(zoned.find("[[lift]]"), 8, "[[lift]]\nzone = \"high\"");
  EXPECT_EQ(refusal(zoned),
            "house.toml line 1: lift 1: there is no zone 'high'; write [[zone]] with this name");
  zoned.replace(zoned.find("zone = "), 13, "floors = [4]");
  EXPECT_EQ(refusal(zoned), "house.toml line 1: lift 1 names floor 4, which is not there");
  EXPECT_EQ(refusal(house + "doors = [5]"), "house.toml line 13: doors: 5 is not from 1 to 4");
  EXPECT_EQ(refusal("[building]\nheights_m = [0]\npopulations = [1, 2]"),
            "house.toml line 3: populations: 2 for 1 floors");
  EXPECT_EQ(refusal(house + "[[node]]\nbus = \"lift2\""),
            "house.toml line 14: bus: 'lift2' is no bus; write [[bus]] with this name");
  EXPECT_EQ(refusal(house + "[[node]]\nbus = \"lift1\"\ndevice = \"boat\""),
            "house.toml line 15: device: 'boat' is none, as lift-drive or lift-landing-panel");
  EXPECT_EQ(refusal(house + "[traffic]\npattern = \"rush\""),
            "house.toml line 14: pattern: 'rush' is no traffic: up-peak, down-peak, interfloor, "
            "lunch");
  EXPECT_EQ(refusal("faults = [\"flood@1s\"]" + house).substr(0, 60),
            "house.toml line 1: faults: fault 'flood@1s': no such fault; ");
}

TEST(LiftFault, SaysWhatIsWrong) {
  const auto why = [](const std::string& text) -> std::string {
    LiftRun run;
    try {
      add_fault<LiftWorld>(run, text);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why("lost-node:lift=9@1s"),
            "fault 'lost-node:lift=9@1s': '9' is no number from 1 to 8");
  EXPECT_EQ(why("lost-node:house=1@1s"),
            "fault 'lost-node:house=1@1s': 'house=1' is no place; there are lift=, group, node=, "
            "floor=");
}

}  // namespace
}  // namespace canvoy::tools::lift_file_test
