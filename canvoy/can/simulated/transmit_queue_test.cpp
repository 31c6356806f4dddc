#include "canvoy/can/simulated/transmit_queue.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace canvoy::transmit_queue_test {
namespace {

class TransmitQueueTest : public testing::Test {
 protected:
  static PendingFrame pending(std::uint32_t id, std::uint8_t mark = 0) {
    const Frame frame = Frame::data_frame(id, {mark});
    return {frame, arbitration_key(frame), 0};
  }

  static std::vector<std::uint32_t> drained(TransmitQueue& queue) {
    std::vector<std::uint32_t> ids;
    for (; !queue.empty(); queue.pop()) ids.push_back(queue.front().frame.id);
    return ids;
  }

  std::array<PendingFrame, 4> storage_{};
};

TEST_F(TransmitQueueTest, AsQueuedKeepsTheOrderWhateverTheIdentifiers) {
  TransmitQueue sut(storage_, TransmitOrder::as_queued);
  for (const std::uint32_t id : {0x700U, 0x080U, 0x180U}) EXPECT_TRUE(sut.push(pending(id)));
  EXPECT_EQ(drained(sut), (std::vector<std::uint32_t>{0x700, 0x080, 0x180}));
}

TEST_F(TransmitQueueTest, ByIdentifierSendsTheMostUrgentFirst) {
  TransmitQueue sut(storage_, TransmitOrder::by_identifier);
  for (const std::uint32_t id : {0x700U, 0x080U, 0x180U}) EXPECT_TRUE(sut.push(pending(id)));
  EXPECT_EQ(drained(sut), (std::vector<std::uint32_t>{0x080, 0x180, 0x700}));
}

TEST_F(TransmitQueueTest, ByIdentifierKeepsTheOrderOfFramesWithOneIdentifier) {
  TransmitQueue sut(storage_, TransmitOrder::by_identifier);
  for (std::uint8_t mark = 1; mark <= 3; ++mark) sut.push(pending(0x581, mark));
  for (std::uint8_t mark = 1; mark <= 3; ++mark) {
    EXPECT_EQ(sut.front().frame.data[0], mark);
    sut.pop();
  }
}

TEST_F(TransmitQueueTest, RefusesAFrameWhenFullAndTakesOneAgainAfterThat) {
  TransmitQueue sut(storage_, TransmitOrder::as_queued);
  for (std::uint32_t id = 0; id < 4; ++id) EXPECT_TRUE(sut.push(pending(id)));
  EXPECT_FALSE(sut.push(pending(9)));
  sut.pop();
  EXPECT_TRUE(sut.push(pending(4)));
  EXPECT_EQ(drained(sut), (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST_F(TransmitQueueTest, NothingOvertakesTheFrameOnTheWire) {
  TransmitQueue sut(storage_, TransmitOrder::by_identifier);
  sut.push(pending(0x700));
  sut.lock();
  sut.push(pending(0x180));
  sut.push(pending(0x080));
  EXPECT_EQ(drained(sut), (std::vector<std::uint32_t>{0x700, 0x080, 0x180}));
}

TEST_F(TransmitQueueTest, AFrameThatHasToBeSentAgainWaitsForMoreUrgentOnes) {
  TransmitQueue sut(storage_, TransmitOrder::by_identifier);
  sut.push(pending(0x500));
  sut.lock();
  for (const std::uint32_t id : {0x700U, 0x180U, 0x080U}) sut.push(pending(id));
  sut.unlock();
  EXPECT_EQ(drained(sut), (std::vector<std::uint32_t>{0x080, 0x180, 0x500, 0x700}));
}

TEST_F(TransmitQueueTest, ClearLeavesTheFrameOnTheWire) {
  TransmitQueue sut(storage_, TransmitOrder::as_queued);
  for (const std::uint32_t id : {0x700U, 0x180U}) sut.push(pending(id));
  sut.lock();
  sut.clear();
  EXPECT_EQ(sut.size(), 1U);
  EXPECT_EQ(sut.front().frame.id, 0x700U);
  sut.unlock();
  sut.clear();
  EXPECT_TRUE(sut.empty());
}

}  // namespace
}  // namespace canvoy::transmit_queue_test
