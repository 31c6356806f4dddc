// Common duties of a device in the network of a car, at its wire: CAN-IDs that follow from the
// node-ID, PDOs from any node, SDO channels of all to all (facts 2.2 and 2.3).
#include "canvoy/devices/cia447/kit/car_network.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::car_network_test {
namespace {

/// A device that reads the states of blue lights and the ignition switch.
struct WatcherUnit {
  WatcherUnit(CarNetwork& /*network*/, const SwitchedHardware& /*hardware*/,
              const SwitchedSettings& /*settings*/) {}
};
struct WatcherKind : CarKind<WatcherUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "watcher", .title = "watches", .node_id = 5};
  static constexpr const VirtualDeviceInfo& provides = discrete_inputs_device;
  static constexpr const ObjectInfo* consumes[] = {&blue_light_flasher_status_object,
                                                   &ignition_switch_status_object};
};

class Watcher : public testing::Test {
 protected:
  std::string number(unsigned index) {
    char request[32];
    std::snprintf(request, sizeof request, "40 %02X %02X 00 00 00 00 00", index & 0xFF, index >> 8);
    return bench.ask(request).substr(12);
  }

  CarBench bench{only_unit<WatcherKind>};
};

TEST_F(Watcher, TakesAPdoFromWhicheverNodeHasTheVirtualDevice) {
  EXPECT_EQ(number(0x6141), "FF FF FF FF");
  // The flashers' PDO is the twelfth: 180h + 11 of node 1, 1A0h + 11 of node 9, 520h + 11 of 16.
  bench.cable.send("18B#01 00 F0 FF");
  EXPECT_EQ(number(0x6141), "01 00 F0 FF");
  EXPECT_EQ(bench.device().network().source_of(66), 1);
  bench.cable.send("1AB#02 00 F0 FF");
  EXPECT_EQ(number(0x6141), "02 00 F0 FF");
  EXPECT_EQ(bench.device().network().source_of(66), 9);
  bench.cable.send("52B#03 00 F0 FF");
  EXPECT_EQ(number(0x6141), "03 00 F0 FF");
  EXPECT_EQ(bench.device().network().source_of(66), 16);
  bench.cable.send("18C#00 00 00 00");
  EXPECT_EQ(number(0x6141), "03 00 F0 FF") << "another PDO";
  EXPECT_EQ(bench.device().network().source_of(1), 0) << "nobody has sent the ignition switch";
}

TEST_F(Watcher, EveryNodeHasItsOwn32CanIds) {
  constexpr unsigned first[] = {0x180, 0x200, 0x280, 0x300, 0x380, 0x400, 0x480, 0x500,
                                0x1A0, 0x220, 0x2A0, 0x320, 0x3A0, 0x420, 0x4A0, 0x520};
  for (unsigned node = 1; node <= 16; ++node) {
    if (node == 5) continue;  // it does not receive its own frames
    char frame[32];
    std::snprintf(frame, sizeof frame, "%03X#%02X", first[node - 1], node);
    bench.cable.send(frame);
    EXPECT_EQ(bench.device().network().source_of(1), node);
    EXPECT_EQ(number(0x6007).substr(0, 2), std::string(frame + 4));
  }
}

TEST_F(Watcher, AsksEachOtherNodeOnAChannelOfTheirOwn) {
  std::uint8_t value[4];
  std::string answers;
  auto done = [&answers](const SdoClient::Outcome& outcome) { answers += outcome ? "y" : "n"; };
  SdoClient to_7(bench.node(), 6);
  SdoClient to_16(bench.node(), 15);
  bench.cable.clear();
  EXPECT_EQ(to_7.upload(7, 0x1000, 0, value, SdoClient::Done::of(done)), AbortCode::none);
  EXPECT_EQ(to_16.upload(16, 0x1000, 0, value, SdoClient::Done::of(done)), AbortCode::none);
  bench.cable.run_for(0s);
  // Client 5: 340h and the server's number less one (facts 2.2).
  EXPECT_EQ(bench.cable.last(0x346), "346#40 00 10 00 00 00 00 00");
  EXPECT_EQ(bench.cable.last(0x34F), "34F#40 00 10 00 00 00 00 00");
  bench.cable.send("2CF#43 00 10 00 BF 01 00 00");
  bench.cable.send("2C6#43 00 10 00 BF 01 00 00");
  EXPECT_EQ(answers, "yy") << "both at once";
}

/// Restricted CAN-IDs (CiA 301, 7.3.5), whether or not this node uses the channel.
TEST_F(Watcher, NoChannelOfAClientTakesARestrictedCanId) {
  for (const std::string channel : {"80", "86", "8F"}) {
    EXPECT_EQ(bench.ask("23 " + channel + " 12 01 01 00 00 00"),
              "80 " + channel + " 12 01 30 00 09 06");
  }
}

TEST_F(Watcher, AWatchedNodeThatFallsSilentOrBootsAnewIsLost) {
  std::string lost;
  auto told = [&lost](NodeId node) { lost += std::to_string(node) + " "; };
  CarNetwork& network = bench.device().network();
  network.on_lost(Callback<void(NodeId)>::of(told));
  network.watch(7);
  network.watch(8);
  bench.cable.run_for(2s);
  bench.cable.send("707#05");
  bench.cable.run_for(999ms);
  EXPECT_EQ(lost, "");
  bench.cable.run_for(1ms);
  EXPECT_EQ(lost, "8 ");
  bench.cable.run_for(2s);
  EXPECT_EQ(lost, "8 7 ");
  network.watch(7);
  bench.cable.send("707#00");
  EXPECT_EQ(lost, "8 7 7 ") << "its boot-up message";
  bench.cable.run_for(1h);
  EXPECT_EQ(lost, "8 7 7 ") << "told once";
}

TEST_F(Watcher, ANodeWithoutANodeIdOfTheProfileSendsNoPdos) {
  Cable cable;
  Environment environment;
  CarDevice stranger(only_unit<WatcherKind>, cable.port(0), 17, environment);
  cable.connect(0, stranger.node());
  cable.start_all();
  cable.send("000#01 11");
  cable.run_for(1s);
  for (std::uint32_t id = 0x180; id < 0x580; ++id) EXPECT_EQ(cable.count(id), 0u);
}

}  // namespace
}  // namespace canvoy::cia447::car_network_test
