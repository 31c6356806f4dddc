// A bus whose devices have other node-IDs than the usual ones: all that hangs on a node-ID follows.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"

#include "canvoy/worlds/bus_line/bus_day_test.hpp"

namespace canvoy::bus_line::bus_node_ids_test {
namespace {

constexpr unsigned further = 70;

/// Each device 70 further.
BusNetworkOptions moved() {
  BusNetworkOptions options = with_seed(1);
  for (const DevicePlace& place : places_of(2)) {
    options.design.node_ids[place.id] = static_cast<NodeId>(place.id + further);
  }
  return options;
}

/// CAN-IDs on the cable of a car.
struct Seen {
  std::set<std::uint32_t> ids;

  Seen(BusNetwork& network, BusIndex bus) {
    network.world().bus(bus).observe(
        {.context = this, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
           static_cast<Seen*>(self)->ids.insert(frame.id);
         }});
  }
};

/// The CAN-IDs of the usual bus with other node-IDs: NMT, the messages of 8.1.4.3 and the stop
/// request are of none.
std::set<std::uint32_t> moved(const std::set<std::uint32_t>& usual) {
  const std::set<std::uint32_t> of_none = {0x000, 0x181, 0x381, 0x401, 0x481,
                                           0x501, 0x201, 0x281, 0x301, 0x1C1};
  std::set<std::uint32_t> ids;
  for (const std::uint32_t id : usual) ids.insert(of_none.contains(id) ? id : id + further);
  return ids;
}

/// Heartbeats (700h), SDO (580h, 600h) and PDOs have the new node-IDs.
TEST(BusNodeIds, AllCanIdsFollow) {
  BusNetwork usual(with_seed(1));
  BusNetwork network(moved());
  EXPECT_EQ(problem_of(network.options().design), "");
  Seen before[] = {{usual, 0}, {usual, 1}};
  Seen seen[] = {{network, 0}, {network, 1}};
  usual.run_until(Time(15min));
  network.run_until(Time(15min));
  EXPECT_EQ(seen[0].ids, moved(before[0].ids));
  EXPECT_EQ(seen[1].ids, moved(before[1].ids));
  for (const std::uint32_t id : {0x700U + 71, 0x180U + 81, 0x600U + 75, 0x580U + 100}) {
    EXPECT_TRUE(seen[0].ids.contains(id)) << id;
  }
  for (const std::uint32_t id : {0x700U + 101, 0x600U + 105, 0x700U + 109}) {
    EXPECT_TRUE(seen[1].ids.contains(id)) << id;
  }
  EXPECT_EQ(broken(network), "");
}

/// 1016h, sub-index 1: the node-ID of who is watched in bits 16 to 22.
TEST(BusNodeIds, HeartbeatsOfTheMasterAreWatched) {
  BusNetwork network(moved());
  network.run_until(Time(1min));
  for (const auto& node : network.nodes()) {
    const NodeId id = node->place().id;
    if (id == 71 || id == 101) continue;
    EXPECT_EQ(node->node().dictionary().word(0x1016, 1) >> 16, id < 101 ? 71U : 101U)
        << "node " << unsigned{id};
    EXPECT_TRUE(node->is_operational());
  }
}

/// Texts by display, without the node-ID.
std::map<std::string, std::vector<std::string>> texts_of(const BusNetwork& network) {
  std::map<std::string, std::vector<std::string>> texts;
  for (const NetworkEvent& event : network.events()) {
    const auto* shown = std::get_if<DisplayShows>(&event.what);
    if (shown == nullptr) continue;
    const std::string name(name_of(network.options().design, shown->node));
    if (texts[name].empty() || texts[name].back() != shown->text) {
      texts[name].push_back(shown->text);
    }
  }
  return texts;
}

TEST(BusNodeIds, PeopleReadTheSame) {
  BusNetwork usual(with_seed(1));
  BusNetwork network(moved());
  usual.run_until(Time(30min));
  network.run_until(Time(30min));
  const auto texts = texts_of(usual);
  EXPECT_EQ(texts.size(), 6U);
  EXPECT_EQ(texts_of(network), texts);
  const BusNetworkSnapshot end = network.snapshot();
  EXPECT_EQ(end.riders.in, usual.snapshot().riders.in);
  EXPECT_EQ(end.displays.front().node, 74);
  EXPECT_EQ(end.nodes.front().id, 71);
  EXPECT_EQ(end.names.front(), "on-board-computer");
}

/// A listener knows who sends what (canvoy run bus --gtfs-rt).
TEST(BusNodeIds, AListenerHearsTheDevicesThatHaveMoved) {
  BusNetwork network(moved());
  network.run_until(Time(12min));
  EXPECT_TRUE(network.heard().stop(network.now()).has_value());
  EXPECT_TRUE(network.heard().position(network.now()).has_value());
  EXPECT_TRUE(network.heard().odometer(network.now()).has_value());
  EXPECT_TRUE(network.heard().aboard(network.now()).has_value());
  network.node(86).power(false);
  network.run_until(Time(12min + 10s));
  EXPECT_FALSE(network.heard().position(network.now()).has_value()) << "positioning is lost";
}

/// A fault names its node by the node-ID on the cable; without one it is at the usual device.
TEST(BusNodeIds, FaultsAreAtTheDevicesThatHaveMoved) {
  std::size_t count = 0;
  for (const DevicePlace& place : places_of(2)) {
    if (count++ % 4 != 0 && !tries_all()) continue;
    BusNetworkOptions options = moved();
    const auto id = static_cast<NodeId>(place.id + further);
    options.faults.faults = {{.start = Time(9min + 20s), .duration = 60s, .node = id}};
    BusNetwork network(options);
    network.run_until(Time(10min));
    EXPECT_FALSE(network.node(id).is_powered()) << place.name;
    network.run_until(Time(21min));
    EXPECT_EQ(broken(network), "") << place.name;
    EXPECT_TRUE(network.node(id).is_operational()) << place.name;
  }
  BusNetworkOptions options = moved();
  options.faults.faults = {{.start = Time(2min), .duration = 10s},
                           {.kind = FaultKind::restart, .start = Time(4min)},
                           {.kind = FaultKind::cable_cut, .start = Time(6min), .duration = 10s}};
  BusNetwork network(options);
  network.run_until(Time(9min));
  std::vector<unsigned> places;
  for (const NetworkEvent& event : network.events()) {
    const auto* began = std::get_if<FaultBegan>(&event.what);
    if (began != nullptr) places.push_back(began->place.node);
  }
  EXPECT_EQ(places, (std::vector<unsigned>{75, 71, 71}))
      << "next stop indicator, computer, computer";
}

/// Two devices change their places, and a third one rides along at a node-ID that is free then.
TEST(BusNodeIds, ANodeIdThatIsFreeIsFree) {
  BusNetworkOptions options = with_seed(1);
  options.design.node_ids = {
      {next_stop_id, 8}, {information_id, 15}, {canceller_id, 7}, {printer_id, 6}};
  options.design.added = {{.kind = "generic-io", .id = 5}};
  BusNetwork network(options);
  EXPECT_EQ(problem_of(options.design), "");
  network.run_until(Time(12min));
  EXPECT_EQ(network.display(8).text(), network.vehicle().truth().stop->name);
  EXPECT_EQ(network.display(15).text().substr(0, 14), "407 to Harbour");
  EXPECT_EQ(network.find_display(5), nullptr);
  EXPECT_EQ(name_of(options.design, 7), "ticket-canceller");
  EXPECT_EQ(name_of(options.design, 5), "generic-io");
  EXPECT_TRUE(network.node(5).is_operational());
  EXPECT_EQ(broken(network), "");
  network.node(5).power(false);
  network.run_until(Time(13min));
  EXPECT_EQ(broken(network), "device_missing ");
}

/// A CAN-ID that the design states stays where the sender moves.
TEST(BusNodeIds, ACanIdThatIsWrittenDownStays) {
  BusDesign design;
  design.node_ids = {{vehicle_gateway_id, 17}};
  EXPECT_EQ(message_ids(design).motion, 0x191U);
  EXPECT_EQ(message_ids(design).mileage, 0x291U);
  design.ids.motion = 0x18B;
  EXPECT_EQ(message_ids(design).motion, 0x18BU);
  EXPECT_EQ(message_ids(design).mileage, 0x291U);
  EXPECT_EQ(message_ids({}).position, 0x190U);
  EXPECT_EQ(message_ids({}).universal_time, 0x390U);
  EXPECT_EQ(message_ids({}).train_stop_request, 0x19EU);
}

TEST(BusNodeIds, WhatCollidesIsSaid) {
  const auto problem = [](std::map<DeviceKey, NodeId> ids, unsigned cars = 2) {
    return problem_of(BusDesign{.cars = cars, .node_ids = std::move(ids)});
  };
  EXPECT_EQ(problem({{next_stop_id, 15}}), "");
  EXPECT_EQ(problem({{next_stop_id, 6}}), "next-stop: node 6 is ticket-canceller too");
  EXPECT_EQ(problem({{next_stop_id, 35}}), "next-stop: node 35 is second-next-stop too");
  EXPECT_EQ(problem({{next_stop_id, 45}}), "");
  EXPECT_EQ(problem({{next_stop_id, 45}}, 3), "next-stop: node 45 is third-next-stop too");
  EXPECT_EQ(problem({{next_stop_id, 0}}), "next-stop: node 0 is none from 1 to 127");
  EXPECT_EQ(problem({{next_stop_id, 128}}), "next-stop: node 128 is none from 1 to 127");
  EXPECT_EQ(problem({{computer_id, 71}, {next_stop_id, 1}}),
            "next-stop: node 1 is of the on-board computer: 181h to 501h are pre-defined (CiA 407, "
            "8.1.4.3)");
  EXPECT_EQ(problem({{next_stop_id, 65}}), "1C1h is of a TPDO of node 65")
      << "the stop request has 1C1h, which is 180h + 65";
  BusDesign design{.node_ids = {{next_stop_id, 50}}, .added = {{.kind = "generic-io", .id = 50}}};
  EXPECT_EQ(problem_of(design), "node 50 is there already");
}

}  // namespace
}  // namespace canvoy::bus_line::bus_node_ids_test
