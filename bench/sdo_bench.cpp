// Processor time of an SDO transfer: client and server, and a queue of frames in place of a bus.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"

namespace canvoy {
namespace {

/// As many objects as a small device has, so that lookups have a realistic cost.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1001, .entry_count = 1},
                              {.index = 0x1003, .entry_count = 2},
                              {.index = 0x1005, .entry_count = 1},
                              {.index = 0x1008, .entry_count = 1},
                              {.index = 0x1014, .entry_count = 1},
                              {.index = 0x1016, .entry_count = 2},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x1018, .entry_count = 2},
                              {.index = 0x1400, .count = 4, .entry_count = 2},
                              {.index = 0x1600, .count = 4, .entry_count = 2},
                              {.index = 0x1800, .count = 4, .entry_count = 2},
                              {.index = 0x1A00, .count = 4, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 1},
                              {.index = 0x6000, .entry_count = 1},
                              {.index = 0x6010, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned32, .initial = 0x0001'01A2},
         {.type = DataType::unsigned8},
         {.type = DataType::unsigned8, .access = Access::rw},
         {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32},
         {.type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::visible_string, .access = Access::ro, .capacity = 32},
         {.type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned8},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned16, .access = Access::rw},
         {.type = DataType::unsigned8},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32},
         {.type = DataType::unsigned8},
         {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned8, .access = Access::rw},
         {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned8},
         {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::unsigned8, .access = Access::rw},
         {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned32, .access = Access::rw},
         {.type = DataType::octet_string, .access = Access::rw, .capacity = 889},
         {.type = DataType::unsigned16, .access = Access::rw},
         {.type = DataType::integer16, .access = Access::rw}}));
constexpr DictionaryTables tables = layout.tables();

/// Queue of frames, as in a driver: a node that answers is not called by its own answer.
class Line {
 public:
  void push(Node& to, const Frame& frame) { waiting_[end_++ % waiting_.size()] = {&to, frame}; }
  void run() {
    while (begin_ != end_) {
      const Waiting& next = waiting_[begin_++ % waiting_.size()];
      next.to->receive(next.frame, Time{});
    }
  }

 private:
  struct Waiting {
    Node* to;
    Frame frame;
  };
  std::array<Waiting, 256> waiting_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

/// A node with frames that go to the other one.
struct Peer {
  Peer(Line& to_use, Peer& other, NodeId id)
      : line(to_use), peer(other), node(tables, memory(), {this, &pass_on, nullptr}, id) {}

  NodeMemory memory() { return {values_, states_, routes_, backlog_}; }

  static bool pass_on(void* context, const Frame& frame) {
    auto& self = *static_cast<Peer*>(context);
    self.line.push(self.peer.node, frame);
    return true;
  }

  Line& line;
  Peer& peer;
  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::vector<ObjectState> states_ = std::vector<ObjectState>(tables.objects.size());
  std::array<Router::Route, 16> routes_;
  std::array<Frame, 8> backlog_;
  Node node;
};

struct Pair {
  Line line;
  Peer a{line, b, 1};
  Peer b{line, a, 5};
  SdoClient client{a.node};
  std::array<std::uint8_t, 889> buffer{};
  SdoServer server{b.node, 0, buffer};
  SdoBlockClient client_blocks{client};
  SdoBlockServer server_blocks{server};

  explicit Pair(SdoTransfer transfer = SdoTransfer::segmented) {
    client.choose(transfer);
    b.node.start(Time{});
    a.node.start(Time{});
    line.run();
  }
};

void check(benchmark::State& state, bool done) {
  if (!done) state.SkipWithError("the transfer failed");
}

void expedited_upload(benchmark::State& state) {
  Pair pair;
  std::array<std::uint8_t, 4> value{};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.upload(5, 0x1000, 0, value, SdoClient::Done::of(done));
    pair.line.run();
    benchmark::DoNotOptimize(value);
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(expedited_upload);

void expedited_download(benchmark::State& state) {
  Pair pair;
  std::array<std::uint8_t, 2> value{1, 2};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.download(5, 0x6000, 0, value, SdoClient::Done::of(done));
    pair.line.run();
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(expedited_download);

/// 889 bytes: 127 segments, or one block with its checksum.
void upload(benchmark::State& state, SdoTransfer transfer) {
  Pair pair(transfer);
  const auto entry = pair.b.node.dictionary().find(0x2000, 0);
  pair.b.node.dictionary().set(*entry, std::vector<std::uint8_t>(889, 0x55));
  std::array<std::uint8_t, 889> value{};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.upload(5, 0x2000, 0, value, SdoClient::Done::of(done));
    pair.line.run();
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 889);
}
void segmented_upload(benchmark::State& state) {
  upload(state, SdoTransfer::segmented);
}
BENCHMARK(segmented_upload);
void block_upload(benchmark::State& state) {
  upload(state, SdoTransfer::block);
}
BENCHMARK(block_upload);

void download(benchmark::State& state, SdoTransfer transfer) {
  Pair pair(transfer);
  std::array<std::uint8_t, 889> value{};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.download(5, 0x2000, 0, value, SdoClient::Done::of(done));
    pair.line.run();
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 889);
}
void segmented_download(benchmark::State& state) {
  download(state, SdoTransfer::segmented);
}
BENCHMARK(segmented_download);
void block_download(benchmark::State& state) {
  download(state, SdoTransfer::block);
}
BENCHMARK(block_download);

}  // namespace
}  // namespace canvoy
