#include "canvoy/tools/device/car_store.hpp"

#include <algorithm>

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t sector_size = 4096;
/// Two each for what a taximeter keeps, for the node-ID, and for whom a gateway has named.
constexpr std::uint32_t sectors = 6;
constexpr std::uint32_t lss_address = 2 * sector_size;
constexpr std::uint32_t known_address = 4 * sector_size;
constexpr std::uint32_t known_kind = 0x4E52'4143;  // "CARN"
constexpr std::uint32_t known_version = 1;

}  // namespace

CarStore::CarStore(const std::string& path)
    : file_(value_or_throw(
          host::FileFlash::open(path, {.sector_size = sector_size, .sectors = sectors}))),
      known_(file_->flash(),
             {.address = known_address, .slot_size = sector_size, .kind = known_kind}) {
  known_.sign(known_kind, known_version);
}

LssStore::Place CarStore::lss_place() const {
  return {.address = lss_address, .slot_size = sector_size};
}

cia447::CarMemory CarStore::memory() {
  return {.load = Callback<cia447::KnownDevices()>::to<&CarStore::load>(*this),
          .store = Callback<void(const cia447::KnownDevices&)>::to<&CarStore::keep>(*this)};
}

cia447::KnownDevices CarStore::load() {
  cia447::KnownDevices known;
  if (known_.find() != RecordState::valid || !known_.read(0, bytes_)) return known;
  const std::uint8_t* from = bytes_.data();
  for (std::size_t i = 0; i < known.addresses.size(); ++i) {
    known.is_known[i] = *from++ != 0;
    for (std::uint32_t& part : known.addresses[i].parts) {
      part = canvoy::load<std::uint32_t>(from);
      from += sizeof part;
    }
  }
  return known;
}

void CarStore::keep(const cia447::KnownDevices& known) {
  std::uint8_t* to = bytes_.data();
  for (std::size_t i = 0; i < known.addresses.size(); ++i) {
    *to++ = known.is_known[i] ? 1 : 0;
    for (const std::uint32_t part : known.addresses[i].parts) {
      store(to, part);
      to += sizeof part;
    }
  }
  known_.begin(
      {.rewind = Callback<void()>::to<&CarStore::rewind>(*this),
       .next = Callback<Result<std::size_t>(std::span<std::uint8_t>)>::to<&CarStore::next>(*this)});
  // A file does not let anybody wait.
  while (known_.step() != RecordStep::done) {
  }
}

Result<std::size_t> CarStore::next(std::span<std::uint8_t> bytes) {
  const std::size_t length = std::min(bytes.size(), bytes_.size() - offset_);
  std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset_), length, bytes.begin());
  offset_ += length;
  return length;
}

}  // namespace canvoy::tools
