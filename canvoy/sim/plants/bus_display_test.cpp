// What a passenger sees: a real device on a cable, with texts and mappings by SDO; the expected
// text is typed from what was sent.
#include "canvoy/sim/plants/bus_display.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"

namespace canvoy::bus_display_test {
namespace {

using Lines = std::vector<std::string>;
using InformationText = cia407::PassengerInformationKind<cia407::InformationClass::information,
                                                         cia407::InformationSubclass::text>;

class Passenger : public testing::Test {
 protected:
  static constexpr const cia407::BusUnit* units[] = {&cia407::bus_unit<InformationText>};

  Time now() { return bench == nullptr ? Time{} : bench->cable.now; }
  /// Writes 6203h, from the first element on, and the update command.
  void show(const std::vector<std::string>& mapped) {
    char number[] = "02";
    for (const std::string& each : mapped) {
      bench->ask(std::string("23 03 62 ") + number + " " + each);
      ++number[1];
    }
    bench->ask("23 03 62 01 0" + std::to_string(mapped.size()) + " 00 00 00");
  }

  cia407::BusBench* bench = nullptr;
  BusDisplay display{{.columns = 12, .lines = 2}, callback<&Passenger::now>(*this)};
  cia407::BusBench own{units, [this](Environment& environment) {
                         environment.provide(callback<&BusDisplay::hardware>(display));
                       }};
  Passenger() { bench = &own; }
};

TEST_F(Passenger, ReadsTextsInTheirPlace) {
  EXPECT_TRUE(display.is_dark());
  bench->download(0x6112, 1, "Zoo");
  bench->download(0x610D, 1, "Airport");
  show({"01 61 12 08", "01 61 0D 0C"});
  EXPECT_EQ(display.text(), (Lines{"    Zoo", "     Airport"})) << "centred, and at the right";
  show({"01 61 12 00"});
  EXPECT_EQ(display.text(), (Lines{"Zoo", ""}));
}

TEST_F(Passenger, ReadsALargeLineAtTheLeft) {
  bench->ask("23 96 61 00 32 33 61 2E");
  bench->download(0x610D, 1, "Airport");
  bench->download(0x610C, 1, "Main");
  show({"00 61 96 0F", "01 61 0D 00", "01 61 0C 00"});
  EXPECT_EQ(display.text(), (Lines{"2 3 a .  Air", "         Mai"}));
}

TEST_F(Passenger, ReadsTheLettersOfTheCharacterSet) {
  bench->download(0x6112, 1, "K\xF6ln \xA4");
  show({"01 61 12 00"});
  EXPECT_EQ(display.text()[0], "K\uFFFDln \uFFFD") << "not ASCII";
  bench->ask("2B 05 62 01 0F 00 00 00");
  show({"01 61 12 00"});
  EXPECT_EQ(display.text()[0], "K\u00F6ln \u20AC") << "ISO 8859-15 has the euro";
  bench->ask("2B 05 62 01 05 00 00 00");
  show({"01 61 12 00"});
  EXPECT_EQ(display.text()[0], "K\u0456ln \u0404") << "ISO 8859-5 is Cyrillic";
}

/// Octets of the code tables of ISO 8859: E1h is aleph in -8, meem in -6, sara ae in -11; of these
/// the sign has no pictures, so that a text in them would be a row of boxes.
TEST_F(Passenger, ChoosesASetThatTheSignCanDraw) {
  std::string offered;
  for (const char* sub : {"02", "03", "04", "05", "06", "07", "08", "09", "0A", "0B", "0C", "0D"}) {
    offered += bench->ask(std::string("40 05 62 ") + sub + " 00 00 00 00").substr(12, 3);
  }
  EXPECT_EQ(offered, "01 02 03 04 05 07 09 0A 0D 0E 0F 00 ");
  for (const char* set : {"06", "08", "0B"}) {
    EXPECT_EQ(bench->ask(std::string("2B 05 62 01 ") + set + " 00 00 00"),
              "80 05 62 01 30 00 09 06");
  }
}

/// FF04h in 7.3, flag 2 in 9.2.4: "mapped information cannot be displayed".
TEST_F(Passenger, IsToldOfACharacterThatTheSignCannotDraw) {
  constexpr std::uint32_t emergency = 0x085;
  constexpr std::uint32_t event = 0x185;
  bench->download(0x6112, 1, "K\xF6ln");
  bench->download(0x610D, 1, "Airport");
  show({"01 61 12 00", "01 61 0D 00"});
  EXPECT_EQ(display.text(), (Lines{"K\uFFFDln", "Airport"})) << "all that can be read is shown";
  EXPECT_EQ(bench->cable.last(emergency), "085#04 FF 01 01 00 00 00 00");
  EXPECT_EQ(bench->cable.last(event), "185#01 00 00 00 04 00 00 03");
  bench->ask("2B 05 62 01 01 00 00 00");
  show({"01 61 12 00", "01 61 0D 00"});
  EXPECT_EQ(display.text()[0], "K\u00F6ln");
  EXPECT_EQ(bench->cable.last(emergency), "085#00 00 00 00 00 00 00 00");
  EXPECT_EQ(bench->cable.last(event), "185#00 00 00 00 00 00 00 00");
  // A5h is no character of ISO 8859-3.
  bench->ask("2B 05 62 01 03 00 00 00");
  bench->download(0x6112, 1, "\xA5");
  show({"01 61 12 00"});
  EXPECT_EQ(bench->cable.last(emergency), "085#04 FF 01 01 00 00 00 00");
}

TEST_F(Passenger, SeesATextFlash) {
  bench->download(0x6112, 1, "Stop");
  show({"01 61 12 40"});
  EXPECT_EQ(display.text()[0], "Stop");
  bench->cable.run_for(999ms);
  EXPECT_EQ(display.text()[0], "Stop");
  bench->cable.run_for(1ms);
  EXPECT_EQ(display.text()[0], "");
  bench->cable.run_for(1s);
  EXPECT_EQ(display.text()[0], "Stop");
  show({"01 61 12 C0"});
  bench->cable.run_for(250ms);
  EXPECT_EQ(display.text()[0], "") << "fast";
}

TEST_F(Passenger, SeesATextScrollFromTheLeft) {
  bench->download(0x6112, 1, "abc");
  show({"01 61 12 30"});
  EXPECT_EQ(display.text()[0], "c");
  bench->cable.run_for(500ms);
  EXPECT_EQ(display.text()[0], "abc");
  bench->cable.run_for(250ms * 10);
  EXPECT_EQ(display.text()[0], "          ab");
  bench->cable.run_for(250ms * 3);
  EXPECT_EQ(display.text()[0], "c") << "and anew";
}

TEST_F(Passenger, ReadsTheTextOfAnXmlFile) {
  bench->download(0x6200, 1, "<p><b>A&amp;B</b> &lt;1</p>");
  show({"01 62 00 00"});
  EXPECT_EQ(display.text()[0], "A&B <1");
}

TEST_F(Passenger, SeesEveryDotInTestMode) {
  bench->ask("23 02 60 01 02 00 00 03");
  std::string full;
  for (int cell = 0; cell < 12; ++cell) full += "\u2588";
  EXPECT_EQ(display.text(), (Lines{full, full}));
  const Picture lit = display.picture();
  for (std::size_t y = 0; y < 32; ++y) {
    for (std::size_t x = 0; x < 96; ++x) {
      ASSERT_EQ(lit.at(x, y), (Picture::Color{0, 0, 0})) << x << "," << y;
    }
  }
  bench->ask("23 02 60 01 00 00 00 03");
  EXPECT_EQ(display.picture().at(0, 0), Picture::Color{});
}

TEST_F(Passenger, SeesAPictureOfTheText) {
  bench->download(0x6112, 1, " L");
  show({"01 61 12 00"});
  const Picture picture = display.picture();
  EXPECT_EQ(picture.width(), 96u);
  EXPECT_EQ(picture.height(), 32u);
  // The foot of an L: dots 1 to 6 of its cell, the second one.
  for (std::size_t x = 0; x < 24; ++x) {
    const bool is_foot = x >= 9 && x <= 14;
    EXPECT_EQ(picture.at(x, 13) == (Picture::Color{0, 0, 0}), is_foot) << x;
  }
}

TEST_F(Passenger, SeesTheStopSign) {
  bench->ask("2F 04 62 00 01 00 00 00");
  EXPECT_TRUE(display.is_stop_requested());
}

}  // namespace
}  // namespace canvoy::bus_display_test
