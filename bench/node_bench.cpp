// Cost of a complete node: four RPDOs and four TPDOs with writable mapping, an SDO server with
// blocks, SYNC, emergency with history, eight monitored heartbeats, an LSS slave. Also what must
// not grow with the number of TPDOs, timers and tasks.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "canvoy/can/host/event_loop.hpp"
#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy {
namespace node_bench {

constexpr EntryInfo output_entries[] = {cia301::highest_sub_index,
                                        {.sub_first = 1,
                                         .sub_last = 16,
                                         .name = "Value",
                                         .type = DataType::unsigned32,
                                         .access = Access::rw,
                                         .mapping = Mapping::optional}};
constexpr ObjectInfo outputs = {
    .index = 0x2000, .code = ObjectCode::array, .name = "Values", .subs = output_entries};

constexpr auto description =
    describe(cia301::device_type(0x0000'0191), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::sync(), cia301::error_history(8),
             cia301::emergency(), cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(8),
             outputs, cia301::rpdo({.number = 1}), cia301::rpdo({.number = 2}),
             cia301::rpdo({.number = 3}), cia301::rpdo({.number = 4}), cia301::tpdo({.number = 1}),
             cia301::tpdo({.number = 2}), cia301::tpdo({.number = 3}), cia301::tpdo({.number = 4}));
constexpr auto layout = lay_out_device<description>();

/// Counts frames and discards them.
struct Driver {
  static bool send(void* context, const Frame& frame) {
    benchmark::DoNotOptimize(frame.data);
    ++static_cast<Driver*>(context)->sent;
    return true;
  }
  Port port() { return {this, send, nullptr}; }

  std::uint64_t sent = 0;
};

/// TPDO n carries 2000h:2n-1 and 2n.
class BenchNode {
 public:
  explicit BenchNode(std::uint8_t transmission_type) {
    node.start(Time{});
    for (std::uint8_t i = 1; i <= 8; ++i) write(0x1016, i, 0x0010'07D0U + 0x1'0000U * i, 4);
    for (unsigned i = 0; i < 4; ++i) {
      map(0x1600, 0x1400, i, 255);
      map(0x1A00, 0x1800, i, transmission_type);
    }
    node.command(NmtCommand::start);
    node.advance(Time{});
    driver.sent = 0;
  }

  Driver driver;
  DeviceNode<layout, LssSlave::routes> device{driver.port(), 5};
  Node& node = device.node();
  LssSlave lss{node};

 private:
  void write(unsigned index, unsigned sub, std::uint32_t number, std::size_t size) {
    std::array<std::uint8_t, 4> bytes{};
    store(bytes.data(), number);
    const AbortCode answer =
        node.dictionary().write(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub),
                                std::span(bytes).first(size), Source::application);
    if (answer != AbortCode::none) std::abort();
  }
  void map(unsigned records, unsigned parameters, unsigned pdo, std::uint8_t type) {
    const std::uint32_t cob_id = (records == 0x1600 ? 0x205U : 0x4000'0185U) + 0x100U * pdo;
    write(parameters + pdo, 1, cob_id | CobId::bit31, 4);
    write(parameters + pdo, 2, type, 1);
    write(records + pdo, 0, 0, 1);
    for (unsigned i = 1; i <= 2; ++i) {
      const unsigned value = (records == 0x1600 ? 8U : 0U) + 2 * pdo + i;
      write(records + pdo, i, 0x2000'0020U | value << 8, 4);
    }
    write(records + pdo, 0, 2, 1);
    write(parameters + pdo, 1, cob_id, 4);
  }
};

// The measured code is in functions of its own, so that bench/run finds it whole.

[[gnu::noinline]] void change(Node& node, const Entry& entry, std::uint32_t number) {
  node.dictionary().set(entry, {reinterpret_cast<const std::uint8_t*>(&number), sizeof number});
  node.advance(Time(Duration(number)));
}
[[gnu::noinline]] void beat(Node& node, std::uint32_t number) {
  node.receive(Frame::data_frame(0x080, {}), Time(Duration(number)));
}
[[gnu::noinline]] void hear(Node& node, std::uint32_t number) {
  node.receive(Frame::data_frame(0x181 + number % 4 * 0x100, {1, 2, 3, 4, 5, 6, 7, 8}),
               Time(Duration(number)));
}
[[gnu::noinline]] void start(Node& node) {
  node.start(Time{});
}
[[gnu::noinline]] void set_and_cancel(TimerQueue& timers, Timer& timer, Time time) {
  timers.arm(timer, time);
  timers.disarm(timer);
}

void node_change(benchmark::State& state) {
  BenchNode bench(255);
  const Entry entry = *bench.node.dictionary().find(0x2000, 4);
  std::uint32_t number = 0;
  for (auto _ : state) change(bench.node, entry, ++number);
  if (bench.driver.sent < number) state.SkipWithError("not all were sent");
}
BENCHMARK(node_change);

void node_sync(benchmark::State& state) {
  BenchNode bench(1);
  const Entry entry = *bench.node.dictionary().find(0x2000, 4);
  std::uint32_t number = 0;
  for (auto _ : state) {
    change(bench.node, entry, ++number);
    beat(bench.node, number);
  }
  if (bench.driver.sent < 4ULL * number) state.SkipWithError("not all were sent");
}
BENCHMARK(node_sync);

void node_foreign_frame(benchmark::State& state) {
  BenchNode bench(255);
  std::uint32_t number = 0;
  for (auto _ : state) hear(bench.node, ++number);
  if (bench.node.counters().unwanted != number) state.SkipWithError("somebody wanted them");
}
BENCHMARK(node_foreign_frame);

void node_start(benchmark::State& state) {
  BenchNode bench(255);
  for (auto _ : state) start(bench.node);
}
BENCHMARK(node_start);

constexpr std::size_t many = 512;
constexpr auto many_layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1800, .count = many, .entry_count = 2},
                                      {.index = 0x1A00, .count = many, .entry_count = 2},
                                      {.index = 0x3000, .count = many, .entry_count = 1}}),
            std::to_array<EntryRow>({
                {.sub_first = 1,
                 .sub_last = 1,
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .initial = CobId::bit31},
                {.sub_first = 2,
                 .sub_last = 2,
                 .type = DataType::unsigned8,
                 .access = Access::rw,
                 .initial = 255},
                {.type = DataType::unsigned8, .access = Access::rw},
                {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
                {.type = DataType::unsigned32, .access = Access::ro | Access::tpdo},
            }));
