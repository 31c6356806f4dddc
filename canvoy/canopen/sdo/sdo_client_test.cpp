// SDO client: common behaviour of all kinds of transfer (CiA 301, 7.2.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_client_node.hpp"

namespace canvoy::sdo_client_test {
namespace {

class SdoClientTest : public SdoClientNode {};

// Refusals of servers

TEST_F(SdoClientTest, AnAbortFromTheServerEndsTheRequest) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 00 00 02 06");
  expect_failed(SdoEnd::by_server(AbortCode::no_object));
  EXPECT_EQ(download(Bytes{1}), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 78 56 34 12");
  expect_failed(SdoEnd::by_server(static_cast<AbortCode>(0x1234'5678)));
}

TEST_F(SdoClientTest, AnAbortWithoutAReasonIsNoSuccess) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 08 20 00 00 00 00 00");
  expect_failed(SdoEnd::by_server(AbortCode::general));
}

/// 0504 0000h is also the abort code of a server that has waited for a segment, or for a bus behind
/// it.
TEST_F(SdoClientTest, AServerThatAbortsWithATimeOutHasAnswered) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(76ms));
  answer("80 08 20 00 00 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::time_out));
  EXPECT_FALSE(last.is_silence());
  EXPECT_TRUE(last.is_refusal());
  EXPECT_EQ(last.abort(), AbortCode::time_out);
}

TEST_F(SdoClientTest, AnAbortFromTheServerEndsATransferInSegments) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("80 08 20 00 22 00 00 08");
  expect_failed(SdoEnd::by_server(AbortCode::device_state));
}

TEST_F(SdoClientTest, AServerThatHasForgottenATransferNeedNotNameItInItsAbort) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("80 00 00 00 01 00 04 05");
  expect_waiting();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("80 00 00 00 01 00 04 05");
  expect_failed(SdoEnd::by_server(AbortCode::command_specifier));
}

TEST_F(SdoClientTest, LateAnswersToOtherRequestsAreNotTakenForThePresentOne) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 01 11 22 33 44");
  answer("43 07 20 00 11 22 33 44");
  answer("60 08 20 00 00 00 00 00");
  answer("80 08 20 01 00 00 02 06");
  answer("1D 08 00 00 00 00 00 00");
  answer("20 00 00 00 00 00 00 00");
  expect_waiting();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(download(Bytes{1}), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 01 00 00 00 00");
  answer("43 08 20 00 11 22 33 44");
  expect_waiting();
  answer("60 08 20 00 00 00 00 00");
  expect_done(1);
}

TEST_F(SdoClientTest, AnInitiateAnswerThatComesTwiceDoesNoHarm) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("41 08 20 00 08 00 00 00");
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  answer("1D 08 00 00 00 00 00 00");
  expect_done(8);
}

TEST_F(SdoClientTest, AnswersWithoutARequestAreIgnored) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  answer("43 08 20 00 55 66 77 88");
  answer("80 08 20 00 00 00 02 06");
  answer("00 01 02 03 04 05 06 07");
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(bytes.at(0), 0x11);
}

TEST_F(SdoClientTest, ASegmentWithTheWrongToggleBitEndsTheTransfer) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  answer("10 01 02 03 04 05 06 07", "80 08 20 00 00 00 03 05");
  expect_failed(AbortCode::toggle_bit);
  const Bytes value(8);
  EXPECT_EQ(download(value), AbortCode::none);
  wire.sent.clear();
  answer("60 08 20 00 00 00 00 00", "00 00 00 00 00 00 00 00");
  answer("30 00 00 00 00 00 00 00", "80 08 20 00 00 00 03 05");
  expect_failed(AbortCode::toggle_bit);
}

TEST_F(SdoClientTest, AnUnknownCommandSpecifierBetweenSegmentsEndsTheTransfer) {
  for (const char* response : {"20 00 00 00 00 00 00 00", "A0 00 00 00 00 00 00 00",
                               "C0 00 00 00 00 00 00 00", "E0 00 00 00 00 00 00 00"}) {
    EXPECT_EQ(upload(bytes), AbortCode::none);
    wire.sent.clear();
    answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
    answer(response, "80 08 20 00 01 00 04 05");
    expect_failed(AbortCode::command_specifier);
  }
}

TEST_F(SdoClientTest, FramesOfAnotherLengthAreIgnoredAndCounted) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33");
  answer("");
  expect_waiting();
  EXPECT_EQ(wire.node.counters().malformed, 2U);
}

// Time

TEST_F(SdoClientTest, AServerThatDoesNotAnswerIsGivenOneSecond) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(999'999us));
  expect_waiting();
  wire.run_until(Time(5s));
  wire.expect({"@1000000 605#80 08 20 00 00 00 04 05"});
  expect_failed(SdoEnd::no_answer());
}

