// Duration of PDO processing: an RPDO from Node::receive to the dictionary, a TPDO from a change of
// value to the port.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"

namespace canvoy {
namespace {

constexpr Access process = Access::rw | Access::rpdo | Access::tpdo;
constexpr std::int64_t rpdo_cob_id = 0x200;
constexpr std::int64_t tpdo_cob_id = 0x4000'0180;
constexpr NodeId node_id = 5;

/// A node like a small device: four RPDOs and four TPDOs, and arrays of values of 8, 16 and 32
/// bits, and of values with a range.
constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1400, .count = 4, .entry_count = 3},
                              {.index = 0x1600, .count = 4, .entry_count = 2},
                              {.index = 0x1800, .count = 4, .entry_count = 4},
                              {.index = 0x1A00, .count = 4, .entry_count = 2},
                              {.index = 0x6000, .entry_count = 1},
                              {.index = 0x6100, .entry_count = 1},
                              {.index = 0x6200, .entry_count = 1},
                              {.index = 0x6300, .entry_count = 1},
                              {.index = 0x6400, .entry_count = 1}}),
    std::to_array<EntryRow>({
        {.type = DataType::unsigned32},
        {.type = DataType::unsigned8, .initial = 2},
        {.sub_first = 1,
         .sub_last = 1,
         .type = DataType::unsigned32,
         .access = Access::rw,
         .traits = EntryTraits::plus_node_id,
         .initial = rpdo_cob_id},
        {.sub_first = 2,
         .sub_last = 2,
         .type = DataType::unsigned8,
         .access = Access::rw,
         .initial = 255},
        {.type = DataType::unsigned8, .access = Access::rw},
        {.sub_first = 1, .sub_last = 64, .type = DataType::unsigned32, .access = Access::rw},
        {.type = DataType::unsigned8, .initial = 2},
        {.sub_first = 1,
         .sub_last = 1,
         .type = DataType::unsigned32,
         .access = Access::rw,
         .traits = EntryTraits::plus_node_id,
         .initial = tpdo_cob_id},
        {.sub_first = 2,
         .sub_last = 2,
         .type = DataType::unsigned8,
         .access = Access::rw,
         .initial = 255},
        {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned16, .access = Access::rw},
        {.type = DataType::unsigned8, .access = Access::rw},
        {.sub_first = 1, .sub_last = 64, .type = DataType::unsigned32, .access = Access::rw},
        {.sub_first = 1, .sub_last = 16, .type = DataType::unsigned8, .access = process},
        {.sub_first = 1, .sub_last = 8, .type = DataType::unsigned16, .access = process},
        {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned32, .access = process},
        {.sub_first = 1, .sub_last = 64, .type = DataType::boolean, .access = process},
        {.sub_first = 1,
         .sub_last = 4,
         .type = DataType::unsigned32,
         .access = process,
         .traits = EntryTraits::limited,
         .high = 0xFFFF'FFFF},
    }));
constexpr DictionaryTables tables = layout.tables();

/// The mapped entries: every `step`-th sub-index of an array; with 1 they are adjacent.
struct Mapped {
  std::uint16_t index;
  std::uint8_t bits;
  std::uint8_t step;
};
constexpr Mapped bytes_apart{0x6000, 8, 2};
constexpr Mapped bytes_adjacent{0x6000, 8, 1};
constexpr Mapped words_apart{0x6100, 16, 2};
constexpr Mapped words_adjacent{0x6100, 16, 1};
constexpr Mapped longs_apart{0x6200, 32, 2};
constexpr Mapped longs_adjacent{0x6200, 32, 1};
constexpr Mapped booleans{0x6300, 1, 1};
constexpr Mapped longs_limited{0x6400, 32, 1};

class BenchNode {
 public:
  explicit BenchNode(const Mapped& mapped) {
    node.start(Time{});
    for (std::uint16_t pdo = 0; pdo < 4; ++pdo) {
      map(static_cast<std::uint16_t>(0x1600 + pdo), 0x1400, pdo, mapped);
      map(static_cast<std::uint16_t>(0x1A00 + pdo), 0x1800, pdo, mapped);
    }
  }

