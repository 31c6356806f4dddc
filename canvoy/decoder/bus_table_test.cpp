#include "canvoy/decoder/bus_table.hpp"

#include <gtest/gtest.h>

namespace canvoy::decoder::bus_table_test {
namespace {

struct Buses {
  int& operator[](std::string_view name) {
    return table.at(name, [] { return std::make_unique<int>(0); });
  }
  BusTable<int> table{2};
};

TEST(BusTable, KeepsWhatIsOfEachBus) {
  Buses buses;
  buses["can0"] = 1;
  buses["can1"] = 2;
  EXPECT_EQ(buses["can0"], 1);
  EXPECT_EQ(buses["can1"], 2);
  EXPECT_EQ(buses.table.forgotten(), 0U);
}

TEST(BusTable, ForgetsTheBusThatWasSilentForLongest) {
  Buses buses;
  buses["can0"] = 1;
  buses["can1"] = 2;
  EXPECT_EQ(buses["can0"], 1);
  buses["can2"] = 3;
  EXPECT_EQ(buses["can0"], 1);
  EXPECT_EQ(buses["can2"], 3);
  EXPECT_EQ(buses["can1"], 0) << "it begins anew";
  EXPECT_EQ(buses.table.forgotten(), 2U);
}

TEST(BusTable, KeepsNoMoreThanItsMostHoweverManyAreNamed) {
  static int living = 0;
  struct Bus {
    Bus() { ++living; }
    ~Bus() { --living; }
  };
  BusTable<Bus> table(8);
  for (int i = 0; i < 10'000; ++i) {
    table.at("can" + std::to_string(i), [] { return std::make_unique<Bus>(); });
    ASSERT_LE(living, 8);
  }
  EXPECT_EQ(table.forgotten(), 9'992U);
}

}  // namespace
}  // namespace canvoy::decoder::bus_table_test
