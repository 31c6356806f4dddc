// SDO channels that an SDO manager assigned temporarily (bit 30 of their COB-IDs: dynamic) are not
// parameters: after power-on the manager assigns the CAN-IDs to others.
#include <gtest/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_sdo_channels_test {
namespace {

constexpr EntryRow number(std::uint8_t first, std::uint8_t last, DataType type, Access access,
                          std::int64_t initial) {
  return {.sub_first = first, .sub_last = last, .type = type, .access = access, .initial = initial};
}

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                                          {.index = 0x1010, .entry_count = 2},
                                                          {.index = 0x1011, .entry_count = 2},
                                                          {.index = 0x1018, .entry_count = 2},
                                                          {.index = 0x1201, .entry_count = 3}}),
                                std::to_array<EntryRow>({
                                    number(0, 0, DataType::unsigned32, Access::const_, 1),
                                    number(0, 0, DataType::unsigned8, Access::const_, 1),
                                    number(1, 1, DataType::unsigned32, Access::rw, 1),
                                    number(0, 0, DataType::unsigned8, Access::const_, 1),
                                    number(1, 1, DataType::unsigned32, Access::rw, 1),
                                    number(0, 0, DataType::unsigned8, Access::const_, 2),
                                    number(1, 2, DataType::unsigned32, Access::const_, 0x123),
                                    number(0, 0, DataType::unsigned8, Access::const_, 3),
                                    number(1, 2, DataType::unsigned32, Access::rw, CobId::bit31),
                                    number(3, 3, DataType::unsigned8, Access::rw, 0),
                                }));

struct TwoServers : StoringNode {
  explicit TwoServers(SimulatedFlash& memory)
      : StoringNode(memory, stored_settings, layout.tables()), second(node, 1, {}) {
    booted();
    receive("000#81 05");  // with the second node-ID
    booted();
  }
  SdoServer second;
};

TEST(StorageOfSdoChannels, ADynamicOneIsNotThereAfterPowerOn) {
  SimulatedFlash memory{stored_geometry};
  TwoServers sut(memory);
  sut.ask("2F 01 12 03 07 00 00 00", "60 01 12 03 00 00 00 00");
  sut.ask("23 01 12 02 81 06 00 40", "60 01 12 02 00 00 00 00");
  sut.ask("23 01 12 01 80 06 00 40", "60 01 12 01 00 00 00 00");
  sut.save(1);
  EXPECT_EQ(sut.get(0x1201, 1), 0x4000'0680U) << "it works on";
  TwoServers again(memory);
  EXPECT_EQ(again.get(0x1201, 1), 0x8000'0000U);
  EXPECT_EQ(again.get(0x1201, 2), 0x8000'0000U);
  again.receive("680#40 00 10 00 00 00 00 00");
  again.expect({});
}

TEST(StorageOfSdoChannels, OneThatWasConfiguredIs) {
  SimulatedFlash memory{stored_geometry};
  TwoServers sut(memory);
  sut.ask("23 01 12 02 81 06 00 00", "60 01 12 02 00 00 00 00");
  sut.ask("23 01 12 01 80 06 00 00", "60 01 12 01 00 00 00 00");
  sut.save(1);
  TwoServers again(memory);
  again.receive("680#40 00 10 00 00 00 00 00");
  again.expect({"681#43 00 10 00 01 00 00 00"});
}

}  // namespace
}  // namespace canvoy::storage_sdo_channels_test
