// A load measuring unit at its wire: loads in, signals out.
#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"

namespace canvoy::cia417::load_measuring_unit_test {
namespace {

struct Ropes {
  std::array<std::optional<double>, 4> kilograms{0, 0, 0, 0};

  std::optional<double> load(unsigned rope) { return kilograms.at(rope - 1); }
  LoadHardware hardware() { return {.rope_load = callback<&Ropes::load>(*this)}; }
};

class LoadUnit : public testing::Test {
 protected:
  LoadUnit() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 0D");
  }
  void weigh(std::optional<double> kilograms) {
    ropes.kilograms[0] = kilograms;
    cable.run_for(100ms);
  }
  /// The answer of the SDO server to a request.
  std::string ask(std::string_view request) {
    cable.send(request);
    return cable.last(0x58D);
  }

  Ropes ropes;
  Cable cable;
  LoadMeasuringDevice<> device{cable.port(0), 13, ropes.hardware()};
};

TEST_F(LoadUnit, TellsTheLimitsThatTheLoadReaches) {
  EXPECT_EQ(cable.last(0x188), "188#01") << "zero load";
  weigh(20);
  EXPECT_EQ(cable.count(0x188), 1u) << "at its limit it is still zero";
  weigh(21);
  EXPECT_EQ(cable.last(0x188), "188#00");
  weigh(314);
  EXPECT_EQ(cable.count(0x188), 2u);
  weigh(315);
  EXPECT_EQ(cable.last(0x188), "188#02") << "norm load";
  weigh(504);
  EXPECT_EQ(cable.last(0x188), "188#06") << "full load, too";
  weigh(693);
  EXPECT_EQ(cable.last(0x188), "188#0E") << "overload, too";
  weigh(692);
  EXPECT_EQ(cable.last(0x188), "188#06");
}

TEST_F(LoadUnit, TheLoadIsReadInKilograms) {
  weigh(450.4);
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 C2 01 00 00");
  EXPECT_EQ(ask("60D#40 80 64 02 00 00 00 00"), "58D#4B 80 64 02 02 00 00 00");
  EXPECT_EQ(ask("60D#40 82 64 01 00 00 00 00"), "58D#4F 82 64 01 02 00 00 00");
}

TEST_F(LoadUnit, LimitsAreChangedWhileItRuns) {
  weigh(450);
  EXPECT_EQ(ask("60D#2B 83 64 04 C2 01 00 00"), "58D#60 83 64 04 00 00 00 00");
  EXPECT_EQ(cable.last(0x188), "188#0A") << "overload from 450 kg on";
  ask("60D#2B 83 64 04 FF FF 00 00");
  EXPECT_EQ(cable.last(0x188), "188#02") << "FFFFh: unused";
  ask("60D#2B 83 64 02 FF FF 00 00");
  EXPECT_EQ(cable.last(0x188), "188#00");
}

TEST_F(LoadUnit, EverySignalMakesAMessageOrNot) {
  // Loads that make one signal change each, with the default limits.
  constexpr double before[] = {20, 314, 503, 692};
  constexpr double after[] = {21, 315, 504, 693};
  for (unsigned mask = 0; mask <= 0x0F; ++mask) {
    for (unsigned bit = 0; bit < 4; ++bit) {
      weigh(before[bit]);
      char text[40];
      std::snprintf(text, sizeof text, "60D#2F 82 64 02 %02X 00 00 00", mask);
      ASSERT_EQ(ask(text), "58D#60 82 64 02 00 00 00 00");
      cable.clear();
      weigh(after[bit]);
      EXPECT_EQ(cable.count(0x188), mask >> bit & 1) << mask << " " << bit;
      const std::string read = ask("60D#40 82 64 01 00 00 00 00").substr(16, 2);
      constexpr const char* expected[] = {"00", "02", "06", "0E"};
      EXPECT_EQ(read, expected[bit]) << "it is there to be read";
    }
  }
}

TEST_F(LoadUnit, ASignalWithoutMessageGoesAlongWithTheNext) {
  ask("60D#2F 82 64 02 08 00 00 00");
  cable.clear();
  weigh(600);
  EXPECT_EQ(cable.count(0x188), 0u);
  weigh(700);
  EXPECT_EQ(cable.last(0x188), "188#0E");
}

/// 6482h:02h was 0 between them.
TEST_F(LoadUnit, ASignalWithAMessageMakesOneWhateverTheTpdoCarriedLast) {
  weigh(700);
  EXPECT_EQ(cable.last(0x188), "188#0E");
  ask("60D#2F 82 64 02 00 00 00 00");
  weigh(600);
  ask("60D#2F 82 64 02 08 00 00 00");
  cable.clear();
  weigh(700);
  EXPECT_EQ(cable.count(0x188), 1u);
  EXPECT_EQ(cable.last(0x188), "188#0E");
}

TEST_F(LoadUnit, ASensorThatFailsIsFfffhAndAnEmergency) {
  weigh(700);
  weigh(std::nullopt);
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 FF FF 00 00");
  EXPECT_EQ(cable.last(0x188), "188#00");
  EXPECT_EQ(cable.last(0x08D), "08D#04 FF 01 00 00 00 00 00");
  cable.run_for(1min);
  EXPECT_EQ(cable.count(0x08D), 1u);
  weigh(700);
  EXPECT_EQ(cable.last(0x188), "188#0E");
  EXPECT_EQ(cable.last(0x08D), "08D#00 00 00 00 00 00 00 00");
}

TEST_F(LoadUnit, TheLoadStaysWithinItsLimits) {
  ask("60D#2B 81 64 01 0A 00 00 00");
  ask("60D#2B 81 64 02 20 03 00 00");
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 0A 00 00 00");
  weigh(900);
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 20 03 00 00");
  EXPECT_EQ(cable.last(0x188), "188#0E") << "and is an overload all the same";
  weigh(1e9);
  ask("60D#2B 81 64 02 00 00 00 00");
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 FE FF 00 00")
      << "without limits what the type holds, other than FFFFh";
}

TEST_F(LoadUnit, SignalsAreOfTheLoadThatThereIsNotOfWhatItsLimitsCutOff) {
  ask("60D#2B 81 64 02 2C 01 00 00");  // 300 kg
  weigh(900);
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 2C 01 00 00");
  EXPECT_EQ(cable.last(0x188), "188#0E") << "an overload whatever the highest value is";
  ask("60D#2B 81 64 01 64 00 00 00");  // 100 kg
  weigh(10);
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 64 00 00 00");
  EXPECT_EQ(cable.last(0x188), "188#01") << "and the car is empty whatever the lowest is";
}

TEST_F(LoadUnit, OtherUnitsThanKilogramsAreRefused) {
  for (unsigned unit = 0; unit <= 0xFFFF; unit += unit % 256 == 3 ? 253 : 1) {
    char text[40];
    std::snprintf(text, sizeof text, "60D#2B 80 64 02 %02X %02X 00 00", unit & 0xFF, unit >> 8);
    const auto prefix = static_cast<std::int8_t>(unit >> 8);
    const bool is_taken = (unit & 0xFF) == 2 && prefix >= -3 && prefix <= 3;
    EXPECT_EQ(ask(text), is_taken ? "58D#60 80 64 02 00 00 00 00" : "58D#80 80 64 02 30 00 09 06");
  }
}

TEST_F(LoadUnit, TheLoadIsInMultiplesOfItsUnit) {
  weigh(450);
  ask("60D#2B 80 64 02 02 01 00 00");
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 2D 00 00 00") << "of 10 kg";
  ask("60D#2B 80 64 02 02 FF 00 00");
  EXPECT_EQ(ask("60D#40 80 64 01 00 00 00 00"), "58D#4B 80 64 01 94 11 00 00") << "of 100 g";
}

class RopeLoads : public testing::Test {
 protected:
  RopeLoads() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 0D");
  }
  unsigned number(std::uint16_t index, std::uint8_t sub) {
    return static_cast<unsigned>(device.node().dictionary().number(index, sub));
  }
  std::string ask(std::string_view request) {
    cable.send(request);
    return cable.last(0x58D);
  }

