// Arbitrary frames, writes of scanner and dispatching lists and PDO parameters, changes of values
// and times, passed to a node with multiplexed PDOs. It continues to run, and what it sends in
// source address mode is a listed object with its value of that moment.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/mpdo_consumer.hpp"
#include "canvoy/canopen/pdo/mpdo_producer.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"

namespace canvoy {
namespace {

using fuzz::Input;
using fuzz::require;

constexpr Access process = Access::rw | Access::rpdo | Access::tpdo;

constexpr EntryRow parameter(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow several(std::uint8_t last, DataType type, Access access = Access::rw) {
  return {.sub_first = 1, .sub_last = last, .type = type, .access = access};
}

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1400, .count = 2, .entry_count = 3},
                                      {.index = 0x1600, .count = 2, .entry_count = 2},
                                      {.index = 0x1800, .count = 2, .entry_count = 4},
                                      {.index = 0x1A00, .count = 2, .entry_count = 2},
                                      {.index = 0x1FA0, .count = 2, .entry_count = 2},
                                      {.index = 0x1FD0, .count = 2, .entry_count = 2},
                                      {.index = 0x2000, .entry_count = 1},
                                      {.index = 0x2001, .entry_count = 1},
                                      {.index = 0x2002, .entry_count = 1}}),
            std::to_array<EntryRow>({
                parameter(1, DataType::unsigned32, CobId::bit31),
                parameter(2, DataType::unsigned8, 255),
                parameter(5, DataType::unsigned16),
                parameter(0, DataType::unsigned8),
                several(4, DataType::unsigned32),
                parameter(1, DataType::unsigned32, CobId::bit31),
                parameter(2, DataType::unsigned8, 255),
                parameter(3, DataType::unsigned16, 20),
                parameter(5, DataType::unsigned16),
                parameter(0, DataType::unsigned8),
                several(4, DataType::unsigned32),
                parameter(0, DataType::unsigned8),
                several(8, DataType::unsigned32),
                parameter(0, DataType::unsigned8),
                several(8, DataType::unsigned64),
                several(16, DataType::unsigned8, process),
                several(4, DataType::integer24, process),
                several(2, DataType::unsigned64, process),
            }));
constexpr DictionaryTables tables = layout.tables();

std::uint32_t take_long(Input& input) {
  return input.word() | std::uint32_t{input.word()} << 16;
}

class World {
 public:
  void run(Input& input) {
    use(0x1400, 0x205, 0xFF);
    use(0x1401, 0x206, 0xFE);
    use(0x1800, 0x185, 0xFE);
    use(0x1801, 0x285, 0xFF);
    node_.command(NmtCommand::start);
    while (!input.empty()) step(input);
  }

