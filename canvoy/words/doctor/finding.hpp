// What can be wrong with a CANopen bus, as it shows to who listens: a row for each kind, with its
// name, its weight, and its words.
//
//     for (const FindingRow& row : finding_rows()) show(row.name, row.title);
//     show(finding_row(finding.kind).cure);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"

namespace canvoy::words {

/// In the order of the rows; of one severity, a report tells them in this order.
enum class FindingKind : std::uint8_t {
  no_traffic,
  wrong_bit_rate,
  not_acknowledged,
  bus_errors,
  errors_at_node,
  node_id_twice,
  cob_id_twice,
  heartbeat_missing,
  pdo_length,
  sync_window,
  sheet_differs,
  heartbeat_late,
  heartbeat_jitter,
  unexpected_boot_up,
  sdo_time_out,
  sdo_slow,
  inhibit_time,
  load_peak,
  emergency_storm,
  reserved_value,
  failed_value,
  against_protocol,
  reported_error,
  silence,
};

/// How bad it is, the worst last.
enum class Severity : std::uint8_t {
  note,     ///< no alarm: worth knowing
  warning,  ///< it works, and something is not as it should be
  error,    ///< something does not work, or will not for long
};
/// `note`, `warning` or `error`.
std::string_view severity_name(Severity severity);

/// One thing that is wrong.
struct Finding {
  FindingKind kind = {};                     ///< what is wrong, as in finding_rows()
  NodeId node = 0;                           ///< 0: of no single node
  std::optional<std::uint16_t> can_id = {};  ///< where it is of one
  std::uint64_t count = 0;                   ///< how often it was seen
  Time first{};                              ///< when it was seen first
  Time last{};                               ///< when it was seen last
  std::string what = {};                     ///< what was seen, in sentences
};
/// Of one bus; empty: nothing is wrong.
using Findings = std::vector<Finding>;

/// All that was heard of a bus: see observed.hpp.
struct Observed;

/// All that is known of a kind.
struct FindingRow {
  FindingKind kind;        ///< the number of the row
  std::string_view name;   ///< `node-id-twice`
  Severity severity;       ///< of all findings of this kind
  std::string_view title;  ///< a few words
  std::string_view why;    ///< why it matters
  std::string_view check;  ///< how to make sure
  std::string_view cure;   ///< what to do
  /// Adds what there is of this kind.
  void (*judge)(const Observed& bus, Findings& findings);
};
/// One for each kind, in the order of FindingKind: errors first, notes last.
std::span<const FindingRow> finding_rows();
/// The row of this kind.
const FindingRow& finding_row(FindingKind kind);

}  // namespace canvoy::words
