// A group controller that also receives the calls of its lifts by multiplexed PDOs: frames of the
// group's bus. The test is lift 1, node 1; the group controller is node 17 (11h).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/group/group_device.hpp"

namespace canvoy::cia417::multiplexed_group_test {
namespace {

GroupControllerSettings one_lift() {
  GroupControllerSettings made{.lifts = 1};
  made.lift[0].served = {FloorSet::between(1, 10)};
  return made;
}

template <MpdoMode mode>
struct Bench {
  Bench() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("701#05");
    cable.send("401#40 01 01 00 F0 01");  // it is at floor 1,
    cable.send("401#43 0A 01 00 F0 00");  // and not out of order
    cable.clear();
  }
  std::size_t count(const std::string& frame) {
    cable.run_for(10ms);
    return static_cast<std::size_t>(std::ranges::count_if(
        cable.heard, [&](const auto& heard) { return wire_text(heard.frame) == frame; }));
  }
  Cable cable;
  GroupControllerDevice<multiplexed_group_controller_layout<mode>> device{cable.port(0),
                                                                          one_lift()};
};

TEST(MultiplexedGroup, InDestinationAddressModeARecordIsACall) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("501#91 11 5F 01 02 01 01 03");
  EXPECT_EQ(bench.count("491#02 01 01 03 10 01"), 0u) << "half of it";
  bench.cable.send("501#91 11 5F 02 10 01 01 11");
  EXPECT_EQ(bench.count("491#02 01 01 03 10 01"), 1u) << "lift 1 has to answer it";
  EXPECT_EQ(bench.count("400#02 01 FF 03 10 81"), 1u);
}

TEST(MultiplexedGroup, InSourceAddressModeARecordIsACall) {
  Bench<MpdoMode::source> bench;
  bench.cable.send("501#01 10 5F 01 02 01 01 03");
  bench.cable.send("501#01 10 5F 02 10 01 01 11");
  EXPECT_EQ(bench.count("491#02 01 01 03 10 01"), 1u);
}

TEST(MultiplexedGroup, ALiftWithAPdoOfItsOwnIsHeardAsWell) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("481#02 01 01 03 10 01");
  EXPECT_EQ(bench.count("491#02 01 01 03 10 01"), 1u);
}

TEST(MultiplexedGroup, AResetOfTheNodeKeepsThem) {
  Bench<MpdoMode::destination> bench;
  bench.cable.send("000#81 11");
  bench.cable.send("701#05");
  bench.cable.send("401#40 01 01 00 F0 01");
  bench.cable.send("401#43 0A 01 00 F0 00");
  bench.cable.send("501#91 11 5F 01 02 01 01 03");
  bench.cable.send("501#91 11 5F 02 10 01 01 11");
  EXPECT_EQ(bench.count("491#02 01 01 03 10 01"), 1u);
}

}  // namespace
}  // namespace canvoy::cia417::multiplexed_group_test
