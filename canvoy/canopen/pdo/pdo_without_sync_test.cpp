// A device without SYNC: a PDO that waits for it would never come, and is refused (CiA 301,
// 7.5.2.35 and 7.5.2.37: 0609 0030h for a transmission type that is not supported).
#include <gtest/gtest.h>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::pdo_without_sync_test {
namespace {

constexpr auto objects_behind_sync =
    std::to_array<ObjectRow>({{.index = 0x1400, .entry_count = 3},
                              {.index = 0x1600, .entry_count = 2},
                              {.index = 0x1800, .entry_count = 3},
                              {.index = 0x1A00, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 1}});
constexpr auto entries_behind_sync = std::to_array<EntryRow>(
    {parameter(0, DataType::unsigned8, 2),
     parameter(1, DataType::unsigned32, 0x205),
     parameter(2, DataType::unsigned8, 255),
     parameter(0, DataType::unsigned8, 1),
     parameter(1, DataType::unsigned32, 0x2000'00'08),
     parameter(0, DataType::unsigned8, 2),
     parameter(1, DataType::unsigned32, 0x185),
     parameter(2, DataType::unsigned8, 255),
     parameter(0, DataType::unsigned8, 1),
     parameter(1, DataType::unsigned32, 0x2000'00'08),
     {.type = DataType::unsigned8, .access = Access::rw | Access::rpdo | Access::tpdo}});
constexpr auto without_sync = partial(lay_out(objects_behind_sync, entries_behind_sync));

constexpr auto consumer_alone =
    partial(lay_out(std::to_array<ObjectRow>({{.index = 0x1005, .entry_count = 1}}),
                    std::to_array<EntryRow>({parameter(0, DataType::unsigned32, 0x80)})));

template <const auto& layout>
struct Bench {
  Bench() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 05");
  }
  std::string ask(const std::string& request) {
    cable.clear();
    cable.send("605#" + request);
    return cable.last(0x585);
  }
  /// The answer to the transmission type of a PDO.
  std::string choose(unsigned index, unsigned type) {
    char request[32];
    std::snprintf(request, sizeof request, "2F %02X %02X 02 %02X 00 00 00", index & 0xFF,
                  index >> 8, type);
    return ask(request);
  }

  Cable cable;
  DeviceNode<layout> device{cable.port(0), 5};
};

TEST(WithoutSync, NoTransmissionTypeIsTakenThatWaitsForIt) {
  Bench<without_sync> bench;
  for (unsigned type = 0; type <= 255; ++type) {
    EXPECT_EQ(bench.choose(0x1400, type),
              type >= 254 ? "585#60 00 14 02 00 00 00 00" : "585#80 00 14 02 30 00 09 06")
        << type;
    EXPECT_EQ(bench.choose(0x1800, type),
              type >= 253 ? "585#60 00 18 02 00 00 00 00" : "585#80 00 18 02 30 00 09 06")
        << type;
  }
}

TEST(WithoutSync, WhatWasRefusedLeavesThePdosAsTheyWere) {
  Bench<without_sync> bench;
  bench.choose(0x1400, 1);
  bench.choose(0x1800, 1);
  bench.cable.clear();
  bench.cable.send("205#07");
  EXPECT_EQ(bench.cable.last(0x185), "185#07") << "at once";
}

TEST(WithoutSync, ADeviceThatCannotProduceItIsNotMadeTo) {
  Bench<consumer_alone> bench;
  EXPECT_EQ(bench.ask("23 05 10 00 80 00 00 40"), "585#80 05 10 00 30 00 09 06")
      << "there is no 1006h to say how often (CiA 301, 7.5.2.5)";
  EXPECT_EQ(bench.ask("23 05 10 00 81 00 00 00"), "585#60 05 10 00 00 00 00 00");
}

}  // namespace
}  // namespace canvoy::pdo_without_sync_test
