// The parameters of outputs at the wire (CiA 417-4, 4.5.1 to 4.5.4): every bit of them, at exact
// virtual times.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/panel/output_panel_test.hpp"

namespace canvoy::cia417::output_parameter_test {
namespace {

class OutputParameterTest : public testing::Test {
 protected:
  OutputParameterTest() { bench.start(); }

  /// Of the first output; `bytes` from the lowest on.
  bool set(unsigned number, const std::string& bytes) {
    const char* objects[] = {"20 62", "40 62", "60 62", "80 62"};
    const bool confirmed = bench.write(std::string("23 ") + objects[number - 1] + " 01 " + bytes);
    bench.shown.clear();
    return confirmed;
  }
  /// Like set(), but with a byte that is a number.
  bool set(unsigned number, const char* format, unsigned value) {
    char bytes[16];
    std::snprintf(bytes, sizeof bytes, format, value);
    return set(number, bytes);
  }
  void on() { bench.tell("02 01 01 03 10 01"); }
  void off() { bench.tell("02 01 01 03 10 00"); }

  OutputBench bench;
};

TEST_F(OutputParameterTest, AfterPowerOnNothingIsUsed) {
  for (const unsigned index : {0x6220U, 0x6240U, 0x6260U, 0x6280U}) {
    EXPECT_EQ(bench.stored(index, 1), 0xFFFF'FFFFu);
  }
}

// Parameter 1

TEST_F(OutputParameterTest, Bit0OfEnableAloneSaysWhetherAnOutputIsEnabled) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    EXPECT_TRUE(set(1, "%02X FF FF FF", value));
    off();
    on();
    EXPECT_EQ(bench.is_on(0), value % 2 == 1) << value;
    EXPECT_EQ(bench.shown.size(), value % 2 == 1 ? 2u : 0u);
  }
}

TEST_F(OutputParameterTest, ADisabledOutputIsOffAndShowsWhatItHadWhenItIsEnabledAgain) {
  on();
  ASSERT_TRUE(set(1, "FE FF FF FF"));
  EXPECT_FALSE(bench.is_on(0));
  off();
  ASSERT_TRUE(set(1, "FF FF FF FF"));
  EXPECT_TRUE(bench.is_on(0)) << "no message was processed meanwhile";
}

TEST_F(OutputParameterTest, AnErrorIsToldInParameter1) {
  bench.panel.unit().report(0, 0x42);
  EXPECT_EQ(bench.stored(0x6220, 1), 0xFFFF'42FFu);
  bench.panel.unit().report(0, 0xFF);
  EXPECT_EQ(bench.stored(0x6220, 1), 0xFFFF'FFFFu);
  bench.panel.unit().report(7, 0x42);
}

/// As if 1010h had stored parameter 1.
TEST(OutputParameter, TheDefaultValueIsTheFunctionDataAfterPowerOn) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    OutputBench bench;
    Node& node = bench.panel.node();
    auto store = [&](ResetScope) {
      node.dictionary().set_number(0x6220, 1, 0x00FF'FFFFU | value << 24);
    };
    node.on_defaults_restored(Callback<void(ResetScope)>::of(store));
    bench.start();
    const unsigned expected = value == 0xFF ? 0 : value;
    EXPECT_EQ(bench.stored(0x6200, 1) >> 40, expected);
    EXPECT_EQ(bench.is_on(0), expected % 2 == 1) << value;
    EXPECT_EQ(bench.view(0).flash_millihertz != 0, (expected >> 1 & 7) == 3) << value;
    node.on_defaults_restored({});
  }
}

// Parameter 2

TEST_F(OutputParameterTest, ZeroEventsAreReserved) {
  EXPECT_FALSE(set(2, "FF 00 FF FF"));
  EXPECT_FALSE(set(2, "FF FF 00 FF"));
  EXPECT_EQ(bench.stored(0x6240, 1), 0xFFFF'FFFFu);
  for (unsigned value = 1; value <= 0xFF; ++value) {
    EXPECT_TRUE(set(2, "FF %02X FF FF", value));
    EXPECT_TRUE(set(2, "FF FF %02X FF", value));
  }
}

TEST_F(OutputParameterTest, MoreEventsThanTheLimitationWaitUntilTheSecondIsOver) {
  ASSERT_TRUE(set(2, "FF 02 FF FF"));
  on();
  off();
  bench.run_for(300ms);
  on();
  off();
  on();
  EXPECT_EQ(bench.shown.size(), 2u);
  EXPECT_FALSE(bench.is_on(0));
  bench.run_for(700ms - 1us);
  EXPECT_FALSE(bench.is_on(0));
  bench.run_for(1us);
  EXPECT_TRUE(bench.is_on(0)) << "the last one";
  EXPECT_EQ(bench.shown.size(), 3u);
  off();
  EXPECT_FALSE(bench.is_on(0)) << "another second";
}

TEST_F(OutputParameterTest, AsManyMessagesAsTheReceptionEventSaysStartOne) {
  for (unsigned needed = 1; needed < 0xFF; ++needed) {
    ASSERT_TRUE(set(2, "FF FF %02X FF", needed));
    for (unsigned message = 1; message < needed; ++message) on();
    ASSERT_FALSE(bench.is_on(0)) << needed;
    on();
    ASSERT_TRUE(bench.is_on(0)) << needed;
    set(2, "FF FF FF FF");
    off();
  }
}

TEST_F(OutputParameterTest, TheImpulseTimeIsInTenthsOfASecondAndTakesNoMessageMeanwhile) {
  for (unsigned tenths = 1; tenths < 0xFF; ++tenths) {
    ASSERT_TRUE(set(2, "FF FF FF %02X", tenths));
    on();
    off();
    bench.run_for(std::chrono::milliseconds(100 * tenths) - 1us);
    ASSERT_TRUE(bench.is_on(0)) << tenths;
    bench.run_for(1us);
    ASSERT_FALSE(bench.is_on(0)) << tenths;
  }
  ASSERT_TRUE(set(2, "FF FF FF 00"));
  on();
  bench.run_for(60s);
  EXPECT_TRUE(bench.is_on(0)) << "no impulse";
}

TEST_F(OutputParameterTest, PropertyImpulseHasATimeOfItsOwn) {
  ASSERT_TRUE(set(2, "FF FF FF 64"));
  bench.tell("02 01 01 03 10 05");
  bench.run_for(500ms);
  EXPECT_FALSE(bench.is_on(0)) << "0.5 s, not 10 s";
}

TEST_F(OutputParameterTest, OtherOutputsHaveNoneOfIt) {
  ASSERT_TRUE(set(2, "FF 01 05 01"));
  bench.tell("02 02 01 03 10 01");
  bench.tell("02 02 01 03 10 00");
  bench.tell("02 02 01 03 10 01");
  EXPECT_TRUE(bench.is_on(1));
}

// Parameter 3

TEST_F(OutputParameterTest, PolarityInvertsTheContactForEachValueOfItsByte) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    ASSERT_TRUE(set(3, "FF %02X FF FF", value));
    const bool inverted = value >= 0x80 && value != 0xFF;
    off();
    EXPECT_EQ(bench.view(0).level(), inverted) << value;
    on();
    EXPECT_TRUE(bench.is_on(0));
    EXPECT_EQ(bench.view(0).level(), !inverted) << value;
  }
}

TEST_F(OutputParameterTest, AnotherPolarityIsShownAtOnce) {
  bench.write("23 60 62 01 FF 80 FF FF");
  EXPECT_EQ(bench.shown, (std::vector<std::uint32_t>{0}));
  EXPECT_TRUE(bench.view(0).level());
}

// Parameter 4

TEST_F(OutputParameterTest, TheBasicSettingIsShownWhereTheMessageSaysDefault) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    const bool used = value != 0xFF;
    ASSERT_TRUE(set(4, "%02X FF FF FF", value));
    EXPECT_EQ(bench.view(0).flash_millihertz, used ? 100 * value : 0) << "0 is always set";
    ASSERT_TRUE(set(4, "FF %02X FF FF", value));
    EXPECT_EQ(bench.view(0).scroll_rate.value_or(0xFF), value);
    ASSERT_TRUE(set(4, "FF FF %02X FF", value));
    EXPECT_EQ(bench.view(0).color.value_or(0xFF), value);
    ASSERT_TRUE(set(4, "FF FF FF %02X", value));
    EXPECT_EQ(bench.view(0).intensity.has_value(), used && value != 0) << "0 is reserved";
    EXPECT_EQ(bench.view(0).intensity.value_or(static_cast<std::uint8_t>(value)), value);
  }
}