  void operate() { node.command(NmtCommand::start); }
  /// Maps 6200h with this sub-index to TPDO 1, after no_tpdos().
  void map_tpdo(std::uint64_t sub) {
    write(0x1A00, 0, 0, 1);
    write(0x1A00, 1, std::uint64_t{0x6200} << 16 | sub << 8 | 32, 4);
    write(0x1A00, 0, 1, 1);
    write(0x1800, 3, 0xFFFF, 2);
    write(0x1800, 1, 0x4000'0185, 4);
  }
  void no_tpdos() {
    for (std::uint16_t pdo = 0; pdo < 4; ++pdo) {
      write(static_cast<std::uint16_t>(0x1800 + pdo), 1, 0x8000'0000, 4);
    }
  }

  std::uint64_t sent = 0;

 private:
  static bool take(void* context, const Frame& frame) {
    benchmark::DoNotOptimize(frame.data);
    ++static_cast<BenchNode*>(context)->sent;
    return true;
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t size) {
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    node.dictionary().write(index, sub, std::span(bytes).first(size), Source::application);
  }
  void map(std::uint16_t record, std::uint16_t parameters, std::uint16_t pdo,
           const Mapped& mapped) {
    const auto index = static_cast<std::uint16_t>(parameters + pdo);
    const std::uint64_t cob_id = node.dictionary().number(index, 1) + 0x100U * pdo;
    write(index, 1, cob_id | CobId::bit31, 4);
    const unsigned count = 64U / mapped.bits;
    for (unsigned i = 0; i < count; ++i) {
      const unsigned sub = 1 + i * mapped.step;
      write(record, static_cast<std::uint8_t>(i + 1),
            (std::uint64_t{mapped.index} << 16) | (sub << 8) | mapped.bits, 4);
    }
    write(record, 0, count, 1);
    write(index, 1, cob_id, 4);
  }

  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::array<ObjectState, tables.objects.size()> states_{};
  std::array<Router::Route, 16> routes_{};
  std::array<Frame, 16> backlog_{};
  std::array<Rpdo, 4> rpdo_memory_{};
  std::array<Tpdo, 4> tpdo_memory_{};
  std::vector<MappedValue> rpdo_values_ = std::vector<MappedValue>(4 * 64);
  std::vector<MappedValue> tpdo_values_ = std::vector<MappedValue>(4 * 64);

 public:
  Node node{
      tables, {values_, states_, routes_, backlog_}, {this, &BenchNode::take, nullptr}, node_id};
  Rpdos rpdos{node, rpdo_memory_, rpdo_values_};
  Tpdos tpdos{node, tpdo_memory_, tpdo_values_};
};

Frame next_frame(std::uint64_t number, std::uint32_t pdo) {
  Frame frame;
  frame.id = static_cast<std::uint32_t>(rpdo_cob_id) + pdo * 0x100U + node_id;
  frame.length = 8;
  store(frame.data.data(), number * 0x0101'0101'0101'0101ULL);
  return frame;
}

void receive_rpdo(benchmark::State& state, const Mapped& mapped) {
  BenchNode bench(mapped);
  bench.no_tpdos();
  bench.operate();
  std::uint64_t number = 0;
  for (auto _ : state) {
    ++number;
    bench.node.receive(next_frame(number, number % 4), Time(Duration(number)));
    benchmark::ClobberMemory();
  }
  if (bench.node.counters().unwanted != 0) state.SkipWithError("frames were not received");
}
BENCHMARK_CAPTURE(receive_rpdo, 8x8_adjacent, bytes_adjacent);
BENCHMARK_CAPTURE(receive_rpdo, 8x8_apart, bytes_apart);
BENCHMARK_CAPTURE(receive_rpdo, 4x16_adjacent, words_adjacent);
BENCHMARK_CAPTURE(receive_rpdo, 4x16_apart, words_apart);
BENCHMARK_CAPTURE(receive_rpdo, 2x32_adjacent, longs_adjacent);
BENCHMARK_CAPTURE(receive_rpdo, 2x32_apart, longs_apart);
BENCHMARK_CAPTURE(receive_rpdo, 64x1, booleans);

/// Like receive_rpdo(), but with something attached to the values: `prepare` attaches it to the
/// node.
template <class Prepare>
void receive_rpdo_with(benchmark::State& state, const Mapped& mapped, Prepare prepare) {
  BenchNode bench(mapped);
  bench.no_tpdos();
  const auto tied = prepare(bench);
  bench.operate();
  std::uint64_t number = 0;
  for (auto _ : state) {
    ++number;
    bench.node.receive(next_frame(number, 0), Time(Duration(number)));
    benchmark::ClobberMemory();
  }
  if (bench.node.counters().unwanted != 0) state.SkipWithError("frames were not received");
}
BENCHMARK_CAPTURE(receive_rpdo_with, 2x32_limits, longs_limited, [](BenchNode&) { return 0; });

/// Notified of both values.
struct ToldOf {
  explicit ToldOf(BenchNode& bench) { bench.node.attach(link); }

  void told() { benchmark::DoNotOptimize(++count); }

  int count = 0;
  static constexpr AccessHandlers hooks[] = {
      {.first = 0x6200, .last = 0x6200, .after_write = [](void* self, const Entry&, Source) {
         static_cast<ToldOf*>(self)->told();
       }}};
  static constexpr ServiceHandlers calls = {.hooks = hooks};
  HandlerBinding link{&calls, this};
};
BENCHMARK_CAPTURE(receive_rpdo_with, 2x32_hook, longs_adjacent,
                  [](BenchNode& bench) { return std::make_unique<ToldOf>(bench); });
/// The other of two neighbours is in a TPDO.
BENCHMARK_CAPTURE(receive_rpdo_with, 2x32_neighbour_in_tpdo, longs_adjacent,
                  [](BenchNode& bench) { return bench.map_tpdo(3), 0; });
/// One of the two is in a TPDO, with an inhibit time longer than the run, so that it is not sent.
BENCHMARK_CAPTURE(receive_rpdo_with, 2x32_one_in_tpdo, longs_adjacent,
                  [](BenchNode& bench) { return bench.map_tpdo(1), 0; });

/// A value of the second TPDO changes, and its frame reaches the port.
void send_changed(benchmark::State& state, const Mapped& mapped) {
  BenchNode bench(mapped);
  bench.operate();
  const Result<Entry> entry = bench.node.dictionary().find(mapped.index, 1);
  std::array<std::uint8_t, 8> bytes{};
  std::uint64_t number = 0;
  for (auto _ : state) {
    ++number;
    store(bytes.data(), number);
    bench.node.dictionary().set(*entry, std::span(bytes).first(entry->row->capacity));
    bench.node.advance(Time(Duration(number)));
  }
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(bench.sent), benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(send_changed, 4x16_in_4_pdos, words_adjacent);

}  // namespace
}  // namespace canvoy
