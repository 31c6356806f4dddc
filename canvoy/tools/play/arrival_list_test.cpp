#include "canvoy/tools/play/arrival_list.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::arrival_list_test {
namespace {

const lift::Building building = lift::uniform_building({.floors = 8});

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(parse_arrivals("people.csv", text, building));
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

TEST(ArrivalList, ReadsALineForEachPersonWithOrWithoutWeight) {
  const auto arrivals = parse_arrivals(
      "people.csv", "seconds,from,to,kg\r\n12.5, 1, 7, 80\r\n\n# late\n13,8,1", building);
  ASSERT_EQ(arrivals.size(), 2U);
  EXPECT_EQ(arrivals[0], (lift::Arrival{.at = Time(12500ms), .from = 1, .to = 7, .mass_kg = 80}));
  EXPECT_EQ(arrivals[1], (lift::Arrival{.at = Time(13s), .from = 8, .to = 1, .mass_kg = 75}));
}

TEST(ArrivalList, TellsTheLineOfWhatIsWrong) {
  EXPECT_EQ(refusal("1,1,2\nx,1,2"), "people.csv line 2: 'x' is no number from 0 to 1000000");
  EXPECT_EQ(refusal("-1,1,2"), "people.csv line 1: '-1' is no number from 0 to 1000000");
  EXPECT_EQ(refusal("nan,1,2"), "people.csv line 1: 'nan' is no number from 0 to 1000000");
  EXPECT_EQ(refusal("1,0,2"), "people.csv line 1: '0' is no floor from 1 to 8");
  EXPECT_EQ(refusal("1,1,9"), "people.csv line 1: '9' is no floor from 1 to 8");
  EXPECT_EQ(refusal("1,1"), "people.csv line 1: '' is no floor from 1 to 8");
  EXPECT_EQ(refusal("1,3,3"), "people.csv line 1: from and to are the same floor");
  EXPECT_EQ(refusal("1,1,2,0"), "people.csv line 1: '0' is no number from 1 to 1000");
  EXPECT_EQ(refusal("1,1,2,80,5"),
            "people.csv line 1: an arrival is: seconds,from,to or seconds,from,to,kg");
  EXPECT_EQ(refusal("seconds,from,to\n"), "people.csv: nobody comes");
  EXPECT_EQ(
      refusal(std::string("\xFF\x00\x1B[1m", 6) + std::string(50, 'x') + ",1,2"),
      "people.csv line 1: '???[1m" + std::string(34, 'x') + "...' is no number from 0 to 1000000");
}

}  // namespace
}  // namespace canvoy::tools::arrival_list_test