constexpr DictionaryTables many_tables = many_layout.tables();

/// TPDO n carries object 3000h + n - 1. All are event-driven.
class ManyTpdos {
 public:
  explicit ManyTpdos(std::size_t count) : pdos_(count) {
    tpdos_ = std::make_unique<Tpdos>(node, pdos_, values_, &sync_, Tpdos::AtStart::wait_for_event);
    node.start(Time{});
    for (std::uint32_t i = 0; i < count; ++i) {
      write(0x1A00 + i, 1, (0x3000 + i) << 16 | 0x20, 4);
      write(0x1A00 + i, 0, 1, 1);
      write(0x1800 + i, 1, 0x4000'0181 + i, 4);
    }
    node.command(NmtCommand::start);
    node.advance(Time{});
  }

  Driver driver;

 private:
  void write(unsigned index, unsigned sub, std::uint32_t number, std::size_t size) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&number);
    const AbortCode answer =
        node.dictionary().write(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub),
                                {bytes, size}, Source::application);
    if (answer != AbortCode::none) std::abort();
  }

  std::vector<std::uint8_t> block_ = std::vector<std::uint8_t>(many_tables.value_bytes);
  std::array<ObjectState, many_tables.objects.size()> states_{};
  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 16> backlog_{};
  std::vector<Tpdo> pdos_;
  std::vector<MappedValue> values_ = std::vector<MappedValue>(many);

 public:
  Node node{many_tables, {block_, states_, routes_, backlog_}, driver.port(), 5};

 private:
  Sync sync_{node};
  std::unique_ptr<Tpdos> tpdos_;
};

void change_of_one_of_tpdos(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  ManyTpdos bench(count);
  const Entry entry =
      *bench.node.dictionary().find(static_cast<std::uint16_t>(0x3000 + count / 2), 0);
  std::uint32_t number = 0;
  for (auto _ : state) change(bench.node, entry, ++number);
  if (bench.driver.sent < number) state.SkipWithError("not all were sent");
}
BENCHMARK(change_of_one_of_tpdos)->Arg(4)->Arg(64)->Arg(512);

void sync_beside_tpdos(benchmark::State& state) {
  ManyTpdos bench(static_cast<std::size_t>(state.range(0)));
  std::uint32_t number = 0;
  for (auto _ : state) beat(bench.node, ++number);
}
BENCHMARK(sync_beside_tpdos)->Arg(4)->Arg(512);

void timer_beside_others(benchmark::State& state) {
  TimerQueue timers;
  std::vector<std::unique_ptr<Timer>> others;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    timers.arm(*others.emplace_back(std::make_unique<Timer>()), Time(Duration(i + 1)));
  }
  Timer timer;
  const Time time(Duration(state.range(0) + 1));
  for (auto _ : state) set_and_cancel(timers, timer, time);
}
BENCHMARK(timer_beside_others)->Arg(4)->Arg(100)->Arg(10000);

/// A task without work.
struct Idle {
  Time deadline() const { return at; }
  void advance(Time) {}
  Time at = never;
};

void loop_turn_beside_tasks(benchmark::State& state, bool are_asked) {
  const std::unique_ptr<host::EventLoop> loop = *host::EventLoop::create();
  std::vector<Idle> idle(static_cast<std::size_t>(state.range(0)));
  for (Idle& task : idle) {
    loop->add({.deadline = Callback<Time()>::to<&Idle::deadline>(task),
               .advance = Callback<void(Time)>::to<&Idle::advance>(task),
               .due = are_asked ? nullptr : &task.at});
  }
  for (auto _ : state) loop->run_until(Time{});
}
BENCHMARK_CAPTURE(loop_turn_beside_tasks, asked, true)->Arg(1)->Arg(1000);
BENCHMARK_CAPTURE(loop_turn_beside_tasks, read, false)->Arg(1)->Arg(1000);

/// Like timers, without a request for their deadlines.
void loop_turn_beside_timers(benchmark::State& state) {
  const std::unique_ptr<host::EventLoop> loop = *host::EventLoop::create();
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    loop->at(Time(Duration(24h) + Duration(i)), [](Time) {});
  }
  for (auto _ : state) loop->run_until(Time{});
}
BENCHMARK(loop_turn_beside_timers)->Arg(1)->Arg(1000);

}  // namespace node_bench
}  // namespace canvoy
