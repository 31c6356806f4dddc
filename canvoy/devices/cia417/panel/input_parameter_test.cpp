// The parameters of inputs at the wire (CiA 417-4, 4.3.2 to 4.3.5): every bit of them, at exact
// virtual times.
#include <gtest/gtest.h>

#include "canvoy/devices/cia417/panel/input_panel_test.hpp"

namespace canvoy::cia417::input_parameter_test {
namespace {

const std::string up_on = "02 01 01 03 10 01";
const std::string up_off = "02 01 01 03 10 00";

class InputParameterTest : public testing::Test {
 protected:
  InputParameterTest() { bench.start(); }

  /// Of the first input; `bytes` from the lowest on.
  bool set(unsigned number, const std::string& bytes) {
    const char* objects[] = {"20 61", "40 61", "60 61", "80 61"};
    const bool confirmed = bench.write(std::string("23 ") + objects[number - 1] + " 01 " + bytes);
    bench.cable.clear();
    return confirmed;
  }
  void run_until(Duration time) { bench.cable.run_until(Time(time)); }

  PanelBench<> bench;
};

TEST_F(InputParameterTest, AfterPowerOnNothingIsUsed) {
  for (const unsigned index : {0x6120U, 0x6140U, 0x6160U, 0x6180U}) {
    EXPECT_EQ(bench.stored(index, 1), 0xFFFF'FFFFu);
  }
}

// Parameter 1

TEST_F(InputParameterTest, Bit0OfEnableAloneSaysWhetherAnInputIsEnabled) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    char text[16];
    std::snprintf(text, sizeof text, "%02X FF FF FF", value);
    EXPECT_TRUE(set(1, text));
    bench.press(0);
    bench.release(0);
    const Records both{up_on, up_off};
    EXPECT_EQ(bench.told(), value % 2 == 1 ? both : Records{}) << value;
  }
}

TEST_F(InputParameterTest, AnInputThatIsDisabledHasNoRequestAnyLonger) {
  bench.press(0);
  bench.told();
  bench.write("23 20 61 01 FE FF FF FF");
  EXPECT_EQ(bench.told(), (Records{up_off}));
  EXPECT_EQ(bench.stored(0x6100, 1), 0x0010'0301'0102u);
  bench.report(0, CallRequest::defective);
  EXPECT_EQ(bench.told(), Records{});
  bench.report(0, CallRequest::none);
  bench.write("23 20 61 01 FF FF FF FF");
  EXPECT_EQ(bench.told(), (Records{up_on})) << "it is still pressed";
}

// Parameter 2

TEST_F(InputParameterTest, ZeroEventsASecondAreReserved) {
  EXPECT_FALSE(set(2, "FF 00 FF FF"));
  EXPECT_FALSE(set(2, "FF FF 00 FF"));
  EXPECT_EQ(bench.stored(0x6140, 1), 0xFFFF'FFFFu);
  for (unsigned value = 1; value <= 0xFF; ++value) {
    char text[16];
    std::snprintf(text, sizeof text, "FF %02X %02X FF", value, value);
    EXPECT_TRUE(set(2, text)) << value;
  }
}

TEST_F(InputParameterTest, MoreEventsThanTheLimitationStartNoMessage) {
  ASSERT_TRUE(set(2, "FF 03 FF FF"));
  run_until(1s);
  for (unsigned i = 0; i < 4; ++i) {
    bench.press(0);
    bench.cable.run_for(50ms);
    bench.release(0);
    bench.cable.run_for(50ms);
  }
  EXPECT_EQ(bench.reported_at(),
            (Records{"1000000 " + up_on, "1050000 " + up_off, "1100000 " + up_on}));
  EXPECT_EQ(bench.stored(0x6100, 1), 0x0010'0301'0102u) << "stored all the same";
  run_until(4s);
  EXPECT_EQ(bench.reported_at(), (Records{"2000000 " + up_off}))
      << "its state when the second is over";
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{up_on})) << "another second";
}

TEST_F(InputParameterTest, AStateThatIsToldAlreadyIsNotToldAfterTheSecond) {
  ASSERT_TRUE(set(2, "FF 01 FF FF"));
  bench.press(0);
  bench.release(0);
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{up_on}));
  bench.cable.run_for(5s);
  EXPECT_EQ(bench.told(), Records{});
}

TEST_F(InputParameterTest, AMessageStartsWithTheSendingEventOfASecond) {
  ASSERT_TRUE(set(2, "FF FF 03 FF"));
  run_until(1s);
  bench.press(0);
  bench.release(0);
  EXPECT_EQ(bench.told(), Records{});
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{up_on})) << "the third";
  run_until(2s);
  bench.release(0);
  bench.press(0);
  run_until(3s);
  bench.release(0);
  EXPECT_EQ(bench.told(), Records{}) << "the first of another second";
}

