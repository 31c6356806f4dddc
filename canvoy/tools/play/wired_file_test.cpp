// Hands of network files of lifts and chargers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/lift_world.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools::wired_file_test {
namespace {

const WorldEntry& world_of(std::string_view name) {
  for (const WorldEntry& world : worlds()) {
    if (world.name == name) return world;
  }
  throw Failure("no such world");
}

/// Four floors and an empty building; sensors in the car.
std::string quiet_house() {
  LiftRun run;
  run.network = lift::standard_lift_network({.floors = 4});
  run.network.traffic.percent_in_5_minutes = 0;
  run.network.nodes.push_back({.id = 14, .kind = lift::DeviceKind::sensors});
  return run_text<LiftWorld>(run);
}

/// `at device [key=value ...] press|set=order`, one per hand.
std::string hand(std::string_view at, std::string_view device, std::string_view order,
                 std::string_view rest = "") {
  return fmt::format("[[hands]]\nat = \"{}\"\ndevice = \"{}\"\n{}{}\n", at, device, rest, order);
}

/// A world of a file, and its error.
struct Made {
  explicit Made(std::string_view world, std::string text) {
    if (world == "charger") text.insert(0, "network = \"charger\"\n");
    TomlFile file("house.toml", text);
    std::string network;
    file.table().take("network", network);
    try {
      heard = world_of(world).make(file.table(), "");
    } catch (const Failure& failure) {
      complaint = failure.what();
    }
  }
  /// JSON Lines.
  std::string events_until(Time until) {
    heard.network->run_until(until);
    std::string events;
    for (std::size_t i = 0; i < heard.network->event_count(); ++i) {
      events += heard.network->event(i).json + "\n";
    }
    return events;
  }
  nlohmann::ordered_json car_at(Time at) {
    heard.network->run_until(at);
    return heard.network->snapshot()["lifts"][0];
  }

