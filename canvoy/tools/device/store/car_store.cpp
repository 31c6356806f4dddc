#include "canvoy/tools/device/store/car_store.hpp"

#include <algorithm>
#include <array>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t sector_size = 4096;
/// Two each for the values of a taximeter, for the node-ID, for the named devices of a gateway, and
/// for the memories of its seats.
constexpr std::uint32_t sectors = 8;
constexpr std::uint32_t lss_address = 2 * sector_size;
constexpr RecordPair::Place known_place = {
    .address = 4 * sector_size, .slot_size = sector_size, .kind = 0x4E52'4143};  // "CARN"
constexpr RecordPair::Place seats_place = {
    .address = 6 * sector_size, .slot_size = sector_size, .kind = 0x5352'4143};  // "CARS"
constexpr std::uint32_t format_version = 1;

/// For each node-ID: whether it was assigned, and the identity of its device.
using KnownBytes =
    std::array<std::uint8_t, cia447::add_on_devices_max * (1 + 4 * sizeof(std::uint32_t))>;
/// For each memory of each seat: whether it is used, and the position of the seat.
using SeatBytes =
    std::array<std::uint8_t, cia447::SeatMemories::seats * cia447::SeatMemories::memories *
                                 (1 + cia447::SeatMemories::ways)>;

}  // namespace

KeptBytes::KeptBytes(const Flash& flash, const RecordPair::Place& place) : records_(flash, place) {
  records_.sign(place.kind, format_version);
}

bool KeptBytes::load(std::span<std::uint8_t> bytes) {
  return records_.find() == RecordState::valid && records_.read(0, bytes);
}

void KeptBytes::keep(std::span<const std::uint8_t> bytes) {
  bytes_ = bytes;
  (void)records_.find();  // where the newest one is
  records_.begin(
      {.rewind = callback<&KeptBytes::rewind>(*this), .next = callback<&KeptBytes::next>(*this)});
  // Writing a file does not block.
  while (records_.step() != RecordStep::done) {
  }
  bytes_ = left_ = {};
}

Result<std::size_t> KeptBytes::next(std::span<std::uint8_t> bytes) {
  const std::size_t length = std::min(bytes.size(), left_.size());
  std::ranges::copy(left_.first(length), bytes.begin());
  left_ = left_.subspan(length);
  return length;
}

CarStore::CarStore(const std::string& path)
    : file_(value_or_throw(
          host::FileFlash::open(path, {.sector_size = sector_size, .sectors = sectors}))),
      known_(file_->flash(), known_place),
      seats_(file_->flash(), seats_place) {}

void CarStore::join(Environment& environment) {
  environment.provide(callback<&CarStore::memory>(*this));
}

LssStore::Place CarStore::lss_place() const {
  return {.address = lss_address, .slot_size = sector_size};
}

cia447::AuditMemory::Place CarStore::audit_place() {
  return {.address = seats_place.address, .slot_size = seats_place.slot_size};
}

cia447::CarMemory CarStore::memory() {
  return {.load = callback<&CarStore::load_known>(*this),
          .store = callback<&CarStore::keep_known>(*this)};
}

cia447::KnownDevices CarStore::load_known() {
  cia447::KnownDevices known;
  KnownBytes bytes;
  if (!known_.load(bytes)) return known;
  const std::uint8_t* from = bytes.data();
  for (std::size_t i = 0; i < known.addresses.size(); ++i) {
    known.is_known[i] = *from++ != 0;
    for (std::uint32_t& part : known.addresses[i].parts) {
      part = load<std::uint32_t>(from);
      from += sizeof part;
    }
  }
  return known;
}

void CarStore::keep_known(const cia447::KnownDevices& known) {
  KnownBytes bytes;
  std::uint8_t* to = bytes.data();
  for (std::size_t i = 0; i < known.addresses.size(); ++i) {
    *to++ = known.is_known[i] ? 1 : 0;
    for (const std::uint32_t part : known.addresses[i].parts) {
      store(to, part);
      to += sizeof part;
    }
  }
  known_.keep(bytes);
}

cia447::SeatStore CarStore::seats() {
  return {.load = callback<&CarStore::load_seats>(*this),
          .store = callback<&CarStore::keep_seats>(*this)};
}

cia447::SeatMemories CarStore::load_seats() {
  cia447::SeatMemories memories;
  SeatBytes bytes;
  if (!seats_.load(bytes)) return memories;
  const std::uint8_t* from = bytes.data();
  for (auto& seat : memories.of_seat) {
    for (cia447::SeatMemories::Memory& memory : seat) {
      memory.is_used = *from++ != 0;
      for (std::uint8_t& position : memory.position) position = *from++;
    }
  }
  return memories;
}

void CarStore::keep_seats(const cia447::SeatMemories& memories) {
  SeatBytes bytes;
  std::uint8_t* to = bytes.data();
  for (const auto& seat : memories.of_seat) {
    for (const cia447::SeatMemories::Memory& memory : seat) {
      *to++ = memory.is_used ? 1 : 0;
      to = std::ranges::copy(memory.position, to).out;
    }
  }
  seats_.keep(bytes);
}

}  // namespace canvoy::tools
