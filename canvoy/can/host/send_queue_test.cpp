#include "canvoy/can/host/send_queue.hpp"

#include <gtest/gtest.h>

namespace canvoy::host::send_queue_test {
namespace {

Frame frame_of(std::uint32_t id) {
  return Frame::data_frame(id, {});
}

class EchoQueueTest : public testing::Test {
 protected:
  void send(std::uint32_t id, const void* sender) { queue_.push({frame_of(id), sender}); }

  EchoQueue queue_;
  const int charger_ = 0;
  const int battery_ = 0;
};

TEST_F(EchoQueueTest, AFrameThatComesBackTellsWhoSentIt) {
  send(0x185, &charger_);
  send(0x186, &battery_);
  EXPECT_EQ(queue_.take(frame_of(0x185)), &charger_);
  EXPECT_EQ(queue_.take(frame_of(0x186)), &battery_);
  EXPECT_EQ(queue_.size(), 0U);
}

TEST_F(EchoQueueTest, OfEqualFramesTheOldestIsMeant) {
  send(0x80, &charger_);
  send(0x80, &battery_);
  EXPECT_EQ(queue_.take(frame_of(0x80)), &charger_);
  EXPECT_EQ(queue_.take(frame_of(0x80)), &battery_);
}

TEST_F(EchoQueueTest, AFrameThatNobodySentIsUnknown) {
  send(0x185, &charger_);
  EXPECT_EQ(queue_.take(frame_of(0x186)), std::nullopt);
  EXPECT_EQ(queue_.size(), 1U);
}

TEST_F(EchoQueueTest, AFrameMayOvertakeOthersAsInAControllerWithMailboxes) {
  send(0x600, &charger_);
  send(0x601, &charger_);
  send(0x080, &battery_);
  EXPECT_EQ(queue_.take(frame_of(0x080)), &battery_);
  EXPECT_EQ(queue_.take(frame_of(0x600)), &charger_);
  EXPECT_EQ(queue_.take(frame_of(0x601)), &charger_);
}

TEST_F(EchoQueueTest, AFrameThatSixtyFourOthersOvertookIsForgottenAsLost) {
  send(0x600, &charger_);
  for (std::size_t i = 0; i < 63; ++i) {
    send(0x80, &battery_);
    ASSERT_EQ(queue_.take(frame_of(0x80)), &battery_);
  }
  EXPECT_EQ(queue_.size(), 1U);
  send(0x80, &battery_);
  ASSERT_EQ(queue_.take(frame_of(0x80)), &battery_);
  EXPECT_EQ(queue_.size(), 0U);
  EXPECT_EQ(queue_.take(frame_of(0x600)), std::nullopt);
}

TEST_F(EchoQueueTest, OfTooManyFramesUnderWayTheOldestIsForgotten) {
  for (std::uint32_t id = 0; id < 4097; ++id) send(id, &charger_);
  EXPECT_EQ(queue_.size(), 4096U);
  EXPECT_EQ(queue_.take(frame_of(0)), std::nullopt);
  EXPECT_EQ(queue_.take(frame_of(1)), &charger_);
}

TEST_F(EchoQueueTest, FramesOfASenderThatIsGoneComeBackAsNobodys) {
  send(0x185, &charger_);
  queue_.forget_sender(&charger_);
  EXPECT_EQ(queue_.take(frame_of(0x185)), nullptr);
}

}  // namespace
}  // namespace canvoy::host::send_queue_test
