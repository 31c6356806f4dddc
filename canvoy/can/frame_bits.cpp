#include "canvoy/can/frame_bits.hpp"

#include <array>
#include <cstddef>

namespace canvoy {
namespace {

constexpr std::size_t byte_values = 256;
constexpr std::size_t bytes_max = 5 + 8;  // a 29-bit header, and the data
constexpr std::uint16_t crc_polynomial = 0x4599;
constexpr unsigned crc_bits = 15;
constexpr unsigned trailer_bits = 1 + 1 + bits_after_acknowledgement;  // CRC delimiter, slot, rest

/// From the start of frame to the last data bit, with padding in front to fill the first byte.
struct Body {
  std::array<std::uint8_t, bytes_max> bytes{};
  std::size_t size = 0;
  std::size_t padding_bits = 0;

  std::size_t bits() const { return size * 8 - padding_bits; }
  bool bit(std::size_t index) const {
    const std::size_t place = padding_bits + index;
    return (bytes[place / 8] >> (7 - place % 8) & 1) != 0;
  }
};

/// Both formats end with RTR, two (29 bit: r1, r0) or (11 bit: IDE, r0) dominant bits and the
/// length.
std::uint64_t header_of(const Frame& frame) {
  const std::uint64_t remote = frame.is_remote() ? 1 : 0;
  const std::uint64_t tail = remote << 6 | frame.length;
  if (!frame.is_extended()) return std::uint64_t{frame.id} << 7 | tail;
  const std::uint64_t recessive = std::uint64_t{3} << 25;  // SRR and IDE
  return std::uint64_t{frame.id >> 18} << 27 | recessive | std::uint64_t{frame.id & 0x3'FFFF} << 7 |
         tail;
}

Body body_of(const Frame& frame) {
  const std::uint64_t header = header_of(frame);
  const std::size_t header_bytes = frame.is_extended() ? 5 : 3;
  Body body;
  body.padding_bits = frame.is_extended() ? 40 - 39 : 24 - 19;
  for (std::size_t i = 0; i < header_bytes; ++i) {
    body.bytes[i] = static_cast<std::uint8_t>(header >> (8 * (header_bytes - 1 - i)));
  }
  const std::size_t data_bytes = frame.payload().size();
  for (std::size_t i = 0; i < data_bytes; ++i) body.bytes[header_bytes + i] = frame.data[i];
  body.size = header_bytes + data_bytes;
  return body;
}

// The checksum is linear: that of the frame is the sum (exclusive or) of what each byte adds, which
// depends on how many bytes follow. So the look-ups wait for nothing but their bytes.

using CrcTable = std::array<std::uint16_t, byte_values>;

constexpr std::uint16_t crc_step(std::uint16_t crc, bool bit) {
  const bool carry = ((crc >> (crc_bits - 1)) & 1) != (bit ? 1 : 0);
  const unsigned shifted = (crc * 2U & 0x7FFFU) ^ (carry ? crc_polynomial : 0U);
  return static_cast<std::uint16_t>(shifted);
}

constexpr std::array<CrcTable, bytes_max> make_crc_tables() {
  std::array<CrcTable, bytes_max> tables{};
  for (unsigned byte = 0; byte < byte_values; ++byte) {
    for (unsigned i = 0; i < 8; ++i) {
      tables[0][byte] = crc_step(tables[0][byte], (byte >> (7 - i) & 1) != 0);
    }
  }
  for (std::size_t following = 1; following < bytes_max; ++following) {
    for (std::size_t byte = 0; byte < byte_values; ++byte) {
      const unsigned before = tables[following - 1][byte];
      tables[following][byte] =
          static_cast<std::uint16_t>((before << 8 & 0x7FFFU) ^ tables[0][before >> 7]);
    }
  }
  return tables;
}

constexpr std::array<CrcTable, bytes_max> crc_tables = make_crc_tables();

std::uint16_t crc_of(const Body& body) {
  unsigned crc = 0;
  for (std::size_t i = 0; i < body.size; ++i) {
    crc ^= crc_tables[body.size - 1 - i][body.bytes[i]];
  }
  return static_cast<std::uint16_t>(crc);
}

/// The last bit on the wire, and how many equal ones there were, 1 to 4: with a fifth, a stuff bit
/// follows at once.
struct Run {
  bool bit = false;
  unsigned length = 1;

  /// True where a stuff bit follows.
  constexpr bool add(bool next) {
    length = next == bit ? length + 1 : 1;
    bit = next;
    if (length < 5) return false;
    bit = !next;
    length = 1;
    return true;
  }
};

/// What a byte does to the run, for each byte and each of the eight runs; the next run is kept as
/// an offset into the table, so that one look-up leads to the next without arithmetic.
struct StuffingTable {
  static constexpr std::size_t runs = 8;
  std::array<std::uint16_t, runs * byte_values> next{};
  std::array<std::uint8_t, runs * byte_values> stuff_bits{};

  static constexpr std::size_t offset(const Run& run) {
    return ((run.bit ? 4U : 0U) + run.length - 1) * byte_values;
  }
};

constexpr StuffingTable make_stuffing_table() {
  StuffingTable table;
  for (std::size_t index = 0; index < table.next.size(); ++index) {
    const std::size_t number = index / byte_values;
    Run run{number >= 4, static_cast<unsigned>(number % 4 + 1)};
    for (unsigned i = 0; i < 8; ++i) {
      if (run.add((index >> (7 - i) & 1) != 0)) ++table.stuff_bits[index];
    }
    table.next[index] = static_cast<std::uint16_t>(StuffingTable::offset(run));
  }
  return table;
}

constexpr StuffingTable stuffing = make_stuffing_table();

/// The padding is made to alternate and to end recessive, as the bus before a frame: it adds no
/// stuff bit and no run.
constexpr std::uint8_t padding_11_bit = 0b1010'1000;
constexpr std::uint8_t padding_29_bit = 0b1000'0000;

unsigned stuff_bits_of(const Body& body, std::uint16_t crc) {
  const std::uint8_t padding = body.padding_bits == 1 ? padding_29_bit : padding_11_bit;
  std::size_t offset = StuffingTable::offset(Run{});
  unsigned count = 0;
  const auto add = [&](std::size_t byte) {
    count += stuffing.stuff_bits[offset + byte];
    offset = stuffing.next[offset + byte];
  };
  add(body.bytes[0] | std::size_t{padding});
  for (std::size_t i = 1; i < body.size; ++i) add(body.bytes[i]);
  // 15 bits, filled up with the complement of the last: no run ends on it.
  const unsigned filled = crc * 2U + (~crc & 1U);
  add(filled >> 8);
  add(filled & 0xFF);
  return count;
}

}  // namespace

unsigned frame_bits(const Frame& frame) {
  if (frame.is_error()) return 0;
  const Body body = body_of(frame);
  const unsigned stuff_bits = stuff_bits_of(body, crc_of(body));
  return static_cast<unsigned>(body.bits()) + crc_bits + stuff_bits + trailer_bits;
}

std::uint16_t frame_crc(const Frame& frame) {
  return crc_of(body_of(frame));
}

unsigned first_different_bit(const Frame& a, const Frame& b) {
  const Body body_a = body_of(a);
  const Body body_b = body_of(b);
  const std::size_t common = body_a.bits() < body_b.bits() ? body_a.bits() : body_b.bits();
  Run run{true, 1};
  unsigned on_wire = 0;
  for (std::size_t i = 0; i < common; ++i) {
    ++on_wire;
    if (body_a.bit(i) != body_b.bit(i)) return on_wire;
    if (run.add(body_a.bit(i))) ++on_wire;
  }
  return 0;
}

}  // namespace canvoy
