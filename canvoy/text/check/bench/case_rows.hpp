// Rows of cases that are code, and what several groups share: an error that the test provokes, and
// the CAN-IDs that it uses.
#pragma once

#include <span>
#include <string_view>

#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

/// A case with a judge in code; the texts are those of TestCase.
struct CaseRow {
  /// Identifier of the case.
  std::string_view id;
  /// Clause of the requirement.
  std::string_view clause;
  /// Tested property.
  std::string_view title;
  /// Sent messages, in a few words.
  std::string_view sends;
  /// Expected result, in a few words.
  std::string_view expects;
  /// Runs the case.
  Verdict (*judge)(Bench&);
};
/// Appends a case for each row.
void add_rows(TestCases& cases, Group group, std::span<const CaseRow> rows);

/// Test CAN-ID for TPDOs, from 680h to 6DFh, which no service uses by default (CiA 301, 7.3.3).
inline constexpr std::uint32_t tpdo_test_id = 0x6B0;
/// Test CAN-ID for RPDOs.
inline constexpr std::uint32_t rpdo_test_id = 0x6B1;
/// Test CAN-ID for SYNC.
inline constexpr std::uint32_t sync_test_id = 0x6B2;

/// Value "save" for 1010h.
inline constexpr std::uint32_t save_signature = 0x6576'6173;
/// Sub-index of 1010h and 1011h for communication parameters, or for all parameters if they are not
/// separate.
std::uint8_t storage_group(Bench& bench);

/// Node-ID of a node that the test plays.
NodeId played_node(const Bench& bench);
/// CAN-ID of the emergencies of the device: from 1014h, else 80h + node-ID.
std::uint32_t emergency_id(Bench& bench);
/// Error code: the first two bytes of an emergency.
inline std::uint16_t error_code(const Frame& emergency) {
  return static_cast<std::uint16_t>(emergency.data[0] | emergency.data[1] << 8);
}

/// Result of a lost heartbeat: the device monitors a node (1016h:01h) and receives exactly one
/// heartbeat of it.
struct LostHeartbeat {
  std::optional<Verdict> cannot = {};  ///< reason if no heartbeat could be lost
  /// The emergency; nothing if none came within 400 ms.
  std::optional<Heard> emergency = {};
};
/// Sends one heartbeat and lets the next one fail. Takes 400 ms if no emergency comes.
LostHeartbeat lose_heartbeat(Bench& bench);
/// Sends one more heartbeat of that node.
void send_heartbeat(Bench& bench);

/// Resets the device, and waits for its boot-up message. Returns what is wrong if none comes within
/// 5 s.
std::optional<Verdict> reset_node(Bench& bench);
/// Why a case that only needs a reset does not apply if reset_node() fails: the cases of NMT judge
/// it.
inline constexpr const char* no_boot_up = "no boot-up message comes behind a reset";

/// Verdict for a failed write: `1017h is not written: abort ...`. An abort means that the case does
/// not apply; silence and an answer to another request are failures.
Verdict cannot_set(std::string_view object, const Reply& reply);
/// Verdict for a write that must be refused, with any abort code; `taken` is the failure if it was
/// not.
Verdict refusal(const Reply& reply, std::string_view taken);

}  // namespace canvoy::conformance
