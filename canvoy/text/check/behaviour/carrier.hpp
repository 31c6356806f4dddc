// Finds the PDO of a device that carries an entry. If it is invalid, or not sent on an event, it
// gets a CAN-ID of the test until Bench::restore().
//
//     std::optional<Carrier> out = find_carrier(bench, PdoWay::transmit, {&object, 1});
//     if (const auto cannot = make_ready(bench, *out, 0x6B3)) return *cannot;
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/text/check/behaviour/step.hpp"
#include "canvoy/text/check/bench/own_pdo.hpp"

namespace canvoy::conformance {

/// A number with this many ones, 0 to 64.
constexpr std::uint64_t low_bits(unsigned bits) {
  return bits >= 64 ? ~0ULL : (1ULL << bits) - 1;
}

struct Carrier {
  OwnPdo pdo = {};         ///< can_id is the one in use
  unsigned first_bit = 0;  ///< of the entry
  unsigned bits = 0;       ///< size of the entry, 1 to 64

  /// The entry in a frame of the PDO; nothing if the frame is too short.
  std::optional<std::uint64_t> value_in(const Frame& frame) const;
  /// Writes the entry into the bytes of a frame.
  void put_into(std::span<std::uint8_t, 8> bytes, std::uint64_t value) const;
};

/// Searches the first 32 PDOs and those of the profile; nothing if none carries the entry.
std::optional<Carrier> find_carrier(Bench& bench, PdoWay way, const Place& place);
/// Makes the PDO valid and event-driven: unchanged if it is, else with this CAN-ID. Returns the
/// reason if this fails.
std::optional<Verdict> make_ready(Bench& bench, Carrier& carrier, std::uint32_t own_id);

}  // namespace canvoy::conformance
