// Reactions of a charger to lost PDOs of its battery: it requests their values by remote frame, and
// decides by the answers (CiA 419, 6.2.3.1).
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_gap_test {
namespace {

class ChargerInAGap : public ChargerTest {
 protected:
  /// Its CAN controller was alone on the cable.
  void mend() {
    charger.node().bus_state(BusState::error_passive, cable.now);
    charger.node().bus_state(BusState::error_warning, cable.now);
    cable.run_for(20ms);
  }
};

TEST_F(ChargerInAGap, AsksForAllValuesThatItWorksWith) {
  run_until_charging();
  mend();
  EXPECT_TRUE(asked(0x28A)) << "status, temperature, voltage";
  EXPECT_TRUE(asked(0x38A)) << "current, state of charge";
  EXPECT_EQ(bench.delivered, 40) << "what it knows still holds";
}

TEST_F(ChargerInAGap, ABatteryThatIsNotReadyAnyMoreIsHeardAsSoonAsItIsAsked) {
  run_until_charging();
  cable.filter = [](const Frame& frame) { return frame.id != 0x28A; };
  bench.readings.ready = false;
  cable.run_for(100ms);
  ASSERT_EQ(bench.delivered, 40);
  cable.filter = [](const Frame&) { return true; };
  mend();
  EXPECT_EQ(bench.delivered, 0);
}

TEST_F(ChargerInAGap, AsksNobodyWithoutABattery) {
  cable.cut(1);
  cable.start_all();
  cable.run_for(5s);
  cable.clear();
  mend();
  EXPECT_FALSE(asked(0x28A));
}

}  // namespace
}  // namespace canvoy::cia419::charger_gap_test
