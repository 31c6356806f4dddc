// All possible SDO channels, 1200h to 127Fh and 1280h to 12FFh, of two nodes on a bus, with a
// transfer on each of them at a time (CiA 301, 7.5.2.32 and 7.5.2.33).
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/bus_node.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"

namespace canvoy::sdo_many_channels_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t channel_count = 128;
constexpr std::size_t value_size = 100;

constexpr EntryRow number(std::uint8_t sub, DataType type, std::int64_t initial) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}

/// Server 0 has its default channel; server and client n have a separate string at 3000h + n.
constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1201, .count = 127, .entry_count = 3},
                                      {.index = 0x1280, .count = 128, .entry_count = 4},
                                      {.index = 0x3000, .count = 128, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned32},
                 {.access = Access::const_, .initial = 2},
                 number(1, DataType::unsigned32, CobId::bit31),
                 number(2, DataType::unsigned32, CobId::bit31),
                 {.access = Access::const_, .initial = 3},
                 number(1, DataType::unsigned32, CobId::bit31),
                 number(2, DataType::unsigned32, CobId::bit31),
                 number(3, DataType::unsigned8, 0),
                 {.type = DataType::octet_string, .access = Access::rw, .capacity = value_size}}));

class End {
 public:
  End(SimulatedBus& bus, NodeId id) : bus_node(bus, layout.tables(), id, 2 * channel_count) {
    for (std::uint8_t i = 0; i < channel_count; ++i) {
      servers.emplace_back(bus_node.node, i, buffers_[i]);
      clients.emplace_back(bus_node.node, i);
    }
    bus_node.node.start(bus.now());
  }

  NodeId id() const { return bus_node.node.id(); }
  void set(std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    std::array<std::uint8_t, 4> bytes;
    store(bytes.data(), value);
    const auto written = std::span(bytes).first(sub == 3 ? 1 : 4);
    EXPECT_EQ(bus_node.node.dictionary().write(index, sub, written, Source::sdo), AbortCode::none);
  }
  /// Sets both COB-IDs of a channel; invalid between two valid ones.
  void open(unsigned index, unsigned request, unsigned response) {
    for (const std::uint8_t sub : {std::uint8_t{1}, std::uint8_t{2}}) {
      set(static_cast<std::uint16_t>(index), sub, CobId::bit31);
      set(static_cast<std::uint16_t>(index), sub, sub == 1 ? request : response);
    }
  }
  std::size_t busy_servers() const {
    return static_cast<std::size_t>(std::ranges::count_if(servers, &SdoServer::busy));
  }

  BusNode bus_node;
  std::deque<SdoServer> servers;
  std::deque<SdoClient> clients;

 private:
  std::array<std::array<std::uint8_t, value_size>, channel_count> buffers_{};
};

class AllSdoChannels : public testing::Test {
 protected:
  AllSdoChannels() {
    connect(left, right, 0x200);
    connect(right, left, 0x300);
  }

  /// Connects client n of one node to server n of the other, on CAN-IDs from `base` on.
  static void connect(End& client, End& server, unsigned base) {
    client.open(0x1280, 0x600U + server.id(), 0x580U + server.id());
    for (unsigned i = 1; i < channel_count; ++i) {
      server.open(0x1200 + i, base + i, base + 0x80 + i);
      client.open(0x1280 + i, base + i, base + 0x80 + i);
    }
    for (unsigned i = 0; i < channel_count; ++i) {
      client.set(static_cast<std::uint16_t>(0x1280 + i), 3, server.id());
    }
  }

  static Bytes value_of(const End& client, unsigned channel) {
    return pattern(value_size, static_cast<std::uint8_t>(client.id() * 128 + channel));
  }
  /// Begins a transfer on each channel; a second one follows by the same function.
  template <class Begin>
  void transfer_all(Begin begin) {
    finished = 0;
    most_at_a_time = 0;
    for (End* const client : {&left, &right}) {
      End& server = client == &left ? right : left;
      for (unsigned i = 0; i < channel_count; ++i) {
        EXPECT_EQ(begin(*client, server.id(), i), AbortCode::none) << i;
      }
    }
    const std::array<BusNode*, 2> nodes{&left.bus_node, &right.bus_node};
    EXPECT_TRUE(run(bus, nodes, [&] {
      most_at_a_time = std::max(most_at_a_time, left.busy_servers() + right.busy_servers());
      return finished == 2U * channel_count;
    }));
  }
  void write_and_read_back() {
    std::deque<Bytes> values;
    transfer_all([&](End& client, NodeId server, unsigned i) {
      values.push_back(value_of(client, i));
      return client.clients[i].download(server, static_cast<std::uint16_t>(0x3000 + i), 0,
                                        values.back(), on_done);
    });
    std::deque<Bytes> read;
    transfer_all([&](End& client, NodeId server, unsigned i) {
      read.emplace_back(value_size);
      return client.clients[i].upload(server, static_cast<std::uint16_t>(0x3000 + i), 0,
                                      std::span(read.back()), on_done);
    });
    EXPECT_EQ(read, values);
  }
  void done(SdoClient::Outcome outcome) {
    EXPECT_EQ(outcome.abort(), AbortCode::none);
    ++finished;
  }

  SimulatedBus bus{{.bit_rate = 1'000'000}};
  End left{bus, 1};
  End right{bus, 2};
  SdoClient::Done on_done = SdoClient::Done::to<&AllSdoChannels::done>(*this);
  std::size_t finished = 0;
  std::size_t most_at_a_time = 0;
};

TEST_F(AllSdoChannels, OfTwoNodesWorkAtATimeAndNothingIsMixedUp) {
  write_and_read_back();
  EXPECT_EQ(most_at_a_time, 2U * channel_count);
}

TEST_F(AllSdoChannels, MoveToOtherCanIdsAtRunTime) {
  write_and_read_back();
  connect(left, right, 0x400);
  connect(right, left, 0x200);
  write_and_read_back();
}

}  // namespace
}  // namespace canvoy::sdo_many_channels_test
