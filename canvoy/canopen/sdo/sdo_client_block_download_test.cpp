// SDO client, download in blocks (CiA 301, 7.2.4.3.9 to 7.2.4.3.11).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_block_download_test {
namespace {

class SdoClientBlockDownload : public SdoClientNode {
 protected:
  SdoClientBlockDownload() { sut.choose(SdoTransfer::block); }

  /// Sends a message of the server, and checks several of the client.
  void answer_all(const std::string& response, std::vector<std::string> requests) {
    SCOPED_TRACE(response);
    for (std::string& request : requests) request = "605#" + request;
    wire.receive("585#" + response);
    wire.expect(requests);
  }
  /// Supplies 1, 2 ... and then reports the end.
  Result<std::size_t> give(std::span<std::uint8_t> piece) {
    const std::size_t size = std::min(piece.size(), left);
    for (std::size_t i = 0; i < size; ++i) piece[i] = ++last_given;
    left -= size;
    return size;
  }
  AbortCode supply(std::size_t size, std::optional<std::uint32_t> told) {
    left = size;
    last_given = 0;
    return sut.download(5, 0x2008, 0, SdoClient::Supply::to<&SdoClientBlockDownload::give>(*this),
                        told, on_done);
  }

  std::array<std::uint8_t, SdoBlockClient::buffer_size> buffer{};
  SdoBlockClient blocks{sut, buffer};
  const Bytes eight = {1, 2, 3, 4, 5, 6, 7, 8};  // their checksum is 76ACh
  const Bytes thirty = pattern(30);              // 30B4h
  std::size_t left = 0;
  std::uint8_t last_given = 0;
};

TEST_F(SdoClientBlockDownload, SegmentsFollowTheAnswerAndTheEndTheirAcknowledgement) {
  EXPECT_EQ(download(eight), AbortCode::none);
  expect_request("C6 08 20 00 08 00 00 00");
  expect_waiting();
  answer_all("A4 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  expect_waiting();
  answer("A2 02 7F 00 00 00 00 00", "D9 AC 76 00 00 00 00 00");
  expect_waiting();
  answer("A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockDownload, AServerWithoutChecksumsGetsNone) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer_all("A0 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  answer("A2 02 7F 00 00 00 00 00", "D9 00 00 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockDownload, TheServerChoosesTheSizeOfEachBlock) {
  EXPECT_EQ(download(thirty), AbortCode::none);
  expect_request("C6 08 20 00 1E 00 00 00");
  answer("A4 08 20 00 01 00 00 00", "01 01 20 3F 5E 7D 9C BB");
  answer_all("A2 01 02 00 00 00 00 00", {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F"});
  answer_all("A2 02 7F 00 00 00 00 00", {"01 8F AE CD EC 0B 2A 49", "82 69 88 00 00 00 00 00"});
  answer("A2 02 05 00 00 00 00 00", "D5 B4 30 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(30);
}

TEST_F(SdoClientBlockDownload, AnEmptyValueIsOneSegmentWithoutData) {
  EXPECT_EQ(download({}), AbortCode::none);
  expect_request("C6 08 20 00 00 00 00 00");
  answer("A4 08 20 00 7F 00 00 00", "81 00 00 00 00 00 00 00");
  answer("A2 01 7F 00 00 00 00 00", "DD 00 00 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(0);
}

TEST_F(SdoClientBlockDownload, ASupplyOfUnknownSizeEndsWhenItGivesLess) {
  EXPECT_EQ(supply(8, std::nullopt), AbortCode::none);
  expect_request("C4 08 20 00 00 00 00 00");
  answer_all("A4 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  answer("A2 02 7F 00 00 00 00 00", "D9 AC 76 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockDownload, ASupplyThatEndsWithAFullSegmentIsFollowedByAnEmptyOne) {
  EXPECT_EQ(supply(7, std::nullopt), AbortCode::none);
  wire.sent.clear();
  answer("A0 08 20 00 01 00 00 00", "01 01 02 03 04 05 06 07");
  answer("A2 01 01 00 00 00 00 00", "81 00 00 00 00 00 00 00");
  answer("A2 00 01 00 00 00 00 00", "81 00 00 00 00 00 00 00");  // it was lost
  answer("A2 01 01 00 00 00 00 00", "DD 00 00 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(7);
}

// Lost, repeated and late frames

TEST_F(SdoClientBlockDownload, WhatWasLostIsSentAgainInTheNextBlock) {
  EXPECT_EQ(download(thirty), AbortCode::none);
  wire.sent.clear();
  answer_all("A4 08 20 00 03 00 00 00",
             {"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95", "03 B5 D4 F3 12 31 50 6F"});
  answer_all("A2 01 03 00 00 00 00 00",
             {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F", "03 8F AE CD EC 0B 2A 49"});
  answer_all("A2 02 7F 00 00 00 00 00", {"01 8F AE CD EC 0B 2A 49", "82 69 88 00 00 00 00 00"});
  answer("A2 01 7F 00 00 00 00 00", "81 69 88 00 00 00 00 00");
  answer("A2 01 7F 00 00 00 00 00", "D5 B4 30 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(30);
}

TEST_F(SdoClientBlockDownload, WhatASupplyGaveIsKeptUntilItHasArrived) {
  for (const bool told : {true, false}) {
    EXPECT_EQ(supply(24, told ? std::optional(24U) : std::nullopt), AbortCode::none);
    wire.sent.clear();
    answer_all("A0 08 20 00 02 00 00 00", {"01 01 02 03 04 05 06 07", "02 08 09 0A 0B 0C 0D 0E"});
    answer_all("A2 01 03 00 00 00 00 00",
               {"01 08 09 0A 0B 0C 0D 0E", "02 0F 10 11 12 13 14 15", "83 16 17 18 00 00 00 00"});
    answer_all("A2 00 02 00 00 00 00 00", {"01 08 09 0A 0B 0C 0D 0E", "02 0F 10 11 12 13 14 15"});
    answer_all("A2 01 7F 00 00 00 00 00", {"01 0F 10 11 12 13 14 15", "82 16 17 18 00 00 00 00"});
    answer("A2 02 7F 00 00 00 00 00", "D1 00 00 00 00 00 00 00");
    answer("A1 00 00 00 00 00 00 00");
    expect_done(24);
  }
}

TEST_F(SdoClientBlockDownload, TheLastAcknowledgementMayComeTwice) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer_all("A4 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  answer("A2 02 7F 00 00 00 00 00", "D9 AC 76 00 00 00 00 00");
  answer("A2 02 7F 00 00 00 00 00");
  answer("A1 00 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientBlockDownload, LateAnswersToOtherRequestsAreNotTakenForThePresentOne) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer("A4 08 20 01 7F 00 00 00");
  answer("A4 07 20 00 7F 00 00 00");
  answer("60 08 20 00 00 00 00 00");
  answer("A2 08 20 00 7F 00 00 00");
  answer("80 08 20 01 00 00 02 06");
  answer("80 00 00 00 01 00 04 05");
  expect_waiting();
  answer_all("A4 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
}

TEST_F(SdoClientBlockDownload, AServerThatFallsSilentIsGivenUpAfterTheTimeOut) {
  const std::vector<const char*> steps = {"A4 08 20 00 7F 00 00 00", "A2 02 7F 00 00 00 00 00"};
  for (std::size_t count = 0; count <= steps.size(); ++count) {
    EXPECT_EQ(download(eight), AbortCode::none);
    for (std::size_t i = 0; i < count; ++i) wire.receive(std::string("585#") + steps[i]);
    wire.sent.clear();
    wire.run_for(999'999us);
    wire.expect({});
    wire.run_for(10s);
    wire.expect({"605#80 08 20 00 00 00 04 05"});
    expect_failed(SdoEnd::no_answer());
  }
}

// The controller

TEST_F(SdoClientBlockDownload, SegmentsLeaveAsTheControllerTakesThem) {
  EXPECT_EQ(download(thirty), AbortCode::none);
  wire.sent.clear();
  wire.full = true;
  answer("A4 08 20 00 7F 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"605#01 01 20 3F 5E 7D 9C BB", "605#02 DB FA 19 38 57 76 95",
               "605#03 B5 D4 F3 12 31 50 6F", "605#04 8F AE CD EC 0B 2A 49",
               "605#85 69 88 00 00 00 00 00"});
  EXPECT_EQ(wire.node.transmitter().lost(), 0U);
}

TEST_F(SdoClientBlockDownload, AnAcknowledgementInMidBlockGoesOnFromThere) {
  EXPECT_EQ(download(thirty), AbortCode::none);
  wire.sent.clear();
  wire.full = true;
  answer("A4 08 20 00 7F 00 00 00");
  answer("A2 05 7F 00 00 00 00 00");  // more than was sent
  answer("A2 01 02 00 00 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"605#01 01 20 3F 5E 7D 9C BB", "605#01 DB FA 19 38 57 76 95",
               "605#02 B5 D4 F3 12 31 50 6F"});
}

TEST_F(SdoClientBlockDownload, ACopyOfAnAcknowledgementInMidBlockTakesNothingFromWhatIsKept) {
  EXPECT_EQ(supply(24, 24U), AbortCode::none);
  wire.sent.clear();
  wire.full = true;
  answer("A0 08 20 00 7F 00 00 00");
  answer("A2 05 7F 00 00 00 00 00");  // more than was sent
  answer("A2 00 02 00 00 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"605#01 01 02 03 04 05 06 07", "605#01 01 02 03 04 05 06 07",
               "605#02 08 09 0A 0B 0C 0D 0E"});
}

// Errors

TEST_F(SdoClientBlockDownload, ABlockHas1To127Segments) {
  for (const char* size : {"00", "80", "FF"}) {
    EXPECT_EQ(download(eight), AbortCode::none);
    wire.sent.clear();
    answer(std::string("A4 08 20 00 ") + size + " 00 00 00", "80 08 20 00 02 00 04 05");
    expect_failed(AbortCode::block_size);
    EXPECT_EQ(download(eight), AbortCode::none);
    wire.sent.clear();
    answer("A4 08 20 00 01 00 00 00", "01 01 02 03 04 05 06 07");
    answer(std::string("A2 01 ") + size + " 00 00 00 00 00", "80 08 20 00 02 00 04 05");
    expect_failed(AbortCode::block_size);
  }
}

TEST_F(SdoClientBlockDownload, AnAcknowledgementOfWhatWasNotSentEndsTheTransfer) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer_all("A4 08 20 00 7F 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  answer("A2 03 7F 00 00 00 00 00", "80 08 20 00 03 00 04 05");
  expect_failed(AbortCode::sequence_number);
}

TEST_F(SdoClientBlockDownload, OtherCommandsEndTheTransfer) {
  for (const char* command :
       {"20 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00",
        "A4 08 20 00 7E 00 00 00", "C1 00 00 00 00 00 00 00", "E0 00 00 00 00 00 00 00"}) {
    EXPECT_EQ(download(eight), AbortCode::none);
    wire.receive("585#A4 08 20 00 7F 00 00 00");
    wire.sent.clear();
    answer(command, "80 08 20 00 01 00 04 05");
    expect_failed(AbortCode::command_specifier);
  }
}

TEST_F(SdoClientBlockDownload, AnAbortFromTheServerEndsItAtAnyTime) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 22 00 00 08");
  expect_failed(SdoEnd::by_server(AbortCode::device_state));
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.receive("585#A4 08 20 00 7F 00 00 00");
  wire.sent.clear();
  answer("80 08 20 00 00 00 06 06");
  expect_failed(SdoEnd::by_server(AbortCode::hardware));
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.receive("585#A4 08 20 00 7F 00 00 00");
  wire.receive("585#A2 02 7F 00 00 00 00 00");
  wire.sent.clear();
  answer("80 08 20 00 04 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::crc));
}

TEST_F(SdoClientBlockDownload, ASupplyMayEndIt) {
  auto fail = [&](std::span<std::uint8_t>) { return Result<std::size_t>(AbortCode::hardware); };
  EXPECT_EQ(sut.download(5, 0x2008, 0, SdoClient::Supply::of(fail), std::nullopt, on_done),
            AbortCode::none);
  wire.sent.clear();
  answer("A4 08 20 00 7F 00 00 00", "80 08 20 00 00 00 06 06");
  expect_failed(AbortCode::hardware);
}

TEST_F(SdoClientBlockDownload, ACancelledOneSendsNothingMore) {
  EXPECT_EQ(download(thirty), AbortCode::none);
  wire.sent.clear();
  wire.full = true;
  answer("A4 08 20 00 7F 00 00 00");
  sut.cancel();
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"605#01 01 20 3F 5E 7D 9C BB", "605#80 08 20 00 00 00 00 08"});
  wire.run_for(10s);
  wire.expect({});
  EXPECT_EQ(calls, 0);
}

// Kind of transfer

TEST_F(SdoClientBlockDownload, WhatIsLongGoesInBlocksAndWhatIsShortDoesNot) {
  sut.choose(SdoTransfer::automatic);
  const Bytes value(64);
  EXPECT_EQ(download(value), AbortCode::none);
  expect_request("C6 08 20 00 40 00 00 00");
  sut.cancel();
  wire.sent.clear();
  EXPECT_EQ(download(std::span(value).first(63)), AbortCode::none);
  expect_request("21 08 20 00 3F 00 00 00");
  sut.cancel();
  wire.sent.clear();
  EXPECT_EQ(supply(100, std::nullopt), AbortCode::none);
  expect_request("C4 08 20 00 00 00 00 00");
  sut.cancel();
  wire.sent.clear();
  sut.choose(SdoTransfer::segmented);
  EXPECT_EQ(download(value), AbortCode::none);
  expect_request("21 08 20 00 40 00 00 00");
}

TEST_F(SdoClientBlockDownload, AServerThatKnowsNoBlocksIsAskedInSegmentsFromThenOn) {
  sut.choose(SdoTransfer::automatic);
  const Bytes value(64);
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 01 00 04 05", "21 08 20 00 40 00 00 00");
  answer("60 08 20 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  sut.cancel();
  wire.sent.clear();
  EXPECT_EQ(download(value), AbortCode::none);
  expect_request("21 08 20 00 40 00 00 00");
  sut.cancel();
  wire.sent.clear();
  EXPECT_EQ(sut.download(6, 0x2008, 0, value, on_done), AbortCode::none);
  wire.expect({"606#C6 08 20 00 40 00 00 00"});
  EXPECT_EQ(calls, 0);
}

TEST_F(SdoClientBlockDownload, WhoWantsBlocksOnlyIsToldThatTheServerKnowsNone) {
  EXPECT_EQ(download(eight), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 01 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::command_specifier));
}

TEST(SdoClientWithoutBlocks, CannotBeAskedForThem) {
  WireNode wire(sdo_objects(), 1);
  SdoClient client(wire.node);
  wire.boot();
  client.choose(SdoTransfer::block);
  std::array<std::uint8_t, 100> bytes{};
  EXPECT_EQ(client.download(5, 0x2008, 0, bytes, {}), AbortCode::unsupported_access);
  EXPECT_EQ(client.upload(5, 0x2008, 0, bytes, {}), AbortCode::unsupported_access);
  EXPECT_FALSE(client.busy());
  client.choose(SdoTransfer::automatic);
  EXPECT_EQ(client.download(5, 0x2008, 0, bytes, {}), AbortCode::none);
  wire.expect({"605#21 08 20 00 64 00 00 00"});
}

TEST(SdoClientWithoutBuffer, SuppliesGoInSegmentsAndMemoryInBlocks) {
  WireNode wire(sdo_objects(), 1);
  SdoClient client(wire.node);
  std::array<std::uint8_t, SdoBlockClient::buffer_size - 1> too_little{};
  const SdoBlockClient blocks(client, too_little);
  wire.boot();
  auto give = [](std::span<std::uint8_t> piece) { return Result<std::size_t>(piece.size()); };
  EXPECT_EQ(client.download(5, 0x2008, 0, SdoClient::Supply::of(give), 100, {}), AbortCode::none);
  wire.expect({"605#21 08 20 00 64 00 00 00"});
  client.cancel();
  wire.sent.clear();
  std::array<std::uint8_t, 100> bytes{};
  EXPECT_EQ(client.download(5, 0x2008, 0, bytes, {}), AbortCode::none);
  wire.expect({"605#C6 08 20 00 64 00 00 00"});
}

}  // namespace
}  // namespace canvoy::sdo_client_block_download_test
