#include "canvoy/devices/cia417/call/destination_calls.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace canvoy::cia417::destination_calls_test {
namespace {

constexpr VirtualInput from_to(std::uint8_t source, std::uint8_t target) {
  return {.function = BasicFunction::standard_destination_call,
          .sub_function = target,
          .lifts = 0x01,
          .floor = source,
          .doors = 0x10};
}

class DestinationCallsTest : public testing::Test {
 protected:
  /// Passengers who board there, in a car that continues in this direction.
  std::vector<VirtualInput> boards(std::uint8_t floor, CallKinds done) {
    std::vector<VirtualInput> boarded;
    calls.answered(floor, done, [&](const VirtualInput& input) { boarded.push_back(input); });
    return boarded;
  }
  void take(const VirtualInput& input) {
    calls.add(input);
    calls.tell(input, true, 0x01);
    while (calls.waits()) calls.next();
  }

  std::array<DestinationCalls::Slot, 2> slots{};
  DestinationCalls calls{slots};
};

TEST_F(DestinationCallsTest, WhoWaitsBoardsTheCarThatGoesHisWay) {
  take(from_to(3, 7));
  EXPECT_TRUE(boards(3, calls_down).empty());
  EXPECT_TRUE(boards(4, calls_up).empty());
  EXPECT_EQ(boards(3, calls_up), std::vector{from_to(3, 7)});
  EXPECT_TRUE(boards(3, calls_up).empty()) << "he is in the car";
}

TEST_F(DestinationCallsTest, HisPanelIsToldThatHeHasBoarded) {
  take(from_to(3, 7));
  boards(3, calls_up);
  ASSERT_TRUE(calls.waits());
  const VirtualOutput told = calls.next();
  EXPECT_EQ(told.function, BasicFunction::standard_destination_call);
  EXPECT_EQ(told.sub_function, 7);
  EXPECT_EQ(told.floor, 3);
  EXPECT_FALSE(OutputData{told.data}.status());
  EXPECT_FALSE(calls.waits());
}

TEST_F(DestinationCallsTest, WithoutRoomACallIsNotTaken) {
  take(from_to(1, 2));
  take(from_to(1, 3));
  EXPECT_FALSE(calls.add(from_to(1, 4)));
  EXPECT_EQ(calls.tell(from_to(1, 4), false, 0x01), DestinationCalls::Answer::no_room);
  EXPECT_TRUE(calls.add(from_to(1, 2))) << "it is there already";
}

TEST_F(DestinationCallsTest, OneThatHasEndedMakesRoom) {
  take(from_to(1, 2));
  take(from_to(1, 3));
  calls.cancel(hall_calls);
  while (calls.waits()) calls.next();
  EXPECT_TRUE(calls.add(from_to(1, 4)));
}

TEST_F(DestinationCallsTest, TheEndForOneLiftLeavesWhatIsShownOfAnother) {
  take(from_to(3, 7));
  calls.tell(from_to(3, 7), true, 0x02);
  EXPECT_EQ(calls.tell(from_to(3, 7), false, 0x01), DestinationCalls::Answer::others);
  EXPECT_EQ(calls.next().lifts, 0x02);
  EXPECT_EQ(calls.tell(from_to(3, 7), false, 0x02), DestinationCalls::Answer::kept);
}

TEST_F(DestinationCallsTest, PanelsThatComeAreToldOfWhatHasEndedUnlessItIsAskedForAgain) {
  take(from_to(3, 7));
  boards(3, calls_up);
  calls.next();
  calls.report_all_again();
  ASSERT_TRUE(calls.waits());
  EXPECT_FALSE(OutputData{calls.next().data}.status());
  take(from_to(3, 7));
  calls.report_all_again();
  EXPECT_TRUE(OutputData{calls.next().data}.status());
  EXPECT_FALSE(calls.waits());
}

}  // namespace
}  // namespace canvoy::cia417::destination_calls_test
