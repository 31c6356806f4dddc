#include "canvoy/tools/lift_file.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/lift_fault.hpp"

namespace canvoy::tools {
namespace {

LiftRun read(std::string_view text) {
  TomlFile file("house.toml", text);
  std::string network;
  file.table().take("network", network);
  return read_lift_run(file.table(), ".");
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
device = "drive"
)";

TEST(LiftFile, WhatIsWrittenIsReadAsTheSame) {
  LiftRun run;
  run.network = lift::standard_lift_network(
      {.lifts = 2, .floors = 12, .destination_control = true, .seed = 7});
  run.network.building.floors[3].name = "a \"quoted\" \\ name";
  run.network.building.lifts[1].doors = 0b0101;
  run.network.building.lifts[1].speed_m_s = 2.5;
  run.duration = 90s;
  add_lift_faults(run, {"lost-node:lift=2:node=6@10s+5s", "stuck-button:floor=5@1min"});
  run.real = {{1, "can0"}};
  const std::string text = lift_run_text(run);
  const LiftRun again = read(text);
  EXPECT_EQ(lift_run_text(again), text);
  EXPECT_EQ(again.network.nodes, run.network.nodes);
  EXPECT_EQ(again.network.faults, run.network.faults);
  EXPECT_EQ(again.network.people.seed, 7U);
  EXPECT_EQ(again.network.building.floors[3].name, "a \"quoted\" \\ name");
  EXPECT_EQ(again.network.building.lifts[1].doors, 0b0101U);
  EXPECT_TRUE(again.network.people.destination_control);
  EXPECT_EQ(again.duration, 90s);
  ASSERT_EQ(again.real.size(), 1U);
  EXPECT_EQ(again.real[0].bus, 1U);
}

TEST(LiftFile, KeepsWhereCarsWithoutACallGo) {
  LiftRun run;
  lift::StandardLifts options;
  options.traffic.pattern = lift::TrafficPattern::up_peak;
  run.network = lift::standard_lift_network(options);
  const LiftRun again = read(lift_run_text(run));
  EXPECT_EQ(again.network.service.parking_floor, 1);
  EXPECT_EQ(again.network.service.parking_after, 1s);
  EXPECT_EQ(lift_run_text(again), lift_run_text(run));
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
  const LiftRun again = read(lift_run_text(run));
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
  EXPECT_TRUE(read(with_bus).network.nodes.empty());
}

TEST(LiftFile, TellsTheLineOfWhatIsWrong) {
  const std::string house(small_house);
  EXPECT_EQ(refusal(house + "speed = 5"),
            "house.toml line 13: speed: is not known here; there are bus, id, device, lift, doors, "
            "floors, played, configuration, values");
  EXPECT_EQ(refusal(house + "doors = [5]"), "house.toml line 13: doors: 5 is not from 1 to 4");
  EXPECT_EQ(refusal("[building]\nheights_m = [0]\npopulations = [1, 2]"),
            "house.toml line 3: populations: 2 for 1 floors");
  EXPECT_EQ(refusal(house + "[[node]]\nbus = \"lift2\""),
            "house.toml line 14: bus: 'lift2' is no bus; write [[bus]] with this name");
  EXPECT_EQ(refusal(house + "[[node]]\nbus = \"lift1\"\ndevice = \"boat\""),
            "house.toml line 15: device: 'boat' is none, as drive or landing-panel");
  EXPECT_EQ(refusal(house + "[traffic]\npattern = \"rush\""),
            "house.toml line 14: pattern: 'rush' is no traffic: up-peak, down-peak, interfloor, "
            "lunch");
  EXPECT_EQ(refusal("faults = [\"flood@1s\"]" + house).substr(0, 60),
            "house.toml line 1: faults: fault 'flood@1s': no such fault; ");
}

TEST(LiftFault, IsReadAndWrittenInOneForm) {
  for (const char* text : {"dead-encoder@10min", "lost-node:lift=2:node=6@10s+30s",
                           "stuck-button:floor=5@1h+2min", "cable-cut:group:node=2@90s"}) {
    EXPECT_EQ(lift_fault_text(parse_lift_fault(text)), text);
  }
  EXPECT_EQ(lift_fault_text(parse_lift_fault("fire-alarm:lift=0@90s")), "fire-alarm:group@90s");
}

TEST(LiftFault, SaysWhatIsWrong) {
  const auto why = [](std::string_view text) -> std::string {
    try {
      static_cast<void>(parse_lift_fault(text));
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why("flood@1s").substr(0, 34), "fault 'flood@1s': no such fault; t");
  EXPECT_EQ(why("lost-node"),
            "fault 'lost-node': when? write lost-node@20min or lost-node@20min+30s");
  EXPECT_EQ(why("lost-node:lift=9@1s"), "fault 'lost-node:lift=9@1s': '9' is no number up to 8");
  EXPECT_EQ(why("lost-node:lift=@1s"), "fault 'lost-node:lift=@1s': '' is no number up to 8");
  EXPECT_EQ(why("lost-node:house=1@1s"),
            "fault 'lost-node:house=1@1s': 'house=1' is no place; there are lift=, group, "
            "node= and floor=");
  EXPECT_EQ(why("lost-node@soon").substr(0, 43), "fault 'lost-node@soon': the start is a numb");
}

}  // namespace
}  // namespace canvoy::tools
