// Queued requests: in order for each server, at a time for many.
#include "canvoy/canopen/sdo/sdo_queue.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <memory>

#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/bus_node.hpp"
#include "canvoy/canopen/testing/prompt_bus.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_queue_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Node 1 is the client; the test is all other nodes.
class SdoQueueTest : public testing::Test {
 protected:
  SdoQueueTest() { wire.boot(); }

  void note(SdoRequest& request) { finished.push_back(&request); }
  SdoRequest read(NodeId server, std::uint16_t index = 0x1000) {
    return {.server = server,
            .index = index,
            .destination = bytes,
            .done = SdoRequest::Done::to<&SdoQueueTest::note>(*this)};
  }
  void expect_finished(const std::vector<SdoRequest*>& expected) {
    EXPECT_EQ(finished, expected);
    finished.clear();
  }

  WireNode wire{sdo_objects(), 1};
  SdoWorkers<2> workers{wire.node};
  SdoQueue sut{wire.node, workers.all()};
  std::array<std::uint8_t, 20> bytes{};
  std::vector<SdoRequest*> finished;
};

TEST_F(SdoQueueTest, RequestsToOneServerAreMadeOneAfterTheOtherInTheirOrder) {
  SdoRequest first = read(5, 0x2001);
  SdoRequest second = read(5, 0x2002);
  SdoRequest third = read(5, 0x2003);
  EXPECT_TRUE(sut.upload(first));
  EXPECT_TRUE(sut.upload(second));
  EXPECT_TRUE(sut.upload(third));
  EXPECT_EQ(first.state(), SdoRequest::State::active);
  EXPECT_EQ(second.state(), SdoRequest::State::waiting);
  wire.expect({"605#40 01 20 00 00 00 00 00"});
  wire.receive("585#4F 01 20 00 11 00 00 00");
  expect_finished({&first});
  wire.expect({"605#40 02 20 00 00 00 00 00"});
  wire.receive("585#80 02 20 00 00 00 02 06");
  expect_finished({&second});
  EXPECT_EQ(second.outcome(), SdoEnd::by_server(AbortCode::no_object));
  wire.expect({"605#40 03 20 00 00 00 00 00"});
  wire.run_for(1s);
  wire.expect({"605#80 03 20 00 00 00 04 05"});
  expect_finished({&third});
  EXPECT_EQ(third.outcome(), SdoEnd::no_answer());
  EXPECT_EQ(*first.outcome(), 1U);
  EXPECT_EQ(bytes[0], 0x11);
  EXPECT_TRUE(sut.idle());
}

TEST_F(SdoQueueTest, AsManyServersAreAskedAtATimeAsThereAreWorkers) {
  SdoRequest at_5 = read(5);
  SdoRequest next_at_5 = read(5, 0x1018);
  SdoRequest at_6 = read(6);
  SdoRequest at_7 = read(7);
  for (SdoRequest* request : {&at_5, &next_at_5, &at_6, &at_7}) EXPECT_TRUE(sut.upload(*request));
  wire.expect({"605#40 00 10 00 00 00 00 00", "606#40 00 10 00 00 00 00 00"});
  wire.receive("586#43 00 10 00 06 00 00 00");
  expect_finished({&at_6});
  wire.expect({"607#40 00 10 00 00 00 00 00"});
  wire.receive("585#43 00 10 00 05 00 00 00");
  expect_finished({&at_5});
  wire.expect({"605#40 18 10 00 00 00 00 00"});
  wire.receive("585#4F 18 10 00 04 00 00 00");
  wire.receive("587#43 00 10 00 07 00 00 00");
  expect_finished({&next_at_5, &at_7});
  EXPECT_TRUE(sut.idle());
}

TEST_F(SdoQueueTest, ServersTakeTurnsWhereWorkersAreFew) {
  std::deque<SdoRequest> requests;
  for (int round = 0; round < 2; ++round) {
    for (const unsigned server : {5U, 6U, 7U}) {
      requests.push_back(read(static_cast<NodeId>(server)));
      EXPECT_TRUE(sut.upload(requests.back()));
    }
  }
  wire.sent.clear();
  for (const char* answer : {"585", "586", "587", "585", "586", "587"}) {
    wire.receive(std::string(answer) + "#43 00 10 00 00 00 00 00");
  }
  expect_finished(
      {&requests[0], &requests[1], &requests[2], &requests[3], &requests[4], &requests[5]});
  wire.expect({"607#40 00 10 00 00 00 00 00", "605#40 00 10 00 00 00 00 00",
               "606#40 00 10 00 00 00 00 00", "607#40 00 10 00 00 00 00 00"});
}

