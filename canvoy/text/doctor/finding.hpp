// The faults of a CANopen bus that a listener can find: a row for each kind, with its name,
// severity and texts.
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
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy::text {

/// Kinds in the order of the rows; a report lists kinds of the same severity in this order.
enum class FindingKind : std::uint8_t {
  lost_bus,
  no_traffic,
  wrong_bit_rate,
  not_acknowledged,
  bus_errors,
  errors_at_node,
  node_id_twice,
  cob_id_twice,
  sync_twice,
  heartbeat_missing,
  pdo_length,
  sync_window,
  sync_differs,
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

/// Severity, the worst last.
enum class Severity : std::uint8_t {
  note,     ///< worth knowing, no fault
  warning,  ///< works, with a deviation
  error,    ///< does not work, or will soon fail
};
/// Name of a severity: `note`, `warning` or `error`.
std::string_view severity_name(Severity severity);

/// A fault.
struct Finding {
  FindingKind kind = {};                     ///< kind of the fault, from finding_rows()
  NodeId node = 0;                           ///< 0: not of a single node
  std::optional<std::uint16_t> can_id = {};  ///< if it concerns one
  std::uint64_t count = 0;                   ///< number of occurrences
  Time first{};                              ///< time of the first occurrence
  Time last{};                               ///< time of the last occurrence
  std::string what = {};                     ///< observation, in sentences
};
/// Findings of one bus; empty: no fault.
using Findings = std::vector<Finding>;

/// All that was heard on a bus: see observed.hpp.
struct Observed;

/// Description of a kind.
struct FindingRow {
  FindingKind kind;        ///< number of the row
  std::string_view name;   ///< `node-id-twice`
  Severity severity;       ///< of all findings of this kind
  std::string_view title;  ///< in a few words
  std::string_view why;    ///< why it matters
  std::string_view check;  ///< how to confirm it
  std::string_view cure;   ///< how to correct it
  /// Adds the findings of this kind.
  void (*judge)(const Observed& bus, Findings& findings);
};
/// The rows in the order of FindingKind: errors first, notes last.
std::span<const FindingRow> finding_rows();
/// The row of a kind.
const FindingRow& finding_row(FindingKind kind);

}  // namespace canvoy::text
