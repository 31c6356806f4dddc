// All devices of CiA 407 at their wire: each has the objects of its clause (6.2 to 6.24), including
// optional ones, with the read and write access of the clause.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/devices/cia407/kinds.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::cia407::every_bus_device_test {
namespace {

class EveryBusDevice : public testing::TestWithParam<std::size_t> {
 protected:
  const BusUnit* unit = kinds()[GetParam()].bus_unit;
  BusBench bench{std::span(&unit, 1)};

  std::string ask(const std::string& command, std::uint16_t index, std::uint8_t sub) {
    char request[64];
    std::snprintf(request, sizeof request, "%s %02X %02X %02X 00 00 00 00", command.c_str(),
                  index & 0xFFU, index >> 8U, sub);
    const std::string answer = bench.ask(request);
    return answer.substr(0, 2) == "80" ? answer.substr(12) : "";
  }
};

TEST_P(EveryBusDevice, HasTheObjectsOfItsClauseWithTheirAccess) {
  const std::string write_only = "01 00 01 06";
  const std::string read_only = "02 00 01 06";
  for (const DeviceObject& object : unit->provides->objects) {
    const std::uint8_t sub = bench.node().dictionary().find(object.index, 1) ? 1 : 0;
    ASSERT_TRUE(bench.node().dictionary().find(object.index, sub))
        << unit->info.name << ": no " << std::hex << object.index;
    // A consumer's object is written by the provider, and not read back.
    const std::string read = ask("40", object.index, sub);
    const std::string written = ask("23", object.index, sub);
    const std::string place = std::string(unit->info.name) + " " + std::to_string(object.index);
    if (object.access == Access::wo) {
      EXPECT_EQ(read, write_only) << place;
      EXPECT_NE(written, read_only) << place;
    } else if (object.access == Access::ro) {
      EXPECT_EQ(read, "") << place;
      // A write that comes to sub-index 01h of a history is taken, since others report there.
      const bool is_reported = object.index >= 0x6740 && object.index <= 0x6744;
      EXPECT_TRUE(is_reported || written == read_only) << place;
    } else {
      EXPECT_NE(written, read_only) << place;
    }
  }
}

constexpr std::size_t file_max = 16384;

/// 6.10: wo, as of all that consume 6741h. In segments (CiA 301, 7.2.4.3.3).
TEST(TakenFile, IsKeptWholeAndNotReadBack) {
  const BusUnit* unit = nullptr;
  for (const DeviceKind& kind : kinds()) {
    if (kind.info.name == "train-bus-gateway") unit = kind.bus_unit;
  }
  BusBench bench{std::span(&unit, 1)};
  EXPECT_TRUE(bench.device().taken_file(0x6741).empty());
  EXPECT_EQ(bench.ask("21 41 67 00 0A 00 00 00"), "60 41 67 00 00 00 00 00");
  EXPECT_EQ(bench.ask("00 64 6F 6F 72 20 32 20"), "20 00 00 00 00 00 00 00");
  EXPECT_TRUE(bench.device().taken_file(0x6741).empty()) << "it is not whole yet";
  EXPECT_EQ(bench.ask("19 69 73 0A 00 00 00 00"), "30 00 00 00 00 00 00 00");
  const std::span<const std::uint8_t> file = bench.device().taken_file(0x6741);
  EXPECT_EQ(std::string(file.begin(), file.end()), "door 2 is\n");
  EXPECT_EQ(bench.ask("40 41 67 00 00 00 00 00"), "80 41 67 00 01 00 01 06");
  EXPECT_EQ(bench.ask("21 41 67 00 01 40 00 00"), "80 41 67 00 12 00 07 06") << file_max + 1;
  EXPECT_TRUE(bench.download(0x6741, 0, std::string(file_max, 'a')));
  EXPECT_EQ(bench.device().taken_file(0x6741).size(), file_max);
  EXPECT_TRUE(bench.device().taken_file(0x6720).empty()) << "another one";
  EXPECT_EQ(bench.ask("2F 20 67 00 2A 00 00 00"), "60 20 67 00 00 00 00 00") << "expedited";
  EXPECT_EQ(bench.device().taken_file(0x6720).size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBusDevice, testing::Range<std::size_t>(0, kind_count));

}  // namespace
}  // namespace canvoy::cia407::every_bus_device_test
