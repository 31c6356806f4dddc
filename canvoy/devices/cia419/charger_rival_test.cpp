// Two chargers on one bus: a battery is charged by one of them (CiA 419, 6.1).
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_rival_test {
namespace {

/// Node 5 and node 6, and batteries 10 and 11, which ask for 40 A each.
class TwoChargers : public testing::Test {
 protected:
  TwoChargers() {
    cable.connect(0, first.node());
    cable.connect(1, second.node());
    cable.connect(2, battery.node());
  }
  /// The maximum current of both to battery 10 during this time.
  double most_within(Duration time) {
    double most = 0;
    for (const Time end = cable.now + time; cable.now < end; cable.run_for(100ms)) {
      most = std::max(most, bench.delivered + second_bench.delivered);
    }
    return most;
  }

  Bench bench;
  Bench second_bench;
  Cable cable;
  ChargerDevice<> first{cable.port(0), 5, bench.charger_hardware(), {}};
  ChargerDevice<> second{cable.port(1), 6, second_bench.charger_hardware(), {}};
  cia418::BatteryDevice<> battery{cable.port(2), 10, bench.battery_hardware(), {}};
  cia418::BatteryDevice<> second_battery{cable.port(3), 11, second_bench.battery_hardware(), {}};
};

TEST_F(TwoChargers, WhoComesLaterLeavesTheBatteryToTheOther) {
  second_bench.plugged = false;
  cable.start_all();
  cable.run_for(10s);
  ASSERT_EQ(bench.delivered, 40);
  second_bench.plugged = true;
  cable.run_for(4s);
  EXPECT_LE(most_within(10min), 40);
  EXPECT_EQ(first.charger().battery(), 10);
  EXPECT_EQ(second.charger().battery(), 0);
  EXPECT_EQ(second.charger().phase(), ChargerPhase::searching);
  EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00") << "nobody else sends any more";
}

TEST_F(TwoChargers, OfTwoThatComeAtOnceOneStays) {
  cable.start_all();
  cable.run_for(20s);
  EXPECT_EQ(most_within(10min), 40);
  EXPECT_NE(first.charger().battery(), second.charger().battery());
}

TEST_F(TwoChargers, EachHasABatteryOfTwo) {
  cable.connect(3, second_battery.node());
  cable.start_all();
  cable.run_for(30s);
  EXPECT_EQ(first.charger().battery() + second.charger().battery(), 10 + 11);
  EXPECT_EQ(bench.delivered, 40);
  EXPECT_EQ(second_bench.delivered, 40);
}

TEST_F(TwoChargers, ABatteryThatHasLostItsChargerIsChargedByTheOther) {
  second_bench.plugged = false;
  cable.start_all();
  cable.run_for(10s);
  second_bench.plugged = true;
  cable.run_for(1min);
  ASSERT_EQ(second_bench.delivered, 0);
  cable.cut(0);
  bench.delivered = 0;
  cable.run_for(10s);
  EXPECT_EQ(second.charger().battery(), 10);
  EXPECT_EQ(second_bench.delivered, 40);
}

class ARival : public ChargerTest {};

/// The collision is reported with the CAN-ID: 8150h, error register 11h, 020Ah (CiA 301, 7.2.7).
TEST_F(ARival, ThatIsHeardOnceByWhoWasFirstIsToldOf) {
  run_until_charging();
  cable.send("20A#01");
  EXPECT_EQ(cable.last(0x085), "085#50 81 11 0A 02 00 00 00");
  cable.run_for(4s);
  EXPECT_EQ(cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ARival, ThatDoesNotLeaveIsLeftTheBattery) {
  run_until_charging();
  for (int i = 0; i < 60; ++i) {
    cable.send("20A#01");
    cable.run_for(100ms);
  }
  EXPECT_EQ(bench.delivered, 0);
  EXPECT_EQ(charger.charger().battery(), 0);
  expect_pdos_invalid();
  cable.run_for(10s);
  EXPECT_EQ(bench.delivered, 40) << "it is gone";
}

TEST_F(ARival, IsNoRemoteFrame) {
  run_until_charging();
  cable.send("20A#R");
  EXPECT_EQ(cable.count(0x085), 0u);
}

}  // namespace
}  // namespace canvoy::cia419::charger_rival_test
