// Expected values are the output of nlohmann::json for the double.
#include "canvoy/text/json_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace canvoy::text::json_number_test {
namespace {

std::string decimal(std::int64_t number, unsigned places) {
  std::string line;
  append_json_decimal(line, number, places);
  return line;
}
std::string dumped(std::int64_t number, unsigned places) {
  return nlohmann::json(static_cast<double>(number) / std::pow(10.0, places)).dump();
}

TEST(JsonNumber, IsWrittenAsTheLibraryDoes) {
  EXPECT_EQ(decimal(20125, 3), "20.125");
  EXPECT_EQ(decimal(20000, 3), "20.0");
  EXPECT_EQ(decimal(-125, 3), "-0.125");
  EXPECT_EQ(decimal(7, 0), "7.0");
  EXPECT_EQ(decimal(0, 6), "0.0");
  EXPECT_EQ(decimal(1'700'000'000'000'125, 6), "1700000000.000125");
  EXPECT_EQ(decimal(25, 6), "2.5e-05");
}

TEST(JsonNumber, OfAllSizesIsTheSame) {
  std::mt19937_64 random(1);
  for (unsigned i = 0; i < 400'000; ++i) {
    const auto number = static_cast<std::int64_t>(random()) >> i % 64;
    if (number == std::numeric_limits<std::int64_t>::min()) continue;
    const unsigned places = i % 16;
    ASSERT_EQ(decimal(number, places), dumped(number, places)) << number << " " << places;
  }
}

TEST(JsonNumber, OfSmallSizesIsTheSame) {
  for (std::int64_t number = -20'000; number <= 20'000; ++number) {
    for (const unsigned places : {0U, 1U, 3U, 6U}) {
      ASSERT_EQ(decimal(number, places), dumped(number, places)) << number << " " << places;
    }
  }
}

TEST(JsonNumber, OfTimesSince1970IsTheSame) {
  std::mt19937_64 random(2);
  for (unsigned i = 0; i < 400'000; ++i) {
    const auto time = static_cast<std::int64_t>(random() % 2'000'000'000'000'000);
    ASSERT_EQ(decimal(time, 6), dumped(time, 6)) << time;
  }
  // Around powers of two, and at the limit of the precision of a double.
  for (unsigned power = 10; power <= 52; ++power) {
    for (std::int64_t off = -3; off <= 3; ++off) {
      const std::int64_t seconds = (std::int64_t{1} << power) + off;
      ASSERT_EQ(decimal(seconds, 6), dumped(seconds, 6)) << seconds;
      if (power > 32) continue;
      const std::int64_t time = (std::int64_t{1} << power) * 1'000'000 + off;
      ASSERT_EQ(decimal(time, 6), dumped(time, 6)) << time;
    }
  }
}

}  // namespace
}  // namespace canvoy::text::json_number_test