TEST_F(OutputParameterTest, AMessageGoesBeforeTheBasicSetting) {
  ASSERT_TRUE(set(4, "14 05 01 40"));
  on();
  const OutputView basic = bench.view(0);
  EXPECT_EQ(basic.flash_millihertz, 2000);
  bench.tell("02 01 01 03 10 03");
  EXPECT_EQ(bench.view(0).flash_millihertz, 0) << "continuous";
  bench.tell("02 01 01 03 10 77");
  EXPECT_EQ(bench.view(0).flash_millihertz, 250) << "flashing";
  bench.tell("02 01 01 03 10 59");
  EXPECT_EQ(bench.view(0).color, 5) << "red";
  EXPECT_EQ(bench.view(0).flash_millihertz, 2000) << "and flashing as always";
  bench.tell("02 01 01 03 10 7B");
  EXPECT_EQ(bench.view(0).intensity, 254);
  bench.tell("02 01 01 03 10 0D");
  EXPECT_FALSE(bench.view(0).scroll_rate.has_value()) << "automatic";
  bench.tell("02 01 01 03 10 0F");
  EXPECT_EQ(bench.view(0), basic) << "the reserved property is taken as default";
  on();
  EXPECT_EQ(bench.view(0), basic) << "what one message says is not kept for the next";
}

}  // namespace
}  // namespace canvoy::cia417::output_parameter_test
