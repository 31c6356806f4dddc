// What an SDO transfer costs in processor time, without a bus: client and server call each other.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/dictionary_layout.hpp"
#include "canvoy/canopen/sdo_client.hpp"
#include "canvoy/canopen/sdo_server.hpp"

namespace canvoy {
namespace {

/// As many objects as a small device has, so that look-ups cost what they cost there.
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

/// A node whose frames go straight into the other one.
struct Peer {
  Peer(Peer& other, NodeId id) : node(tables, memory(), {&other.node, &pass_on, nullptr}, id) {}

  NodeMemory memory() { return {values_, states_, routes_, backlog_}; }

  static bool pass_on(void* other, const Frame& frame) {
    static_cast<Node*>(other)->receive(frame, Time{});
    return true;
  }

  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::vector<ObjectState> states_ = std::vector<ObjectState>(tables.objects.size());
  std::array<Router::Route, 16> routes_;
  std::array<Frame, 8> backlog_;
  Node node;
};

struct Pair {
  Peer a{b, 1};
  Peer b{a, 5};
  SdoClient client{a.node};
  std::array<std::uint8_t, 889> buffer{};
  SdoServer server{b.node, 0, buffer};

  Pair() {
    b.node.start(Time{});
    a.node.start(Time{});
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
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(expedited_download);

/// 889 bytes: 127 segments.
void segmented_upload(benchmark::State& state) {
  Pair pair;
  const auto entry = pair.b.node.dictionary().find(0x2000, 0);
  pair.b.node.dictionary().set(*entry, std::vector<std::uint8_t>(889, 0x55));
  std::array<std::uint8_t, 889> value{};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.upload(5, 0x2000, 0, value, SdoClient::Done::of(done));
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 889);
}
BENCHMARK(segmented_upload);

void segmented_download(benchmark::State& state) {
  Pair pair;
  std::array<std::uint8_t, 889> value{};
  std::int64_t answered = 0;
  auto done = [&](SdoClient::Outcome outcome) { answered += outcome ? 1 : 0; };
  for (auto _ : state) {
    (void)pair.client.download(5, 0x2000, 0, value, SdoClient::Done::of(done));
  }
  check(state, answered == static_cast<std::int64_t>(state.iterations()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * 889);
}
BENCHMARK(segmented_download);

}  // namespace
}  // namespace canvoy
