// A disk that caches writes until a sync, and loses or keeps any of them when power fails: the
// stored set is the old or the new one there, too.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_disk_test {
namespace {

constexpr std::size_t disk_size = 512;
constexpr Storage::Settings settings{.slot_size = 256, .groups = stored_groups};

/// Writes since the last sync are kept separately, byte by byte.
class CachedDisk {
 public:
  explicit CachedDisk(SimulatedFlash::Bytes content) : lasting(std::move(content)) {
    lasting.resize(disk_size, 0xFF);
    seen = lasting;
    flash.sector_size = 256;
    flash.erase = decltype(Flash::erase)::to<&CachedDisk::erase>(*this);
    flash.program = decltype(Flash::program)::to<&CachedDisk::program>(*this);
    flash.read = decltype(Flash::read)::to<&CachedDisk::read>(*this);
    flash.sync = decltype(Flash::sync)::to<&CachedDisk::sync>(*this);
  }

  /// Contents after power-on: each byte that was not synced is old or new, as `decide` returns.
  template <class Decide>
  SimulatedFlash::Bytes crash(Decide decide) const {
    SimulatedFlash::Bytes kept = lasting;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i] != seen[i] && decide()) kept[i] = seen[i];
    }
    return kept;
  }

  Flash flash;
  SimulatedFlash::Bytes lasting;
  SimulatedFlash::Bytes seen;
  unsigned writes_left = 1000;  ///< then power fails

 private:
  FlashState write(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    if (writes_left == 0) return FlashState::done;
    --writes_left;
    std::ranges::copy(bytes, seen.begin() + address);
    return FlashState::done;
  }
  FlashState erase(std::uint32_t address) {
    return write(address, std::vector<std::uint8_t>(256, 0xFF));
  }
  FlashState program(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    return write(address, bytes);
  }
  bool read(std::uint32_t address, std::span<std::uint8_t> bytes) {
    std::copy_n(seen.begin() + address, bytes.size(), bytes.begin());
    return true;
  }
  FlashState sync() {
    if (writes_left == 0) return FlashState::done;
    --writes_left;
    lasting = seen;
    return FlashState::done;
  }
};

struct Device {
  explicit Device(const Flash& flash)
      : wire(stored_layout.tables(), 5), storage(wire.node, flash, settings) {
    wire.start();
  }
  void set(std::uint32_t number) {
    wire.node.dictionary().set_number(0x1017, 0, number);
    wire.node.dictionary().set_number(0x6020, 2, number);
    wire.node.dictionary().set_number(0xA000, 0, number);
  }
  /// The number set, or 1000 if the values are from different sets.
  std::uint64_t get() {
    const Dictionary& dictionary = wire.node.dictionary();
    const std::uint64_t number = dictionary.number(0x1017, 0);
    if (number == 0 && dictionary.number(0x6020, 2) == 0x60) return 0;
    return dictionary.number(0x6020, 2) == number && dictionary.number(0xA000, 0) == number ? number
                                                                                            : 1000;
  }
  void store() {
    storage.store(1);
    wire.settle();
  }
  WireNode wire;
  Storage storage;
};

RC_GTEST_PROP(StorageDisk, ALossOfPowerLeavesTheOldSetOrTheNewOne, ()) {
  SimulatedFlash::Bytes bytes;
  std::uint64_t kept = 0;
  const auto lives = *rc::gen::inRange(1U, 6U);
  for (unsigned number = 1; number <= lives; ++number) {
    CachedDisk disk(bytes);
    Device device(disk.flash);
    RC_ASSERT(device.get() == kept);
    device.set(number);
    disk.writes_left = *rc::gen::inRange(0U, 12U);
    device.store();
    const bool confirmed = disk.writes_left != 0;
    const auto fate = *rc::gen::inRange(0, 4);
    bytes = disk.crash([&] { return fate == 0 || (fate != 1 && *rc::gen::arbitrary<bool>()); });
    CachedDisk after(bytes);
    const std::uint64_t found = Device(after.flash).get();
    RC_ASSERT(found == kept || found == number);
    if (confirmed) RC_ASSERT(found == number);
    kept = found;
  }
}

}  // namespace
}  // namespace canvoy::storage_disk_test
