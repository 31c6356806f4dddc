// A call controller that hears panels by PDOs and by multiplexed PDOs: frames of CiA 301, 7.2.3 in
// both modes. The panel is node 22 (16h).
#include "canvoy/devices/cia417/multiplexed_panels.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/call_controller_device.hpp"

namespace canvoy::cia417 {
namespace {

template <MpdoMode mode>
struct Bench {
  Bench() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(1s);
    cable.clear();
  }
  std::string answer() {
    cable.run_for(10ms);
    return cable.last(0x400);
  }
  Cable cable;
  CallControllerDevice<multiplexed_call_controller_layout<mode>> device{
      cable.port(0), 1, {.lift = 1, .served = {FloorSet::between(1, 20)}}};
};

TEST(MultiplexedPanels, InDestinationAddressModeARecordIsACall) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("516#80 11 5F 2B 02 01 01 03");
  EXPECT_EQ(bench.answer(), "") << "half of it";
  bench.cable.send("516#80 11 5F 2C 10 01 01 11");
  EXPECT_EQ(bench.answer(), "400#02 01 01 03 10 81");
}

TEST(MultiplexedPanels, InSourceAddressModeARecordIsACall) {
  Bench<MpdoMode::source> bench;
  bench.cable.send("516#16 10 5F 01 02 01 01 03");
  bench.cable.send("516#16 10 5F 02 10 01 01 11");
  EXPECT_EQ(bench.answer(), "400#02 01 01 03 10 81");
}

TEST(MultiplexedPanels, EachNodeHasItsOwnParts) {
  Bench<MpdoMode::source> bench;
  bench.cable.send("516#16 10 5F 01 02 01 01 03");
  bench.cable.send("57F#7F 10 5F 01 02 02 01 04");
  bench.cable.send("516#16 10 5F 02 10 01 01 11");
  EXPECT_EQ(bench.answer(), "400#02 01 01 03 10 81");
  bench.cable.send("57F#7F 10 5F 02 10 01 01 15");
  EXPECT_EQ(bench.answer(), "400#02 02 01 04 10 81");
}

TEST(MultiplexedPanels, APanelWithAPdoOfItsOwnIsHeardAsWell) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("496#02 01 01 03 10 01");
  EXPECT_EQ(bench.answer(), "400#02 01 01 03 10 81");
}

TEST(MultiplexedPanels, AResetOfTheNodeKeepsThem) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("000#81 01");
  bench.cable.send("000#01 01");
  bench.cable.run_for(1s);
  bench.cable.clear();
  bench.cable.send("516#80 11 5F 2B 02 01 01 03");
  bench.cable.send("516#80 11 5F 2C 10 01 01 11");
  EXPECT_EQ(bench.answer(), "400#02 01 01 03 10 81");
}

}  // namespace
}  // namespace canvoy::cia417
