// Signs are read by their dots alone.
#include "canvoy/sim/plants/sign_reader.hpp"

#include <gtest/gtest.h>

#include "canvoy/sim/plants/bus_display.hpp"

namespace canvoy::sign_reader_test {
namespace {

/// Reads a sign of 12 columns and 2 lines that receives these octets.
class Sign : public testing::Test {
 protected:
  void show(const std::string& octets, std::uint16_t set) {
    octets_.assign(octets.begin(), octets.end());
    const cia407::ShownElement element{.octets = octets_, .character_set = set};
    display_.hardware().show({&element, 1});
  }
  std::u32string read(std::size_t page = 0) const { return read_sign(display_.picture_of(page)); }

  Time midnight() { return {}; }

  std::vector<std::uint8_t> octets_;
  BusDisplay display_{{.columns = 12, .lines = 2}, callback<&Sign::midnight>(*this)};
};

TEST_F(Sign, IsReadByItsDots) {
  show("Main Street", 0);
  EXPECT_EQ(read(), U"Main Street");
  show("", 0);
  EXPECT_EQ(read(), U"");
}

TEST_F(Sign, HasTheLettersOfItsCharacterSet) {
  // In ISO 8859-2, A3h is L with a stroke, BCh z with an acute; in 8859-7, D0h is capital pi, E1h
  // alpha.
  show(
      "\xA3\xF3"
      "d\xBC",
      2);
  EXPECT_EQ(read(), U"\u0141\u00F3d\u017A");
  show("\xD0\xE1", 7);
  EXPECT_EQ(read(), U"\u03A0\u03B1");
  // In 8859-5, BCh to BFh are capital em to pe; the first looks like M.
  show("\xBF\xD8", 5);
  EXPECT_EQ(read(), (std::u32string{look_of(U'\u041F'), U'\u0438'}));
  EXPECT_EQ(look_of(U'\u041C'), U'M');
}

TEST_F(Sign, ABoxCannotBeRead) {
  // In 8859-6, C7h is an alef, of which the sign has no picture.
  show("A\xC7", 6);
  EXPECT_EQ(read(), (std::u32string{U'A', unreadable}));
  EXPECT_EQ(look_of(U'\u0627'), unreadable);
}

TEST_F(Sign, ATestPatternCannotBeRead) {
  show("Main Street", 0);
  display_.hardware().test(true);
  EXPECT_EQ(read(), std::u32string(12, unreadable) + U"\n" + std::u32string(12, unreadable));
}

TEST_F(Sign, ATextThatIsLongerThanALineGoesOnInTheNextOne) {
  show("Market Square North Side", 0);
  EXPECT_EQ(display_.pages(), 2u);
  EXPECT_EQ(read(0), U"Market\nSquare North");
  EXPECT_EQ(read(1), U"Side");
  EXPECT_EQ(display_.text(), (std::vector<std::string>{"Market", "Square North"}));
}

TEST_F(Sign, AWordThatIsLongerThanALineIsCut) {
  show("Hauptbahnhofsplatz", 0);
  EXPECT_EQ(read(), U"Hauptbahnhof");
}

}  // namespace
}  // namespace canvoy::sign_reader_test
