// Three lifts of ten floors on the bus of their group, each with panels on a separate bus; all
// stand at floor 1.
//
//     press(1, "02 02 07 07 10 01");
//     EXPECT_EQ(count("491#02 02 04 07 10 01"), 1u) << "lift 3 has to answer it";
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>

#include "canvoy/devices/cia417/controller/lift_controller_test.hpp"
#include "canvoy/devices/cia417/group/group_device.hpp"

namespace canvoy::cia417 {

inline GroupControllerSettings group_settings() {
  GroupControllerSettings made{.lifts = 3, .up_peak = {.in_a_row = 1}};
  for (GroupLift& lift : made.lift) {
    lift.served = {FloorSet::between(1, 10), FloorSet::between(5, 5)};
    lift.times = {.flight = 3s, .stop = 8s};
  }
  return made;
}

class GroupTest : public testing::Test {
 protected:
  GroupTest() {
    bus.connect(0, controller.node());
    for (NodeId lift = 1; lift <= 3; ++lift) {
      LiftBench& bench = benches.emplace_back(LiftControllerSettings{}, lift);
      GroupMemberDevice<>& member = members.emplace_back(bus.port(lift), lift, bench.device.node(),
                                                         bench.device.calls(), bench.lift);
      bus.connect(lift, member.node());
    }
    for (LiftBench& bench : benches) bench.start();
    bus.start_all();
    run_for(1s);
    bus.clear();
  }
  void step() {
    for (LiftBench& bench : benches) bench.step();
    bus.run_until(benches[0].cable.now);
  }
  void run_for(Duration duration) {
    for (const Time end = benches[0].cable.now + duration; benches[0].cable.now < end;) step();
  }
  bool run_until(const std::function<bool()>& done, Duration most = 120s) {
    for (const Time end = benches[0].cable.now + most; benches[0].cable.now < end && !done();) {
      step();
    }
    return done();
  }
  /// A panel on the bus of this lift.
  void press(unsigned lift, const std::string& record) {
    benches[lift - 1].press(record);
    step();
    step();
  }
  bool is_open_at(unsigned lift, std::uint8_t floor) {
    return benches[lift - 1].lift.phase() == LiftPhase::open && benches[lift - 1].at(floor);
  }
  std::size_t count(const std::string& frame) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        bus.heard, [&](const auto& heard) { return wire_text(heard.frame) == frame; }));
  }
  /// Sends a lift to a floor by a car call, and waits until it stands there.
  void send_to(unsigned lift, unsigned floor) {
    char record[32];
    std::snprintf(record, sizeof record, "05 %02X FF 00 11 01", floor);
    press(lift, record);
    ASSERT_TRUE(run_until([&] {
      return benches[lift - 1].lift.phase() == LiftPhase::idle &&
             benches[lift - 1].at(static_cast<std::uint8_t>(floor));
    }));
  }

  std::deque<LiftBench> benches;
  Cable bus;
  std::deque<GroupMemberDevice<>> members;
  GroupControllerDevice<> controller{bus.port(0), group_settings()};
  const GroupController& group = controller.group();
};

}  // namespace canvoy::cia417