 private:
  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
        return receive(input);
      case 1:
        return feeder_.write(static_cast<std::uint16_t>(0x1FA0 + input.byte() % 2),
                             input.byte() % 9, listed(input));
      case 2:
        return feeder_.write(static_cast<std::uint16_t>(0x1FD0 + input.byte() % 2),
                             input.byte() % 9,
                             std::uint64_t{listed(input)} << 32 | take_long(input));
      case 3:
        return write_parameter(input);
      case 4:
        node_.dictionary().set_number(static_cast<std::uint16_t>(0x2000 + input.byte() % 3),
                                      input.byte() % 18, take_long(input));
        return node_.advance(feeder_.now());
      case 5:
        return feeder_.pass(Duration(input.word()));
      case 6:
        return change_controller();
      default:
        return act(input);
    }
  }

  /// An index, a sub-index and a small block, usually of an existing object.
  static std::uint32_t listed(Input& input) {
    const std::uint32_t choice = input.byte();
    if (choice > 240) return take_long(input);
    return choice % 20 << 24 | (0x2000U + choice % 3) << 8 | (1U + input.byte() % 17);
  }
  void receive(Input& input) {
    constexpr std::array<std::uint32_t, 5> likely = {0x205, 0x206, 0x000, 0x185, 0x285};
    Frame frame;
    frame.id = likely[input.byte() % likely.size()];
    frame.length = input.byte() % 4 == 0 ? static_cast<std::uint8_t>(input.byte() % 9) : 8;
    input.fill(std::span(frame.data).first(frame.length));
    node_.receive(frame, feeder_.now());
  }
  void write_parameter(Input& input) {
    constexpr std::array<std::uint16_t, 8> objects = {0x1400, 0x1401, 0x1600, 0x1601,
                                                      0x1800, 0x1801, 0x1A00, 0x1A01};
    const std::uint16_t index = objects[input.byte() % objects.size()];
    feeder_.write(index, input.byte() % 6, take_long(input) & 0x8000'FFFF);
  }
  void act(Input& input) {
    node_.advance(feeder_.now());
    tpdos_.trigger(input.byte() % 4);
    std::array<std::uint8_t, 5> value;
    input.fill(value);
    producer_.send(input.byte() % 4, input.byte(), input.word(), input.byte(),
                   std::span(value).first(input.byte() % 6));
  }
  /// By the procedure of CiA 301.
  void use(std::uint16_t parameters, std::uint32_t cob_id, std::uint8_t mode) {
    feeder_.write(static_cast<std::uint16_t>(parameters + 0x200), 0, mode);
    feeder_.write(parameters, 1, cob_id);
  }

  void change_controller() {
    full_ = !full_;
    if (full_) return;
    flushes_ = true;
    node_.tx_ready(feeder_.now());
    flushes_ = false;
  }

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    if (self.full_) return false;
    if (frame.id == 0x185) self.check(frame);
    return true;
  }
  /// A frame that has waited in the backlog may be older than the present parameters.
  void check(const Frame& frame) {
    const Dictionary& dictionary = node_.dictionary();
    if (flushes_ || dictionary.number(0x1A00, 0) != 0xFE) return;
    require(node_.state() == NmtState::operational && frame.length == 8);
    const Mpdo mpdo = decode_mpdo(frame.data.data());
    require(mpdo.mode == MpdoMode::source && mpdo.node == node_.id());
    const Result<Entry> entry = dictionary.find(mpdo.index, mpdo.sub);
    require(entry && is_listed(mpdo));
    require(load<std::uint32_t>(mpdo.data.data()) == load_unsigned(entry->bytes()));
  }
  bool is_listed(const Mpdo& mpdo) const {
    const Dictionary& dictionary = node_.dictionary();
    for (const std::uint16_t list : std::to_array<std::uint16_t>({0x1FA0, 0x1FA1})) {
      const std::uint64_t count = dictionary.number(list, 0);
      for (std::uint64_t i = 1; i <= count; ++i) {
        const std::uint64_t entry = dictionary.number(list, static_cast<std::uint8_t>(i));
        const std::uint64_t first = entry & 0xFF;
        const std::uint64_t block = std::max<std::uint64_t>(entry >> 24, 1);
        if (entry != 0 && (entry >> 8 & 0xFFFF) == mpdo.index && mpdo.sub >= first &&
            mpdo.sub < first + block) {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::array<ObjectState, tables.objects.size()> states_{};
  std::array<Router::Route, 8> routes_{};
  std::array<Frame, 4> backlog_{};
  std::array<Rpdo, 2> rpdo_memory_{};
  std::array<Tpdo, 2> tpdo_memory_{};
  std::array<MappedValue, 8> rpdo_values_{};
  std::array<MappedValue, 8> tpdo_values_{};
  std::array<ScannedObject, 12> scanned_{};
  std::array<MpdoProducer::Message, 3> queue_{};
  bool full_ = false;
  bool flushes_ = false;
  Node node_{tables, {values_, states_, routes_, backlog_}, {this, &World::take, nullptr}, 5};

  Rpdos rpdos_{node_, rpdo_memory_, rpdo_values_};
  Tpdos tpdos_{node_, tpdo_memory_, tpdo_values_};
  MpdoConsumer consumer_{node_, rpdos_};
  MpdoProducer producer_{node_, tpdos_, scanned_, queue_};
  fuzz::NodeFeeder feeder_{node_};  // starts it, with all of the above
};

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  canvoy::World world;
  world.run(input);
  return 0;
}
