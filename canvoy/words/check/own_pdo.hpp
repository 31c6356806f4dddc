// A PDO of the device that the test has for itself: with a CAN-ID that nobody else has, until
// Bench::restore().
//
//     const auto pdo = find_pdo(bench, PdoWay::transmit);
//     if (const auto cannot = arrange(bench, *pdo, {.type = 1})) return *cannot;
#pragma once

#include <optional>
#include <vector>

#include "canvoy/words/check/bench.hpp"
#include "canvoy/words/check/test_case.hpp"

namespace canvoy::conformance {

/// As the device sees it.
enum class PdoWay : std::uint8_t { receive, transmit };

struct OwnPdo {
  /// Whether it is sent or received.
  PdoWay way = PdoWay::transmit;
  std::uint16_t parameter = 0;  ///< 1400h, 1800h or above
  /// 1600h, 1A00h or above.
  std::uint16_t mapping = 0;
  std::uint32_t cob_id = 0;                ///< as it was found
  std::vector<std::uint32_t> mapped = {};  ///< the entries that it carries
  std::uint32_t can_id = 0;                ///< what the test gives it

  /// What it carries, in bits.
  std::size_t bits() const;
};

/// The first of the device that carries something and is no multiplexed one; nothing where it has
/// none.
std::optional<OwnPdo> find_pdo(Bench& bench, PdoWay way);

/// How a PDO is to be sent or taken.
struct Sending {
  /// Transmission type, as sub-index 02h has it.
  unsigned type = 255;
  std::uint16_t event_ms = 0;       ///< 0: as it is
  std::uint16_t inhibit_100us = 0;  ///< 0: as it is
};
/// Makes it valid with the test's CAN-ID. Answers why that cannot be.
std::optional<Verdict> arrange(Bench& bench, const OwnPdo& pdo, const Sending& sending);
/// Makes it invalid.
std::optional<Verdict> disable(Bench& bench, const OwnPdo& pdo);

}  // namespace canvoy::conformance
