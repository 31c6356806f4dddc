// SDO server: common behaviour of all kinds of transfer (CiA 301, 7.2.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_server_test {
namespace {

class SdoServerTest : public SdoServerNode {};

// The order of messages

TEST_F(SdoServerTest, SegmentsOutOfNowhereAreAborted) {
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("70 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  ask("1D 08 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  expect_alive();
}

TEST_F(SdoServerTest, ASegmentOfTheOtherDirectionEndsTheTransfer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("60 00 00 00 00 00 00 00", "80 08 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("00 01 02 03 04 05 06 07", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, AnAbortFromTheClientEndsTheTransferWithoutAnAnswer) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask_in_vain("80 08 20 00 00 00 00 08");
  EXPECT_FALSE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  ask_in_vain("80 08 20 00 00 00 00 08");
  expect_alive();
}

TEST_F(SdoServerTest, ANewInitiateInMidTransferStartsAfresh) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("00 11 12 13 14 15 16 17", "20 00 00 00 00 00 00 00");
  ask("1D 18 00 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(value(0x2008), (Bytes{0x11, 0x12, 0x13, 0x14, 0x15, 0x16, 0x17, 0x18}));
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
  expect_alive();
  ask("70 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
}

TEST_F(SdoServerTest, AnUnknownCommandSpecifierIsAborted) {
  ask("E0 13 20 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("FF 13 20 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  ask("E0 00 00 00 00 00 00 00", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
}

TEST_F(SdoServerTest, ABlockTransferIsRefusedByNameSoThatTheClientTakesAnother) {
  ask("A4 13 20 00 7F 00 00 00", "80 13 20 00 01 00 04 05");
  ask("C6 08 20 00 08 00 00 00", "80 08 20 00 01 00 04 05");
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  ask("A0 13 20 00 7F 00 00 00", "80 13 20 00 01 00 04 05");
  EXPECT_FALSE(sut.busy());
  ask("A2 01 02 03 00 00 00 00", "80 00 00 00 01 00 04 05");
}

// Time

TEST_F(SdoServerTest, AnAbandonedTransferIsAbortedAfterTheTimeOut) {
  ask("21 08 20 00 08 00 00 00", "60 08 20 00 00 00 00 00");
  wire.run_until(Time(999'999us));
  wire.expect({});
  wire.run_until(Time(10s));
  wire.expect({"@1000000 585#80 08 20 00 00 00 04 05"});
  EXPECT_FALSE(sut.busy());
  ask("00 01 02 03 04 05 06 07", "80 00 00 00 01 00 04 05");
  EXPECT_EQ(value(0x2008), Bytes(8));
}

TEST_F(SdoServerTest, EachSegmentStartsTheTimeOutAnew) {
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  wire.run_until(Time(900ms));
  ask("60 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  wire.run_until(Time(1899ms));
  wire.expect({});
  wire.run_until(Time(10s));
  wire.expect({"@1900000 585#80 08 20 00 00 00 04 05"});
}

TEST_F(SdoServerTest, AFinishedTransferHasNoTimeOut) {
  ask("40 08 20 00 00 00 00 00", "41 08 20 00 08 00 00 00");
  ask("60 00 00 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  ask("70 00 00 00 00 00 00 00", "1D 00 00 00 00 00 00 00");
  wire.run_until(Time(10s));
  wire.expect({});
}

TEST_F(SdoServerTest, AnExpeditedTransferNeedsNoTimer) {
  expect_alive();
  EXPECT_EQ(wire.node.deadline(), never);
}

TEST_F(SdoServerTest, TheTimeOutIsTheOwnersChoice) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {}, 50ms);
  other.boot();
  other.receive("605#21 08 20 00 08 00 00 00");
  other.run_until(Time(1s));
  other.expect({"585#60 08 20 00 00 00 00 00", "@50000 585#80 08 20 00 00 00 04 05"});
}

// The buffer

TEST_F(SdoServerTest, ValuesOfEightBytesNeedNoBuffer) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {});
  other.boot();
  other.receive("605#21 08 20 00 08 00 00 00");
  other.receive("605#00 01 02 03 04 05 06 07");
  other.receive("605#1D 08 00 00 00 00 00 00");
  other.receive("605#40 08 20 00 00 00 00 00");
  other.expect({"585#60 08 20 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
                "585#30 00 00 00 00 00 00 00", "585#41 08 20 00 08 00 00 00"});
}

TEST_F(SdoServerTest, AValueThatDoesNotFitTheBufferIsAborted) {
  WireNode other(sdo_objects(), 5);
  std::array<std::uint8_t, 10> small{};
  SdoServer server(other.node, 0, small);
  other.boot();
  other.receive("605#21 21 20 00 0B 00 00 00");
  other.expect({"585#80 21 20 00 05 00 04 05"});
  other.receive("605#20 21 20 00 00 00 00 00");
  other.receive("605#00 01 02 03 04 05 06 07");
  other.receive("605#17 08 09 0A 0B 00 00 00");
  other.expect({"585#60 21 20 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
                "585#80 21 20 00 05 00 04 05"});
  set_value(other.node, 0x2021, Bytes(11));
  other.receive("605#40 21 20 00 00 00 00 00");
  other.expect({"585#80 21 20 00 05 00 04 05"});
}

TEST_F(SdoServerTest, AConstantValueNeedsNoBuffer) {
  WireNode other(sdo_objects(), 5);
  SdoServer server(other.node, 0, {});
  other.boot();
  other.receive("605#40 13 20 00 00 00 00 00");
  other.receive("605#60 00 00 00 00 00 00 00");
  other.receive("605#70 00 00 00 00 00 00 00");
  other.expect({"585#41 13 20 00 0B 00 00 00", "585#00 43 61 6E 76 6F 79 20",
                "585#17 6E 6F 64 65 00 00 00"});
}

TEST(SdoBufferSize, IsTheLengthOfTheLongestValue) {
  EXPECT_EQ(sdo_buffer_size(sdo_objects()), 5000U);
}

// Domains

TEST_F(SdoServerTest, ADomainThatNobodyServesCannotBeAccessed) {
  ask("40 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("20 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("2F 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
}

TEST_F(SdoServerTest, ADomainNeedNotServeBothDirections) {
  const Domain nothing;
  Hook hook{.first = 0x2033, .last = 0x2033, .domain = &nothing};
  wire.node.dictionary().attach(hook);
  ask("40 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
  ask("20 33 20 00 00 00 00 00", "80 33 20 00 00 00 01 06");
}

TEST_F(SdoServerTest, ADomainMayRefuseToBeOpened) {
  domain.open_answer = AbortCode::local_control;
  ask("40 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  ask("20 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  ask("2F 30 20 00 00 00 00 00", "80 30 20 00 21 00 00 08");
  EXPECT_EQ(domain.dropped, 0);
}

TEST_F(SdoServerTest, ADomainMayFailInTheMiddle) {
  domain.content = pattern(20);
  domain.refused_from = 8;
  ask("40 30 20 00 00 00 00 00", "41 30 20 00 14 00 00 00");
  wire.receive("605#60 00 00 00 00 00 00 00");
  wire.sent.clear();
  ask("70 00 00 00 00 00 00 00", "80 30 20 00 00 00 06 06");
  ask("20 30 20 00 00 00 00 00", "60 30 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("10 01 02 03 04 05 06 07", "80 30 20 00 00 00 06 06");
  EXPECT_EQ(domain.dropped, 1);
  EXPECT_EQ(domain.content, pattern(20));
}

TEST_F(SdoServerTest, ADomainMayRefuseWhatHasArrived) {
  domain.close_answer = AbortCode::cannot_store;
  ask("2F 30 20 00 00 00 00 00", "80 30 20 00 20 00 00 08");
  EXPECT_FALSE(domain.open);
  EXPECT_EQ(domain.dropped, 0);
}

TEST_F(SdoServerTest, ADomainForgetsADownloadThatCameToNothing) {
  const auto begin = [&] {
    ask("21 30 20 00 08 00 00 00", "60 30 20 00 00 00 00 00");
    ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
    EXPECT_TRUE(domain.open);
  };
  begin();
  ask_in_vain("80 30 20 00 00 00 00 08");
  EXPECT_EQ(domain.dropped, 1);
  begin();
  expect_alive();
  EXPECT_EQ(domain.dropped, 2);
  begin();
  ask("0D 08 00 00 00 00 00 00", "80 30 20 00 00 00 03 05");
  EXPECT_EQ(domain.dropped, 3);
  begin();
  ask("1F 00 00 00 00 00 00 00", "80 30 20 00 13 00 07 06");
  EXPECT_EQ(domain.dropped, 4);
  begin();
  ask("1B 08 09 00 00 00 00 00", "80 30 20 00 12 00 07 06");
  EXPECT_EQ(domain.dropped, 5);
  begin();
  wire.run_for(1s);
  EXPECT_EQ(domain.dropped, 6);
  wire.sent.clear();
  begin();
  wire.receive("000#02 05");
  EXPECT_EQ(domain.dropped, 7);
  EXPECT_FALSE(domain.open);
  EXPECT_EQ(domain.content, Bytes{});
}

// NMT states and malformed frames

TEST_F(SdoServerTest, ItServesInPreOperationalAndOperationalAndIsSilentInStopped) {
  expect_alive();
  wire.receive("000#01 05");
  expect_alive();
  wire.receive("000#02 05");
  ask_in_vain("40 00 10 00 00 00 00 00");
  wire.receive("000#80 05");
  expect_alive();
}

TEST_F(SdoServerTest, ItIsSilentInInitialisation) {
  WireNode other(sdo_objects(), node_id_unconfigured);
  SdoServer server(other.node, 0, {});
  other.start();
  other.receive("6FF#40 00 10 00 00 00 00 00");
  other.receive("605#40 00 10 00 00 00 00 00");
  other.expect({});
}

TEST_F(SdoServerTest, ATransferSurvivesTheWayFromPreOperationalToOperational) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#01 05");
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerTest, StoppedAndResetEndATransferWithoutAWord) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#02 05");
  wire.receive("000#80 05");
  wire.expect({});
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  wire.receive("000#82 05");
  wire.expect({"705#00"});
  ask("60 00 00 00 00 00 00 00", "80 00 00 00 01 00 04 05");
}

TEST_F(SdoServerTest, AWriteThatStopsTheNodeIsNotConfirmed) {
  auto stop = [&](const Entry&, Source) { wire.node.command(NmtCommand::stop); };
  Hook hook{.first = 0x2001, .last = 0x2001};
  hook.after_write = decltype(hook.after_write)::of(stop);
  wire.node.dictionary().attach(hook);
  ask_in_vain("2F 01 20 00 11 00 00 00");
  EXPECT_EQ(wire.node.state(), NmtState::stopped);
}

TEST_F(SdoServerTest, FramesOfAnotherLengthAreIgnoredAndCounted) {
  ask("40 13 20 00 00 00 00 00", "41 13 20 00 0B 00 00 00");
  for (const char* frame : {"605#", "605#60", "605#60 00 00 00", "605#60 00 00 00 00 00 00"}) {
    wire.receive(frame);
  }
  wire.expect({});
  EXPECT_EQ(wire.node.counters().malformed, 4U);
  ask("60 00 00 00 00 00 00 00", "00 43 61 6E 76 6F 79 20");
}

TEST_F(SdoServerTest, RemoteAndExtendedFramesAndForeignCanIdsAreNotRequests) {
  wire.receive("605#R8");
  wire.receive("00000605#40 00 10 00 00 00 00 00");
  wire.receive("606#40 00 10 00 00 00 00 00");
  wire.receive("585#40 00 10 00 00 00 00 00");
  wire.expect({});
}

TEST_F(SdoServerTest, AnAnswerWaitsWhereTheControllerIsFull) {
  wire.full = true;
  ask_in_vain("40 00 10 00 00 00 00 00");
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"585#43 00 10 00 A2 01 02 00"});
}

}  // namespace
}  // namespace canvoy::sdo_server_test
