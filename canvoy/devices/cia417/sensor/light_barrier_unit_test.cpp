// Light barriers at their wire: beams in, statuses and emergencies out.
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"

namespace canvoy::cia417::light_barrier_unit_test {
namespace {

struct Beams {
  std::array<Detection, 4> seen{};
  int looks = 0;

  Detection sense(unsigned door) {
    ++looks;
    return seen.at(door - 1);
  }
  LightBarrierHardware hardware() { return {.sense = callback<&Beams::sense>(*this)}; }
};

class LightBarrier : public testing::Test {
 protected:
  LightBarrier() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 09");
  }
  void see(Detection seen) {
    beams.seen[0] = seen;
    cable.run_for(10ms);
  }

  Beams beams;
  Cable cable;
  LightBarrierDevice<> device{cable.port(0), 9, beams.hardware()};
};

TEST_F(LightBarrier, TellsWhatItSees) {
  EXPECT_EQ(cable.last(0x205), "205#3F") << "nobody; bits 5 to 0 are 1";
  see(Detection::yes);
  EXPECT_EQ(cable.last(0x205), "205#7F");
  see(Detection::no);
  EXPECT_EQ(cable.last(0x205), "205#3F");
  see(Detection::not_available);
  EXPECT_EQ(cable.last(0x205), "205#FF");
  EXPECT_EQ(cable.count(0x205), 4u);
  EXPECT_EQ(cable.count(0x089), 0u);
}

TEST_F(LightBarrier, ADefectIsAnEmergency) {
  see(Detection::error);
  EXPECT_EQ(cable.last(0x205), "205#BF");
  EXPECT_EQ(cable.last(0x089), "089#01 FF 01 01 00 00 00 00");
  cable.run_for(1min);
  EXPECT_EQ(cable.count(0x089), 1u) << "told once";
  see(Detection::yes);
  EXPECT_EQ(cable.last(0x089), "089#00 00 00 00 00 00 00 00");
  see(Detection::no);
  EXPECT_EQ(cable.count(0x089), 2u);
}

TEST_F(LightBarrier, EveryChangeFromEveryStateIsTold) {
  constexpr Detection all[] = {Detection::no, Detection::yes, Detection::error,
                               Detection::not_available};
  constexpr const char* frames[] = {"205#3F", "205#7F", "205#BF", "205#FF"};
  for (const Detection from : all) {
    for (std::size_t to = 0; to < 4; ++to) {
      see(from);
      cable.clear();
      see(all[to]);
      EXPECT_EQ(cable.count(0x205), from == all[to] ? 0u : 1u);
      if (from != all[to]) {
        EXPECT_EQ(cable.last(0x205), frames[to]);
      }
      const bool is_defect = all[to] == Detection::error;
      EXPECT_EQ(cable.count(0x089), is_defect != (from == Detection::error) ? 1u : 0u);
    }
  }
}

TEST_F(LightBarrier, ADefectIsToldAgainAfterAReset) {
  see(Detection::error);
  cable.send("000#81 09");
  cable.send("000#01 09");
  EXPECT_EQ(cable.count(0x089), 2u);
  EXPECT_EQ(cable.last(0x205), "205#BF");
}

TEST_F(LightBarrier, WithoutAPeriodItIsLookedAtWhenItSaysSo) {
  Cable other;
  Beams quiet;
  LightBarrierDevice<> patient(other.port(0), 9, quiet.hardware(), {.sensing_period = 0s});
  other.connect(0, patient.node());
  other.start_all();
  other.send("000#01 09");
  const int looks = quiet.looks;
  quiet.seen[0] = Detection::yes;
  other.run_for(1h);
  EXPECT_EQ(quiet.looks, looks);
  patient.unit().hardware_changed();
  other.run_for(0s);
  EXPECT_EQ(other.last(0x205), "205#7F");
}

TEST_F(LightBarrier, OneDeviceCanWatchSeveralDoorsOfItsLift) {
  static constexpr LiftDeviceOptions options = {.lift = 2, .doors = 0b0110, .parts = 96};
  Cable other;
  Beams two;
  LightBarrierDevice<options> both(other.port(0), 9, two.hardware());
  other.connect(0, both.node());
  other.start_all();
  other.send("000#01 09");
  EXPECT_EQ(other.last(0x216), "216#3F");
  two.seen[2] = Detection::error;
  two.seen[0] = Detection::yes;
  other.run_for(10ms);
  EXPECT_EQ(other.last(0x217), "217#BF");
  EXPECT_EQ(other.last(0x089), "089#01 FF 01 03 00 00 00 00") << "door 3";
  EXPECT_EQ(both.node().dictionary().number(0x6B10, 1), 0xFFu) << "door 1 is another device's";
}

}  // namespace
}  // namespace canvoy::cia417::light_barrier_unit_test
