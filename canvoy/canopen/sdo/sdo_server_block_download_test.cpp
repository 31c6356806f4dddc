// SDO server, download in blocks (CiA 301, 7.2.4.3.9 to 7.2.4.3.11).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_block_download_test {
namespace {

class SdoServerBlockDownload : public SdoServerNode {
 protected:
  /// Sends segments of which only the last is answered.
  void send(const std::vector<std::string>& segments, const std::string& answer) {
    for (const std::string& segment : segments) wire.receive("605#" + segment);
    wire.expect({"585#" + answer});
  }
  void send_in_vain(const std::vector<std::string>& segments) {
    for (const std::string& segment : segments) wire.receive("605#" + segment);
    wire.expect({});
  }

  SdoBlockServer blocks{sut, 4};
};

// The checksum of 1, 2 ... 8 is 76ACh.

TEST_F(SdoServerBlockDownload, ABlockIsAcknowledgedAtItsLastSegmentAndTheEndIsConfirmed) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  EXPECT_TRUE(sut.busy());
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), Bytes(8));
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, TheBlockSizeIs127UnlessTheOwnerWantsLess) {
  const std::vector<std::pair<unsigned, const char*>> wanted = {
      {127, "7F"}, {1, "01"}, {126, "7E"}, {0, "7F"}, {128, "7F"}, {255, "7F"}};
  for (const auto& [size, told] : wanted) {
    WireNode other(sdo_objects(), 5);
    SdoServer server(other.node, 0, {});
    const SdoBlockServer its_blocks(server, static_cast<std::uint8_t>(size));
    other.boot();
    other.receive("605#C6 08 20 00 08 00 00 00");
    other.expect({std::string("585#A4 08 20 00 ") + told + " 00 00 00"});
  }
}