TEST_F(SdoQueueTest, ADownloadGoesTheOtherWay) {
  const Bytes value{0x34, 0x12};
  SdoRequest request{.server = 5, .index = 0x2002, .value = value};
  EXPECT_TRUE(sut.download(request));
  wire.expect({"605#2B 02 20 00 34 12 00 00"});
  wire.receive("585#60 02 20 00 00 00 00 00");
  EXPECT_EQ(request.state(), SdoRequest::State::idle);
  EXPECT_EQ(*request.outcome(), 2U);
}

TEST_F(SdoQueueTest, ItTellsHowFarARequestIs) {
  SdoRequest request = read(5, 0x2008);
  EXPECT_TRUE(sut.upload(request));
  EXPECT_EQ(request.transferred(), 0U);
  EXPECT_EQ(request.announced(), std::nullopt);
  wire.receive("585#41 08 20 00 08 00 00 00");
  EXPECT_EQ(request.announced(), 8U);
  wire.receive("585#00 01 02 03 04 05 06 07");
  EXPECT_EQ(request.transferred(), 7U);
  wire.receive("585#1D 08 00 00 00 00 00 00");
  EXPECT_EQ(request.transferred(), 8U);
  EXPECT_EQ(request.outcome().abort(), AbortCode::none);
}

TEST_F(SdoQueueTest, ARequestIsTakenOnceAtATimeAndToNodesOnly) {
  SdoRequest request = read(5);
  EXPECT_TRUE(sut.upload(request));
  EXPECT_FALSE(sut.upload(request));
  EXPECT_FALSE(sut.download(request));
  for (const unsigned wrong : {0U, 128U, 255U}) {
    SdoRequest nobody = read(static_cast<NodeId>(wrong));
    EXPECT_FALSE(sut.upload(nobody));
  }
  wire.expect({"605#40 00 10 00 00 00 00 00"});
  wire.receive("585#43 00 10 00 00 00 00 00");
  expect_finished({&request});
  EXPECT_TRUE(sut.upload(request));
}

TEST_F(SdoQueueTest, ARequestMayBeQueuedAgainFromItsEnd) {
  int left = 3;
  auto again = [&](SdoRequest& request) {
    if (--left > 0) {
      EXPECT_TRUE(sut.upload(request));
    }
  };
  SdoRequest request = read(5);
  request.done = SdoRequest::Done::of(again);
  SdoRequest other = read(5, 0x1018);
  EXPECT_TRUE(sut.upload(request));
  EXPECT_TRUE(sut.upload(other));
  wire.receive("585#43 00 10 00 00 00 00 00");
  wire.receive("585#4F 18 10 00 04 00 00 00");
  wire.receive("585#43 00 10 00 00 00 00 00");
  wire.receive("585#43 00 10 00 00 00 00 00");
  EXPECT_EQ(left, 0);
  wire.expect({"605#40 00 10 00 00 00 00 00", "605#40 18 10 00 00 00 00 00",
               "605#40 00 10 00 00 00 00 00", "605#40 00 10 00 00 00 00 00"});
}

TEST_F(SdoQueueTest, ARequestThatIsTakenBackIsAbortedOrNeverMade) {
  SdoRequest first = read(5, 0x2001);
  SdoRequest second = read(5, 0x2002);
  SdoRequest third = read(5, 0x2003);
  for (SdoRequest* request : {&first, &second, &third}) EXPECT_TRUE(sut.upload(*request));
  wire.sent.clear();
  sut.cancel(second);
  wire.expect({});
  EXPECT_EQ(second.state(), SdoRequest::State::idle);
  sut.cancel(first);
  wire.expect({"605#80 01 20 00 00 00 00 08", "605#40 03 20 00 00 00 00 00"});
  sut.cancel(first);
  wire.expect({});
  wire.receive("585#4F 03 20 00 00 00 00 00");
  expect_finished({&third});
  EXPECT_TRUE(sut.idle());
}

TEST_F(SdoQueueTest, StoppedEndsAllThatWait) {
  SdoRequest first = read(5);
  SdoRequest second = read(5);
  SdoRequest third = read(6);
  for (SdoRequest* request : {&first, &second, &third}) EXPECT_TRUE(sut.upload(*request));
  wire.receive("000#02 01");
  EXPECT_EQ(finished.size(), 3U);
  for (const SdoRequest* request : finished) {
    EXPECT_EQ(request->outcome().abort(), AbortCode::device_state);
  }
  EXPECT_TRUE(sut.idle());
}

