#include "canvoy/formats/sheet/sheet_storage.hpp"

#include <algorithm>

namespace canvoy::formats {

namespace {

constexpr std::uint8_t erased = 0xFF;

}  // namespace

std::uint32_t storage_slot_size(const Dictionary& dictionary) {
  const std::uint32_t size = RecordHead::size + stored_size_max(dictionary);
  return (size + storage_sector_size - 1) / storage_sector_size * storage_sector_size;
}

MemoryStorage::MemoryStorage(Node& node)
    : bytes_(std::size_t{2} * storage_slot_size(node.dictionary()), erased),
      flash_(flash()),
      storage_(node, flash_, {.slot_size = storage_slot_size(node.dictionary())}) {}

Flash MemoryStorage::flash() {
  Flash made;
  made.sector_size = storage_sector_size;
  made.erase = decltype(made.erase)::to<&MemoryStorage::erase>(*this);
  made.program = decltype(made.program)::to<&MemoryStorage::program>(*this);
  made.read = decltype(made.read)::to<&MemoryStorage::read>(*this);
  return made;
}

FlashState MemoryStorage::erase(std::uint32_t address) {
  std::fill_n(bytes_.begin() + address, storage_sector_size, erased);
  return FlashState::done;
}

FlashState MemoryStorage::program(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  std::ranges::copy(bytes, bytes_.begin() + address);
  return FlashState::done;
}

bool MemoryStorage::read(std::uint32_t address, std::span<std::uint8_t> bytes) {
  std::copy_n(bytes_.begin() + address, bytes.size(), bytes.begin());
  return true;
}

}  // namespace canvoy::formats
