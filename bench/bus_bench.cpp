// Frames per second of wall time on the simulated bus with complete nodes: each frame is a TPDO
// that is packed from a dictionary, wins arbitration, is delivered, and is written into the
// dictionaries of the nodes that map it.
//
// The nodes pass on what they receive, so that the bus is never idle: a value circulates and is
// incremented by each node. With 127 nodes, 64 of them are active at a time, so that there is
// arbitration as on a real bus at full load.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

namespace canvoy {
namespace {

constexpr std::size_t rpdo_count = 4;
constexpr std::uint16_t inputs = 0x6000;   // written by RPDOs: sub-indices 2n + 1 and 2n + 2
constexpr std::uint16_t outputs = 0x6400;  // read by the TPDO

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1400, .count = rpdo_count, .entry_count = 2},
                                      {.index = 0x1600, .count = rpdo_count, .entry_count = 2},
                                      {.index = 0x1800, .entry_count = 2},
                                      {.index = 0x1A00, .entry_count = 2},
                                      {.index = inputs, .entry_count = 1},
                                      {.index = outputs, .entry_count = 1}}),
            std::to_array<EntryRow>({
                {.type = DataType::unsigned32},
                {.type = DataType::unsigned8, .initial = 2},
                {.sub_first = 1,
                 .sub_last = 1,
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .initial = CobId::bit31},
                {.type = DataType::unsigned8, .access = Access::rw},
                {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned32, .access = Access::rw},
                {.type = DataType::unsigned8, .initial = 2},
                {.sub_first = 1,
                 .sub_last = 1,
                 .type = DataType::unsigned32,
                 .access = Access::rw,
                 .initial = CobId::bit31},
                {.type = DataType::unsigned8, .access = Access::rw},
                {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned32, .access = Access::rw},
                {.sub_first = 1,
                 .sub_last = 2 * rpdo_count,
                 .type = DataType::unsigned32,
                 .access = Access::rw | Access::rpdo},
                {.sub_first = 1,
                 .sub_last = 2,
                 .type = DataType::unsigned32,
                 .access = Access::rw | Access::tpdo},
            }));
constexpr DictionaryTables tables = layout.tables();

constexpr std::uint32_t tpdo_can_id(std::size_t node) {
  return 0x180 + static_cast<std::uint32_t>(node) + 1;
}

/// Receives the TPDOs of four others, and increments the value of the first of them.
class RingNode {
 public:
  RingNode(World& world, BusIndex bus, std::size_t number, std::size_t nodes)
      : slot(world.add_slot(bus)),
        node_(tables, {values_, states_, routes_, backlog_}, world.port(slot),
              static_cast<NodeId>(number + 1)) {
    world.occupy(slot, node_);
    rpdos_.received = Callback<void(std::uint16_t)>::to<&RingNode::pass_on>(*this);
    output_ = *node_.dictionary().find(outputs, 1);
    input_ = *node_.dictionary().find(inputs, 1);
    for (std::size_t i = 0; i < rpdo_count; ++i) peers_[i] = (number + nodes - 1 - i) % nodes;
    number_ = number;
  }

  void configure() {
    for (std::uint16_t i = 0; i < rpdo_count; ++i) {
      map(static_cast<std::uint16_t>(0x1600 + i), inputs, static_cast<std::uint8_t>(2 * i + 1));
      write(static_cast<std::uint16_t>(0x1400 + i), 1, tpdo_can_id(peers_[i]), 4);
    }
    map(0x1A00, outputs, 1);
    write(0x1800, 1, tpdo_can_id(number_) | CobId::bit30, 4);
    node_.command(NmtCommand::start);
  }

  std::uint64_t value() const { return node_.dictionary().number(outputs, 1); }
  std::uint64_t received() const { return node_.counters().received; }
  bool is_sound() const { return node_.counters().unwanted + node_.counters().malformed == 0; }
  void stir() { pass_on(1); }

  SlotIndex slot;