TEST_F(SdoClientTest, EachAnswerStartsTheTimeOutAnew) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(900ms));
  answer("41 08 20 00 08 00 00 00", "60 00 00 00 00 00 00 00");
  wire.run_until(Time(1800ms));
  answer("00 01 02 03 04 05 06 07", "70 00 00 00 00 00 00 00");
  wire.run_until(Time(2799ms));
  expect_waiting();
  wire.run_until(Time(5s));
  wire.expect({"@2800000 605#80 08 20 00 00 00 04 05"});
  expect_failed(SdoEnd::no_answer());
}

TEST_F(SdoClientTest, ARequestMayHaveAShorterTimeOutThanTheOneBefore) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  EXPECT_EQ(sut.upload(5, 0x2008, 0, bytes, on_done, 100ms), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(5s));
  wire.expect({"@100000 605#80 08 20 00 00 00 04 05"});
  expect_failed(SdoEnd::no_answer());
}

TEST_F(SdoClientTest, LateAnswersDoNotPutTheTimeOutOff) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.run_until(Time(900ms));
  answer("43 08 20 01 11 22 33 44");
  wire.run_until(Time(5s));
  wire.expect({"@1000000 605#80 08 20 00 00 00 04 05"});
}

TEST_F(SdoClientTest, ADoneRequestHasNoTimeOut) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
  wire.run_until(Time(5s));
  wire.expect({});
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(wire.node.deadline(), never);
}

// The side of the owner

TEST_F(SdoClientTest, OneRequestAtATime) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  EXPECT_EQ(upload(bytes), AbortCode::device_state);
  EXPECT_EQ(download(bytes), AbortCode::device_state);
  expect_request("40 08 20 00 00 00 00 00");
}

TEST_F(SdoClientTest, ACancelledRequestIsAbortedAndNotToldOf) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  sut.cancel();
  expect_request("80 08 20 00 00 00 00 08");
  EXPECT_FALSE(sut.busy());
  sut.cancel();
  wire.expect({});
  answer("43 08 20 00 11 22 33 44");
  wire.run_until(Time(5s));
  wire.expect({});
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
  sut.cancel(AbortCode::local_control);
  expect_request("80 08 20 00 21 00 00 08");
}

TEST_F(SdoClientTest, TheNextRequestMayBeStartedFromTheOutcomeOfTheLast) {
  std::vector<SdoEnd> outcomes;
  SdoClient::Done ask_next;
  std::uint8_t sub = 0;
  auto again = [&](SdoClient::Outcome outcome) {
    outcomes.push_back(outcome);
    if (++sub > 3) return;
    EXPECT_EQ(sut.upload(5, 0x2009, sub, bytes, ask_next), AbortCode::none);
  };
  ask_next = SdoClient::Done::of(again);
  EXPECT_EQ(sut.upload(5, 0x2009, 0, bytes, ask_next), AbortCode::none);
  expect_request("40 09 20 00 00 00 00 00");
  answer("4F 09 20 00 03 00 00 00", "40 09 20 01 00 00 00 00");  // after a success
  answer("80 09 20 01 11 00 09 06", "40 09 20 02 00 00 00 00");  // after an abort
  wire.run_for(1s);                                              // after a time-out
  wire.expect({"605#80 09 20 02 00 00 04 05", "605#40 09 20 03 00 00 00 00"});
  wire.receive("000#02 01");  // a stop ends it
  EXPECT_EQ(outcomes,
            (std::vector{SdoEnd(), SdoEnd::by_server(AbortCode::no_sub_index), SdoEnd::no_answer(),
                         SdoEnd::cancelled(AbortCode::device_state)}));
}

TEST_F(SdoClientTest, SeveralClientsAskSeveralServersAtOnce) {
  SdoClient other(wire.node);
  std::array<std::uint8_t, 4> others{};
  EXPECT_EQ(upload(bytes), AbortCode::none);
  EXPECT_EQ(other.upload(6, 0x2008, 0, others, on_done), AbortCode::none);
  wire.expect({"605#40 08 20 00 00 00 00 00", "606#40 08 20 00 00 00 00 00"});
  wire.receive("586#4F 08 20 00 66 00 00 00");
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(others.at(0), 0x66);
  EXPECT_TRUE(sut.busy());
  answer("4F 08 20 00 55 00 00 00");
  EXPECT_EQ(bytes.at(0), 0x55);
}

