#include "canvoy/canopen/storage/record.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/storage/crc32.hpp"

namespace canvoy {

namespace {

constexpr std::size_t covered = RecordHead::size - 4;  ///< by the CRC at the end

}  // namespace

RecordHead::Bytes RecordHead::bytes() const {
  Bytes bytes;
  const std::uint32_t words[] = {kind, format, sequence, length, crc, signature[0], signature[1]};
  std::uint8_t* place = bytes.data();
  for (const std::uint32_t word : words) {
    store(place, word);
    place += sizeof word;
  }
  store(place, crc32(std::span(bytes).first(covered)));
  return bytes;
}

std::optional<RecordHead> RecordHead::from(const Bytes& bytes) {
  const auto word = [&](std::size_t number) {
    return load<std::uint32_t>(bytes.data() + number * sizeof(std::uint32_t));
  };
  if (crc32(std::span(bytes).first(covered)) != word(7)) return std::nullopt;
  return RecordHead{.kind = word(0),
                    .format = word(1),
                    .sequence = word(2),
                    .length = word(3),
                    .crc = word(4),
                    .signature = {word(5), word(6)}};
}

HeadState read_head(const Flash& flash, std::uint32_t address, RecordHead& head) {
  RecordHead::Bytes bytes;
  if (!flash.read(address, bytes)) return HeadState::unreadable;
  const auto found = RecordHead::from(bytes);
  if (found) head = *found;
  if (found) return HeadState::good;
  const bool blank = std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0xFF; });
  return blank ? HeadState::blank : HeadState::bad;
}

std::optional<std::uint32_t> crc32_of(const Flash& flash, std::uint32_t address,
                                      std::uint32_t length) {
  Crc32 crc;
  std::array<std::uint8_t, RecordHead::size> bytes;
  while (length > 0) {
    const auto piece = std::span(bytes).first(std::min<std::size_t>(length, bytes.size()));
    if (!flash.read(address, piece)) return std::nullopt;
    crc.add(piece);
    address += static_cast<std::uint32_t>(piece.size());
    length -= static_cast<std::uint32_t>(piece.size());
  }
  return crc.value();
}

}  // namespace canvoy
