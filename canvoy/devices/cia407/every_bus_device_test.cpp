// All devices of CiA 407 at their wire: each has the objects of its clause (6.2 to 6.24), those
// that are optional too, and who may read and who may write them is as the clause says.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/devices/cia407/bus_bench_test.hpp"
#include "canvoy/devices/cia407/kinds.hpp"

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
    // As consumer it is written by who provides it, and not read back.
    const std::string read = ask("40", object.index, sub);
    const std::string written = ask("23", object.index, sub);
    const std::string place = std::string(unit->info.name) + " " + std::to_string(object.index);
    // The main on-board computer passes 6001h on, and so it can be read there (errata 96).
    if (unit->provides->code == 1 && object.index == 0x6001) continue;
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

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBusDevice, testing::Range<std::size_t>(0, kind_count));

}  // namespace
}  // namespace canvoy::cia407::every_bus_device_test
