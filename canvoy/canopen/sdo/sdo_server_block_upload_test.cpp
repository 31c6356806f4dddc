// SDO server, upload in blocks (CiA 301, 7.2.4.3.12 to 7.2.4.3.15).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_block_upload_test {
namespace {

class SdoServerBlockUpload : public SdoServerNode {
 protected:
  /// Sends one message, and checks those of the server.
  void ask_for(const std::string& request, std::vector<std::string> answers) {
    SCOPED_TRACE(request);
    for (std::string& answer : answers) answer = "585#" + answer;
    wire.receive("605#" + request);
    wire.expect(answers);
  }

  SdoBlockServer blocks{sut};
};

// 2013h is "Canvoy node", with the checksum 28EEh.

TEST_F(SdoServerBlockUpload, SegmentsFollowTheStartAndTheEndTheirAcknowledgement) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  ask("A2 02 7F 00 00 00 00 00", "CD EE 28 00 00 00 00 00");
  EXPECT_TRUE(sut.busy());
  ask_in_vain("A1 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
  wire.run_for(10s);
  wire.expect({});
}

TEST_F(SdoServerBlockUpload, AClientWithoutChecksumsGetsNone) {
  ask("A0 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  ask("A2 02 7F 00 00 00 00 00", "CD 00 00 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, TheClientChoosesTheSizeOfEachBlock) {
  // 01 20 3F ... with the checksum 30B4h.
  set_value(wire.node, 0x2021, pattern(30));
  ask("A4 21 20 00 01 00 00 00", "C6 21 20 00 1E 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 01 20 3F 5E 7D 9C BB"});
  ask_for("A2 01 02 00 00 00 00 00", {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F"});
  ask_for("A2 02 7F 00 00 00 00 00", {"01 8F AE CD EC 0B 2A 49", "82 69 88 00 00 00 00 00"});
  ask("A2 02 01 00 00 00 00 00", "D5 B4 30 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, ALastSegmentMayBeFull) {
  set_value(wire.node, 0x2021, pattern(14));
  ask("A4 21 20 00 02 00 00 00", "C6 21 20 00 0E 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 01 20 3F 5E 7D 9C BB", "82 DB FA 19 38 57 76 95"});
  ask("A2 02 02 00 00 00 00 00", "C1 D2 8F 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, AShortValueIsUploadedInABlockWhereTheClientAsksForIt) {
  set_value(wire.node, 0x2002, Bytes{0x34, 0x12});
  ask("A4 02 20 00 7F 00 00 00", "C6 02 20 00 02 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"81 34 12 00 00 00 00 00"});
  ask("A2 01 7F 00 00 00 00 00", "D5 22 FB 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, AnEmptyValueIsOneSegmentWithoutData) {
  ask("A4 20 20 00 7F 00 00 00", "C6 20 20 00 00 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"81 00 00 00 00 00 00 00"});
  ask("A2 01 7F 00 00 00 00 00", "DD 00 00 00 00 00 00 00");
  ask_in_vain("A1 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

// The protocol switch threshold

TEST_F(SdoServerBlockUpload, WhatIsNotLongerThanTheThresholdGoesInSegments) {
  ask("A4 13 20 00 7F 0B 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  ask("70 00 00 00 00 00 00 00", "17 6E 6F 64 65 00 00 00");
  EXPECT_FALSE(sut.busy());
  ask("A4 13 20 00 7F 0A 00 00", "C6 13 20 00 0B 00 00 00");
}

TEST_F(SdoServerBlockUpload, WhatFitsIntoOneFrameGoesExpeditedBelowTheThreshold) {
  ask("A4 00 10 00 7F 04 00 00", "43 00 10 00 A2 01 02 00");
  EXPECT_FALSE(sut.busy());
  ask("A4 00 10 00 7F 03 00 00", "C6 00 10 00 04 00 00 00");
}

TEST_F(SdoServerBlockUpload, AnEmptyDomainWithAThresholdIsOneEmptySegment) {
  ask("A4 31 20 00 7F 01 00 00", "41 31 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "0F 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, ADomainBelowTheThresholdIsOpenedOnce) {
  readable.content = {1, 2, 3};
  ask("A4 31 20 00 7F 03 00 00", "41 31 20 00 03 00 00 00");
  EXPECT_EQ(readable.opened, 1);
  ask("60 00 00 00 00 00 00 00", "09 01 02 03 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, ADomainOfUnknownSizeGoesInBlocksWhateverTheThreshold) {
  readable.tells_size = false;
  readable.content = {1, 2, 3, 4, 5, 6, 7, 8};
  ask("A4 31 20 00 7F FF 00 00", "C4 31 20 00 00 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"});
  ask("A2 02 7F 00 00 00 00 00", "D9 AC 76 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, ADomainOfUnknownSizeThatEndsWithAFullSegmentIsFollowedByAnEmptyOne) {
  readable.tells_size = false;
  readable.content = {1, 2, 3, 4, 5, 6, 7};
  ask("A0 31 20 00 01 00 00 00", "C4 31 20 00 00 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 01 02 03 04 05 06 07"});
  ask_for("A2 01 01 00 00 00 00 00", {"81 00 00 00 00 00 00 00"});
  ask_for("A2 00 01 00 00 00 00 00", {"81 00 00 00 00 00 00 00"});
  ask("A2 01 01 00 00 00 00 00", "DD 00 00 00 00 00 00 00");
}

// Lost, repeated and late frames

TEST_F(SdoServerBlockUpload, WhatWasLostIsSentAgainInTheNextBlock) {
  set_value(wire.node, 0x2021, pattern(30));
  ask("A4 21 20 00 03 00 00 00", "C6 21 20 00 1E 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00",
          {"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95", "03 B5 D4 F3 12 31 50 6F"});
  ask_for("A2 01 03 00 00 00 00 00",
          {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F", "03 8F AE CD EC 0B 2A 49"});
  ask_for("A2 00 7F 00 00 00 00 00", {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F",
                                      "03 8F AE CD EC 0B 2A 49", "84 69 88 00 00 00 00 00"});
  ask_for("A2 03 7F 00 00 00 00 00", {"81 69 88 00 00 00 00 00"});
  ask("A2 01 7F 00 00 00 00 00", "D5 B4 30 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, ADomainIsReadAgainFromWhereSegmentsWereLost) {
  readable.content = pattern(30);
  ask("A4 31 20 00 02 00 00 00", "C6 31 20 00 1E 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95"});
  ask_for("A2 01 02 00 00 00 00 00", {"01 DB FA 19 38 57 76 95", "02 B5 D4 F3 12 31 50 6F"});
  ask_for("A2 02 02 00 00 00 00 00", {"01 8F AE CD EC 0B 2A 49", "82 69 88 00 00 00 00 00"});
  ask("A2 02 02 00 00 00 00 00", "D5 B4 30 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, AClientToWhichNothingEverComesIsGivenUp) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  for (int i = 0; i < 10; ++i) {
    ask_for("A2 00 7F 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  }
  ask("A2 00 7F 00 00 00 00 00", "80 13 20 00 03 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, TheLastAcknowledgementMayComeTwice) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  ask("A2 02 7F 00 00 00 00 00", "CD EE 28 00 00 00 00 00");
  ask_in_vain("A2 02 7F 00 00 00 00 00");
  ask_in_vain("A1 00 00 00 00 00 00 00");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, AnAbandonedUploadIsAbortedAfterTheTimeOut) {
  const std::vector<const char*> steps = {"A4 13 20 00 7F 00 00 00", "A3 00 00 00 00 00 00 00",
                                          "A2 02 7F 00 00 00 00 00"};
  for (std::size_t count = 1; count <= steps.size(); ++count) {
    for (std::size_t i = 0; i < count; ++i) wire.receive(std::string("605#") + steps[i]);
    wire.sent.clear();
    wire.run_for(999'999us);
    wire.expect({});
    wire.run_for(10s);
    wire.expect({"585#80 13 20 00 00 00 04 05"});
    EXPECT_FALSE(sut.busy());
  }
}

// The controller

TEST_F(SdoServerBlockUpload, SegmentsLeaveAsTheControllerTakesThem) {
  set_value(wire.node, 0x2021, pattern(30));
  ask("A4 21 20 00 7F 00 00 00", "C6 21 20 00 1E 00 00 00");
  wire.full = true;
  ask_in_vain("A3 00 00 00 00 00 00 00");
  EXPECT_FALSE(wire.node.transmitter().idle());
  wire.node.tx_ready(wire.now);
  wire.expect({});
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"585#01 01 20 3F 5E 7D 9C BB", "585#02 DB FA 19 38 57 76 95",
               "585#03 B5 D4 F3 12 31 50 6F", "585#04 8F AE CD EC 0B 2A 49",
               "585#85 69 88 00 00 00 00 00"});
  EXPECT_EQ(wire.node.transmitter().lost(), 0U);
  wire.node.tx_ready(wire.now);
  wire.expect({});
}

TEST_F(SdoServerBlockUpload, AnAcknowledgementInMidBlockGoesOnFromThere) {
  set_value(wire.node, 0x2021, pattern(30));
  ask("A4 21 20 00 7F 00 00 00", "C6 21 20 00 1E 00 00 00");
  wire.full = true;
  ask_in_vain("A3 00 00 00 00 00 00 00");
  ask_in_vain("A2 7F 7F 00 00 00 00 00");  // more than was sent: of a block before this one
  ask_in_vain("A2 00 02 00 00 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"585#01 01 20 3F 5E 7D 9C BB", "585#01 01 20 3F 5E 7D 9C BB",
               "585#02 DB FA 19 38 57 76 95"});
}

TEST_F(SdoServerBlockUpload, OtherFramesOfTheNodeDoNotPutTheTimeOutOff) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  for (int i = 0; i < 9; ++i) {
    wire.run_for(100ms);
    wire.node.tx_ready(wire.now);
  }
  wire.run_for(10s);
  wire.expect({"@1000000 585#80 13 20 00 00 00 04 05"});
}

TEST_F(SdoServerBlockUpload, AControllerThatTakesNothingEndsItAfterTheTimeOut) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  wire.full = true;
  ask_in_vain("A3 00 00 00 00 00 00 00");
  wire.run_for(10s);
  EXPECT_FALSE(sut.busy());
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"585#01 43 61 6E 76 6F 79 20", "585#80 13 20 00 00 00 04 05"});
}

// Errors

TEST_F(SdoServerBlockUpload, ABlockHas1To127Segments) {
  ask("A4 13 20 00 00 00 00 00", "80 13 20 00 02 00 04 05");
  ask("A4 13 20 00 80 00 00 00", "80 13 20 00 02 00 04 05");
  ask("A4 13 20 00 FF 00 00 00", "80 13 20 00 02 00 04 05");
  for (const char* size : {"00", "80", "FF"}) {
    ask("A4 13 20 00 01 00 00 00", "C6 13 20 00 0B 00 00 00");
    ask("A3 00 00 00 00 00 00 00", "01 43 61 6E 76 6F 79 20");
    ask(std::string("A2 01 ") + size + " 00 00 00 00 00", "80 13 20 00 02 00 04 05");
    EXPECT_FALSE(sut.busy());
  }
}

TEST_F(SdoServerBlockUpload, AtTheEndTheNextBlockSizeDoesNotMatter) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  ask("A2 02 00 00 00 00 00 00", "CD EE 28 00 00 00 00 00");
}

TEST_F(SdoServerBlockUpload, AnAcknowledgementOfWhatWasNotSentEndsTheTransfer) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
  ask("A2 03 7F 00 00 00 00 00", "80 13 20 00 03 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, AnAcknowledgementOfNothingIsAStart) {
  ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask_for("A2 00 7F 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
}

TEST_F(SdoServerBlockUpload, CommandsOutOfTheirOrderEndTheTransfer) {
  const std::vector<std::vector<const char*>> steps = {
      {"A4 13 20 00 7F 00 00 00"},
      {"A4 13 20 00 7F 00 00 00", "A3 00 00 00 00 00 00 00"},
      {"A4 13 20 00 7F 00 00 00", "A3 00 00 00 00 00 00 00", "A2 02 7F 00 00 00 00 00"}};
  const std::vector<std::vector<const char*>> wrong = {
      {"A1 00 00 00 00 00 00 00", "A2 02 7F 00 00 00 00 00", "A2 01 7F 00 00 00 00 00",
       "60 00 00 00 00 00 00 00"},
      {"A1 00 00 00 00 00 00 00", "A3 00 00 00 00 00 00 01", "C1 00 00 00 00 00 00 00"},
      {"A3 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00", "E0 00 00 00 00 00 00 00"}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const char* command : wrong[i]) {
      for (const char* step : steps[i]) wire.receive(std::string("605#") + step);
      wire.sent.clear();
      ask(command, "80 13 20 00 01 00 04 05");
      EXPECT_FALSE(sut.busy());
    }
  }
}

TEST_F(SdoServerBlockUpload, OutOfNowhereTheyAreAborted) {
  for (const char* command : {"A1", "A2", "A3"}) {
    ask(std::string(command) + " 02 7F 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  }
  expect_alive();
}

TEST_F(SdoServerBlockUpload, WhatCannotBeReadIsAbortedAtOnce) {
  ask("A4 99 20 00 7F 00 00 00", "80 99 20 00 00 00 02 06");
  ask("A4 09 20 04 7F 00 00 00", "80 09 20 04 11 00 09 06");
  ask("A4 11 20 00 7F 00 00 00", "80 11 20 00 01 00 01 06");
  ask("A4 32 20 00 7F 00 00 00", "80 32 20 00 01 00 01 06");
  ask("A4 33 20 00 7F 00 00 00", "80 33 20 00 00 00 01 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, ADomainMayFailInTheMiddle) {
  readable.content = pattern(30);
  readable.refused_from = 14;
  ask("A4 31 20 00 7F 00 00 00", "C6 31 20 00 1E 00 00 00");
  ask_for("A3 00 00 00 00 00 00 00",
          {"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95", "80 31 20 00 00 00 06 06"});
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockUpload, AnAbortEndsTheTransferWithoutAnAnswer) {
  ask("A4 13 20 00 01 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask("A3 00 00 00 00 00 00 00", "01 43 61 6E 76 6F 79 20");
  ask_in_vain("80 13 20 00 00 00 00 08");
  EXPECT_FALSE(sut.busy());
  expect_alive();
}

TEST_F(SdoServerBlockUpload, ANewInitiateInMidTransferStartsAfresh) {
  const std::vector<std::pair<const char*, const char*>> initiates = {
      {"40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00"},
      {"21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00"},
      {"C6 08 20 00 08 00 00 00", "A4 08 20 00 7F 00 00 00"},
      {"A4 13 20 00 01 00 00 00", "C6 13 20 00 0B 00 00 00"}};
  for (const auto& [request, answer] : initiates) {
    ask("A4 13 20 00 01 00 00 00", "C6 13 20 00 0B 00 00 00");
    ask("A3 00 00 00 00 00 00 00", "01 43 61 6E 76 6F 79 20");
    ask(request, answer);
    ask_in_vain("80 00 00 00 00 00 00 08");
  }
}

TEST_F(SdoServerBlockUpload, BackToBackUploadsDoNotDisturbEachOther) {
  for (int i = 0; i < 3; ++i) {
    ask("A4 13 20 00 7F 00 00 00", "C6 13 20 00 0B 00 00 00");
    ask_for("A3 00 00 00 00 00 00 00", {"01 43 61 6E 76 6F 79 20", "82 6E 6F 64 65 00 00 00"});
    ask("A2 02 7F 00 00 00 00 00", "CD EE 28 00 00 00 00 00");
    ask_in_vain("A1 00 00 00 00 00 00 00");
  }
}

TEST_F(SdoServerBlockUpload, StoppedEndsItWithoutAWord) {
  ask("A4 13 20 00 01 00 00 00", "C6 13 20 00 0B 00 00 00");
  ask("A3 00 00 00 00 00 00 00", "01 43 61 6E 76 6F 79 20");
  wire.receive("000#02 05");
  wire.node.tx_ready(wire.now);
  wire.run_for(10s);
  wire.expect({});
  EXPECT_FALSE(sut.busy());
}

}  // namespace
}  // namespace canvoy::sdo_server_block_upload_test