TEST_F(SdoQueueTest, WhatCannotEvenBeginIsNotTakenAgainFromItsEnd) {
  int calls = 0;
  auto poll = [&](SdoRequest& request) {
    if (++calls < 1000) sut.upload(request);
  };
  SdoRequest request = read(5);
  request.done = SdoRequest::Done::of(poll);
  EXPECT_TRUE(sut.upload(request));
  wire.receive("000#02 01");
  EXPECT_EQ(calls, 2);  // the one under way, and the next, which could not begin
  EXPECT_EQ(request.outcome().abort(), AbortCode::device_state);
  EXPECT_TRUE(sut.idle());
  wire.receive("000#80 01");
  wire.sent.clear();
  EXPECT_TRUE(sut.upload(request));
  wire.expect({"605#40 00 10 00 00 00 00 00"});
}

TEST_F(SdoQueueTest, ARequestThatIsQueuedAgainHasTransferredNothingYet) {
  SdoRequest request = read(5, 0x2002);
  EXPECT_TRUE(sut.upload(request));
  wire.receive("585#4B 02 20 00 34 12 00 00");
  EXPECT_EQ(request.transferred(), 2U);
  SdoRequest other = read(5);
  EXPECT_TRUE(sut.upload(other));
  EXPECT_TRUE(sut.upload(request));
  EXPECT_EQ(request.state(), SdoRequest::State::waiting);
  EXPECT_EQ(request.transferred(), 0U);
  EXPECT_EQ(request.outcome(), SdoEnd::cancelled(AbortCode::no_data));
}

TEST_F(SdoQueueTest, RequestsWaitWhileTheControllerTakesNoFrames) {
  wire.full = true;
  SdoRequest first = read(5);
  SdoRequest second = read(6);
  EXPECT_TRUE(sut.upload(first));
  EXPECT_TRUE(sut.upload(second));
  EXPECT_EQ(first.state(), SdoRequest::State::active);
  EXPECT_EQ(second.state(), SdoRequest::State::waiting);
  wire.full = false;
  wire.node.tx_ready(wire.now);
  wire.expect({"605#40 00 10 00 00 00 00 00", "606#40 00 10 00 00 00 00 00"});
}

TEST(SdoQueueTransfers, LongValuesGoInBlocksAndShortOnesDoNot) {
  WireNode wire(sdo_objects(), 1);
  SdoBlockWorkers<1> workers(wire.node);
  SdoQueue sut(wire.node, workers.all());
  wire.boot();
  const Bytes value(64, 0x55);
  SdoRequest request{.server = 5, .index = 0x2021, .value = value};
  EXPECT_TRUE(sut.download(request));
  wire.expect({"605#C6 21 20 00 40 00 00 00"});
  sut.cancel(request);
  request.value = std::span(value).first(63);
  EXPECT_TRUE(sut.download(request));
  wire.expect({"605#80 21 20 00 00 00 00 08", "605#21 21 20 00 3F 00 00 00"});
  sut.cancel(request);
  request.transfer = SdoTransfer::block;
  EXPECT_TRUE(sut.download(request));
  wire.expect({"605#80 21 20 00 00 00 00 08", "605#C6 21 20 00 3F 00 00 00"});
  sut.cancel(request);
  request.transfer = SdoTransfer::segmented;
  request.value = value;
  EXPECT_TRUE(sut.download(request));
  wire.expect({"605#80 21 20 00 00 00 00 08", "605#21 21 20 00 40 00 00 00"});
}

