#include "canvoy/canopen/storage/record_pair.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/storage/testing/simulated_flash.hpp"

namespace canvoy::record_pair_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Content in a vector.
struct Content {
  explicit Content(Bytes content) : bytes(std::move(content)) {}
  RecordSource source() {
    return {.rewind = callback<&Content::rewind>(*this), .next = callback<&Content::next>(*this)};
  }
  void rewind() { offset = 0; }
  Result<std::size_t> next(std::span<std::uint8_t> place) {
    if (failure != AbortCode::none) return failure;
    const std::size_t size = std::min(place.size(), bytes.size() - offset);
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), size, place.begin());
    offset += size;
    return size;
  }
  Bytes bytes;
  std::size_t offset = 0;
  AbortCode failure = AbortCode::none;
};

class RecordPairTest : public testing::Test {
 protected:
  static constexpr RecordPair::Place place{.address = 0, .slot_size = 128, .kind = 7};

  static AbortCode write(RecordPair& sut, const RecordSource& source) {
    sut.begin(source);
    for (int i = 0; sut.step() != RecordStep::done; ++i) {
      if (i == 1000) return AbortCode::time_out;
    }
    return sut.outcome();
  }
  AbortCode write(const Bytes& bytes) {
    RecordPair sut(memory.flash, place);
    sut.find();
    Content content(bytes);
    return write(sut, content.source());
  }
  Bytes found() {
    RecordPair sut(memory.flash, place);
    if (sut.find() != RecordState::valid) return {0xBA, 0xD0};
    Bytes bytes(sut.length());
    EXPECT_TRUE(sut.read(0, bytes));
    return bytes;
  }

  SimulatedFlash memory{{.sector_size = 64, .sectors = 4, .unit = 8}};
};

TEST_F(RecordPairTest, AContentOfAnyLengthThatFitsIsKept) {
  for (std::size_t length = 0; length <= 96; ++length) {
    const Bytes bytes(length, static_cast<std::uint8_t>(length));
    ASSERT_EQ(write(bytes), AbortCode::none) << length;
    ASSERT_EQ(found(), bytes) << length;
  }
  EXPECT_EQ(memory.violations, 0U);
}

/// Whichever read fails: what is there is not taken for nothing or for something else.
TEST_F(RecordPairTest, AReadThatFailsOnceIsToldAndLeavesTheOldContentOrTheNewOne) {
  const Bytes old{1, 2, 3};
  const Bytes latest(40, 9);
  write(Bytes{7});
  write(old);
  const Bytes kept = memory.bytes;
  unsigned tried = 0;
  for (bool is_reached = true; is_reached; ++tried) {
    memory.bytes = kept;
    memory.fail_read_at = tried + 1;
    RecordPair sut(memory.flash, place);
    const RecordState state = sut.find();
    const bool was_unreadable = memory.fail_read_at == 0;
    EXPECT_EQ(state, was_unreadable ? RecordState::unreadable : RecordState::valid) << tried;
    Content content(latest);
    const AbortCode outcome = write(sut, content.source());
    is_reached = memory.fail_read_at == 0;
    memory.fail_read_at = 0;
    const Bytes present = found();
    EXPECT_TRUE(present == latest || (outcome != AbortCode::none && present == old)) << tried;
  }
  EXPECT_GT(tried, 6u);
}

TEST_F(RecordPairTest, AContentThatIsTooLongIsRefusedAndTheOldOneStays) {
  write(Bytes{1, 2, 3});
  for (std::size_t length = 97; length <= 130; ++length) {
    ASSERT_EQ(write(Bytes(length, 9)), AbortCode::out_of_memory) << length;
    ASSERT_EQ(found(), (Bytes{1, 2, 3}));
  }
}

