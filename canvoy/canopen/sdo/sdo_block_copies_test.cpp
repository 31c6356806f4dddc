// Frames that come twice in a block transfer: a controller repeats a frame that others have
// received already if it misses its very end. Such a copy follows at once, and has no new content
// (CiA 301, 7.2.4.3.9 to 7.2.4.3.15; ISO 11898-1).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"
#include "canvoy/canopen/testing/sdo_line.hpp"
#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_block_copies_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string hex(const std::vector<unsigned>& bytes) {
  std::string text;
  for (const unsigned byte : bytes) {
    char part[8];
    std::snprintf(part, sizeof part, "%s%02X", text.empty() ? "" : " ", byte);
    text += part;
  }
  return text;
}

/// Segments of one block, as eight bytes each.
std::vector<std::string> block_of(const Bytes& bytes) {
  std::vector<std::string> segments;
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    const bool last = at + 7 >= bytes.size();
    std::vector<unsigned> message(8);
    message[0] = static_cast<unsigned>(segments.size() + 1) | (last ? 0x80U : 0U);
    for (std::size_t i = 0; i < 7 && at + i < bytes.size(); ++i) message[i + 1] = bytes[at + i];
    segments.push_back(hex(message));
  }
  return segments;
}

/// Four bytes in the last of `segments`, so that three of it are not data.
Bytes with_four_in_the_last(std::size_t segments, bool zeros) {
  return zeros ? Bytes(segments * 7 - 3) : pattern(segments * 7 - 3);
}
constexpr const char* end_without_three = "CD 00 00 00 00 00 00 00";

/// The end message after `bytes`, with their checksum (CiA 301, 7.2.4.3.16).
std::string end_of(const Bytes& bytes) {
  const unsigned unused = static_cast<unsigned>((7 - bytes.size() % 7) % 7);
  const unsigned crc = crc16(bytes);
  return hex({0xC1 | unused << 2, crc & 0xFF, crc >> 8, 0, 0, 0, 0, 0});
}

/// The answer to `segments` of one block.
std::string acknowledged(std::size_t segments) {
  return hex({0xA2, static_cast<unsigned>(segments), 0x7F, 0, 0, 0, 0, 0});
}

// The server

class SdoServerBlockCopies : public SdoServerNode {
 protected:
  void download(const Bytes& bytes, const std::string& initiate) {
    ask(initiate, "A4 21 20 00 7F 00 00 00");
    const auto segments = block_of(bytes);
    for (const std::string& segment : segments) wire.receive("605#" + segment);
    wire.expect({"585#" + acknowledged(segments.size())});
    last = segments.back();
  }

  SdoBlockServer blocks{sut};
  std::string last;  ///< segment
};

TEST_F(SdoServerBlockCopies, OfTheLastSegmentWhateverItsNumberLeavesTheEndToBeWaitedFor) {
  for (std::size_t segments = 1; segments <= 127; ++segments) {
    SCOPED_TRACE(segments);
    const Bytes bytes = with_four_in_the_last(segments, false);
    download(bytes, "C0 21 20 00 00 00 00 00");
    ask_in_vain(last);
    ask_in_vain(last);
    ask(end_without_three, "A1 00 00 00 00 00 00 00");
    EXPECT_EQ(value(0x2021), bytes);
    EXPECT_FALSE(sut.busy());
  }
}

/// With zeros the 65th segment is C1 00 00 ...: the end of 455 bytes, by all its bits. With the
/// 77th it is that of the bytes received, and so the end or its copy: both mean the same.
TEST_F(SdoServerBlockCopies, OfALastSegmentThatLooksLikeAnEndIsNoneWhereAnEndFollows) {
  for (std::size_t segments = 1; segments <= 127; ++segments) {
    if (segments == 77) continue;
    SCOPED_TRACE(segments);
    const Bytes bytes = with_four_in_the_last(segments, true);
    for (const char* initiate : {"C0 21 20 00 00 00 00 00", "C4 21 20 00 00 00 00 00"}) {
      download(bytes, initiate);
      ask_in_vain(last);
      ask(end_without_three, "A1 00 00 00 00 00 00 00");
      EXPECT_EQ(value(0x2021), bytes);
    }
  }
}

