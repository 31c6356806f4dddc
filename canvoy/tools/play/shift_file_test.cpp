// The file of a recorded shift: its content, and refusals.
#include "canvoy/tools/play/shift_file.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::shift_file_test {
namespace {

using excavator::HandInput;
using excavator::RecordedShift;

TEST(ShiftFile, SaysWhatHandsDoAndWhen) {
  const RecordedShift expected = {{Time(500ms), HandInput::lever, 1},
                                  {Time(2s), HandInput::lock, 0.12},
                                  {Time(2'500'001us), HandInput::right_y, -0.08},
                                  {Time(3s), HandInput::knob, -1},
                                  {Time(3s), HandInput::activity, 3}};
  EXPECT_EQ(parse_shift("a.csv",
                        "seconds,input,value\n"
                        "0.5,lever,1   # down\n"
                        "\n"
                        "2 , lock , 0.12\r\n"
                        "2.500001,right_y,-0.08\n"
                        "# the knob\n"
                        "3,knob,-1\n"
                        "3,operator,digs"),
            expected);
}

TEST(ShiftFile, ReadsAsWhatWasWritten) {
  RecordedShift shift;
  for (std::size_t i = 0; i < excavator::hand_inputs; ++i) {
    const auto input = static_cast<HandInput>(i);
    const double place = excavator::is_place(input) ? 1.0 / 3 : 1;
    shift.push_back({Time(Duration(i) * 333'333), input, place});
  }
  EXPECT_EQ(parse_shift("a.csv", shift_text(shift)), shift);
}

TEST(ShiftFile, TellsTheLineThatIsWrong) {
  const struct {
    std::string_view text;
    std::string_view said;
  } examples[] = {
      {"", "a.csv: nobody does anything"},
      {"seconds,input,value\n", "a.csv: nobody does anything"},
      {"1,lever,1\n0.5,lever,0\n", "a.csv line 2: its time is before that of the line above"},
      {"-1,lever,1\n", "a.csv line 1: '-1' is no number from 0 to 1000000"},
      {"nan,lever,1\n", "a.csv line 1: 'nan' is no number from 0 to 1000000"},
      {"1,left_x,1.1\n", "a.csv line 1: '1.1' is no number from -1 to 1"},
      {"1,horn,0\n", "a.csv line 1: '0' is no number from 0.001 to 60"},
      {"1,knob,0.5\n", "a.csv line 1: '0.5' is no whole number"},
      {"1,lever,2\n", "a.csv line 1: '2' is no number from 0 to 1"},
      {"1,operator,sleeps\n", "a.csv line 1: 'sleeps' is nothing that an operator does"},
      {"1,lever\n", "a.csv line 1: '' is no number from 0 to 1"},
      {"1,lever,1,2\n", "a.csv line 1: a line is: seconds,input,value"},
      {"1,\x01,1\n",
       "a.csv line 1: '?' is none of left_x, left_y, right_x, right_y, left_pedal, "
       "right_pedal, throttle, rotator, knob, lever, horn, light, beacon, travel, "
       "lock, operator"},
  };
  for (const auto& [text, said] : examples) {
    try {
      parse_shift("a.csv", text);
      ADD_FAILURE() << text;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.what(), said);
    }
  }
}

TEST(ShiftFile, OneThatIsNotThereIsToldOf) {
  EXPECT_THROW(read_shift("/no/such/shift.csv"), Failure);
}

}  // namespace
}  // namespace canvoy::tools::shift_file_test
