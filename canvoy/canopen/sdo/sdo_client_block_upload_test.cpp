// SDO client, upload in blocks (CiA 301, 7.2.4.3.12 to 7.2.4.3.15).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_block_upload_test {
namespace {

class SdoClientBlockUpload : public SdoClientNode {
 protected:
  SdoClientBlockUpload() { sut.choose(SdoTransfer::block); }

  /// Segments with one common answer.
  void answer_with(const std::vector<std::string>& segments, const std::string& request) {
    for (const std::string& segment : segments) wire.receive("585#" + segment);
    wire.expect({"605#" + request});
  }
  /// Begins an upload that the server announces with `initiated`.
  void begin(const std::string& initiated, std::size_t room = 20) {
    EXPECT_EQ(upload(std::span(bytes).first(room)), AbortCode::none);
    expect_request("A4 08 20 00 04 00 00 00");
    answer(initiated, "A3 00 00 00 00 00 00 00");
  }
  Bytes first(std::size_t count) const {
    return {bytes.begin(), bytes.begin() + static_cast<long>(count)};
  }

  SdoBlockClient blocks{sut, {}, 4};
};

// The checksum of 1, 2 ... 8 is 76ACh.

TEST_F(SdoClientBlockUpload, ABlockIsAcknowledgedAndTheEndConfirmed) {
  begin("C6 08 20 00 08 00 00 00");
  EXPECT_EQ(sut.announced(), 8U);
  answer("01 01 02 03 04 05 06 07");
  answer("82 08 00 00 00 00 00 00", "A2 02 04 00 00 00 00 00");
  expect_waiting();
  EXPECT_EQ(sut.transferred(), 7U);  // the last segment may have fewer bytes
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(first(9), (Bytes{1, 2, 3, 4, 5, 6, 7, 8, 0}));
}

TEST_F(SdoClientBlockUpload, ItAsksForBlocksOf127SegmentsUnlessTheOwnerWantsLess) {
  WireNode other(sdo_objects(), 1);
  SdoClient client(other.node);
  const SdoBlockClient whole(client);
  other.boot();
  client.choose(SdoTransfer::block);
  EXPECT_EQ(client.upload(5, 0x2008, 0, bytes, {}), AbortCode::none);
  other.expect({"605#A4 08 20 00 7F 00 00 00"});
}

TEST_F(SdoClientBlockUpload, AServerWithoutChecksumsSendsNone) {
  begin("C2 08 20 00 08 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 34 12 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, TheServerNeedNotTellTheSize) {
  begin("C4 08 20 00 EE EE EE EE");
  EXPECT_EQ(sut.announced(), std::nullopt);
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, BlockFollowsBlockUntilTheLastSegment) {
  std::array<std::uint8_t, 40> destination{};
  EXPECT_EQ(upload(destination), AbortCode::none);
  wire.sent.clear();
  answer("C2 08 20 00 1E 00 00 00", "A3 00 00 00 00 00 00 00");
  answer_with({"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95", "03 B5 D4 F3 12 31 50 6F",
               "04 8F AE CD EC 0B 2A 49"},
              "A2 04 04 00 00 00 00 00");
  answer("81 69 88 EE EE EE EE EE", "A2 01 04 00 00 00 00 00");
  answer("D5 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(30);
  EXPECT_EQ(Bytes(destination.begin(), destination.begin() + 30), pattern(30));
  EXPECT_EQ(destination[30], 0);
}

TEST_F(SdoClientBlockUpload, AnEmptyValueIsUploaded) {
  begin("C6 08 20 00 00 00 00 00");
  answer("81 00 00 00 00 00 00 00", "A2 01 04 00 00 00 00 00");
  answer("DD 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientBlockUpload, ASinkTakesSegments) {
  Bytes all;
  auto take = [&](std::span<const std::uint8_t> piece) {
    all.insert(all.end(), piece.begin(), piece.end());
    return AbortCode::none;
  };
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(take), on_done), AbortCode::none);
  wire.sent.clear();
  answer("C6 08 20 00 08 00 00 00", "A3 00 00 00 00 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(all, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

// Lost, repeated and late frames

TEST_F(SdoClientBlockUpload, AfterALostSegmentTheRestOfTheBlockIsAskedForAgain) {
  begin("C6 08 20 00 08 00 00 00");
  answer("82 08 00 00 00 00 00 00", "A2 00 04 00 00 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, ASegmentThatComesTwiceCountsOnce) {
  begin("C6 08 20 00 08 00 00 00");
  answer("01 01 02 03 04 05 06 07");
  answer("01 01 02 03 04 05 06 07");
  answer("82 08 00 00 00 00 00 00", "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, WhereTheEndOfABlockIsLostItIsAcknowledgedAfterHalfOfTheTimeOut) {
  begin("C6 08 20 00 08 00 00 00");
  answer("01 01 02 03 04 05 06 07");
  wire.run_until(Time(700ms));
  wire.expect({"@500000 605#A2 01 04 00 00 00 00 00"});
  answer("81 08 00 00 00 00 00 00", "A2 01 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, AServerThatFallsSilentIsGivenUpAfterTheTimeOut) {
  begin("C6 08 20 00 08 00 00 00");
  answer("01 01 02 03 04 05 06 07");
  wire.run_until(Time(10s));
  wire.expect({"@500000 605#A2 01 04 00 00 00 00 00", "@1000000 605#80 08 20 00 00 00 04 05"});
  expect_failed(SdoEnd::no_answer());
  begin("C4 08 20 00 00 00 00 00");
  wire.run_for(10s);
  wire.expect({"605#80 08 20 00 00 00 04 05"});
  expect_failed(SdoEnd::no_answer());
}

TEST_F(SdoClientBlockUpload, ABlockOfWhichNothingComesIsAskedForAgainWhereTheSizeWasTold) {
  begin("C6 08 20 00 08 00 00 00");
  wire.run_until(Time(700ms));
  wire.expect({"@500000 605#A2 00 04 00 00 00 00 00"});
  answer("01 01 02 03 04 05 06 07");
  answer("82 08 00 00 00 00 00 00", "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockUpload, LateAnswersToOtherRequestsAreNotTakenForThePresentOne) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  for (const char* late :
       {"C6 08 20 01 08 00 00 00", "C6 07 20 00 08 00 00 00", "60 08 20 00 00 00 00 00",
        "C1 08 20 00 00 00 00 00", "43 07 20 00 01 02 03 04", "80 07 20 00 00 00 02 06"}) {
    answer(late);
  }
  expect_waiting();
  answer("C6 08 20 00 08 00 00 00", "A3 00 00 00 00 00 00 00");
}

// Errors

TEST_F(SdoClientBlockUpload, NumbersThatNoSegmentOfTheBlockHasEndTheTransfer) {
  for (const char* segment : {"00 01 02 03 04 05 06 07", "05 01 02 03 04 05 06 07",
                              "85 01 02 03 04 05 06 07", "7F 01 02 03 04 05 06 07"}) {
    begin("C6 08 20 00 08 00 00 00");
    answer(segment, "80 08 20 00 03 00 04 05");
    expect_failed(AbortCode::sequence_number);
  }
}

TEST_F(SdoClientBlockUpload, AWrongChecksumEndsTheTransfer) {
  begin("C6 08 20 00 08 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 AD 76 00 00 00 00 00", "80 08 20 00 04 00 04 05");
  expect_failed(AbortCode::crc);
}

TEST_F(SdoClientBlockUpload, AnEndThatCountsOtherBytesThanWereToldEndsTheTransfer) {
  begin("C2 08 20 00 08 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D5 00 00 00 00 00 00 00", "80 08 20 00 12 00 07 06");
  expect_failed(AbortCode::length_too_high);
  begin("C2 08 20 00 08 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("DD 00 00 00 00 00 00 00", "80 08 20 00 13 00 07 06");
  expect_failed(AbortCode::length_too_low);
}

TEST_F(SdoClientBlockUpload, ADestinationThatIsTooShortEndsIt) {
  EXPECT_EQ(upload(std::span(bytes).first(7)), AbortCode::none);
  wire.sent.clear();
  answer("C6 08 20 00 08 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  begin("C4 08 20 00 00 00 00 00", 7);
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("D9 AC 76 00 00 00 00 00", "80 08 20 00 05 00 04 05");
  expect_failed(AbortCode::out_of_memory);
  EXPECT_EQ(bytes[7], 0);
}

TEST_F(SdoClientBlockUpload, ASinkMayEndIt) {
  auto refuse = [&](std::span<const std::uint8_t>) { return AbortCode::cannot_store; };
  EXPECT_EQ(sut.upload(5, 0x2008, 0, SdoClient::Sink::of(refuse), on_done), AbortCode::none);
  wire.sent.clear();
  answer("C6 08 20 00 08 00 00 00", "A3 00 00 00 00 00 00 00");
  answer("01 01 02 03 04 05 06 07");
  answer("82 08 00 00 00 00 00 00", "80 08 20 00 20 00 00 08");
  expect_failed(AbortCode::cannot_store);
}

TEST_F(SdoClientBlockUpload, AnAbortFromTheServerEndsItAtAnyTime) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 00 00 02 06");
  expect_failed(SdoEnd::by_server(AbortCode::no_object));
  begin("C6 08 20 00 08 00 00 00");
  answer("01 01 02 03 04 05 06 07");
  answer("80 08 20 00 00 00 06 06");
  expect_failed(SdoEnd::by_server(AbortCode::hardware));
  begin("C6 08 20 00 08 00 00 00");
  answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  answer("80 08 20 00 00 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::time_out));
}

TEST_F(SdoClientBlockUpload, OtherCommandsInPlaceOfTheEndEndTheTransfer) {
  for (const char* command :
       {"20 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00",
        "C6 08 20 00 08 00 00 00", "41 08 20 00 08 00 00 00", "E0 00 00 00 00 00 00 00"}) {
    begin("C6 08 20 00 08 00 00 00");
    answer_with({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
    answer(command, "80 08 20 00 01 00 04 05");
    expect_failed(AbortCode::command_specifier);
  }
}

TEST_F(SdoClientBlockUpload, FramesOfAnotherLengthAreIgnoredAndCounted) {
  begin("C6 08 20 00 08 00 00 00");
  answer("01 01 02 03 04 05 06");
  answer("");
  EXPECT_EQ(wire.node.counters().malformed, 2U);
  expect_waiting();
}

TEST_F(SdoClientBlockUpload, StoppedEndsItWithoutAWord) {
  begin("C6 08 20 00 08 00 00 00");
  wire.receive("000#02 01");
  wire.run_for(10s);
  wire.expect({});
  expect_failed(SdoEnd::cancelled(AbortCode::device_state));
}

// Kind of transfer

TEST_F(SdoClientBlockUpload, AServerMaySwitchToSegmentsForWhatIsShort) {
  sut.choose(SdoTransfer::automatic);
  std::array<std::uint8_t, 64> destination{};
  EXPECT_EQ(upload(destination), AbortCode::none);
  expect_request("A4 08 20 00 04 00 00 00");
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
  EXPECT_EQ(upload(destination), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 01 02 03 04");
  expect_done(4);
}

TEST_F(SdoClientBlockUpload, WhatHasLittleRoomIsAskedForInSegments) {
  sut.choose(SdoTransfer::automatic);
  std::array<std::uint8_t, 63> destination{};
  EXPECT_EQ(upload(destination), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
}

TEST_F(SdoClientBlockUpload, AServerThatKnowsNoBlocksIsAskedInSegmentsFromThenOn) {
  sut.choose(SdoTransfer::automatic);
  std::array<std::uint8_t, 64> destination{};
  EXPECT_EQ(upload(destination), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 01 00 04 05", "40 08 20 00 00 00 00 00");
  answer("43 08 20 00 01 02 03 04");
  expect_done(4);
  EXPECT_EQ(upload(destination), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  answer("80 08 20 00 00 00 02 06");
  expect_failed(SdoEnd::by_server(AbortCode::no_object));
}

TEST_F(SdoClientBlockUpload, WhoWantsBlocksOnlyIsToldThatTheServerKnowsNone) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 01 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::command_specifier));
}

}  // namespace
}  // namespace canvoy::sdo_client_block_upload_test