TEST_F(SdoServerBlockCopies, OfALastSegmentThatLooksLikeAnEndAreTheEndWhereNothingElseComes) {
  const Bytes bytes = with_four_in_the_last(77, true);
  download(bytes, "C0 21 20 00 00 00 00 00");
  wire.run_until(Time(100ms));
  ask_in_vain(end_without_three);
  EXPECT_TRUE(sut.busy());
  wire.run_until(Time(10s));
  wire.expect({"@350000 585#A1 00 00 00 00 00 00 00"});  // a quarter of the time-out later
  EXPECT_EQ(value(0x2021), bytes);
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockCopies, OfALastSegmentAreToldFromTheEndByTheSizeThatWasTold) {
  download(Bytes(452), "C2 21 20 00 C4 01 00 00");
  ask_in_vain(last);  // would be the end of 455
  ask(end_without_three, "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021), Bytes(452));
  download(Bytes(455), "C2 21 20 00 C7 01 00 00");
  ask(last, "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021), Bytes(455));
}

/// 89 segments of which the last has one byte: by its number it leaves six without data, as it
/// does, and that byte is where an end has its checksum.
TEST_F(SdoServerBlockCopies, OfALastSegmentAreToldFromTheEndByTheChecksum) {
  const Bytes bytes = pattern(88 * 7 + 1);
  for (const char* initiate : {"C6 21 20 00 69 02 00 00", "C4 21 20 00 00 00 00 00"}) {
    download(bytes, initiate);
    EXPECT_EQ(last.substr(0, 2), "D9");
    ask_in_vain(last);
    wire.run_until(wire.now + 900ms);
    ask(end_of(bytes), "A1 00 00 00 00 00 00 00");
    EXPECT_EQ(value(0x2021), bytes);
  }
}

TEST_F(SdoServerBlockCopies, OfALastSegmentPutTheTimeOutNotOff) {
  download(pattern(452), "C0 21 20 00 00 00 00 00");
  wire.run_until(Time(900ms));
  ask_in_vain(last);
  wire.run_until(Time(10s));
  wire.expect({"@1000000 585#80 21 20 00 00 00 04 05"});
}

TEST_F(SdoServerBlockCopies, OfTheEndOfABlockAcknowledgeNothing) {
  const Bytes bytes = pattern(1000);
  auto segments = block_of(bytes);  // 143: 127 and 16
  segments.back().replace(0, 2, "90");
  for (std::size_t i = 127; i + 1 < segments.size(); ++i) {
    segments[i].replace(0, 2, hex({static_cast<unsigned>(i - 126)}));
  }
  ask("C0 21 20 00 00 00 00 00", "A4 21 20 00 7F 00 00 00");
  for (std::size_t i = 0; i < 127; ++i) wire.receive("605#" + segments[i]);
  wire.expect({"585#" + acknowledged(127)});
  ask_in_vain(segments[126]);
  wire.receive("605#" + segments[127]);
  ask_in_vain(segments[126]);
  for (std::size_t i = 128; i < segments.size(); ++i) wire.receive("605#" + segments[i]);
  wire.expect({"585#" + acknowledged(16)});
  ask("C5 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021), bytes);
}

/// 142 was lost, so that the block ends with a segment that is not accepted.
TEST_F(SdoServerBlockCopies, OfAnEndOfABlockThatWasNotTakenAcknowledgeNothing) {
  ask("C2 21 20 00 0E 00 00 00", "A4 21 20 00 7F 00 00 00");
  ask("82 02 02 02 02 02 02 02", "A2 00 7F 00 00 00 00 00");
  ask_in_vain("82 02 02 02 02 02 02 02");
  ask_in_vain("01 01 01 01 01 01 01 01");
  ask("82 02 02 02 02 02 02 02", "A2 02 7F 00 00 00 00 00");
  ask_in_vain("82 02 02 02 02 02 02 02");
  ask("C1 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
}

TEST_F(SdoServerBlockCopies, OfTheBeginningAreNoSegments) {
  for (const char* initiate : {"C0 21 20 00 0E 00 00 00", "C2 21 20 00 0E 00 00 00",
                               "C4 21 20 00 0E 00 00 00", "C6 21 20 00 0E 00 00 00"}) {
    ask(initiate, "A4 21 20 00 7F 00 00 00");
    ask_in_vain(initiate);
    ask_in_vain("01 01 02 03 04 05 06 07");
    ask("82 08 00 00 00 00 00 00", "A2 02 7F 00 00 00 00 00");
    ask_in_vain("80 21 20 00 00 00 00 08");
  }
}

TEST_F(SdoServerBlockCopies, OfTheEndAreNotAnswered) {
  download({1, 2, 3, 4, 5, 6, 7, 8}, "C6 21 20 00 08 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  ask_in_vain("D9 AC 76 00 00 00 00 00");
  ask("D9 AD 76 00 00 00 00 00", "80 00 00 00 01 00 04 05");  // another end
  expect_alive();
}

TEST_F(SdoServerBlockCopies, OfTheStartAndTheConfirmationOfAnUploadAreNotAnswered) {
  set_value(wire.node, 0x2021, pattern(8));
  ask("A0 21 20 00 7F 00 00 00", "C6 21 20 00 08 00 00 00");
  wire.receive("605#A3 00 00 00 00 00 00 00");
  wire.expect({"585#01 01 20 3F 5E 7D 9C BB", "585#82 DB 00 00 00 00 00 00"});
  ask_in_vain("A3 00 00 00 00 00 00 00");
  ask("A2 02 7F 00 00 00 00 00", "D9 00 00 00 00 00 00 00");
  ask_in_vain("A1 00 00 00 00 00 00 00");
  ask_in_vain("A1 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
  ask("A3 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
}

TEST_F(SdoServerBlockCopies, OfAnAcknowledgementOfMoreThanIsInTheLastBlockAreIgnored) {
  set_value(wire.node, 0x2021, pattern(15));
  ask("A0 21 20 00 02 00 00 00", "C6 21 20 00 0F 00 00 00");
  wire.receive("605#A3 00 00 00 00 00 00 00");
  wire.sent.clear();
  ask("A2 02 02 00 00 00 00 00", "81 B5 00 00 00 00 00 00");
  ask_in_vain("A2 02 02 00 00 00 00 00");
  ask("A2 01 02 00 00 00 00 00", "D9 00 00 00 00 00 00 00");
  ask_in_vain("A1 00 00 00 00 00 00 00");
}

TEST_F(SdoServerBlockCopies, OfAnAcknowledgementInMidBlockAreIgnoredWhateverTheyAcknowledge) {
  set_value(wire.node, 0x2021, pattern(70));
  ask("A0 21 20 00 04 00 00 00", "C6 21 20 00 46 00 00 00");
  wire.receive("605#A3 00 00 00 00 00 00 00");
  EXPECT_EQ(std::exchange(wire.sent, {}).size(), 4U);
  std::size_t room = 2;
  wire.on_sent = [&](const Frame&) { wire.full = --room == 0; };
  wire.receive("605#A2 01 04 00 00 00 00 00");  // three were lost, and two leave again
  wire.receive("605#A2 01 04 00 00 00 00 00");
  EXPECT_EQ(wire.sent.size(), 2U);
  room = 100;
  wire.full = false;
  wire.node.tx_ready(wire.now);
  ASSERT_EQ(wire.sent.size(), 4U);
  EXPECT_EQ(wire_text(wire.sent[0].frame), "585#01 DB FA 19 38 57 76 95");
  EXPECT_EQ(wire_text(wire.sent[3].frame).substr(0, 6), "585#04");
}

// The client

class SdoClientBlockCopies : public SdoClientNode {
 protected:
  SdoClientBlockCopies() { sut.choose(SdoTransfer::block); }

  /// Begins an upload that the server announces with `initiated`, and takes one block of it.
  void take(const Bytes& data, const std::string& initiated) {
    EXPECT_EQ(upload(destination, 0x2021), AbortCode::none);
    expect_request("A4 21 20 00 7F 00 00 00");
    answer(initiated, "A3 00 00 00 00 00 00 00");
    const auto segments = block_of(data);
    for (const std::string& segment : segments) wire.receive("585#" + segment);
    wire.expect({"605#" + acknowledged(segments.size())});
    last_segment = segments.back();
  }
  void expect_taken(const Bytes& data) {
    expect_done(data.size());
    EXPECT_TRUE(std::equal(data.begin(), data.end(), destination.begin()));
  }

  SdoBlockClient blocks{sut};
  std::array<std::uint8_t, 1000> destination{};
  std::string last_segment;
};

TEST_F(SdoClientBlockCopies, OfTheLastSegmentWhateverItsNumberLeaveTheEndToBeWaitedFor) {
  for (std::size_t segments = 1; segments <= 127; ++segments) {
    for (const bool zeros : {false, true}) {
      if (zeros && segments == 77) continue;
      SCOPED_TRACE(segments);
      const Bytes data = with_four_in_the_last(segments, zeros);
      take(data, "C0 21 20 00 00 00 00 00");
      answer(last_segment);
      answer(last_segment);
      expect_waiting();
      answer(end_without_three, "A1 00 00 00 00 00 00 00");
      expect_taken(data);
    }
  }
}

TEST_F(SdoClientBlockCopies, OfALastSegmentThatLooksLikeAnEndAreTheEndWhereNothingElseComes) {
  const Bytes data = with_four_in_the_last(77, true);
  take(data, "C0 21 20 00 00 00 00 00");
  wire.run_until(Time(100ms));
  answer(end_without_three);
  expect_waiting();
  wire.run_until(Time(10s));
  wire.expect({"@350000 605#A1 00 00 00 00 00 00 00"});
  expect_taken(data);
}

TEST_F(SdoClientBlockCopies, OfALastSegmentAreToldFromTheEndByTheSizeThatWasTold) {
  take(Bytes(452), "C2 21 20 00 C4 01 00 00");
  answer(last_segment);
  answer(end_without_three, "A1 00 00 00 00 00 00 00");
  expect_taken(Bytes(452));
  take(Bytes(455), "C2 21 20 00 C7 01 00 00");
  answer(last_segment, "A1 00 00 00 00 00 00 00");
  expect_taken(Bytes(455));
}

TEST_F(SdoClientBlockCopies, OfALastSegmentAreToldFromTheEndByTheChecksum) {
  const Bytes data = pattern(88 * 7 + 1);
  for (const char* initiated : {"C6 21 20 00 69 02 00 00", "C4 21 20 00 00 00 00 00"}) {
    take(data, initiated);
    answer(last_segment);
    wire.run_until(wire.now + 900ms);
    expect_waiting();
    answer(end_of(data), "A1 00 00 00 00 00 00 00");
    expect_taken(data);
  }
}

TEST_F(SdoClientBlockCopies, OfTheEndOfABlockAcknowledgeNothing) {
  take({1, 2, 3, 4, 5, 6, 7, 8}, "C2 21 20 00 08 00 00 00");
  answer("D9 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(upload(destination, 0x2021), AbortCode::none);
  wire.sent.clear();
  answer("C2 21 20 00 0E 00 00 00", "A3 00 00 00 00 00 00 00");
  answer("82 02 02 02 02 02 02 02", "A2 00 7F 00 00 00 00 00");
  answer("82 02 02 02 02 02 02 02");
  answer("01 01 01 01 01 01 01 01");
  answer("82 02 02 02 02 02 02 02", "A2 02 7F 00 00 00 00 00");
  answer("C1 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_taken({1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2});
}

TEST_F(SdoClientBlockCopies, OfTheAnswerToTheBeginningAreNoSegments) {
  for (const char* initiated : {"C0 21 20 00 08 00 00 00", "C2 21 20 00 08 00 00 00",
                                "C4 21 20 00 08 00 00 00", "C6 21 20 00 08 00 00 00"}) {
    EXPECT_EQ(upload(destination, 0x2021), AbortCode::none);
    wire.sent.clear();
    answer(initiated, "A3 00 00 00 00 00 00 00");
    answer(initiated);
    answer("01 01 02 03 04 05 06 07");
    answer("82 08 00 00 00 00 00 00", "A2 02 7F 00 00 00 00 00");
    answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
    expect_done(8);
  }
}

TEST_F(SdoClientBlockCopies, OfTheAnswerToTheBeginningOfADownloadAreNoAcknowledgements) {
  const Bytes value = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(download(value, 0x2021), AbortCode::none);
  wire.sent.clear();
  wire.receive("585#A4 21 20 00 7F 00 00 00");
  wire.expect({"605#01 01 02 03 04 05 06 07", "605#82 08 00 00 00 00 00 00"});
  answer("A4 21 20 00 7F 00 00 00");
  answer("A2 02 7F 00 00 00 00 00", "D9 AC 76 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(8);
  answer("A1 00 00 00 00 00 00 00");
}

TEST_F(SdoClientBlockCopies, OfAnAcknowledgementOfMoreThanIsInTheLastBlockAreIgnored) {
  const Bytes value = pattern(15);
  EXPECT_EQ(download(value, 0x2021), AbortCode::none);
  wire.sent.clear();
  wire.receive("585#A0 21 20 00 02 00 00 00");
  wire.sent.clear();
  answer("A2 02 02 00 00 00 00 00", "81 B5 00 00 00 00 00 00");
  answer("A2 02 02 00 00 00 00 00");
  answer("A2 01 02 00 00 00 00 00", "D9 00 00 00 00 00 00 00");
}

// Both

/// An acknowledgement has no number: for a block that is sent completely, a copy of the one before
/// may as well be its own. A copy of every other frame is recognised.
class SdoBlockCopies : public testing::Test {
 protected:
  struct Trial {
    bool is_upload;
    unsigned block_size;
    std::size_t size;
  };
  /// Number of frames of a transfer that delivers all data, with the copies in `fates`.
  static std::size_t frames(const Trial& trial, const std::vector<Fate>& fates) {
    Line line(static_cast<std::uint8_t>(trial.block_size));
    line.client.choose(SdoTransfer::block);
    line.copies_acknowledgements = false;
    const Bytes sent = pattern(trial.size);
    if (trial.is_upload) set_value(line.server_node.node, 0x2021, sent);
    Bytes received(trial.size);
    EXPECT_EQ(trial.is_upload ? line.client.upload(5, 0x2021, 0, received, line.on_done())
                              : line.client.download(5, 0x2021, 0, sent, line.on_done()),
              AbortCode::none);
    line.run(fates);
    EXPECT_EQ(line.outcome.value_or(AbortCode::general).abort(), AbortCode::none);
    EXPECT_EQ(trial.is_upload ? received : value_of(line.server_node.node, 0x2021), sent);
    EXPECT_FALSE(line.server.busy());
    return line.frames;
  }
};

TEST_F(SdoBlockCopies, OfAnyFrameButAnAcknowledgementBringNoFurtherFrame) {
  for (const bool is_upload : {true, false}) {
    for (const unsigned block_size : {2U, 3U, 10U, 65U, 127U}) {
      for (const std::size_t size : {4U, 8U, 30U, 452U}) {
        const Trial trial{is_upload, block_size, size};
        const std::size_t undisturbed = frames(trial, {});
        for (std::size_t place = 0; place < undisturbed; ++place) {
          SCOPED_TRACE((is_upload ? "upload " : "download ") + std::to_string(block_size) + ", " +
                       std::to_string(size) + " bytes, frame " + std::to_string(place));
          std::vector<Fate> fates(place, Fate::arrives);
          fates.push_back(Fate::comes_twice);
          // The answer to a first request is sent again.
          const std::size_t again = is_upload && place == 0 ? 1 : 0;
          EXPECT_EQ(frames(trial, fates), undisturbed + again);
        }
      }
    }
  }
}

/// If the last segment has one byte or two, and a number that matches that of an end.
TEST_F(SdoBlockCopies, OfALastSegmentThatLooksLikeAnEndCostNoTransfer) {
  for (const bool is_upload : {true, false}) {
    for (const std::size_t size : {std::size_t{88 * 7 + 1}, std::size_t{84 * 7 + 2}}) {
      frames({is_upload, 127, size}, std::vector<Fate>(1000, Fate::comes_twice));
    }
  }
}

RC_GTEST_FIXTURE_PROP(SdoBlockCopies, OfAllFramesButAcknowledgementsCostNoTransfer, ()) {
  const Trial trial{*rc::gen::arbitrary<bool>(), *rc::gen::inRange(2U, 128U),
                    *rc::gen::inRange<std::size_t>(0, 900)};
  frames(trial, std::vector<Fate>(1000, Fate::comes_twice));
  RC_ASSERT(!HasFailure());
}

}  // namespace
}  // namespace canvoy::sdo_block_copies_test
