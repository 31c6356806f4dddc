// The common part of LSS slave and master: addresses, command specifiers, error codes, and the
// table of bit rates (CiA 305).
//
//     const LssAddress address{.parts = {0x2F0, 419, 0x10000, 77}};
//     const Frame request = lss::frame(can_id::lss_request, lss::Command::inquire_vendor);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

/// The identity of a node as in 1018h: vendor-ID, product code, revision number, serial number. It
/// must be unique in a network.
struct LssAddress {
  static constexpr std::size_t vendor = 0;    ///< part: vendor-ID
  static constexpr std::size_t product = 1;   ///< part: product code
  static constexpr std::size_t revision = 2;  ///< part: revision number
  static constexpr std::size_t serial = 3;    ///< part: serial number

  std::array<std::uint32_t, 4> parts{};  ///< in the order of 1018h

  friend bool operator==(const LssAddress&, const LssAddress&) = default;
};

/// LSS state: only a slave in configuration obeys the services that change settings.
enum class LssState : std::uint8_t { waiting = 0, configuration = 1 };

/// Answer of a slave to a configuration or to storing.
struct LssError {
  /// The meaning of a code depends on the service, except 0 and FFh.
  static constexpr std::uint8_t none = 0;
  static constexpr std::uint8_t out_of_range = 1;       ///< for a node-ID or a bit timing
  static constexpr std::uint8_t store_unsupported = 1;  ///< for storing
  static constexpr std::uint8_t store_failed = 2;       ///< the storage medium does not work
  static constexpr std::uint8_t manufacturer = 0xFF;    ///< `specific` has details

  std::uint8_t code = none;   ///< 0: done
  std::uint8_t specific = 0;  ///< of the manufacturer, if `code` is FFh

  /// True if the slave has done as requested.
  constexpr bool ok() const { return code == none; }
  friend bool operator==(const LssError&, const LssError&) = default;
};

/// Bit timings of table selector 0, by index.
namespace lss_bit_timing {

inline constexpr std::uint8_t automatic = 9;  ///< the node detects the bit rate (CiA 801)
/// The node cannot say, or its bit rate is not in the table.
inline constexpr std::uint8_t unknown = 0xFF;
inline constexpr std::uint8_t reserved = 5;  ///< index without a bit rate
/// In bit/s, by index; 0 at the reserved one.
inline constexpr std::array<std::uint32_t, 9> bit_rates = {
    1'000'000, 800'000, 500'000, 250'000, 125'000, 0, 50'000, 20'000, 10'000};

/// True for the index of a bit rate, or of its detection.
constexpr bool is_index(std::uint8_t index) {
  return index <= automatic && index != reserved;
}
/// Bit rate in bit/s; 0 for an index without one.
constexpr std::uint32_t bit_rate(std::uint8_t index) {
  return index < bit_rates.size() ? bit_rates[index] : 0;
}
/// Index of a bit rate; `unknown` if the table does not have it.
constexpr std::uint8_t index(std::uint32_t bit_rate) {
  const auto* found = std::find(bit_rates.begin(), bit_rates.end(), bit_rate);
  return bit_rate == 0 || found == bit_rates.end()
             ? unknown
             : static_cast<std::uint8_t>(found - bit_rates.begin());
}

}  // namespace lss_bit_timing

namespace lss {

/// Command: the first byte of each message.
enum class Command : std::uint8_t {
  switch_global = 0x04,
  configure_node_id = 0x11,
  configure_bit_timing = 0x13,
  activate_bit_timing = 0x15,
  store = 0x17,
  select_vendor = 0x40,
  select_product = 0x41,
  select_revision = 0x42,
  select_serial = 0x43,
  selected = 0x44,  ///< answer of the slave
  identify_vendor = 0x46,
  identify_product = 0x47,
  identify_revision_low = 0x48,
  identify_revision_high = 0x49,
  identify_serial_low = 0x4A,
  identify_serial_high = 0x4B,
  identify_unconfigured = 0x4C,
  identified = 0x4F,    ///< answer of the slave
  unconfigured = 0x50,  ///< answer of the slave
  fastscan = 0x51,
  inquire_vendor = 0x5A,
  inquire_product = 0x5B,
  inquire_revision = 0x5C,
  inquire_serial = 0x5D,
  inquire_node_id = 0x5E,
};

/// The n-th of several commands with consecutive numbers.
constexpr Command operator+(Command command, std::size_t n) {
  return static_cast<Command>(static_cast<std::size_t>(command) + n);
}

/// All messages have eight bytes; unused ones are zero.
inline constexpr std::uint8_t length = 8;

/// Message with a command and up to four bytes after it.
inline Frame frame(std::uint16_t can_id, Command command, std::uint32_t value = 0) {
  Frame frame;
  frame.id = can_id;
  frame.length = length;
  frame.data[0] = static_cast<std::uint8_t>(command);
  store(&frame.data[1], value);
  return frame;
}

/// Question of Fastscan: is there a node with the bits of `id_number` from 31 down to `bit_checked`
/// in part `sub` of its address?
struct FastscanRequest {
  /// As bit_checked: all participating slaves answer.
  static constexpr std::uint8_t anybody = 0x80;

  std::uint32_t id_number = 0;         ///< bits to compare with
  std::uint8_t bit_checked = anybody;  ///< lowest bit to compare: 31 to 0
  std::uint8_t sub = 0;                ///< LSSSub: the part of the address, 0 to 3
  std::uint8_t next = 0;               ///< LSSNext: the part that follows this message

  /// True for a question about bits; false for `anybody` too.
  constexpr bool valid() const { return sub <= 3 && next <= 3 && bit_checked <= 31; }
};

}  // namespace lss

}  // namespace canvoy
