// Rows of cases that are code, and what several classes share: an error that the test provokes, and
// CAN-IDs that it uses.
#pragma once

#include <span>
#include <string_view>

#include "canvoy/words/check/bench.hpp"
#include "canvoy/words/check/test_case.hpp"

namespace canvoy::conformance {

/// A case whose judge is code; the texts are those of TestCase.
struct CaseRow {
  /// Its name.
  std::string_view id;
  /// Who says so.
  std::string_view clause;
  /// What is judged.
  std::string_view title;
  /// In a few words.
  std::string_view sends;
  /// The same.
  std::string_view expects;
  /// Tries it.
  Verdict (*judge)(Bench&);
};
/// Appends a case for each row.
void add_rows(TestCases& cases, Group group, std::span<const CaseRow> rows);

/// Of 680h to 6DFh, which nothing has by default (CiA 301, 7.3.3): what the test configures a
/// device to.
inline constexpr std::uint32_t tpdo_test_id = 0x6B0;
/// Of an RPDO.
inline constexpr std::uint32_t rpdo_test_id = 0x6B1;
/// Of SYNC.
inline constexpr std::uint32_t sync_test_id = 0x6B2;

/// A node that the test plays.
NodeId played_node(const Bench& bench);
/// Of the device's emergencies: that in 1014h, else 80h + node-ID.
std::uint32_t emergency_id(Bench& bench);
/// Of an emergency, its first two bytes.
inline std::uint16_t error_code(const Frame& emergency) {
  return static_cast<std::uint16_t>(emergency.data[0] | emergency.data[1] << 8);
}

/// The device watches a node (1016h:01h), hears one heartbeat of it, and no other.
struct LostHeartbeat {
  std::optional<Verdict> cannot = {};  ///< why there was none to lose
  /// Nothing: none came within 400 ms.
  std::optional<Heard> emergency = {};
};
/// Takes 400 ms where no emergency comes.
LostHeartbeat lose_heartbeat(Bench& bench);
/// One more heartbeat of that node.
void send_heartbeat(Bench& bench);

/// `1017h is not written: abort ...`
Verdict cannot_set(std::string_view object, const Reply& reply);

}  // namespace canvoy::conformance