TEST_F(SdoClientTest, OneClientAsksOneServerAfterTheOther) {
  for (unsigned server = 1; server <= 127; ++server) {
    const auto id = static_cast<NodeId>(server);
    EXPECT_EQ(sut.upload(id, 0x1000, 0, bytes, on_done), AbortCode::none);
    wire.expect({wire_text(Frame::data_frame(0x600 + server, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}))});
    wire.receive(wire_text(Frame::data_frame(0x580 + server, {0x43, 0x00, 0x10, 0, id, 0, 0, 0})));
    expect_done(4);
    EXPECT_EQ(bytes.at(0), id);
  }
}

TEST_F(SdoClientTest, AClientKeepsARouteToItsLastServerOnly) {
  for (unsigned request = 0; request < 1500; ++request) {  // the node has 1200 routes
    const auto server = static_cast<NodeId>(2 + request % 100);
    ASSERT_EQ(sut.upload(server, 0x1000, 0, bytes, on_done), AbortCode::none) << request;
    sut.cancel();
  }
}

TEST_F(SdoClientTest, WithoutARouteLeftARequestIsNotStarted) {
  std::vector<std::unique_ptr<SdoClient>> many;
  AbortCode answer = AbortCode::none;
  while (answer == AbortCode::none) {
    ASSERT_LT(many.size(), 1300U);
    many.push_back(std::make_unique<SdoClient>(wire.node));
    answer = many.back()->upload(5, 0x1000, 0, bytes, on_done);
  }
  EXPECT_EQ(answer, AbortCode::out_of_memory);
  EXPECT_FALSE(many.back()->busy());
}

TEST_F(SdoClientTest, ThereIsNoServerOutsideOfTheNodeIds) {
  EXPECT_EQ(sut.upload(0, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  EXPECT_EQ(sut.upload(128, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  EXPECT_EQ(sut.download(255, 0x1000, 0, bytes, on_done), AbortCode::no_sdo_connection);
  wire.expect({});
  wire.run_until(Time(5s));
  EXPECT_EQ(calls, 0);
}

// NMT

TEST_F(SdoClientTest, StoppedEndsARequestAndAllowsNone) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#02 01");
  wire.expect({});
  expect_failed(SdoEnd::cancelled(AbortCode::device_state));
  EXPECT_EQ(upload(bytes), AbortCode::device_state);
  wire.receive("000#01 01");
  EXPECT_EQ(upload(bytes), AbortCode::none);
  expect_request("40 08 20 00 00 00 00 00");
}

TEST(SdoClientCancel, StoppedIsSilentForOneWhoCancelsJustThen) {
  WireNode node(sdo_objects(), 1);
  std::unique_ptr<SdoClient> client;
  auto cancel = [&](NmtState state) {
    if (state == NmtState::stopped) client->cancel();
  };
  Service earlier;
  earlier.state_entered = decltype(earlier.state_entered)::of(cancel);
  node.node.attach(earlier);
  client = std::make_unique<SdoClient>(node.node);
  node.boot();
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_EQ(client->upload(5, 0x1000, 0, bytes, {}), AbortCode::none);
  node.sent.clear();
  node.receive("000#02 01");
  node.expect({});
}

TEST_F(SdoClientTest, ResetEndsARequest) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#81 01");
  wire.expect({"701#00"});
  expect_failed(SdoEnd::cancelled(AbortCode::device_state));
  wire.run_until(Time(5s));
  wire.expect({});
}

TEST_F(SdoClientTest, ARequestGoesOnFromPreOperationalToOperational) {
  EXPECT_EQ(upload(bytes), AbortCode::none);
  wire.sent.clear();
  wire.receive("000#01 01");
  answer("43 08 20 00 11 22 33 44");
  expect_done(4);
}

TEST_F(SdoClientTest, ANodeWithoutNodeIdMayAskToo) {
  WireNode tool(sdo_objects(), node_id_unconfigured);
  SdoClient client(tool.node);
  tool.start();
  EXPECT_EQ(client.upload(5, 0x1000, 0, bytes, on_done), AbortCode::none);
  tool.expect({"605#40 00 10 00 00 00 00 00"});
  tool.receive("585#43 00 10 00 A2 01 00 00");
  expect_done(4);
}

TEST_F(SdoClientTest, WhatTheBacklogCannotHoldEndsWithATimeOut) {
  wire.full = true;
  std::vector<std::unique_ptr<SdoClient>> many;
  for (int i = 0; i < 17; ++i) many.push_back(std::make_unique<SdoClient>(wire.node));
  for (auto& client : many) {
    EXPECT_EQ(client->upload(5, 0x2008, 0, bytes, on_done), AbortCode::none);
  }
  wire.run_until(Time(1s));
  EXPECT_EQ(calls, 17);
  EXPECT_EQ(last, SdoEnd::no_answer());
}

}  // namespace
}  // namespace canvoy::sdo_client_test
