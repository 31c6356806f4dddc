#include "canvoy/worlds/lift/call_buttons.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace canvoy::lift::call_buttons_test {
namespace {

class CallButtonsTest : public testing::Test {
 protected:
  std::vector<std::string> diary;
  const PassengerHands hands{
      .hall_button =
          [this](const HallButton& button, bool pressed) {
            diary.push_back("hall " + std::to_string(button.floor) + " to " +
                            std::to_string(button.to) + (pressed ? " down" : " up"));
          },
      .car_button =
          [this](const CarButton& button, bool pressed) {
            diary.push_back("car " + std::to_string(button.lift) + " floor " +
                            std::to_string(button.floor) + (pressed ? " down" : " up"));
          }};
  CallButtons sut{hands};
};

TEST_F(CallButtonsTest, AButtonHasOneFingerOnItAtATime) {
  const CallButton up = CallButton::hall(3, Direction::up);
  EXPECT_TRUE(sut.press(up, 7));
  EXPECT_FALSE(sut.press(up, 8));
  EXPECT_TRUE(sut.press(CallButton::hall(3, Direction::down), 1)) << "another button";
  EXPECT_TRUE(sut.is_held(up));
  sut.release(up);
  EXPECT_FALSE(sut.is_held(up));
  EXPECT_TRUE(sut.press(up, 8));
  EXPECT_EQ(sut.presses(), 3U);
  EXPECT_EQ(diary, (std::vector<std::string>{"hall 3 to 7 down", "hall 3 to 1 down",
                                             "hall 3 to 0 up", "hall 3 to 8 down"}));
}

TEST_F(CallButtonsTest, ALampIsThatOfItsButtonAlone) {
  sut.show(CallButton::car(1, 4), true);
  EXPECT_TRUE(sut.is_lit(CallButton::car(1, 4)));
  EXPECT_FALSE(sut.is_lit(CallButton::car(2, 4)));
  EXPECT_FALSE(sut.is_lit(CallButton::destination(1, 4)));
  sut.show(CallButton::car(1, 4), false);
  EXPECT_FALSE(sut.is_lit(CallButton::car(1, 4)));
}

TEST_F(CallButtonsTest, HandsThatAreNotThereDoNothing) {
  EXPECT_TRUE(sut.press(CallButton::destination(1, 4), 4));
  EXPECT_TRUE(diary.empty());
}

}  // namespace
}  // namespace canvoy::lift::call_buttons_test
