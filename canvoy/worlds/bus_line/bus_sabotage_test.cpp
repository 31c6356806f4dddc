// Each referee of a bus detects its errors: something is broken in the whole network, and that
// alone is found, also beside a harmless fault elsewhere. The built-in line begins at 5:00, with a
// journey every 20 minutes; time 0 is 4:55.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/bus_line/bus_day_test.hpp"
#include "canvoy/worlds/bus_line/excused_kinds.hpp"

namespace canvoy::bus_line::bus_sabotage_test {
namespace {

constexpr Duration two_journeys = 43min;

/// Each recurs every three minutes; beside a sabotage stand those that excuse nothing that it
/// breaks.
constexpr ScheduledFault faults_beside[] = {
    {.kind = FaultKind::restart, .node = driver_display_id},
    {.kind = FaultKind::restart, .node = tachograph_id},
    {.kind = FaultKind::corrupted_frames, .duration = 30s},
    {.kind = FaultKind::restart, .node = announcer_id},
    {.kind = FaultKind::restart, .node = second_counter_id}};

bool excuses_any(const ScheduledFault& fault, const BusNetwork& network) {
  const InvariantSet excused = affected_by(fault.kind, node_of(fault));
  const auto all = network.invariants();
  return std::ranges::any_of(all, [&](const Invariant& each) {
    return !each.held && excused[static_cast<std::size_t>(each.kind)];
  });
}

void recur(BusNetworkOptions& options, ScheduledFault fault, Duration time) {
  for (fault.start = Time(1min); fault.start < Time(time); fault.start += 3min) {
    options.faults.faults.push_back(fault);
  }
}

void expect_beside(BusNetworkOptions options, const ScheduledFault& fault, Duration time,
                   const std::string& names) {
  SCOPED_TRACE(fault_text(fault));
  recur(options, fault, time);
  BusNetwork network(options);
  network.run_until(Time(time));
  EXPECT_EQ(broken(network), names);
}

/// What is broken beside the first fault that excuses none of it.
std::string played_beside_one(const BusNetworkOptions& sabotaged, Duration time) {
  for (const ScheduledFault& fault : faults_beside) {
    BusNetworkOptions options = sabotaged;
    recur(options, fault, time);
    BusNetwork network(options);
    network.run_until(Time(time));
    if (!network.all_hold() && !excuses_any(fault, network)) return broken(network);
  }
  return "";
}

/// What is broken alone; beside each fault elsewhere, it is the same. Beside one alone in a quick
/// run: what is broken beside a fault is broken without it.
std::string played(const Sabotage& sabotage, Duration time = two_journeys) {
  BusNetworkOptions options = with_seed(1);
  options.sabotage = sabotage;
  if (!tries_all()) return played_beside_one(options, time);
  BusNetwork network(options);
  network.run_until(Time(time));
  const std::string names = broken(network);
  for (const ScheduledFault& fault : faults_beside) {
    if (excuses_any(fault, network)) continue;
    expect_beside(options, fault, time, names);
  }
  return names;
}

TEST(BusSabotage, ANextStopIndicatorThatIsNotWired) {
  EXPECT_EQ(played({.cuts_next_stop = true}), "next_stop ");
}

TEST(BusSabotage, ADestinationIndicatorThatIsNotWired) {
  EXPECT_EQ(played({.cuts_destination = true}), "destination ");
}

TEST(BusSabotage, AnInformationDisplayThatIsNotWired) {
  EXPECT_EQ(played({.cuts_information = true}), "information ");
}

TEST(BusSabotage, ADestinationThatDoesNotChange) {
  EXPECT_EQ(played({.freezes_destination = true}), "lie ");
}

TEST(BusSabotage, AMemoryThatIsTooShortForTheText) {
  EXPECT_EQ(played({.short_memory = true}), "information texts ");
}

TEST(BusSabotage, ADriverWhoDoesNotWaitForTheTimetable) {
  EXPECT_EQ(played({.hasty_driver = true}), "early_departure ");
}

TEST(BusSabotage, ADriverWhoLeavesPeopleAtTheirStop) {
  EXPECT_EQ(played({.unkind_driver = true}), "left_behind ");
}

TEST(BusSabotage, ACrowdThatGetsIntoAFullBus) {
  BusNetworkOptions options = with_seed(1);
  options.vehicle.riders.capacity = 2;
  options.vehicle.riders.boarding_mean = 5;
  options.sabotage.crowd = true;
  BusNetwork crowded(options);
  crowded.run_until(Time(two_journeys));
  EXPECT_EQ(broken(crowded), "overcrowded ");
  options.sabotage.crowd = false;
  BusNetwork full(options);
  full.run_until(Time(two_journeys));
  EXPECT_EQ(broken(full), "") << "who finds it full is left behind rightly";
  EXPECT_GT(full.vehicle().riders().statistics().left_behind, 0U);
}

TEST(BusSabotage, ASignWithoutALamp) {
  EXPECT_EQ(played({.no_sign_lamp = true}), "stop_sign ");
}

TEST(BusSabotage, LoudspeakersThatAreNotWired) {
  EXPECT_EQ(played({.mute_announcer = true}), "announcements ");
}

TEST(BusSabotage, AStampWithAStuckWheel) {
  EXPECT_EQ(played({.stuck_zone_wheel = true}, 50min), "tickets ");
}

TEST(BusSabotage, ClocksThatAreSlow) {
  EXPECT_EQ(played({.slow_clocks = true}), "clock ");
}

TEST(BusSabotage, ACounterThatSeesNobody) {
  EXPECT_EQ(played({.blind_counter = true}), "passengers ");
}

TEST(BusSabotage, AStrangerThatSendsAPredefinedMessage) {
  EXPECT_EQ(played({.false_messages = true}), "pdo_tables ");
}

TEST(BusSabotage, ACancellerThatTakesNoTickets) {
  EXPECT_EQ(played({.jammed_canceller = true}, 50min), "service ");
}

TEST(BusSabotage, ASecondCarThatIsDark) {
  EXPECT_EQ(played({.cut_car = 2}), "second_car ");
}

TEST(BusSabotage, ASecondCarThatShowsItsFirstStopForEver) {
  EXPECT_EQ(played({.frozen_car = 2}), "lie ");
}

TEST(BusSabotage, ASecondCarThatIsSilent) {
  EXPECT_EQ(played({.mute_car = 2}), "second_announcements ");
}

TEST(BusSabotage, ASignOfTheSecondCarWithoutALamp) {
  EXPECT_EQ(played({.unlit_car = 2}), "second_stop_sign ");
}

TEST(BusSabotage, ButtonsOfTheSecondCarThatAreNotWired) {
  EXPECT_EQ(played({.dead_button_car = 2}), "second_stop_sign ");
}

TEST(BusSabotage, ASignThatIsLitForEver) {
  EXPECT_EQ(played({.stuck_sign = true}), "false_stop_sign ");
}

TEST(BusSabotage, ASignThatIsLitFromTheFirstSecond) {
  EXPECT_EQ(played({.stuck_sign = true}, 2s), "false_stop_sign ");
}

/// The counting device reports five people aboard; the doors have not been open yet.
TEST(BusSabotage, ACountThatIsWrongFromTheFirstSeconds) {
  BusNetwork network(with_seed(1));
  SimulatedBus& cable = network.world().bus();
  const ControllerId stranger = cable.attach({});
  network.world().at(Time(2s), [&cable, stranger](Time) {
    cable.send(stranger, Frame::data_frame(0x295, {5, 0, 6}));
  });
  network.run_until(Time(4'900ms));
  EXPECT_EQ(broken(network), "");
  network.run_until(Time(5'300ms));
  EXPECT_EQ(broken(network), "passengers ");
}

/// A foreign device writes to a display, by SDO.
class StrangerAtDisplays : public testing::Test {
 protected:
  void write(NodeId node, const std::array<std::uint8_t, 8>& bytes, Time at) {
    network_.world().at(at, [this, node, bytes](Time) {
      cable_.send(stranger_, Frame::data_frame(0x600U + node, bytes));
    });
  }

  BusNetwork network_{with_seed(1)};
  SimulatedBus& cable_ = network_.world().bus();
  ControllerId stranger_ = cable_.attach({});
};

/// 6002h:01h: event 2 for the first virtual device, the test mode.
TEST_F(StrangerAtDisplays, ATestPatternIsNoText) {
  write(next_stop_id, {0x23, 0x02, 0x60, 0x01, 0x02, 0x00, 0x00, 0x03}, Time(5min + 30s));
  network_.run_until(Time(5min + 30'900ms));
  EXPECT_EQ(broken(network_), "texts ");
  network_.run_until(Time(5min + 32s));
  EXPECT_EQ(broken(network_), "next_stop texts ");
}

TEST(BusSabotage, ADeviceThatIsNotThere) {
  BusNetwork network(with_seed(1));
  network.world().at(Time(20min), [&](Time) { network.node(driver_display_id).power(false); });
  network.run_until(Time(21min));
  EXPECT_EQ(broken(network), "device_missing ");
}

}  // namespace
}  // namespace canvoy::bus_line::bus_sabotage_test