  static constexpr LiftDeviceOptions lift_2 = {.lift = 2};
  Ropes ropes{{250, 260, 240, 250}};
  Cable cable;
  LoadMeasuringDevice<lift_2, 4> device{
      cable.port(0), 13, ropes.hardware(), {.tare_kg = 1500, .rope_ratio = 0x0201}};
};

TEST_F(RopeLoads, OfACarWithTwoToOneRopingTheRopesCarryHalf) {
  EXPECT_EQ(number(0x6C80, 1), 500u) << "2 x 1000 kg, less the car";
  EXPECT_EQ(cable.last(0x198), "198#02");
  EXPECT_EQ(number(0x6C84, 0), 4u);
  EXPECT_EQ(number(0x6C84, 2), 260u);
  EXPECT_EQ(number(0x6C84, 3), 240u);
}

TEST_F(RopeLoads, TheRatioCanBeSet) {
  EXPECT_EQ(ask("60D#2B 85 6C 01 02 05 00 00"), "58D#60 85 6C 01 00 00 00 00");
  EXPECT_EQ(number(0x6C80, 1), 1000u) << "5 halves of 1000 kg, less the car";
  EXPECT_EQ(ask("60D#2B 85 6C 01 00 01 00 00"), "58D#80 85 6C 01 30 00 09 06");
  EXPECT_EQ(ask("60D#2B 85 6C 01 01 00 00 00"), "58D#80 85 6C 01 30 00 09 06");
}

TEST_F(RopeLoads, OneRopeThatIsNotKnownLeavesTheLoadUnknown) {
  ropes.kilograms[2].reset();
  device.unit().hardware_changed();
  cable.run_for(0s);
  EXPECT_EQ(number(0x6C80, 1), 0xFFFFu);
  EXPECT_EQ(number(0x6C84, 1), 250u);
}

TEST_F(RopeLoads, ALightCarIsNoNegativeLoad) {
  ropes.kilograms = {100, 100, 100, 100};
  cable.run_for(100ms);
  EXPECT_EQ(number(0x6C80, 1), 0u);
  EXPECT_EQ(cable.last(0x198), "198#01");
}

}  // namespace
}  // namespace canvoy::cia417::load_measuring_unit_test