 private:
  void pass_on(std::uint16_t number) {
    if (number != 1) return;
    std::array<std::uint8_t, 4> bytes{};
    store(bytes.data(), load<std::uint32_t>(input_.value) + 1);
    node_.dictionary().set(output_, bytes);
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number, std::size_t size) {
    std::array<std::uint8_t, 8> bytes{};
    store(bytes.data(), number);
    node_.dictionary().write(index, sub, std::span(bytes).first(size), Source::application);
  }
  void map(std::uint16_t record, std::uint16_t object, std::uint8_t first_sub) {
    for (std::uint8_t i = 0; i < 2; ++i) {
      const std::uint32_t sub = std::uint32_t{first_sub} + i;
      write(record, static_cast<std::uint8_t>(i + 1), std::uint32_t{object} << 16 | sub << 8 | 32,
            4);
    }
    write(record, 0, 2, 1);
  }

  std::array<std::uint8_t, tables.value_bytes> values_{};
  std::array<ObjectState, tables.objects.size()> states_{};
  std::array<Router::Route, 8> routes_{};
  std::array<Frame, 4> backlog_{};
  std::array<Rpdo, rpdo_count> rpdo_memory_{};
  std::array<Tpdo, 1> tpdo_memory_{};
  std::array<MappedValue, rpdo_count * 2> rpdo_values_{};
  std::array<MappedValue, 2> tpdo_values_{};
  Node node_;
  Rpdos rpdos_{node_, rpdo_memory_, rpdo_values_};
  Tpdos tpdos_{node_, tpdo_memory_, tpdo_values_};
  Entry input_;
  Entry output_;
  std::size_t number_ = 0;
  std::array<std::size_t, rpdo_count> peers_{};
};

using Ring = std::vector<std::unique_ptr<RingNode>>;

/// Makes nodes on a bus of their own, in pre-operational.
Ring make_ring(World& world, std::size_t nodes) {
  const BusIndex bus = world.add_bus({.bit_rate = 1'000'000});
  Ring ring;
  for (std::size_t i = 0; i < nodes; ++i) {
    ring.push_back(std::make_unique<RingNode>(world, bus, i, nodes));
  }
  for (const auto& node : ring) world.start(node->slot);
  return ring;
}

void configure(World& world, const Ring& ring) {
  for (const auto& node : ring) node->configure();
  for (const auto& node : ring) world.touched(node->slot);
}

void stir(World& world, const Ring& ring, std::size_t values) {
  for (std::size_t i = 0; i < values; ++i) {
    RingNode& node = *ring[i * ring.size() / values];
    node.stir();
    world.touched(node.slot);
  }
}

std::uint64_t frames_on(const World& world, std::size_t buses) {
  std::uint64_t frames = 0;
  for (BusIndex bus = 0; bus < buses; ++bus) frames += world.bus(bus).statistics().frames;
  return frames;
}

/// Frames circulate for a second of bus time at 1 Mbit/s in each iteration: about 8000 of them on
/// each bus.
void carry_frames(benchmark::State& state) {
  const auto buses = static_cast<std::size_t>(state.range(0));
  World world;
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < buses; ++i) {
    rings.push_back(make_ring(world, static_cast<std::size_t>(state.range(1))));
  }
  world.run_for(1s);  // boot-up messages
  for (const Ring& ring : rings) configure(world, ring);
  world.run_for(1s);
  for (const Ring& ring : rings) stir(world, ring, static_cast<std::size_t>(state.range(2)));
  const std::uint64_t before = frames_on(world, buses);
  for (auto _ : state) world.run_for(1s);
  const std::uint64_t frames = frames_on(world, buses) - before;
  state.SetItemsProcessed(static_cast<std::int64_t>(frames));
  state.counters["load"] = world.bus().load();
  bool is_sound = world.bus().load() > 0.99;
  for (const Ring& ring : rings) {
    for (const auto& node : ring) is_sound = is_sound && node->is_sound();
  }
  if (!is_sound) state.SkipWithError("the bus was idle, or a frame was not understood");
}
BENCHMARK(carry_frames)
    ->ArgNames({"buses", "nodes", "values"})
    ->Args({1, 2, 2})
    ->Args({1, 127, 64})
    ->Args({8, 125, 64})
    ->Unit(benchmark::kMillisecond);

/// Eight hours of a charger and its battery, from a fifth to full.
void charge_a_night(benchmark::State& state) {
  std::uint64_t frames = 0;
  for (auto _ : state) {
    charger::ChargerNetwork network;
    network.run_until(Time(8h));
    frames += network.snapshot().bus.frames;
    if (!network.all_hold()) state.SkipWithError("an invariant did not hold");
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(frames));
}
BENCHMARK(charge_a_night)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace canvoy