/// The answers come at once, and so does the reaction to the abort of a request: it is cancelled
/// while that leaves. The next one neither begins before that, nor is ended by it.
TEST(SdoQueueOnAPromptBus, ARequestThatIsTakenBackWhileItsAbortLeavesEndsNoOther) {
  PromptBus bus(sdo_objects(), 1);
  bus.run_for(Duration::zero());
  bus.sent.clear();
  SdoWorkers<1> workers(bus.node);
  SdoQueue sut(bus.node, workers.all());
  std::vector<SdoRequest*> finished;
  auto note = [&](SdoRequest& request) { finished.push_back(&request); };
  const auto done = SdoRequest::Done::of(note);
  std::array<std::uint8_t, 1> too_small{};
  std::array<std::uint8_t, 4> bytes{};
  SdoRequest first = {.server = 5, .index = 0x1000, .destination = too_small, .done = done};
  SdoRequest second = {.server = 6, .index = 0x1000, .destination = bytes, .done = done};
  bus.answers = [&](const Frame& frame) -> std::optional<Frame> {
    if (frame == wire_frame("605#40 00 10 00 00 00 00 00")) {
      EXPECT_TRUE(sut.upload(second));
      return wire_frame("585#43 00 10 00 01 02 03 04");
    }
    if (frame.id == 0x605) sut.cancel(first);
    if (frame.id == 0x606) return wire_frame("586#43 00 10 00 05 06 07 08");
    return std::nullopt;
  };
  EXPECT_TRUE(sut.upload(first));
  bus.run_for(1s);
  EXPECT_EQ(bus.sent,
            (std::vector<std::string>{"605#40 00 10 00 00 00 00 00", "605#80 00 10 00 05 00 04 05",
                                      "606#40 00 10 00 00 00 00 00"}));
  EXPECT_EQ(finished, (std::vector<SdoRequest*>{&second}));
  EXPECT_EQ(*second.outcome(), 4U);
  EXPECT_TRUE(sut.idle());
}

/// Node 127 reads and writes all others, each with a server.
TEST(SdoQueueOnABus, OneHundredAndTwentySixServersAreReadAndWrittenAtATimeAndNothingIsMixedUp) {
  SimulatedBus bus({.bit_rate = 1'000'000});
  std::vector<std::shared_ptr<BusNode>> nodes;
  std::vector<std::unique_ptr<SdoServer>> servers;
  std::vector<std::unique_ptr<SdoBlockServer>> blocks;
  std::array<std::array<std::uint8_t, 600>, 126> buffers{};
  for (unsigned id = 1; id <= 126; ++id) {
    nodes.push_back(std::make_shared<BusNode>(bus, sdo_objects(), static_cast<NodeId>(id)));
    servers.push_back(std::make_unique<SdoServer>(nodes.back()->node, 0, buffers[id - 1]));
    if (id % 3 != 0) blocks.push_back(std::make_unique<SdoBlockServer>(*servers.back()));
  }
  nodes.push_back(std::make_shared<BusNode>(bus, sdo_objects(), NodeId{127}, 126));
  const auto workers = std::make_unique<SdoBlockWorkers<126>>(nodes.back()->node);
  SdoQueue sut(nodes.back()->node, workers->all());
  for (const auto& node : nodes) node->node.start(bus.now());
  run(bus, nodes, [&] { return bus.next_event() == never; });

  // Three requests to each: write with some kind of transfer, read back, read a missing entry.
  std::deque<SdoRequest> requests;
  std::deque<Bytes> written;
  std::deque<Bytes> read;
  std::size_t finished = 0;
  auto count = [&](SdoRequest&) { ++finished; };
  const auto done = SdoRequest::Done::of(count);
  for (unsigned id = 1; id <= 126; ++id) {
    const auto server = static_cast<NodeId>(id);
    written.push_back(pattern(id * 4, server));
    read.emplace_back(600);
    requests.push_back({.server = server, .index = 0x2021, .value = written.back(), .done = done});
    EXPECT_TRUE(sut.download(requests.back()));
    requests.push_back(
        {.server = server, .index = 0x2021, .destination = read.back(), .done = done});
    EXPECT_TRUE(sut.upload(requests.back()));
    requests.push_back({.server = server, .index = 0x2999, .destination = {}, .done = done});
    EXPECT_TRUE(sut.upload(requests.back()));
  }
  EXPECT_TRUE(run(bus, nodes, [&] { return finished == requests.size(); }));
  for (unsigned id = 1; id <= 126; ++id) {
    SCOPED_TRACE(id);
    EXPECT_EQ(requests[3 * id - 3].outcome().abort(), AbortCode::none);
    EXPECT_EQ(requests[3 * id - 2].outcome().abort(), AbortCode::none);
    EXPECT_EQ(requests[3 * id - 1].outcome().abort(), AbortCode::no_object);
    read[id - 1].resize(*requests[3 * id - 2].outcome());
    EXPECT_EQ(read[id - 1], written[id - 1]);
  }
  EXPECT_TRUE(sut.idle());
  for (const auto& node : nodes) EXPECT_EQ(node->node.transmitter().lost(), 0U);
}

}  // namespace
}  // namespace canvoy::sdo_queue_test
