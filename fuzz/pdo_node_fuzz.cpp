// Arbitrary frames, writes of PDO parameters and mappings, changes of values and times, passed to a
// node with SYNC and PDOs. Frames that it sends must be allowed by an independent reading of its
// dictionary: in operational only, of a valid PDO, with the mapped values of that moment, not
// within the inhibit time.
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"
#include "fuzz/require.hpp"

namespace canvoy {
namespace {

using fuzz::require;

constexpr Access process = Access::rw | Access::rpdo | Access::tpdo;
constexpr std::uint16_t pdo_count = 2;
constexpr std::size_t values_each = 16;

constexpr EntryRow parameter(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}
constexpr EntryRow process_data(std::uint8_t first, std::uint8_t last, DataType type) {
  return {.sub_first = first, .sub_last = last, .type = type, .access = process};
}

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1005, .entry_count = 1},
                              {.index = 0x1006, .entry_count = 1},
                              {.index = 0x1007, .entry_count = 1},
                              {.index = 0x1019, .entry_count = 1},
                              {.index = 0x1400, .count = pdo_count, .entry_count = 3},
                              {.index = 0x1600, .count = pdo_count, .entry_count = 2},
                              {.index = 0x1800, .count = pdo_count, .entry_count = 5},
                              {.index = 0x1A00, .count = pdo_count, .entry_count = 2},
                              {.index = 0x2000, .entry_count = 6}}),
    std::to_array<EntryRow>({
        parameter(0, DataType::unsigned32, 0x80),
        parameter(0, DataType::unsigned32),
        parameter(0, DataType::unsigned32),
        parameter(0, DataType::unsigned8),
        parameter(1, DataType::unsigned32, CobId::bit31),
        parameter(2, DataType::unsigned8, 255),
        parameter(5, DataType::unsigned16),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 16, .type = DataType::unsigned32, .access = Access::rw},
        parameter(1, DataType::unsigned32, CobId::bit31),
        parameter(2, DataType::unsigned8, 255),
        parameter(3, DataType::unsigned16),
        parameter(5, DataType::unsigned16),
        parameter(6, DataType::unsigned8),
        parameter(0, DataType::unsigned8),
        {.sub_first = 1, .sub_last = 16, .type = DataType::unsigned32, .access = Access::rw},
        process_data(1, 4, DataType::unsigned8),
        process_data(5, 8, DataType::boolean),
        process_data(9, 10, DataType{0x68}),  // 11 bits
        process_data(11, 12, DataType::integer24),
        process_data(13, 13, DataType::unsigned64),
        {.sub_first = 14,
         .sub_last = 14,
         .type = DataType::unsigned8,
         .access = process,
         .traits = EntryTraits::limited,
         .low = 10,
         .high = 20},
    }));
constexpr DictionaryTables tables = layout.tables();

using fuzz::Input;

std::uint32_t take_long(Input& input) {
  return input.word() | std::uint32_t{input.word()} << 16;
}

/// Counts the lives of the TPDOs: a life begins, without a transmission yet, with each NMT state
/// and each parameter. Attached before them, so that it counts first.
class Lives {
 public:
  explicit Lives(Node& node) {
    service_.state_entered = Callback<void(NmtState)>::to<&Lives::state_entered>(*this);
    node.attach(service_);
  }
  /// The last attached hook is called first.
  void attach_hook(Dictionary& dictionary) {
    hook_.first = 0x1800;
    hook_.last = 0x1801;
    hook_.after_write = Callback<void(const Entry&, Source)>::to<&Lives::written>(*this);
    dictionary.attach(hook_);
  }
  std::uint64_t count() const { return count_; }

 private:
  void state_entered(NmtState) { ++count_; }
  void written(const Entry&, Source) { ++count_; }

  std::uint64_t count_ = 1;
  Service service_;
  Hook hook_;
};

class World {
 public:
  World() {
    lives_.attach_hook(node_.dictionary());
    node_.start(now_);
  }

  void run(Input& input) {
    while (!input.empty()) step(input);
  }

