#include "canvoy/can/frame_bits.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace canvoy {
namespace {

constexpr std::size_t byte_values = 256;
constexpr std::size_t bytes_max = 5 + 8;  // a 29-bit header, padded to bytes, and the data
constexpr std::uint16_t crc_polynomial = 0x4599;
constexpr unsigned crc_bits = 15;
constexpr unsigned trailer_bits = 1 + 1 + bits_after_acknowledgement;  // CRC delimiter, slot, rest

/// Header, from the start of frame to the data length: 19 bits, or 39 for a 29-bit frame. Both
/// formats end with RTR, two dominant bits (IDE and r0, or r1 and r0) and the length.
template <bool is_extended>
std::uint64_t header_of(const Frame& frame) {
  const std::uint64_t tail = std::uint64_t{frame.is_remote()} << 6 | frame.length;
  if constexpr (!is_extended) return std::uint64_t{frame.id} << 7 | tail;
  const std::uint64_t recessive = std::uint64_t{3} << 25;  // SRR and IDE
  const std::uint64_t base_id = frame.id >> 18;
  return base_id << 27 | recessive | std::uint64_t{frame.id & 0x3'FFFF} << 7 | tail;
}

template <bool is_extended>
constexpr unsigned header_bits = is_extended ? 39 : 19;

/// Calls visit(byte, following) for each byte of the header, padded in front with dominant bits,
/// and of the data.
template <bool is_extended, typename Visit>
void for_each_byte(const Frame& frame, Visit&& visit) {
  const std::uint64_t header = header_of<is_extended>(frame);
  const std::size_t data_bytes = frame.payload().size();
  for (std::size_t left = (header_bits<is_extended> + 7) / 8; left > 0; --left) {
    visit(static_cast<std::uint8_t>(header >> (8 * (left - 1))), left - 1 + data_bytes);
  }
  const auto visit_data = [&](auto count) {
    for (std::size_t i = 0; i < count; ++i) visit(frame.data[i], count - 1 - i);
  };
  if (data_bytes == Frame::length_max) {
    visit_data(
        std::integral_constant<std::size_t, Frame::length_max>{});  // unrolled: the most frequent
  } else {
    visit_data(data_bytes);
  }
}

// The checksum is linear: that of the frame is the sum (exclusive or) of the contribution of each
// byte, which depends on the number of bytes that follow. The look-ups thus depend on their bytes
// only.

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

/// The last bit on the wire, and the number of equal ones, 1 to 4: with a fifth, a stuff bit
/// follows at once.
struct Run {
  bool bit = false;
  unsigned length = 1;

  /// Adds a bit; true if a stuff bit follows.
  constexpr bool add(bool next) {
    length = next == bit ? length + 1 : 1;
    bit = next;
    if (length < 5) return false;
    bit = !next;
    length = 1;
    return true;
  }
};

/// Effect of a byte on the run, for each byte and each of the eight runs; the next run is stored as
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

/// The header is padded in front with dominant bits: five of them, or, for a 29-bit frame, one,
/// which counts as the fifth. A recessive stuff bit follows that looks like the idle bus, and is
/// not counted.
template <bool is_extended>
constexpr Run run_before = is_extended ? Run{false, 4} : Run{true, 1};

struct Sums {
  std::uint16_t crc = 0;
  unsigned stuff_bits = 0;
};

template <bool is_extended>
Sums sums_of(const Frame& frame) {
  constexpr unsigned uncounted = 1;
  unsigned crc = 0;
  unsigned stuff_bits = 0;
  std::size_t offset = StuffingTable::offset(run_before<is_extended>);
  const auto stuff = [&](std::size_t byte) {
    stuff_bits += stuffing.stuff_bits[offset + byte];
    offset = stuffing.next[offset + byte];
  };
  for_each_byte<is_extended>(frame, [&](std::uint8_t byte, std::size_t following) {
    crc ^= crc_tables[following][byte];
    stuff(byte);
  });
  // 15 bits, padded with the complement of the last: no run ends on it.
  const unsigned filled = crc * 2 + (~crc & 1);
  stuff(filled >> 8);
  stuff(filled & 0xFF);
  return {static_cast<std::uint16_t>(crc), stuff_bits - uncounted};
}

/// The frame without stuff bits up to the last bit of data: value of the bit at `place`.
bool bit_at(const Frame& frame, std::size_t place) {
  const std::size_t header_size = frame.is_extended() ? header_bits<true> : header_bits<false>;
  if (place < header_size) {
    const std::uint64_t header =
        frame.is_extended() ? header_of<true>(frame) : header_of<false>(frame);
    return (header >> (header_size - 1 - place) & 1) != 0;
  }
  const std::size_t data_place = place - header_size;
  return (frame.data[data_place / 8] >> (7 - data_place % 8) & 1) != 0;
}

std::size_t body_bits(const Frame& frame) {
  const std::size_t header_size = frame.is_extended() ? header_bits<true> : header_bits<false>;
  return header_size + 8 * frame.payload().size();
}

}  // namespace

unsigned frame_bits(const Frame& frame) {
  if (frame.is_error()) return 0;
  const Sums sums = frame.is_extended() ? sums_of<true>(frame) : sums_of<false>(frame);
  return static_cast<unsigned>(body_bits(frame)) + crc_bits + sums.stuff_bits + trailer_bits;
}

std::uint16_t frame_crc(const Frame& frame) {
  return frame.is_extended() ? sums_of<true>(frame).crc : sums_of<false>(frame).crc;
}

unsigned first_different_bit(const Frame& a, const Frame& b) {
  const std::size_t common = std::min(body_bits(a), body_bits(b));
  Run run{true, 1};
  unsigned on_wire = 0;
  for (std::size_t place = 0; place < common; ++place) {
    ++on_wire;
    if (bit_at(a, place) != bit_at(b, place)) return on_wire;
    if (run.add(bit_at(a, place))) ++on_wire;
  }
  return 0;
}

}  // namespace canvoy
