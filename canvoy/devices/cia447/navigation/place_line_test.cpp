// Lines of a file of places, right and wrong.
#include "canvoy/devices/cia447/navigation/place_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace canvoy::cia447::place_line_test {
namespace {

TEST(PlaceLine, SaysWhereWhatIs) {
  const PlaceLine line = parse_place_line("48.13715 11.57538 | Marienplatz 1 | Munich | Germany");
  ASSERT_TRUE(line.has_place);
  EXPECT_EQ(line.error, PlaceLineError::none);
  EXPECT_EQ(line.place, (NamedPlace{.position = {48.13715, 11.57538},
                                    .city = "Munich",
                                    .street = "Marienplatz 1",
                                    .country = "Germany"}));
}

TEST(PlaceLine, BlanksDoNotMatter) {
  const PlaceLine line = parse_place_line("\t-33.5   -70  |  |Santiago de Chile|\r");
  ASSERT_TRUE(line.has_place);
  EXPECT_EQ(line.place.position, (GeoPosition{-33.5, -70}));
  EXPECT_EQ(line.place.city, "Santiago de Chile");
  EXPECT_EQ(line.place.street, "");
  EXPECT_EQ(line.place.country, "");
}

TEST(PlaceLine, RemarksAndEmptyLinesAreNoPlaces) {
  for (const std::string_view text : {"", "   ", "\r", "# a remark", "  # 1 2 | a | b | c"}) {
    const PlaceLine line = parse_place_line(text);
    EXPECT_FALSE(line.has_place) << text;
    EXPECT_EQ(line.error, PlaceLineError::none) << text;
  }
}

TEST(PlaceLine, SaysWhatIsWrong) {
  struct Case {
    std::string text;
    PlaceLineError error;
  };
  const std::string long_name(65, 'x');
  for (const Case& one :
       {Case{"48 11", PlaceLineError::fields}, Case{"48 11 | a | b", PlaceLineError::fields},
        Case{"48 11 | a | b | c | d", PlaceLineError::fields},
        Case{" | a | b | c", PlaceLineError::latitude},
        Case{"90.1 11 | a | b | c", PlaceLineError::latitude},
        Case{"-90.1 11 | a | b | c", PlaceLineError::latitude},
        Case{"N48 11 | a | b | c", PlaceLineError::latitude},
        Case{"48,1 11 | a | b | c", PlaceLineError::latitude},
        Case{"48 | a | b | c", PlaceLineError::longitude},
        Case{"48 180.1 | a | b | c", PlaceLineError::longitude},
        Case{"48 -180.1 | a | b | c", PlaceLineError::longitude},
        Case{"48 11 12 | a | b | c", PlaceLineError::position},
        Case{"48 11 | a |  | c", PlaceLineError::city},
        Case{"48 11 | " + long_name + " | b | c", PlaceLineError::length},
        Case{"48 11 | a | " + long_name + " | c", PlaceLineError::length},
        Case{"48 11 | a | b | " + long_name, PlaceLineError::length}}) {
    const PlaceLine line = parse_place_line(one.text);
    EXPECT_EQ(line.error, one.error) << one.text;
    EXPECT_FALSE(line.has_place) << one.text;
    EXPECT_FALSE(text_of(line.error).empty());
  }
}

TEST(PlaceLine, TheEdgesOfTheEarthAreOnIt) {
  EXPECT_TRUE(parse_place_line("90 180 | | Pole | ").has_place);
  EXPECT_TRUE(parse_place_line("-90 -180 | | Pole | ").has_place);
  EXPECT_TRUE(parse_place_line("0 0 | | " + std::string(64, 'x') + " | ").has_place);
}

}  // namespace
}  // namespace canvoy::cia447::place_line_test
