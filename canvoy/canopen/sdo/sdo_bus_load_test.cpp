// Bus time of a transfer on a simulated bus of 1 Mbit/s with frames of exact lengths: between two
// frames there is no gap on the side of this library.
#include <gtest/gtest.h>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/canopen/testing/bus_node.hpp"
#include "canvoy/canopen/testing/sdo_line.hpp"

namespace canvoy::sdo_bus_load_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Pair {
  Pair() {
    bus.observe({.context = this, .on_frame = &Pair::count});
    for (const auto& node : nodes) node->node.start(bus.now());
    run(bus, nodes, [&] { return bus.next_event() == never; });
    bits = 0;
    begin = bus.now();
  }
  static void count(void* context, Time, ControllerId, const Frame& frame) {
    static_cast<Pair*>(context)->bits += frame_bits(frame) + intermission_bits;
  }
  void done(SdoClient::Outcome result) { outcome = result; }
  SdoClient::Done on_done() { return SdoClient::Done::to<&Pair::done>(*this); }
  /// Completes the transfer; returns the time of its frames as a share of its duration.
  double share(AbortCode started) {
    EXPECT_EQ(started, AbortCode::none);
    EXPECT_TRUE(run(bus, nodes, [&] { return outcome.has_value(); }));
    EXPECT_EQ(outcome->abort(), AbortCode::none);
    run(bus, nodes, [&] { return !server.busy(); });
    EXPECT_EQ(nodes[0]->node.transmitter().lost() + nodes[1]->node.transmitter().lost(), 0U);
    return static_cast<double>(bits) / static_cast<double>((bus.now() - begin).count());
  }

  SimulatedBus bus{{.bit_rate = 1'000'000, .transmit_queue_max = 4}};
  std::vector<std::shared_ptr<BusNode>> nodes{
      std::make_shared<BusNode>(bus, sdo_objects(), NodeId{1}),
      std::make_shared<BusNode>(bus, sdo_objects(), NodeId{5})};
  SdoClient client{nodes[0]->node};
  SdoBlockClient client_blocks{client};
  std::array<std::uint8_t, 5000> buffer{};
  SdoServer server{nodes[1]->node, 0, buffer};
  SdoBlockServer server_blocks{server};
  MemoryDomain domain{nodes[1]->node, 0x2030};
  std::uint64_t bits = 0;
  Time begin{};
  std::optional<SdoClient::Outcome> outcome;
};

constexpr std::size_t size = 100'000;

TEST(SdoBusLoad, DownloadsUseTheWireFully) {
  for (const SdoTransfer transfer : {SdoTransfer::segmented, SdoTransfer::block}) {
    Pair pair;
    pair.client.choose(transfer);
    const Bytes bytes = pattern(size);
    const double share = pair.share(pair.client.download(5, 0x2030, 0, bytes, pair.on_done()));
    EXPECT_EQ(pair.domain.content, bytes);
    EXPECT_GE(share, 0.99);
    EXPECT_LE(share, 1.00001);  // the last intermission is not waited for
  }
}

TEST(SdoBusLoad, UploadsUseTheWireFully) {
  for (const SdoTransfer transfer : {SdoTransfer::segmented, SdoTransfer::block}) {
    Pair pair;
    pair.client.choose(transfer);
    pair.domain.content = pattern(size);
    Bytes bytes(size);
    const double share = pair.share(pair.client.upload(5, 0x2030, 0, bytes, pair.on_done()));
    EXPECT_EQ(bytes, pair.domain.content);
    EXPECT_GE(share, 0.99);
    EXPECT_LE(share, 1.00001);  // the last intermission is not waited for
  }
}

/// One segment after the other, each with its command and its data alone, would take 111 bits and
/// the stuffed ones for 7 bytes: a block adds its acknowledgements, and little else.
TEST(SdoBusLoad, ABlockTransferReachesNinetyFivePerCentOfBareSegments) {
  Pair pair;
  pair.client.choose(SdoTransfer::block);
  const Bytes bytes = pattern(size);
  std::uint64_t bare = 0;
  for (std::size_t offset = 0; offset < size; offset += 7) {
    const std::size_t count = std::min<std::size_t>(7, size - offset);
    Frame frame = Frame::data_frame(0x605, {0, 0, 0, 0, 0, 0, 0, 0});
    frame.data[0] = static_cast<std::uint8_t>(offset / 7 % 127 + 1);
    std::copy_n(bytes.begin() + static_cast<long>(offset), count, frame.data.begin() + 1);
    bare += frame_bits(frame) + intermission_bits;
  }
  const Time begin = pair.bus.now();
  (void)pair.share(pair.client.download(5, 0x2030, 0, bytes, pair.on_done()));
  const auto taken = static_cast<double>((pair.bus.now() - begin).count());
  EXPECT_GE(static_cast<double>(bare) / taken, 0.95);
}

TEST(SdoBusLoad, OtherFramesOfTheNodeAreNotKeptWaitingByABlock) {
  Pair pair;
  pair.client.choose(SdoTransfer::block);
  const Bytes bytes = pattern(size);
  EXPECT_EQ(pair.client.download(5, 0x2030, 0, bytes, pair.on_done()), AbortCode::none);
  run(pair.bus, pair.nodes, [&] { return pair.bus.now() > pair.begin + 50ms; });
  const Time before = pair.bus.now();
  pair.nodes[0]->node.transmitter().send(Frame::data_frame(0x181, {1}));
  struct Heard {
    Time at = never;
    static void on_frame(void* context, Time now, ControllerId, const Frame& frame) {
      if (frame.id == 0x181) static_cast<Heard*>(context)->at = now;
    }
  } heard;
  pair.bus.observe({.context = &heard, .on_frame = &Heard::on_frame});
  run(pair.bus, pair.nodes, [&] { return heard.at != never; });
  // After the frames that the controller has accepted, and the one that waits for it.
  EXPECT_LE(heard.at - before, 6 * 135us);
  run(pair.bus, pair.nodes, [&] { return pair.outcome.has_value(); });
  EXPECT_EQ(pair.domain.content, bytes);
}

}  // namespace
}  // namespace canvoy::sdo_bus_load_test
