// A PDO of the device that is reserved for the test: it has a CAN-ID that no other node uses, until
// Bench::restore().
//
//     const auto pdo = find_pdo(bench, PdoWay::transmit);
//     if (const auto cannot = arrange(bench, *pdo, {.type = 1})) return *cannot;
#pragma once

#include <optional>
#include <vector>

#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

/// Direction as seen from the device.
enum class PdoWay : std::uint8_t { receive, transmit };

struct OwnPdo {
  /// Direction of the PDO.
  PdoWay way = PdoWay::transmit;
  std::uint16_t parameter = 0;  ///< 1400h, 1800h or above
  /// 1600h, 1A00h or above.
  std::uint16_t mapping = 0;
  std::uint32_t cob_id = 0;                ///< value before the test
  std::vector<std::uint32_t> mapped = {};  ///< the entries that it carries
  std::uint32_t can_id = 0;                ///< CAN-ID for the test

  /// Size of the mapped entries in bits.
  std::size_t bits() const;
};

/// The first PDO of the device with mapped entries that is not multiplexed; nothing if there is
/// none.
std::optional<OwnPdo> find_pdo(Bench& bench, PdoWay way);

/// Transmission parameters of a PDO.
struct Sending {
  /// Transmission type (sub-index 02h).
  unsigned type = 255;
  std::uint16_t event_ms = 0;       ///< 0: unchanged
  std::uint16_t inhibit_100us = 0;  ///< 0: unchanged
};
/// Makes the PDO valid with the test CAN-ID. Returns the reason if this fails.
std::optional<Verdict> arrange(Bench& bench, const OwnPdo& pdo, const Sending& sending);
/// Makes the PDO invalid. Returns the reason if this fails.
std::optional<Verdict> disable(Bench& bench, const OwnPdo& pdo);

}  // namespace canvoy::conformance
