// A bus by the design of a fleet: other messages, heartbeats, doors and capacity, and all 24
// virtual devices.
#include "canvoy/worlds/bus_line/bus_design.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "canvoy/worlds/bus_line/bus_day_test.hpp"

namespace canvoy::bus_line::bus_design_test {
namespace {

/// Counts the frames of the first car by CAN-ID, and keeps the last data byte of heartbeats.
struct Tap {
  std::map<std::uint32_t, unsigned> frames;
  std::map<std::uint32_t, std::uint8_t> last_byte;

  void join(BusNetwork& network) {
    network.world().bus(0).observe(
        {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
           auto& tap = *static_cast<Tap*>(self);
           ++tap.frames[frame.id];
           if (frame.length != 0) tap.last_byte[frame.id] = frame.data[0];
         }});
  }
};

/// A bus that is driven, with the frames on the cable of its first car. All invariants hold at the
/// end.
struct Driven {
  Driven(const BusNetworkOptions& options, Duration time) : network(options) {
    EXPECT_EQ(problem_of(options.design), "");
    tap.join(network);
    network.run_until(Time(time));
    EXPECT_EQ(broken(network), "");
  }

  BusNetwork network;
  Tap tap;
};

/// Clause 6 has 24 virtual devices, ten of which are on no bus here by default.
TEST(BusDesign, All24VirtualDevicesRideAlong) {
  BusNetworkOptions options = with_seed(1);
  NodeId next = 50;
  for (const char* kind : {"ticket-reader", "acoustic-control-manager", "data-radio", "voice-radio",
                           "short-range-communication", "console-display", "console-keyboard",
                           "diagnostics", "generic-io", "bus-power-supply"}) {
    options.design.added.push_back({.kind = kind, .id = next++});
  }
  Driven bus(options, 12min);
  std::set<std::uint8_t> codes;
  for (const auto& node : bus.network.nodes()) {
    const Dictionary& dictionary = node->node().dictionary();
    const auto code = static_cast<std::uint8_t>(dictionary.word(0x1000, 0) >> 24);
    if (code != 0) codes.insert(code);
    for (std::uint8_t sub = 1; code == 0 && sub <= 2; ++sub) {
      codes.insert(static_cast<std::uint8_t>(dictionary.word(0x6000, sub) >> 8));
    }
  }
  EXPECT_EQ(codes.size(), 24u);
  EXPECT_EQ(*codes.begin(), 0x01);
  EXPECT_EQ(*codes.rbegin(), 0x18);
  for (NodeId id = 50; id < next; ++id) {
    EXPECT_EQ(bus.tap.last_byte[0x700U + id], 0x05) << "node " << unsigned{id} << " is operational";
    EXPECT_GT(bus.tap.frames[0x700U + id], 600u);
  }
}

/// FF01h of the ticket printer (7.3) is in 6740h, with its node-ID (9.2.27.1): once, by SDO.
TEST(BusDesign, ErrorsOfOthersAreWrittenToTheDiagnosticsDevice) {
  BusNetworkOptions options = with_seed(1);
  options.design.added = {{.kind = "diagnostics", .id = 50}};
  options.faults.faults = {{.kind = FaultKind::no_paper, .start = Time(2min), .duration = 1min},
                           {.kind = FaultKind::no_paper, .start = Time(5min), .duration = 1min}};
  BusNetwork network(options);
  std::vector<std::string> written;
  network.world().bus(0).observe(
      {.context = &written, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
         if (frame.id != 0x632) return;
         std::string text;
         for (const std::uint8_t byte : frame.payload()) {
           char hex[4];
           std::snprintf(hex, sizeof hex, "%02X ", byte);
           text += hex;
         }
         static_cast<std::vector<std::string>*>(self)->push_back(text);
       }});
  network.run_until(Time(4min));
  EXPECT_EQ(written, std::vector<std::string>{"23 40 67 01 01 FF 07 00 "});
  network.run_until(Time(7min));
  EXPECT_EQ(written.size(), 2u);
  const Dictionary& dictionary = network.node(50).node().dictionary();
  EXPECT_EQ(dictionary.word(0x6740, 0), 2u);
  EXPECT_EQ(dictionary.word(0x6740, 1), 0x0007'FF01u);
  EXPECT_EQ(broken(network), "");
}

/// An added device is watched like the others.
TEST(BusDesign, WhoRidesAlongInTheSecondCarIsStartedThere) {
  BusNetworkOptions options = with_seed(1);
  options.design.added = {{.kind = "generic-io", .id = 50, .car = 2}};
  BusNetwork network(options);
  network.run_until(Time(1min));
  EXPECT_TRUE(network.node(50).is_operational());
  EXPECT_EQ(network.node(50).bus(), network.node(gateway_of(2)).bus());
  network.node(50).power(false);
  network.run_until(Time(2min));
  EXPECT_EQ(broken(network), "device_missing ");
}

TEST(BusDesign, MessagesHaveTheCanIdsOfTheFleet) {
  BusNetworkOptions options = with_seed(1);
  options.design.ids = {.motion = 0x1C8,
                        .mileage = 0x2C8,
                        .position = 0x1C9,
                        .movement = 0x2C9,
                        .universal_time = 0x3C9,
                        .first_count = 0x2CA,
                        .second_count = 0x2CB,
                        .aboard = 0x2CC,
                        .train_stop_request = 0x1CD,
                        .stop_request = 0x1CE};
  Driven bus(options, 40min);
  for (const std::uint32_t id :
       {0x1C8U, 0x2C8U, 0x1C9U, 0x2C9U, 0x3C9U, 0x2CAU, 0x2CBU, 0x2CCU, 0x1CDU, 0x1CEU}) {
    EXPECT_GT(bus.tap.frames[id], 0u) << std::hex << id;
  }
  for (const std::uint32_t id :
       {0x18BU, 0x28BU, 0x190U, 0x290U, 0x390U, 0x294U, 0x296U, 0x295U, 0x19EU, 0x1C1U}) {
    EXPECT_EQ(bus.tap.frames[id], 0u) << std::hex << id;
  }
  EXPECT_TRUE(bus.network.heard().position(bus.network.now()));
  EXPECT_TRUE(bus.network.heard().aboard(bus.network.now()));
}

TEST(BusDesign, HeartbeatsAreAsQuickAsIsWritten) {
  BusNetworkOptions options = with_seed(1);
  options.design.heartbeats = {{printer_id, 200ms}, {computer_id, 250ms}};
  Driven bus(options, 1min);
  const auto is_near = [&](NodeId id, unsigned per_minute) {
    const unsigned count = bus.tap.frames[0x700U + id];
    return count >= per_minute - 3 && count <= per_minute + 3;
  };
  EXPECT_TRUE(is_near(printer_id, 300)) << bus.tap.frames[0x707];
  EXPECT_TRUE(is_near(computer_id, 240)) << bus.tap.frames[0x701];
  EXPECT_TRUE(is_near(canceller_id, 60)) << bus.tap.frames[0x706];
}

/// A bus of 18 m: four doors, each with its counter, and room for 140 people.
TEST(BusDesign, FourDoorsAreCounted) {
  BusNetworkOptions options = with_seed(1);
  options.design.doors = {{.boards = true, .alights = false}, {}, {}, {}};
  options.design.capacity = 140;
  options.design.added = {{.kind = "passenger-counter", .id = 23, .door = 3},
                          {.kind = "passenger-counter", .id = 24, .door = 4}};
  options.vehicle.riders.boarding_mean = 12;
  Driven bus(options, 40min);
  EXPECT_GT(bus.tap.frames[0x297], 0u) << "of door 3";
  EXPECT_GT(bus.tap.frames[0x298], 0u);
  EXPECT_EQ(bus.network.vehicle().door_count(), 4u);
  EXPECT_GT(bus.network.vehicle().riders().statistics().aboard_max, 20u);
}

/// A device without a door has no part in the counts of the doors: those of the second journey
/// are judged, too, which begins at 5:20.
TEST(BusDesign, AnAddedDeviceThatIsLostDoesNotExcuseTheCounters) {
  BusNetworkOptions options = with_seed(1);
  options.design.added = {{.kind = "generic-io", .id = 50}};
  options.faults.faults = {
      {.kind = FaultKind::lost_node, .start = Time(1s), .duration = 42min, .node = 50}};
  BusNetwork network(options);
  const auto judged = [&] {
    const auto all = network.invariants();
    return std::ranges::find(all, InvariantKind::passengers, &Invariant::kind)->judged;
  };
  network.run_until(Time(30min));
  const auto before = judged();
  network.run_until(Time(40min));
  EXPECT_GT(judged(), before);
}

TEST(BusDesign, ASmallBusLeavesPeopleBehind) {
  BusNetworkOptions options = with_seed(1);
  options.design.capacity = 4;
  BusNetwork network(options);
  network.run_until(Time(3h));
  EXPECT_LE(network.vehicle().riders().statistics().aboard_max, 4u);
  EXPECT_GT(network.vehicle().riders().statistics().left_behind, 0u);
  EXPECT_EQ(broken(network), "");
}

TEST(BusDesign, WhatMakesNoBusIsSaid) {
  const auto added = [](AddedDevice device) {
    return problem_of(BusDesign{.added = {std::move(device)}});
  };
  EXPECT_EQ(problem_of(BusDesign{}), "");
  EXPECT_EQ(added({.kind = "charger", .id = 50}),
            "'charger' is no device of CiA 407: canvoy device --list");
  EXPECT_EQ(added({.kind = "identification", .id = 50}),
            "a bus has one identification in a car, and no other");
  EXPECT_EQ(added({.kind = "generic-io", .id = 11}), "node 11 is there already");
  EXPECT_EQ(added({.kind = "generic-io"}), "node: its node-ID is missing");
  EXPECT_EQ(added({.kind = "passenger-counter", .id = 50}),
            "door: of which one it counts is missing");
  EXPECT_EQ(added({.kind = "generic-io", .id = 50, .door = 1}),
            "door: of a passenger-counter alone");
  EXPECT_EQ(added({.kind = "passenger-counter", .id = 50, .door = 3}),
            "there is no door 3 without a counter");
  const auto with_motion = [](std::uint32_t id) {
    BusDesign design;
    design.ids.motion = id;
    return problem_of(design);
  };
  EXPECT_EQ(with_motion(0x181), "181h is that of a pre-defined message (CiA 407, 8.1.4.3)");
  EXPECT_EQ(with_motion(0x186), "186h is of a TPDO of node 6");
  EXPECT_EQ(with_motion(0x190), "190h is of a TPDO of node 16");
  EXPECT_EQ(with_motion(0x1C1), "1C1h is of two messages");
  EXPECT_EQ(with_motion(0x80),
            "80h is no CAN-ID of a PDO: SYNC, EMCY, TIME, SDO and others have it");
  EXPECT_EQ(with_motion(0x601),
            "601h is no CAN-ID of a PDO: SYNC, EMCY, TIME, SDO and others have it");
  BusDesign three;
  three.doors = {{}, {}, {}};
  EXPECT_EQ(problem_of(three), "door 3 wants a passenger-counter of its own");
  BusDesign no_way_out;
  no_way_out.doors = {{.boards = true, .alights = false}};
  EXPECT_EQ(problem_of(no_way_out), "people get in by some door, and out by some door");
}

/// Most buses have one car: nothing is on the second cable, and nothing of it is judged.
TEST(BusDesign, ABusOfOneCar) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    BusNetworkOptions options;
    options.faults.seed = seed;
    options.design.cars = 1;
    options.length = 40min;
    BusNetwork network(options);
    network.run_until(network.end());
    const BusNetworkSnapshot end = network.snapshot();
    EXPECT_EQ(end.buses[1].frames, 0U);
    EXPECT_EQ(end.nodes.size(), 16U) << "21 less four of the second car and the train gateway";
    EXPECT_EQ(end.names.size(), 16U);
    EXPECT_EQ(end.displays.size(), 4U);
    EXPECT_EQ(network.invariants().size(), invariant_kinds - 3 * kinds_of_a_car);
    for (const Invariant& invariant : network.invariants()) {
      EXPECT_TRUE(invariant.held) << invariant_name(invariant.kind).name << " of seed " << seed;
    }
    EXPECT_GT(end.riders.out, 0U);
  }
}

}  // namespace
}  // namespace canvoy::bus_line::bus_design_test
