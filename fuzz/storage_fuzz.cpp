// A flash with arbitrary contents: the content is refused, or is a set that fits; in any case the
// device afterwards stores what is commanded, and finds it again.
//
// The contents are a genuine set with some bytes changed, or only such bytes; they may also be
// forged, with matching CRCs and the right signature. Then a client writes values, 1010h and 1011h.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/program_server.hpp"
#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/storage.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {
namespace {

constexpr std::uint32_t slot_size = 192;
constexpr std::uint32_t flash_size = 3 * slot_size;  ///< two slots, and one for a program

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1010, .entry_count = 2},
                              {.index = 0x1011, .entry_count = 2},
                              {.index = 0x1017, .entry_count = 1},
                              {.index = 0x2010, .entry_count = 1},
                              {.index = 0x6000, .entry_count = 1},
                              {.index = 0x6020, .count = 2, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 4},
         {.sub_first = 1,
          .sub_last = 4,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 1},
         {.access = Access::const_, .initial = 4},
         {.sub_first = 1,
          .sub_last = 4,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = 1},
         {.type = DataType::unsigned16, .access = Access::rw},
         {.type = DataType::visible_string, .access = Access::rw, .capacity = 12},
         {.type = DataType::unsigned16,
          .access = Access::rw,
          .traits = EntryTraits::limited,
          .low = 0,
          .high = 1000},
         {.access = Access::const_, .initial = 2},
         {.sub_first = 1, .sub_last = 2, .type = DataType::unsigned24, .access = Access::rw}}));

/// Bytes in memory that can be programmed once between erasures.
class Memory {
 public:
  Memory() {
    bytes.fill(0xFF);
    flash.sector_size = slot_size;
    flash.unit = 8;
    flash.erase = decltype(Flash::erase)::to<&Memory::erase>(*this);
    flash.program = decltype(Flash::program)::to<&Memory::program>(*this);
    flash.read = decltype(Flash::read)::to<&Memory::read>(*this);
  }
  Flash flash;
  std::array<std::uint8_t, flash_size> bytes;

 private:
  FlashState erase(std::uint32_t address) {
    require(address % slot_size == 0 && address < flash_size);
    std::fill_n(bytes.begin() + address, slot_size, std::uint8_t{0xFF});
    return FlashState::done;
  }
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> data) {
    require(address % 8 == 0 && address + data.size() <= flash_size);
    for (const std::uint8_t byte : data) {
      require(bytes[address] == 0xFF);
      bytes[address++] = byte;
    }
    return FlashState::done;
  }
  bool read(std::uint32_t address, std::span<std::uint8_t> data) {
    require(address + data.size() <= flash_size);
    std::copy_n(bytes.begin() + address, data.size(), data.begin());
    return true;
  }
};

/// A node on that memory, just after power-on.
class Device {
 public:
  Device(Memory& memory, bool keep_what_fits)
      : node_(tables_, {values_, states_, routes_, backlog_},
              {nullptr, [](void*, const Frame&) { return true; }, nullptr}, 5),
        storage_(node_, memory.flash, {.slot_size = slot_size, .keep_what_fits = keep_what_fits}),
        programs_(node_, memory.flash, slots_) {
    node_.start(Time{});
    settle();
  }

  void write(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
    node_.dictionary().write(index, sub, value, Source::sdo);
    settle();
  }
  bool store() {
    AbortCode answer = AbortCode::general;
    auto done = [&](AbortCode code) { answer = code; };
    require(storage_.store(1, Storage::Done::of(done)) == AbortCode::none);
    settle();
    return answer == AbortCode::none;
  }
  RecordState state() const { return storage_.state(); }
  bool has_same_values(const Device& other) const {
    Entry entry;
    for (ParameterWalk walk(node_.dictionary()); walk.next(entry);) {
      const auto found = other.node_.dictionary().find(entry.index, entry.sub);
      if (!std::ranges::equal(entry.bytes(), found->bytes())) return false;
    }
    return true;
  }

 private:
  void settle() {
    for (int i = 0; node_.deadline() <= Time{}; ++i) {
      require(i < 1000);
      node_.advance(Time{});
    }
  }

  DictionaryTables tables_ = layout.tables();
  std::array<std::uint8_t, layout.tables().value_bytes> values_{};
  std::array<ObjectState, layout.tables().objects.size()> states_{};
  std::array<Router::Route, 4> routes_{};
  std::array<Frame, 4> backlog_{};
  Node node_;
  Storage storage_;
  std::array<ProgramSlot, 1> slots_{{{.address = 2 * slot_size, .size = slot_size}}};
  ProgramServer programs_;
};

/// Forges a slot: head and content have matching CRCs, and the signature of a genuine head.
void seal(std::span<std::uint8_t> slot, std::span<const std::uint8_t> genuine) {
  std::copy_n(genuine.begin(), 8, slot.begin());
  std::copy_n(genuine.begin() + 20, 8, slot.begin() + 20);
  const auto length = std::min<std::uint32_t>(load<std::uint32_t>(&slot[12]), slot_size - 32);
  store(&slot[16], crc32(slot.subspan(32, length)));
  store(&slot[28], crc32(slot.first(28)));
}

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  using namespace canvoy::fuzz;
  Input input(data, size);
  const std::uint8_t how = input.byte();
  Memory memory;
  require(Device(memory, false).store());
  const auto genuine = memory.bytes;
  if ((how & 8) != 0) memory.bytes.fill(input.byte());
  for (unsigned changes = input.byte(); changes > 0; --changes) {
    memory.bytes[input.word() % flash_size] = input.byte();
  }
  for (unsigned slot = 0; slot < 2; ++slot) {
    if ((how >> slot & 1) == 0) continue;
    seal(std::span(memory.bytes).subspan(slot * slot_size, slot_size), genuine);
  }
  Device device(memory, (how & 4) != 0);
  while (!input.empty()) {
    constexpr std::uint16_t objects[] = {0x1010, 0x1011, 0x1017, 0x2010, 0x6000, 0x6020, 0x6021};
    const std::uint16_t index = objects[input.byte() % std::size(objects)];
    const std::uint8_t sub = input.byte() % 6;
    std::array<std::uint8_t, 12> value;
    const auto bytes = std::span(value).first(input.byte() % (value.size() + 1));
    input.fill(bytes);
    device.write(index, sub, bytes);
  }
  if (!device.store()) return 0;
  const Device again(memory, false);
  require(again.state() == RecordState::valid && again.has_same_values(device));
  return 0;
}