TEST_F(InputParameterTest, OtherInputsHaveNoneOfIt) {
  ASSERT_TRUE(set(2, "FF 01 FF FF"));
  ASSERT_TRUE(set(1, "FE FF FF FF"));
  for (unsigned i = 0; i < 3; ++i) {
    bench.press(1);
    bench.release(1);
  }
  EXPECT_EQ(bench.told().size(), 6u);
}

// Parameter 3

TEST_F(InputParameterTest, ALevelCountsWhenItWasThereForTheDebounceTime) {
  ASSERT_TRUE(set(3, "14 FF FF FF"));
  run_until(1s);
  bench.press(0);
  EXPECT_EQ(bench.stored(0x6100, 1), 0x0010'0301'0102u);
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.reported_at(), (Records{"1020000 " + up_on}));
}

TEST_F(InputParameterTest, EachBounceBeginsTheDebounceTimeAnew) {
  ASSERT_TRUE(set(3, "14 FF FF FF"));
  run_until(1s);
  bench.press(0);
  bench.cable.run_for(19ms);
  bench.release(0);
  bench.cable.run_for(1ms);
  bench.press(0);
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.reported_at(), (Records{"1040000 " + up_on}));
  bench.release(0);
  bench.cable.run_for(5ms);
  bench.press(0);
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.told(), Records{}) << "too short";
}

TEST_F(InputParameterTest, EveryDebounceTimeIsInMillisecondsAndFFhIsNone) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    char text[16];
    std::snprintf(text, sizeof text, "%02X FF FF FF", value);
    ASSERT_TRUE(set(3, text));
    const Time begin = bench.cable.now;
    bench.press(0);
    bench.cable.run_for(1s);
    const Duration expected = std::chrono::milliseconds(value == 0xFF ? 0 : value);
    ASSERT_EQ(bench.cable.heard.size(), 1u) << value;
    EXPECT_EQ(bench.cable.heard.front().at - begin, expected);
    bench.release(0);
    bench.cable.run_for(1s);
    bench.told();
  }
}

/// All values of the byte: bit 0 rising edges, bit 1 falling edges, bit 7 polarity; FFh nothing
/// used.
TEST_F(InputParameterTest, EdgesAndPolarityHoldForEachValueOfTheirByte) {
  for (unsigned value = 0; value <= 0xFF; ++value) {
    char text[16];
    std::snprintf(text, sizeof text, "FF %02X FF FF", value);
    const bool inverted = value != 0xFF && value >= 0x80;
    set(3, "FF FF FF FF");
    bench.level(0, inverted);
    set(3, text);
    bench.cable.clear();
    bench.level(0, !inverted);
    EXPECT_EQ(bench.told(), (value & 1) != 0 ? Records{up_on} : Records{}) << value;
    EXPECT_EQ(bench.stored(0x6100, 1) >> 40, 1u) << "stored whichever edge is told";
    bench.level(0, inverted);
    EXPECT_EQ(bench.told(), (value & 2) != 0 ? Records{up_off} : Records{}) << value;
    EXPECT_EQ(bench.stored(0x6100, 1) >> 40, 0u);
  }
}

TEST_F(InputParameterTest, WithRisingEdgesAloneEachPressIsToldAlthoughTheRecordIsTheSame) {
  ASSERT_TRUE(set(3, "FF 7D FF FF"));
  for (unsigned i = 0; i < 3; ++i) {
    bench.press(0);
    bench.release(0);
  }
  EXPECT_EQ(bench.told(), (Records{up_on, up_on, up_on}));
}

TEST_F(InputParameterTest, AnotherPolarityIsAnotherState) {
  bench.write("23 60 61 01 FF 83 FF FF");
  EXPECT_EQ(bench.told(), (Records{up_on})) << "open is a request now";
  bench.write("23 60 61 01 FF FF FF FF");
  EXPECT_EQ(bench.told(), (Records{up_off}));
}

// Parameter 4

TEST_F(InputParameterTest, Parameter4IsReservedAndMeansNothing) {
  EXPECT_TRUE(set(4, "00 00 00 00"));
  bench.press(0);
  EXPECT_EQ(bench.told(), (Records{up_on}));
}

// Panels without parameters

constexpr auto bare_panel =
    describe(panel<PanelOptions{.inputs = 2, .parameters = false}>(), cia301::identity({}));
constexpr auto bare_layout = partial(lay_out_device<bare_panel>());

TEST(InputParameter, APanelWithoutParametersIsEnabledAndTellsBothEdges) {
  PanelBench<bare_layout> bench;
  bench.start();
  bench.press(0);
  bench.release(0);
  EXPECT_EQ(bench.told(), (Records{up_on, up_off}));
}

}  // namespace
}  // namespace canvoy::cia417::input_parameter_test
