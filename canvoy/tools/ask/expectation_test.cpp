#include "canvoy/tools/ask/expectation.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia418.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools::expectation_test {
namespace {

/// 20.0 °C: 0.125 °C a step (CiA 418, 6010h).
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
}

TEST(Expectation, IsRefusedWhereItIsNone) {
  for (const char* text : {"", "temperature", "> 5", "temperature >", "temperature ! 5",
                           "temperature > 5 within soon"}) {
    EXPECT_THROW(parse_expectation(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace canvoy::tools::expectation_test