// The head as stored: kind 7, format 1, sequence 1, length 9, CRC-32 of "123456789", signature, and
// the CRC-32 of these 28 bytes.
TEST_F(RecordPairTest, TheHeadStandsInFrontOfTheContent) {
  RecordPair sut(memory.flash, place);
  sut.sign(0x1122'3344, 0x5566'7788);
  sut.find();
  Content content(Bytes{'1', '2', '3', '4', '5', '6', '7', '8', '9'});
  ASSERT_EQ(write(sut, content.source()), AbortCode::none);
  const Bytes head(memory.bytes.begin(), memory.bytes.begin() + 28);
  EXPECT_EQ(head,
            (Bytes{7, 0, 0,    0,    1,    0,    0,    0,    1,    0,    0,    0,    9,    0,
                   0, 0, 0x26, 0x39, 0xF4, 0xCB, 0x44, 0x33, 0x22, 0x11, 0x88, 0x77, 0x66, 0x55}));
  EXPECT_EQ(load<std::uint32_t>(memory.bytes.data() + 28), crc32(head));
  EXPECT_EQ(memory.bytes[32], '1');
  EXPECT_EQ(memory.bytes[40], '9');
  EXPECT_EQ(memory.bytes[41], 0xFF);
}

TEST_F(RecordPairTest, SequenceNumbersGoRound) {
  RecordHead head;
  for (const std::uint32_t sequence : {0xFFFF'FFFEU, 0xFFFF'FFFFU, 0U, 1U}) {
    head.sequence = sequence;
    EXPECT_TRUE((RecordHead{.sequence = sequence + 1}.newer_than(head)));
    EXPECT_FALSE(head.newer_than(RecordHead{.sequence = sequence + 1}));
    EXPECT_FALSE(head.newer_than(head));
  }
  // A device after four thousand million stores.
  head = {.kind = 7, .sequence = 0xFFFF'FFFF, .length = 0, .crc = 0};
  std::ranges::copy(head.bytes(), memory.bytes.begin());
  EXPECT_EQ(found(), Bytes{});
  write(Bytes{1});
  EXPECT_EQ(found(), Bytes{1});
  write(Bytes{2});
  EXPECT_EQ(found(), Bytes{2});
}

TEST_F(RecordPairTest, TheSectorWithTheHeadIsErasedFirst) {
  write(Bytes(90, 1));
  write(Bytes(90, 2));
  memory.cut_after(64);
  write(Bytes(90, 3));
  EXPECT_EQ(memory.bytes[0], 0xFF);
  EXPECT_EQ(memory.bytes[64], 1);
  EXPECT_EQ(found(), Bytes(90, 2));
}

TEST_F(RecordPairTest, ReadingKeepsWithinTheContent) {
  write(Bytes{1, 2, 3});
  RecordPair sut(memory.flash, place);
  Bytes bytes(2);
  EXPECT_FALSE(sut.read(0, bytes)) << "nothing was found yet";
  sut.find();
  EXPECT_TRUE(sut.read(1, bytes));
  EXPECT_EQ(bytes, (Bytes{2, 3}));
  EXPECT_FALSE(sut.read(2, bytes));
  EXPECT_FALSE(sut.read(4, std::span(bytes).first(0)));
  EXPECT_FALSE(sut.read(0xFFFF'FFFF, bytes));
}

TEST_F(RecordPairTest, AContentThatCannotBeGivenEndsTheAttempt) {
  write(Bytes{1, 2, 3});
  RecordPair sut(memory.flash, place);
  sut.find();
  Content content(Bytes{4});
  content.failure = AbortCode::no_data;
  EXPECT_EQ(write(sut, content.source()), AbortCode::no_data);
  EXPECT_EQ(found(), (Bytes{1, 2, 3}));
}

TEST_F(RecordPairTest, AnAttemptThatIsCancelledLeavesTheOldContent) {
  write(Bytes{1, 2, 3});
  for (int steps = 0; steps < 10; ++steps) {
    RecordPair sut(memory.flash, place);
    sut.find();
    Content content(Bytes(60, static_cast<std::uint8_t>(steps)));
    sut.begin(content.source());
    for (int i = 0; i < steps && sut.step() != RecordStep::done; ++i) {
    }
    if (!sut.busy()) break;
    sut.cancel();
    EXPECT_EQ(sut.step(), RecordStep::done);
    const Bytes kept = found();
    ASSERT_TRUE(kept == (Bytes{1, 2, 3}) || kept == content.bytes) << steps;
  }
}

TEST_F(RecordPairTest, StepsWithoutABeginningDoNothing) {
  RecordPair sut(memory.flash, place);
  EXPECT_EQ(sut.step(), RecordStep::done);
  EXPECT_EQ(memory.programmings + memory.erasures, 0U);
}

}  // namespace
}  // namespace canvoy::record_pair_test