  HeardWorld heard;
  std::string complaint;
};

void expect_in(const std::string& events, std::initializer_list<const char*> expected) {
  for (const char* each : expected) {
    EXPECT_NE(events.find(each), std::string::npos) << each << "\n" << events;
  }
}

TEST(LiftFileHands, AButtonAtALandingCallsTheCar) {
  Made house("lift",
             quiet_house() + hand("20s", "lift-landing-panel", "press = \"up\"", "floor = 3\n"));
  ASSERT_EQ(house.complaint, "");
  expect_in(house.events_until(Time(50s)),
            {R"({"time":20.0,"event":"hand","node":23,"hand":"up","bus":"lift1"})",
             R"({"time":20.3,"event":"hand","node":23,"hand":"up=released","bus":"lift1"})",
             R"("event":"lamp","lit":true,"lift":0,"floor":3,"direction":"up")",
             R"("event":"doors","lift":1,"floor":3)"});
}

TEST(LiftFileHands, WhatStandsInADoorKeepsItOpen) {
  const std::string call = hand("20s", "lift-car-panel", "press = \"3\"");
  EXPECT_EQ(Made("lift", quiet_house() + call).car_at(Time(50s))["open"], 0.0);
  Made house("lift", quiet_house() + call + hand("30s", "lift-door", "set = \"obstacle=yes\"") +
                         hand("2min", "lift-door", "set = \"obstacle=no\""));
  EXPECT_GT(house.car_at(Time(50s))["open"], 0.5);
  EXPECT_EQ(house.car_at(Time(150s))["open"], 0.0);
}

TEST(LiftFileHands, GoodsComeToWhatPeopleWeigh) {
  Made house("lift", quiet_house() + hand("20s", "lift-load", "set = \"load=2000\""));
  const auto car = house.car_at(Time(30s));
  EXPECT_EQ(car["load_kg"], 2000.0);
  EXPECT_EQ(car["overload"], true);
}

TEST(LiftFileHands, AStopSwitchHoldsTheCarAndASensorTells) {
  Made house("lift", quiet_house() + hand("10s", "lift-drive", "set = \"safety-chain=open\"") +
                         hand("20s", "lift-car-panel", "press = \"4\"") +
                         hand("70s", "lift-drive", "set = \"safety-chain=closed\"") +
                         hand("80s", "lift-sensors", "set = \"smoke=signal\""));
  EXPECT_EQ(house.car_at(Time(65s))["floor"], 1);
  EXPECT_EQ(house.car_at(Time(3min))["floor"], 4);
  expect_in(house.events_until(Time(3min)),
            {R"({"time":80.0,"event":"hand","node":14,"hand":"smoke=signal","bus":"lift1"})"});
}

TEST(LiftFileHands, AreWrittenAsTheyWereRead) {
  const std::string text =
      quiet_house() +
      hand("20s", "lift-landing-panel", "press = \"up\"", "node = 23\nfloor = 3\n") +
      hand("30s", "lift-door", "set = \"lock-bolt=sprung\"");
  TomlFile file("house.toml", text);
  std::string network;
  file.table().take("network", network);
  const std::string written = world_of("lift").rewrite(file.table(), "");
  expect_in(written, {"\n[[hands]]\nat = \"20s\"\ndevice = \"lift-landing-panel\"\npress = \"up\"",
                      "\nnode = 23", "\nfloor = 3", "set = \"lock-bolt=sprung\""});
  TomlFile again("house.toml", written);
  again.table().take("network", network);
  EXPECT_EQ(world_of("lift").rewrite(again.table(), ""), written);
}

TEST(LiftFileHands, RefusesHandsThatNobodyHas) {
  const auto complaint = [](const std::string& hands) {
    const std::string all = Made("lift", quiet_house() + hands).complaint;
    const std::size_t begin = all.find(": ");
    return begin == std::string::npos ? all : all.substr(begin + 2);
  };
  EXPECT_EQ(complaint(hand("1s", "lift-dor", "press = \"up\"")), "device: lift 1 has no lift-dor");
  EXPECT_EQ(complaint(hand("1s", "lift-door", "set = \"lock=stuck\"", "lift = 2\n")),
            "device: lift 2 has no lift-door");
  EXPECT_EQ(complaint(hand("1s", "lift-door", "set = \"lock=stuck\"", "node = 7\n")),
            "device: lift 1 has no lift-door with node-ID 7");
  EXPECT_EQ(complaint(hand("1s", "lift-landing-panel", "press = \"up\"", "floor = 9\n")),
            "device: lift 1 has no lift-landing-panel at floor 9");
  EXPECT_EQ(complaint(hand("1s", "lift-door", "press = \"lock=stuck\"")),
            "press: it is set: write set =");
  EXPECT_EQ(complaint(hand("1s", "lift-controller", "press = \"up\"")),
            "press: 'up@0s': lift-controller has no hands: all that it does follows from the bus");
  EXPECT_TRUE(complaint(hand("1s", "lift-landing-panel", "press = \"down\""))
                  .starts_with("press: 'down@0s': nothing here is 'down'"));
}

TEST(ChargerFileHands, PullThePlugAndSetWhatABatterySays) {
  Made garage("charger", "for = \"1h\"\n[bus]\n[charger]\n[battery]\n[manager]\n" +
                             hand("1min", "charger", "set = \"plug=out\"") +
                             hand("2min", "charger", "set = \"plug=in\"") +
                             hand("3min", "battery", "set = \"ready=no\""));
  ASSERT_EQ(garage.complaint, "");
  garage.heard.network->run_until(Time(59s));
  const std::string events = garage.events_until(Time(4min));
  expect_in(events, {R"({"time":60.0,"event":"hand","node":5,"hand":"plug=out"})",
                     R"({"time":180.0,"event":"hand","node":10,"hand":"ready=no"})",
                     R"("event":"phase","battery":0)"});
  EXPECT_EQ(Made("charger", hand("1s", "manager", "set = \"plug=out\"")).complaint,
            "house.toml line 4: device: there is no 'manager': there are charger, battery");
}

}  // namespace
}  // namespace canvoy::tools::wired_file_test
