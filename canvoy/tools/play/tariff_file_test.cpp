// The tariff of a taxi in its network file: what is read is written again, invalid values are
// refused in one line, and passengers pay by it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "canvoy/tools/play/network_file_test.hpp"

namespace canvoy::tools::tariff_file_test {
namespace {

std::string written(const std::string& text) {
  return rewritten_file("taxi", text);
}
void expect_written(const std::string& text, const std::string& expected) {
  const std::string file = written(text);
  EXPECT_NE(file.find(expected), std::string::npos) << expected << "\n" << file;
}

/// Without comments.
std::string values_of(const std::string& file) {
  std::string values;
  for (std::size_t at = 0; at < file.size();) {
    const std::size_t end = std::min(file.find('\n', at), file.size());
    const std::string line = file.substr(at, end - at);
    values += line.substr(0, line.find("  #")) + "\n";
    at = end + 1;
  }
  return values;
}

TEST(TariffFile, OfTheExampleIsReadAsItIsWritten) {
  const std::string file = written("");
  const std::string second_line = file.substr(file.find("\n", file.find("network = ")) + 1);
  EXPECT_EQ(written(second_line), file);
}

TEST(TariffFile, HasACurrencyOfItsOwn) {
  const std::string swiss =
      "[currency]\ncode = \"CHF\"\nsymbol = \"Fr.\"\nsymbol_leads = true\ncoin = 0.05\n";
  const std::string values = values_of(written(swiss));
  EXPECT_NE(values.find("\n" + swiss), std::string::npos) << values;
  expect_written("[currency]\ncode = \"USD\"\n", "symbol = \"USD\"");
}

TEST(TariffFile, HasSupplementsOfSeveralKinds) {
  const std::string kinds =
      "[[supplement]]\nname = \"Luggage\"\nprice = 1.5\nshare = 0.25\n"
      "\n[[supplement]]\nname = \"Wheelchair\"\nprice = 0.0\nshare = 1.0\n";
  const std::string values = values_of(written(kinds));
  EXPECT_NE(values.find("[[supplement]]\nname = \"Luggage\""), std::string::npos) << values;
  EXPECT_NE(values.find("name = \"Wheelchair\""), std::string::npos) << values;
  EXPECT_EQ(values.find("Airport"), std::string::npos) << "of the example";
}

TEST(TariffFile, WithLevelsOfItsOwnHasNoSupplementsOfTheExample) {
  const std::string values = values_of(written("[[tariff]]\nlevel = \"1\"\ninitial_fare = 4\n"));
  EXPECT_EQ(values.find("[[supplement]]"), std::string::npos) << values;
}

struct Refused {
  const char* text;
  const char* complaint;
};
class TariffFileRefuses : public testing::TestWithParam<Refused> {};

TEST_P(TariffFileRefuses, InOneLine) {
  EXPECT_EQ(written(GetParam().text), std::string("car.toml line ") + GetParam().complaint);
}

constexpr Refused refused[] = {
    {"[currency]\ncode = \"Euro\"\n", "3: code: \"Euro\" is no code of three capitals"},
    {"[currency]\ncode = \"eur\"\n", "3: code: \"eur\" is no code of three capitals"},
    {"[currency]\nsymbol = \"\"\n", "3: symbol: \"\" is no symbol of 1 to 4 characters of ASCII"},
    {"[currency]\nsymbol = \"Euros\"\n",
     "3: symbol: \"Euros\" is no symbol of 1 to 4 characters of ASCII"},
    {"[currency]\ncoin = 0.0005\n", "3: coin: 0.0005 is not from 0.001 to 1000"},
    {"[currency]\ncoin = 0.0015\n", "3: coin: 0.0015 is no whole number of thousandths"},
    {"[currency]\ncoin = 0.25\n",
     "2: currency: the tariff of the example is no coins of 0.25: write [[tariff]]"},
    {"[currency]\ncoin = 1\n[[tariff]]\nlevel = \"1\"\ninitial_fare = 4.5\n",
     "6: initial_fare: 4.5 is no whole number of coins, of which nobody can pay a part: take a "
     "multiple of 1"},
    {"[currency]\ncoin = 1\n[[tariff]]\nlevel = \"1\"\ninitial_fare = 4\nstep = 0.1\n",
     "7: step: 0.1 is not from 1 to 100000"},
    {"[[supplement]]\nprice = 1\n",
     "2: name: \"\" is no name of 1 to 11 characters of ASCII, with a letter first"},
    {"[[supplement]]\nname = \"Two large bags\"\n",
     "3: name: \"Two large bags\" is no name of 1 to 11 characters of ASCII, with a letter first"},
    {"[[supplement]]\nname = \"1 bag\"\n",
     "3: name: \"1 bag\" is no name of 1 to 11 characters of ASCII, with a letter first"},
    {"[[supplement]]\nname = \"Total\"\n", "3: name: \"Total\" is another line of receipts"},
    {"[[supplement]]\nname = \"Bag\"\nprice = 0.005\n",
     "4: price: 0.005 is no whole number of coins, of which nobody can pay a part: take a multiple "
     "of 0.01"},
    {"[[supplement]]\nname = \"Bag\"\nprice = -1\n", "4: price: -1 is not from 0 to 100000"},
    {"[[supplement]]\nname = \"Bag\"\nshare = 2\n", "4: share: 2 is not from 0 to 1"},
    {"[[supplement]]\nname = \"Bag\"\n[[supplement]]\nname = \"bag\"\n",
     "5: name: there is one of this name already"},
    {"[agreed_price]\nshare = 0.5\n",
     "2: agreed_price: a trip costs nothing: write per_km or least"},
    {"[agreed_price]\nleast = 0.001\n",
     "3: least: 0.001 is no whole number of coins, of which nobody can pay a part: take a multiple "
     "of 0.01"},
    {"[business]\nvat_percent = 7.25\n", "3: vat_percent: 7.25 is no whole number of tenths"},
    {"[business]\nvat_percent = 51\n", "3: vat_percent: 51 is not from 0 to 50"},
    {"[business]\ncompany = \"A company that has a very long name\"\n",
     "3: company: \"A company that has a very long name\" is no text of 24 characters of ASCII"}};
INSTANTIATE_TEST_SUITE_P(Each, TariffFileRefuses, testing::ValuesIn(refused));

TEST(TariffFile, HasEightKindsOfSupplementsAtMost) {
  std::string text;
  for (char name = 'A'; name <= 'H'; ++name)
    text += fmt::format("[[supplement]]\nname = \"{}\"\n", name);
  expect_written(text, "name = \"H\"");
  EXPECT_EQ(written(text + "[[supplement]]\nname = \"I\"\n"),
            "car.toml line 18: there are more than 8 supplements");
}

// -- and the fares

/// Yen: 500, then 100 every 250 m or 90 s: 400 per km, 4000 per hour; luggage for all, and half of
/// them agree on 300 per km.
constexpr const char* in_yen =
    "for = \"80min\"\n[currency]\ncode = \"JPY\"\nsymbol = \"Yen\"\ncoin = 1\n"
    "[[tariff]]\nlevel = \"1\"\ninitial_fare = 500\nper_km = 400\nper_hour = 4000\nstep = 100\n"
    "[[supplement]]\nname = \"Luggage\"\nprice = 200\nshare = 1\n"
    "[agreed_price]\nshare = 0.5\nper_km = 300\nleast = 600\n"
    "[business]\ncompany = \"Edo Cabs\"\ndriver = \"B. Basho\"\nvat_percent = 10\n"
    "[shift]\nwaiting_max = \"30s\"\ntrip_max_m = 2000\n";

TEST(TariffFile, IsWhatPassengersPay) {
  TomlFile file("car.toml", std::string("network = \"taxi\"\n") + in_yen);
  std::string network;
  file.table().take("network", network);
  const HeardWorld made = world_of("taxi").make(file.table(), "");
  made.network->run_until(Time(70min));
  const auto end = made.network->summary_json();
  ASSERT_GE(end["trips"].size(), 3u);
  EXPECT_TRUE(end["all_held"]) << end["invariants"];
  unsigned agreed = 0;
  for (const auto& trip : end["trips"]) {
    EXPECT_EQ(trip["extras"], 200) << trip;
    const double fare = trip["fare"];
    EXPECT_EQ(std::fmod(fare, 100), 0) << fare;
    if (trip["fare_low"] == trip["fare_high"]) ++agreed;
  }
  EXPECT_GE(agreed, 1u);
  EXPECT_LT(agreed, end["trips"].size());
  for (const auto& one : end["invariants"]) {
    const bool is_of_money = one["invariant"] == "receipts" ||
                             one["invariant"] == "receipt_lines" ||
                             one["invariant"] == "shift_slip" || one["invariant"] == "waiting";
    if (is_of_money) {
      EXPECT_TRUE(one["decided"]) << one;
    }
  }
}

}  // namespace
}  // namespace canvoy::tools::tariff_file_test
