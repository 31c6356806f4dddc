// What can only be a bus, by its form.
#include "canvoy/tools/argument/bus_argument.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools::bus_argument_test {
namespace {

TEST(BusArgument, KnowsWhatIsABus) {
  for (const char* bus : {"can0", "vcan12", "slcan3", "udp:", "tcp:host/can0", "sim", "can0,can1",
                          "can0/2:7", "lo"}) {
    EXPECT_TRUE(names_bus(bus)) << bus;
  }
  for (const char* other : {"10", "0x0A", "all", "pump.eds", "a.log", "./can", "can", "", "1018"}) {
    EXPECT_FALSE(names_bus(other)) << other;
  }
}

}  // namespace
}  // namespace canvoy::tools::bus_argument_test
