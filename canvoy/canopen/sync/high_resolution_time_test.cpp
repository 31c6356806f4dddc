#include "canvoy/canopen/sync/high_resolution_time.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::high_resolution_time_test {
namespace {

constexpr EntryRow entry(std::uint8_t sub, DataType type, std::int64_t initial) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}

// 1013h in RPDO 1 (205h, event-driven) and TPDO 1 (185h, at each SYNC).
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1013, .entry_count = 1},
                                      {.index = 0x1400, .entry_count = 3},
                                      {.index = 0x1600, .entry_count = 2},
                                      {.index = 0x1800, .entry_count = 3},
                                      {.index = 0x1A00, .entry_count = 2}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32, .access = Access::rw | Access::tpdo | Access::rpdo},
                 entry(0, DataType::unsigned8, 2),
                 entry(1, DataType::unsigned32, 0x205),
                 entry(2, DataType::unsigned8, 255),
                 entry(0, DataType::unsigned8, 1),
                 entry(1, DataType::unsigned32, 0x1013'0020),
                 entry(0, DataType::unsigned8, 2),
                 entry(1, DataType::unsigned32, 0x185),
                 entry(2, DataType::unsigned8, 1),
                 entry(0, DataType::unsigned8, 1),
                 entry(1, DataType::unsigned32, 0x1013'0020)}));

struct StampingNode : WireNode {
  StampingNode()
      : WireNode(layout.tables(), 5),
        server(node, 0, buffer),
        sync(node),
        rpdos(node, std::span<Rpdo>(rpdo), std::span<MappedValue>(rpdo_values), &sync),
        tpdos(node, std::span<Tpdo>(tpdo), std::span<MappedValue>(tpdo_values), &sync),
        sut(node, &sync) {
    boot_operational();
  }
  std::uint8_t buffer[16] = {};
  Rpdo rpdo[1];
  Tpdo tpdo[1];
  MappedValue rpdo_values[1];
  MappedValue tpdo_values[1];
  SdoServer server;
  Sync sync;
  Rpdos rpdos;
  Tpdos tpdos;
  HighResolutionTime sut;
};

constexpr auto read_request = "605#40 13 10 00 00 00 00 00";

TEST(HighResolutionTime, ShowsTheMicrosecondsOfTheMomentToSdo) {
  StampingNode node;
  node.run_until(Time(0x12345678us));
  node.receive(read_request);
  node.run_for(1us);
  node.receive(read_request);
  node.expect({"585#43 13 10 00 78 56 34 12", "585#43 13 10 00 79 56 34 12"});
}

TEST(HighResolutionTime, RunsOverAfter32Bits) {
  StampingNode node;
  node.run_until(Time(0x1'0000'0005us));
  node.receive(read_request);
  node.expect({"585#43 13 10 00 05 00 00 00"});
}

TEST(HighResolutionTime, IsThatOfTheSyncInAPdo) {
  StampingNode node;
  node.run_until(Time(1000us));
  node.receive("080#");
  node.run_until(Time(2500us));
  node.receive(read_request);
  node.receive("080#");
  node.expect({"185#E8 03 00 00", "585#43 13 10 00 C4 09 00 00", "185#C4 09 00 00"});
}

TEST(HighResolutionTime, IsSetByWhatAPdoSaysOfTheLastSync) {
  StampingNode node;
  node.run_until(Time(1000us));
  node.receive("080#");
  node.sent.clear();
  node.run_until(Time(1300us));
  node.receive("205#00 00 01 00");  // 65,536 us at the SYNC
  EXPECT_EQ(node.sut.clock(node.now), 65'836U);
  node.receive(read_request);
  node.run_until(Time(2000us));
  node.receive("080#");
  node.expect({"585#43 13 10 00 2C 01 01 00", "185#E8 03 01 00"});
}

TEST(HighResolutionTime, IsSetBySdoAndBeforeAnySyncFromNowOn) {
  StampingNode node;
  node.run_until(Time(500us));
  node.receive("605#23 13 10 00 00 00 00 80");
  node.run_until(Time(700us));
  node.receive(read_request);
  node.expect({"585#60 13 10 00 00 00 00 00", "585#43 13 10 00 C8 00 00 80"});
}

TEST(HighResolutionTime, WorksWithoutSync) {
  WireNode wire(layout.tables(), 5);
  std::uint8_t buffer[16];
  SdoServer server(wire.node, 0, buffer);
  HighResolutionTime sut(wire.node, nullptr);
  wire.boot();
  wire.run_until(Time(16us));
  wire.receive("080#");
  wire.receive(read_request);
  wire.expect({"585#43 13 10 00 10 00 00 00"});
}

}  // namespace
}  // namespace canvoy::high_resolution_time_test
