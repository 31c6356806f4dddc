// The audit log of a taximeter for other devices: lines of ASCII, in objects of the manufacturer's
// area, since CiA 447-3 has none for it (4.2.12).
//
//     dictionary.set(entry, audit_text(*log.newest(0)).view());
//     // 2026-11-23 11:00:00 UTC: write refused: node 7, 6055h:00h = 1F4h, 20 times until ...
#pragma once

#include "canvoy/devices/cia447/taximeter/audit_log.hpp"
#include "canvoy/devices/cia447/taximeter/fixed_text.hpp"
#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

/// Characters of the longest line.
inline constexpr std::size_t audit_line_capacity = 112;
/// A line.
using AuditText = FixedText<audit_line_capacity>;

/// Time, kind, origin, and details.
AuditText audit_text(const AuditEntry& entry);

/// A number of events or entries.
inline constexpr ValueInfo audit_count = {.limits = at_least(0, 0xFFFF'FFFF)};
/// An entry of 5F20h.
constexpr EntryInfo audit_number(unsigned sub, std::string_view name) {
  return at(
      sub, name,
      {.type = DataType::unsigned32, .access = Access::ro, .initial = 0, .value = audit_count});
}
/// The entries of 5F21h.
constexpr EntryInfo audit_line() {
  EntryInfo entry =
      at(1, "Entry #",
         {.type = DataType::visible_string, .access = Access::ro, .capacity = audit_line_capacity});
  entry.sub_last = AuditLog::capacity;
  entry.first_number = 1;
  return entry;
}
/// The entries of 5F20h.
inline constexpr EntryInfo audit_entries[] = {
    highest_sub_index(3, 3), audit_number(1, "Events recorded"), audit_number(2, "Entries kept"),
    audit_number(3, "Entries lost")};
/// The entries of 5F21h.
inline constexpr EntryInfo audit_log_entries[] = {
    highest_sub_index(AuditLog::capacity, AuditLog::capacity), audit_line()};

/// Numbers of events and entries.
inline constexpr ObjectInfo audit_object = {.index = 0x5F20,
                                            .code = ObjectCode::record,
                                            .name = "Taximeter audit log",
                                            .category = Category::optional,
                                            .clause = "manufacturer-specific",
                                            .description = "What was recorded, and what is left.",
                                            .subs = audit_entries};
/// The newest entry first; empty if there are fewer.
inline constexpr ObjectInfo audit_log_object = {
    .index = 0x5F21,
    .code = ObjectCode::array,
    .name = "Taximeter audit log entries",
    .category = Category::optional,
    .clause = "manufacturer-specific",
    .description = "What was done to the meter, when and by whom; the newest first.",
    .subs = audit_log_entries};

}  // namespace canvoy::cia447
