#include "canvoy/tools/node/expectation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::expectation_test {
namespace {

/// 20.0 °C in steps of 0.125 °C (CiA 418, 6010h).
constexpr std::uint8_t twenty_degrees[] = {0xA0, 0x00};

bool holds(const char* text, std::span<const std::uint8_t> bytes = twenty_degrees,
           const char* object = "6010") {
  return parse_expectation(text).holds(find_address(cia418::profile, object)->entry, bytes);
}

TEST(Expectation, IsAComparisonWithANumberInAnyUnit) {
  EXPECT_TRUE(holds("temperature > 19.9"));
  EXPECT_TRUE(holds("temperature>19.9degC"));
  EXPECT_FALSE(holds("temperature > 20 °C"));
  EXPECT_TRUE(holds("temperature >= 20"));
  EXPECT_TRUE(holds("temperature <= 20"));
  EXPECT_FALSE(holds("temperature < 20"));
  EXPECT_TRUE(holds("temperature = 20.000 °C"));
  EXPECT_TRUE(holds("temperature != 21"));
}

TEST(Expectation, IsARangeWithBothEnds) {
  for (const char* text : {"temperature in 20..30degC", "temperature in 10..20",
                           "temperature in 20..20 °C", "temperature = 19.9..20.1 degC",
                           "temperature in -5degC..20degC", "temperature != 20.1..30"}) {
    EXPECT_TRUE(holds(text)) << text;
  }
  for (const char* text : {"temperature in 20.1..30degC", "temperature in -30..-20",
                           "temperature = 20.1..30", "temperature != 20..30"}) {
    EXPECT_FALSE(holds(text)) << text;
  }
  for (const char* text :
       {"temperature in 30..20", "temperature in warm..hot", "temperature in 20..30V",
        "temperature in 20", "temperature > 20..30", "in 20..30", "temperature in 20.."}) {
    EXPECT_THROW(holds(text), UsageError) << text;
  }
}

TEST(Expectation, IsARangeInAnyUnitWhichMayStandAtItsEndAlone) {
  constexpr std::uint8_t voltage[] = {0x8F, 0xBE, 0x00, 0x00};  // 47.6396 V: CiA 418, 1/1024 V
  for (const char* text : {"battery_voltage in 47600..47700mV", "battery_voltage in 47V..47700mV",
                           "battery_voltage in 0.047..0.048 kV"}) {
    EXPECT_TRUE(holds(text, voltage, "6060")) << text;
  }
  EXPECT_FALSE(holds("battery_voltage in 47640..47700mV", voltage, "6060"));
}

TEST(Expectation, OfANumberThatSaysThatThereIsNoneIsOutsideOfEveryRange) {
  constexpr std::uint8_t none[] = {0xFF, 0xFF};  // CiA 418, 6010h: invalid
  EXPECT_FALSE(holds("temperature in -1000..10000", none));
  EXPECT_TRUE(holds("temperature != -1000..10000", none));
}

TEST(Expectation, IsTheNameOfAState) {
  constexpr std::uint8_t ready[] = {1};
  EXPECT_TRUE(holds("battery_status = ready", ready, "6000"));
  EXPECT_FALSE(holds("battery_status = not_ready", ready, "6000"));
  EXPECT_TRUE(holds("battery_status != not ready", ready, "6000"));
  EXPECT_THROW(holds("battery_status = redy", ready, "6000"), UsageError);
  EXPECT_THROW(holds("battery_status > ready", ready, "6000"), UsageError);
}

TEST(Expectation, OfAnUnknownObjectIsAnUnsignedNumber) {
  constexpr std::uint8_t bytes[] = {0x34, 0x12};
  const auto unknown = [&](const char* text) {
    return parse_expectation(text).holds(nullptr, bytes);
  };
  EXPECT_TRUE(unknown("2000 = 4660"));
  EXPECT_TRUE(unknown("2000 = 0x1234"));
  EXPECT_FALSE(unknown("2000 > 4660"));
}

TEST(Expectation, HasATimeToComeTrueOrToHold) {
  const Expectation within = parse_expectation("battery status = not ready within 1min 30s");
  EXPECT_EQ(within.object, "battery status");
  EXPECT_EQ(within.value, "not ready");
  EXPECT_EQ(within.within, Duration(90s));
  EXPECT_EQ(parse_expectation("6010 < 5 for 2s").holding, Duration(2s));
  EXPECT_EQ(parse_expectation("6010 < 5").within, std::nullopt);
  EXPECT_EQ(parse_expectation("6010 in 5..7degC within 2s").within, Duration(2s));
  EXPECT_EQ(parse_expectation("6010 in 5..7degC for 2s").holding, Duration(2s));
}

TEST(Expectation, WordsInATextAreNoTime) {
  for (const char* value : {R"("waiting for bus")", R"("stays within 5 m")", R"("it's for 2s")"}) {
    const std::string text = fmt::format("manufacturer_device_name = {}", value);
    const Expectation plain = parse_expectation(text);
    EXPECT_EQ(plain.value, value);
    EXPECT_EQ(plain.within, std::nullopt) << value;
    EXPECT_EQ(plain.holding, std::nullopt) << value;
    const Expectation within = parse_expectation(text + " within 2s");
    EXPECT_EQ(within.value, value);
    EXPECT_EQ(within.within, Duration(2s)) << value;
    EXPECT_EQ(parse_expectation(text + " for 300ms").holding, Duration(300ms)) << value;
  }
  std::string filter = "text='is within 5 m' and node=5";
  EXPECT_EQ(take_span(filter, "within"), std::nullopt);
  EXPECT_EQ(filter, "text='is within 5 m' and node=5");
  filter += " within 5s";
  EXPECT_EQ(take_span(filter, "within"), Duration(5s));
  EXPECT_EQ(filter, "text='is within 5 m' and node=5");
  constexpr std::string_view bytes = "waiting for bus";
  const std::span said(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  EXPECT_TRUE(holds(R"(1008 = "waiting for bus")", said, "1008"));
}

TEST(Expectation, IsRefusedWhereItIsNone) {
  for (const char* text : {"", "temperature", "> 5", "temperature >", "temperature ! 5",
                           "temperature > 5 within soon"}) {
    EXPECT_THROW(parse_expectation(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace canvoy::tools::expectation_test