 private:
  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
        return receive(input);
      case 1:
        return write_parameter(input);
      case 2:
        return write_mapping(input);
      case 3:
        return map_quickly(input);
      case 4:
        node_.dictionary().set_number(0x2000, sub_of(input),
                                      std::uint64_t{take_long(input)} << 32 | take_long(input));
        return node_.advance(now_);
      case 5:
        return fuzz::pass(node_, now_, Duration(input.word()));
      case 6:
        return change_controller();
      default:
        node_.advance(now_);
        tpdos_.trigger(input.byte());
        rpdos_.request(input.byte());
    }
  }

  /// A frame that waited for a full controller may be older than the present parameters.
  void change_controller() {
    full_ = !full_;
    if (full_) return;
    flushes_ = true;
    node_.tx_ready(now_);
    flushes_ = false;
  }
  void receive(Input& input) {
    constexpr std::array<std::uint32_t, 6> likely = {0x000, 0x080, 0x185, 0x186, 0x205, 0x206};
    const auto choice = input.byte();
    Frame frame;
    frame.id =
        choice < 200 ? likely[choice % likely.size()] : take_long(input) & Frame::extended_id_max;
    frame.flags = static_cast<FrameFlags>(choice < 180 ? 0 : input.byte() % 8);
    frame.length = static_cast<std::uint8_t>(input.byte() % 9);
    input.fill(std::span(frame.data).first(frame.length));
    if (frame.is_remote()) frame.data = {};
    node_.receive(frame, now_);
  }
  void write_parameter(Input& input) {
    constexpr std::array<std::uint16_t, 8> objects = {0x1005, 0x1006, 0x1007, 0x1019,
                                                      0x1400, 0x1401, 0x1800, 0x1801};
    const std::uint16_t index = objects[input.byte() % objects.size()];
    write(index, index < 0x1400 ? 0 : static_cast<std::uint8_t>(input.byte() % 8),
          take_long(input));
  }
  void write_mapping(Input& input) {
    constexpr std::array<std::uint16_t, 4> records = {0x1600, 0x1601, 0x1A00, 0x1A01};
    write(records[input.byte() % records.size()], static_cast<std::uint8_t>(input.byte() % 20),
          take_long(input));
  }
  /// By the procedure of CiA 301, with mappable entries.
  void map_quickly(Input& input) {
    const auto pdo = static_cast<std::uint16_t>(input.byte() % pdo_count);
    const bool receives = input.byte() % 2 == 0;
    const auto parameters = static_cast<std::uint16_t>((receives ? 0x1400 : 0x1800) + pdo);
    const auto record = static_cast<std::uint16_t>(parameters + 0x200);
    write(parameters, 1, CobId::bit31);
    write(record, 0, 0);
    const auto count = static_cast<std::uint8_t>(input.byte() % 10);
    for (std::uint8_t i = 1; i <= count; ++i) {
      const std::uint8_t sub = sub_of(input);
      write(record, i, 0x2000'0000U | std::uint32_t{sub} << 8 | bits_of(sub));
    }
    write(record, 0, count);
    write(parameters, 2, input.byte());
    write(parameters, 1, (receives ? 0x205U : 0x185U) + pdo);
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
    fuzz::write(node_, now_, index, sub, number);
  }

  static std::uint8_t sub_of(Input& input) {
    return static_cast<std::uint8_t>(1 + input.byte() % 14);
  }
  static std::uint32_t bits_of(std::uint8_t sub) {
    if (sub >= 5 && sub <= 8) return 1;
    if (sub == 9 || sub == 10) return 11;
    if (sub == 11 || sub == 12) return 24;
    return sub == 13 ? 64 : 8;
  }

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    if (self.full_) return false;
    self.check(frame);
    return true;
  }
  void check(const Frame& frame) {
    const bool is_boot_up = frame.id == 0x705 && frame.length == 1;
    if (is_boot_up || frame.is_remote()) return;
    const auto sync_id = node_.dictionary().number(0x1005, 0) & 0x7FF;
    if (frame.id == sync_id && frame.length <= 1) return;
    if (flushes_) return;
    bool allowed = false;
    for (std::uint16_t pdo = 0; pdo < pdo_count; ++pdo) allowed |= is_sent_by(pdo, frame);
    require(allowed && node_.state() == NmtState::operational);
  }
  bool is_sent_by(std::uint16_t pdo, const Frame& frame) {
    const Dictionary& dictionary = node_.dictionary();
    const auto index = static_cast<std::uint16_t>(0x1800 + pdo);
    const std::uint64_t cob_id = dictionary.number(index, 1);
    if ((cob_id & CobId::bit31) != 0 || (cob_id & 0x7FF) != frame.id) return false;
    const std::uint64_t type = dictionary.number(index, 2);
    // Others may be sent with an older sample.
    if (type < 253) return true;
    if (packed(static_cast<std::uint16_t>(0x1A00 + pdo)) != wire_bits(frame)) return false;
    const Duration inhibit = 100us * dictionary.number(index, 3);
    const Sent before = std::exchange(sent_[pdo], {now_, lives_.count()});
    return type == 253 || before.life != lives_.count() || now_ - before.at >= inhibit;
  }
  static std::vector<bool> wire_bits(const Frame& frame) {
    std::vector<bool> bits;
    for (std::size_t i = 0; i < frame.length * 8U; ++i) {
      bits.push_back((frame.data[i / 8] >> i % 8 & 1) != 0);
    }
    return bits;
  }
  std::vector<bool> packed(std::uint16_t record) const {
    std::vector<bool> bits;
    const Dictionary& dictionary = node_.dictionary();
    const std::uint64_t count = dictionary.number(record, 0);
    for (std::uint64_t entry = 1; entry <= count; ++entry) {
      const std::uint64_t mapped = dictionary.number(record, static_cast<std::uint8_t>(entry));
      const auto sub = static_cast<std::uint8_t>(mapped >> 8);
      std::uint64_t value = dictionary.number(static_cast<std::uint16_t>(mapped >> 16), sub);
      if ((mapped & 0xFF) == 1) value = value != 0 ? 1 : 0;
      for (unsigned bit = 0; bit < (mapped & 0xFF); ++bit) bits.push_back((value >> bit & 1) != 0);
    }
    while (bits.size() % 8 != 0) bits.push_back(false);
    return bits;
  }
  struct Sent {
    Time at{};
    std::uint64_t life = 0;
  };

  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(tables.value_bytes);
  std::array<ObjectState, tables.objects.size()> states_{};
  std::array<Router::Route, 8> routes_{};
  std::array<Frame, 4> backlog_{};
  std::array<Rpdo, pdo_count> rpdo_memory_{};
  std::array<Tpdo, pdo_count> tpdo_memory_{};
  std::array<MappedValue, pdo_count * values_each> rpdo_values_{};
  std::array<MappedValue, pdo_count * values_each> tpdo_values_{};
  std::array<Sent, pdo_count> sent_{};
  Time now_{};
  bool full_ = false;
  bool flushes_ = false;
  Node node_{tables, {values_, states_, routes_, backlog_}, {this, &World::take, nullptr}, 5};

  Lives lives_{node_};
  Sync sync_{node_};
  Rpdos rpdos_{node_, rpdo_memory_, rpdo_values_, &sync_};
  Tpdos tpdos_{node_, tpdo_memory_, tpdo_values_, &sync_};
};

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  canvoy::World world;
  world.run(input);
  return 0;
}