TEST_F(SdoServerBlockDownload, WithoutTheSizeTheEndShowsIt) {
  ask("C4 08 20 00 EE EE EE EE", "A4 08 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(SdoServerBlockDownload, BlockFollowsBlockUntilTheLastSegment) {
  const Bytes bytes = {1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7, 1, 2, 3,
                       4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7, 9, 9, 9, 9, 9, 9};
  ask("C0 21 20 00 00 00 00 00", "A4 21 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07", "03 01 02 03 04 05 06 07",
        "04 01 02 03 04 05 06 07"},
       "A2 04 04 00 00 00 00 00");
  send({"81 09 09 09 09 09 09 EE"}, "A2 01 04 00 00 00 00 00");
  ask("C5 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021), bytes);
}

TEST_F(SdoServerBlockDownload, ALastSegmentMayBeFullAndTheLastOfItsBlock) {
  ask("C2 21 20 00 1C 00 00 00", "A4 21 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07", "03 01 02 03 04 05 06 07",
        "84 01 02 03 04 05 06 07"},
       "A2 04 04 00 00 00 00 00");
  ask("C1 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021).size(), 28U);
}

TEST_F(SdoServerBlockDownload, AStringIsEmptiedByOneSegmentWithoutData) {
  set_value(wire.node, 0x2020, Bytes{'a'});
  ask("C6 20 20 00 00 00 00 00", "A4 20 20 00 04 00 00 00");
  send({"81 00 00 00 00 00 00 00"}, "A2 01 04 00 00 00 00 00");
  ask("DD 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2020), Bytes{});
}

TEST_F(SdoServerBlockDownload, AShortValueMayComeInABlockToo) {
  ask("C6 02 20 00 02 00 00 00", "A4 02 20 00 04 00 00 00");
  send({"81 34 12 00 00 00 00 00"}, "A2 01 04 00 00 00 00 00");
  ask("D5 23 FB 00 00 00 00 00", "80 02 20 00 04 00 04 05");  // FB22h is right
  EXPECT_EQ(value(0x2002), (Bytes{0, 0}));
  ask("C6 02 20 00 02 00 00 00", "A4 02 20 00 04 00 00 00");
  send({"81 34 12 00 00 00 00 00"}, "A2 01 04 00 00 00 00 00");
  ask("D5 22 FB 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2002), (Bytes{0x34, 0x12}));
}

TEST_F(SdoServerBlockDownload, AClientWithoutChecksumsSendsNone) {
  ask("C2 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 34 12 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

// Lost, repeated and late frames

TEST_F(SdoServerBlockDownload, AfterALostSegmentTheRestOfTheBlockIsAskedForAgain) {
  ask("C6 21 20 00 1C 00 00 00", "A4 21 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "03 21 22 23 24 25 26 27", "84 31 32 33 34 35 36 37"},
       "A2 01 04 00 00 00 00 00");
  send({"01 11 12 13 14 15 16 17", "02 21 22 23 24 25 26 27", "83 31 32 33 34 35 36 37"},
       "A2 03 04 00 00 00 00 00");
  ask("C1 77 36 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2021), (Bytes{0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x11, 0x12, 0x13,
                                  0x14, 0x15, 0x16, 0x17, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26,
                                  0x27, 0x31, 0x32, 0x33, 0x34, 0x35, 0x36, 0x37}));
}

TEST_F(SdoServerBlockDownload, OfABlockWhoseFirstSegmentIsLostNothingIsAcknowledged) {
  ask("C2 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send({"82 08 00 00 00 00 00 00"}, "A2 00 04 00 00 00 00 00");
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(SdoServerBlockDownload, ASegmentThatComesTwiceCountsOnce) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07", "01 01 02 03 04 05 06 07"});
  send({"82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
}

TEST_F(SdoServerBlockDownload, WhereTheEndOfABlockIsLostItIsAcknowledgedAfterHalfOfTheTimeOut) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  wire.run_until(Time(100ms));
  send_in_vain({"01 01 02 03 04 05 06 07"});
  wire.run_until(Time(700ms));
  wire.expect({"@600000 585#A2 01 04 00 00 00 00 00"});
  send({"81 08 00 00 00 00 00 00"}, "A2 01 04 00 00 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(SdoServerBlockDownload, AnAbandonedBlockIsAbortedAfterTheTimeOut) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07"});
  wire.run_until(Time(10s));
  wire.expect({"@500000 585#A2 01 04 00 00 00 00 00", "@1000000 585#80 08 20 00 00 00 04 05"});
  EXPECT_FALSE(sut.busy());
  EXPECT_EQ(value(0x2008), Bytes(8));
  expect_alive();
}

TEST_F(SdoServerBlockDownload, ABlockOfWhichNothingComesIsAskedForAgainWhereTheSizeWasTold) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  wire.run_until(Time(700ms));
  wire.expect({"@500000 585#A2 00 04 00 00 00 00 00"});
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

/// The client has not received the acknowledgement of the block, and sends the block again.
TEST_F(SdoServerBlockDownload, ABlockThatComesTwiceMakesTooManyBytesAndEndsTheTransfer) {
  ask("C2 21 20 00 1D 00 00 00", "A4 21 20 00 04 00 00 00");  // 29 bytes
  const std::vector<std::string> block = {"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07",
                                          "03 01 02 03 04 05 06 07", "04 01 02 03 04 05 06 07"};
  send(block, "A2 04 04 00 00 00 00 00");
  wire.run_until(Time(500ms));
  wire.expect({"@500000 585#A2 00 04 00 00 00 00 00"});
  send({block[0], block[1]}, "80 21 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
  expect_alive();
}

TEST_F(SdoServerBlockDownload, OfWhatHasNotBegunNothingIsAskedForWithoutItsSize) {
  ask("C4 08 20 00 00 00 00 00", "A4 08 20 00 04 00 00 00");
  wire.run_until(Time(10s));
  wire.expect({"@1000000 585#80 08 20 00 00 00 04 05"});
}

TEST_F(SdoServerBlockDownload, AnEndThatDoesNotComeIsWaitedForUntilTheTimeOut) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  wire.run_until(Time(10s));
  wire.expect({"@1000000 585#80 08 20 00 00 00 04 05"});
  EXPECT_EQ(value(0x2008), Bytes(8));
}

// Errors

TEST_F(SdoServerBlockDownload, NumbersThatNoSegmentOfTheBlockHasEndTheTransfer) {
  for (const char* segment : {"00 01 02 03 04 05 06 07", "05 01 02 03 04 05 06 07",
                              "7F 01 02 03 04 05 06 07", "85 01 02 03 04 05 06 07"}) {
    ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
    ask(segment, "80 08 20 00 03 00 04 05");
    EXPECT_FALSE(sut.busy());
  }
}

TEST_F(SdoServerBlockDownload, AWrongChecksumEndsTheTransferAndNothingIsWritten) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 AD 76 00 00 00 00 00", "80 08 20 00 04 00 04 05");
  EXPECT_EQ(value(0x2008), Bytes(8));
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, AnEndThatCountsOtherBytesThanWereToldEndsTheTransfer) {
  for (const auto& [end, code] : {std::pair{"D5 00 00 00 00 00 00 00", "12 00 07 06"},
                                  std::pair{"DD 00 00 00 00 00 00 00", "13 00 07 06"},
                                  std::pair{"C1 00 00 00 00 00 00 00", "12 00 07 06"}}) {
    ask("C2 21 20 00 08 00 00 00", "A4 21 20 00 04 00 00 00");
    send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
    ask(end, std::string("80 21 20 00 ") + code);
    EXPECT_EQ(value(0x2021), Bytes{});
  }
}

TEST_F(SdoServerBlockDownload, ASizeThatDoesNotFitTheEntryIsAbortedAtOnce) {
  ask("C6 08 20 00 09 00 00 00", "80 08 20 00 12 00 07 06");
  ask("C6 08 20 00 07 00 00 00", "80 08 20 00 13 00 07 06");
  ask("C6 12 20 00 02 00 00 00", "80 12 20 00 02 00 01 06");
  ask("C6 99 20 00 02 00 00 00", "80 99 20 00 00 00 02 06");
  ask("C6 09 20 04 02 00 00 00", "80 09 20 04 11 00 09 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, MoreThanFitsIsAbortedInTheMiddleOfABlock) {
  ask("C4 08 20 00 00 00 00 00", "A4 08 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07"});
  ask("03 01 02 03 04 05 06 07", "80 08 20 00 12 00 07 06");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, TheEndOutOfNowhereIsAborted) {
  ask("C1 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("C1 00 00 00 00 00 00 00", "80 08 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, OtherCommandsInPlaceOfTheEndEndTheTransfer) {
  for (const char* command :
       {"00 00 00 00 00 00 00 00", "60 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00",
        "A2 01 04 00 00 00 00 00", "A3 00 00 00 00 00 00 00", "E0 00 00 00 00 00 00 00"}) {
    ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
    send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
    ask(command, "80 08 20 00 01 00 04 05");
    EXPECT_FALSE(sut.busy());
  }
}

TEST_F(SdoServerBlockDownload, AnAbortEndsTheTransferWithoutAnAnswer) {
  ask("C6 30 20 00 08 00 00 00", "A4 30 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07", "80 30 20 00 00 00 00 08"});
  EXPECT_FALSE(sut.busy());
  EXPECT_EQ(domain.dropped, 1);
  expect_alive();
}

TEST_F(SdoServerBlockDownload, ANewInitiateInPlaceOfTheEndStartsAfresh) {
  const std::vector<std::pair<const char*, const char*>> initiates = {
      {"40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00"},
      {"2F 01 20 00 11 00 00 00", "60 01 20 00 00 00 00 00"},
      {"C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00"},
      {"A4 13 20 00 04 00 00 00", "C6 13 20 00 0B 00 00 00"}};
  for (const auto& [request, answer] : initiates) {
    ask("C6 30 20 00 08 00 00 00", "A4 30 20 00 04 00 00 00");
    send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
    ask(request, answer);
    ask_in_vain("80 00 00 00 00 00 00 08");
  }
  EXPECT_EQ(domain.dropped, 4);
}

// Domains and NMT

TEST_F(SdoServerBlockDownload, ADomainIsWrittenSegmentBySegmentAndClosedAtTheEnd) {
  ask("C6 32 20 00 08 00 00 00", "A4 32 20 00 04 00 00 00");
  EXPECT_EQ(writable.announced, 8U);
  send_in_vain({"01 01 02 03 04 05 06 07"});
  EXPECT_EQ(writable.arriving, Bytes{});  // it may be the last
  send({"82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  EXPECT_EQ(writable.arriving, (Bytes{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(writable.open);
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  EXPECT_EQ(writable.content, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(writable.open);
}

TEST_F(SdoServerBlockDownload, ADomainMayRefuseAtAnyTime) {
  domain.open_answer = AbortCode::local_control;
  ask("C6 30 20 00 08 00 00 00", "80 30 20 00 21 00 00 08");
  domain.open_answer = AbortCode::none;
  domain.refused_from = 7;
  ask("C6 30 20 00 0F 00 00 00", "A4 30 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07"});
  ask("83 01 00 00 00 00 00 00", "80 30 20 00 00 00 06 06");
  EXPECT_EQ(domain.dropped, 1);
  domain.refused_from = SIZE_MAX;
  domain.close_answer = AbortCode::cannot_store;
  ask("C2 30 20 00 01 00 00 00", "A4 30 20 00 04 00 00 00");
  send({"81 01 00 00 00 00 00 00"}, "A2 01 04 00 00 00 00 00");
  ask("D9 00 00 00 00 00 00 00", "80 30 20 00 20 00 00 08");
  EXPECT_EQ(domain.dropped, 1);
}

/// A host passes on what is gathered with the acknowledgement, and the last segment at the end.
TEST_F(SdoServerBlockDownload, ADomainGetsTheSegmentsOfABlockAtOnce) {
  ask("C2 30 20 00 23 00 00 00", "A4 30 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06 07", "02 01 02 03 04 05 06 07", "03 01 02 03 04 05 06 07"});
  EXPECT_EQ(domain.arriving.size(), is_small_machine ? 14U : 0U);
  send({"04 01 02 03 04 05 06 07"}, "A2 04 04 00 00 00 00 00");
  EXPECT_EQ(domain.longest_piece, is_small_machine ? 7U : 28U);
  send({"81 01 02 03 04 05 06 07"}, "A2 01 04 00 00 00 00 00");
  ask("C1 00 00 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
  Bytes whole;
  for (int i = 0; i < 5; ++i) whole.insert(whole.end(), {1, 2, 3, 4, 5, 6, 7});
  EXPECT_EQ(domain.content, whole);
}

TEST_F(SdoServerBlockDownload, StoppedEndsItWithoutAWord) {
  ask("C6 30 20 00 08 00 00 00", "A4 30 20 00 04 00 00 00");
  wire.receive("000#02 05");
  EXPECT_EQ(domain.dropped, 1);
  wire.receive("000#80 05");
  wire.run_for(10s);
  wire.expect({});
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerBlockDownload, FramesOfAnotherLengthAreIgnoredAndCounted) {
  ask("C6 08 20 00 08 00 00 00", "A4 08 20 00 04 00 00 00");
  send_in_vain({"01 01 02 03 04 05 06", "01", ""});
  EXPECT_EQ(wire.node.counters().malformed, 3U);
  send({"01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00"}, "A2 02 04 00 00 00 00 00");
  ask("D9 AC 76 00 00 00 00 00", "A1 00 00 00 00 00 00 00");
}

TEST(SdoServerWithoutBlocks, RefusesThemByNameSoThatTheClientTakesAnother) {
  WireNode wire(sdo_objects(), 5);
  SdoServer server(wire.node, 0, {});
  wire.boot();
  wire.receive("605#C6 08 20 00 08 00 00 00");
  wire.receive("605#A4 08 20 00 7F 00 00 00");
  wire.expect({"585#80 08 20 00 01 00 04 05", "585#80 08 20 00 01 00 04 05"});
}

}  // namespace
}  // namespace canvoy::sdo_server_block_download_test
