// Objects that a device must have: those of every device, and of each service that its dictionary
// claims (CiA 301, 7.5.2; error control: 7.2.8.2). The check runs by index when a DeviceNode is
// compiled, and so works for any description, and for tables written by hand.
//
//     constexpr MissingEntry missing = find_missing(layout.tables());
//     static_assert(missing.rule.empty());
//
// A test of a single service need not use a whole device: partial(lay_out(...)).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/dictionary/words_of_error.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/canopen/pdo/pdo_records.hpp"

namespace canvoy {

/// An entry that a device must have, and the rule that requires it; without a rule: no entry is
/// missing.
struct MissingEntry {
  std::uint16_t index = 0;       ///< of the object; 0 if no entry is missing
  std::uint8_t sub = 0;          ///< sub-index of the entry
  std::string_view object = {};  ///< name of the object, as CiA 301 has it
  std::string_view entry = {};   ///< name of the entry; empty where the object is its only one
  /// Why it is mandatory; 36 characters at most, see words_of_error.hpp.
  std::string_view rule = {};
};

namespace detail {

/// A device with `claimed` must have `needed` as well; claimed 0: every device.
struct EntryRule {
  std::uint16_t claimed;
  MissingEntry needed;
  DataType type;
};

inline constexpr std::string_view of_every_device = "CiA 301: every device has it";
inline constexpr std::string_view of_guarding = "CiA 301: guarding needs both times";
inline constexpr std::string_view of_sync = "CiA 301: SYNC needs its COB-ID";
inline constexpr std::string_view of_array = "CiA 301: the object has this entry";

inline constexpr EntryRule entry_rules[] = {
    {0, {0x1000, 0, "Device type", "", of_every_device}, DataType::unsigned32},
    {0, {0x1001, 0, "Error register", "", of_every_device}, DataType::unsigned8},
    {0, {0x1018, 0, "Identity object", "Highest sub-index", of_every_device}, DataType::unsigned8},
    {0, {0x1018, 1, "Identity object", "Vendor-ID", of_every_device}, DataType::unsigned32},
    {0x100C, {0x100D, 0, "Life time factor", "", of_guarding}, DataType::unsigned8},
    {0x100D, {0x100C, 0, "Guard time", "", of_guarding}, DataType::unsigned16},
    {0x1003, {0x1003, 1, "Pre-defined error field", "", of_array}, DataType::unsigned32},
    {0x1006, {0x1005, 0, "COB-ID SYNC message", "", of_sync}, DataType::unsigned32},
    {0x1007, {0x1005, 0, "COB-ID SYNC message", "", of_sync}, DataType::unsigned32},
    {0x1019, {0x1005, 0, "COB-ID SYNC message", "", of_sync}, DataType::unsigned32},
    {0x1010, {0x1010, 1, "Store parameters", "", of_array}, DataType::unsigned32},
    {0x1011, {0x1011, 1, "Restore default parameters", "", of_array}, DataType::unsigned32},
    {0x1015, {0x1014, 0, "COB-ID EMCY", "", "CiA 301: 1015h needs it"}, DataType::unsigned32},
    {0x1016, {0x1016, 1, "Consumer heartbeat time", "", of_array}, DataType::unsigned32},
    {0x1020, {0x1020, 1, "Verify configuration", "Date", of_array}, DataType::unsigned32},
    {0x1020, {0x1020, 2, "Verify configuration", "Time", of_array}, DataType::unsigned32},
    {0x1028, {0x1028, 1, "Emergency consumer object", "", of_array}, DataType::unsigned32},
    {0x1029, {0x1029, 1, "Error behavior object", "", of_array}, DataType::unsigned8},
};

/// Like find_described(), but by bisection: compilers limit the number of steps.
constexpr DescribedEntry find_by_halves(const DictionaryTables& tables, unsigned index,
                                        unsigned sub) {
  std::span<const ObjectRow> objects = tables.objects;
  while (objects.size() > 1) {
    const std::size_t half = objects.size() / 2;
    objects = objects[half].index <= index ? objects.subspan(half) : objects.first(half);
  }
  if (objects.empty()) return {};
  const ObjectRow& object = objects.front();
  if (index < object.index || index - object.index >= object.count) return {};
  const std::uint32_t* initial = tables.defaults_of(object, index);
  for (const EntryShape& row : tables.entries_of(object)) {
    if (sub >= row.sub_first && sub <= row.sub_last) return {&row, *initial};
    ++initial;
  }
  return {};
}
constexpr bool is_there(const DictionaryTables& tables, unsigned index, unsigned sub) {
  return find_by_halves(tables, index, sub).row != nullptr;
}

constexpr MissingEntry find_missing_entry(const DictionaryTables& tables) {
  for (const EntryRule& rule : entry_rules) {
    if (rule.claimed != 0 && !is_there(tables, rule.claimed, 0)) continue;
    const DescribedEntry entry = find_by_halves(tables, rule.needed.index, rule.needed.sub);
    if (entry.row == nullptr || entry.row->type != rule.type) return rule.needed;
  }
  return {};
}

constexpr MissingEntry find_missing_of_error_control(const DictionaryTables& tables) {
  const bool has_one = is_there(tables, object_index::heartbeat_producer, 0) ||
                       is_there(tables, object_index::guard_time, 0);
  if (has_one) return {};
  return {0x1017, 0, "Producer heartbeat time", "", "CiA 301: heartbeat or node guarding"};
}

/// A SYNC producer is recognised by the period.
constexpr MissingEntry find_missing_of_sync(const DictionaryTables& tables) {
  const DescribedEntry sync = find_by_halves(tables, object_index::cob_id_sync, 0);
  const bool produces = sync.row != nullptr && (sync.initial & CobId::bit30) != 0;
  if (!produces || is_there(tables, object_index::sync_period, 0)) return {};
  return {0x1006, 0, "Communication cycle period", "", "CiA 301: SYNC producers have it"};
}

/// Rule for objects of which a device may have many: entries 1 to `needed` of each.
struct RecordRule {
  std::uint16_t first;
  std::uint16_t last;
  std::uint8_t needed;
  std::uint16_t partner;  ///< index of the first object of its other half; 0: none
  std::string_view object;
  std::string_view partner_object;
};
inline constexpr RecordRule record_rules[] = {
    {0x1200, 0x127F, 2, 0, "SDO server parameter", ""},
    {0x1280, 0x12FF, 3, 0, "SDO client parameter", ""},
    {0x1400, 0x15FF, 2, 0x1600, "RPDO communication parameter", "RPDO mapping parameter"},
    {0x1600, 0x17FF, 0, 0x1400, "RPDO mapping parameter", "RPDO communication parameter"},
    {0x1800, 0x19FF, 2, 0x1A00, "TPDO communication parameter", "TPDO mapping parameter"},
    {0x1A00, 0x1BFF, 0, 0x1800, "TPDO mapping parameter", "TPDO communication parameter"},
};

/// Checks the objects of one row, which are alike.
constexpr MissingEntry find_missing_of_record(const DictionaryTables& tables, const ObjectRow& row,
                                              const RecordRule& rule) {
  for (unsigned sub = 0; sub <= rule.needed; ++sub) {
    if (is_there(tables, row.index, sub)) continue;
    return {row.index, static_cast<std::uint8_t>(sub), rule.object, "", of_array};
  }
  if (rule.partner == 0) return {};
  const unsigned lowest = row.index - unsigned{rule.first};
  for (const unsigned at : {lowest, lowest + row.count - 1}) {
    if (is_there(tables, rule.partner + at, 0)) continue;
    return {static_cast<std::uint16_t>(rule.partner + at), 0, rule.partner_object, "",
            "CiA 301: a PDO has both parameters"};
  }
  const std::uint32_t type = find_by_halves(tables, row.index, 2).initial;
  const bool waits_for_sync =
      rule.needed == 2 && (is_synchronous(static_cast<std::uint8_t>(type)) ||
                           type == transmission_type::remote_synchronous);
  if (!waits_for_sync || is_there(tables, object_index::cob_id_sync, 0)) return {};
  return {0x1005, 0, "COB-ID SYNC message", "", "CiA 301: synchronous PDOs need it"};
}

constexpr MissingEntry find_missing_of_records(const DictionaryTables& tables) {
  for (const ObjectRow& row : tables.objects) {
    for (const RecordRule& rule : record_rules) {
      if (row.index < rule.first || row.index > rule.last) continue;
      const MissingEntry missing = find_missing_of_record(tables, row, rule);
      if (!missing.rule.empty()) return missing;
    }
  }
  return {};
}

}  // namespace detail

/// First entry that a device with these tables must have and lacks, or has with another type.
constexpr MissingEntry find_missing(const DictionaryTables& tables) {
  for (const auto find : {detail::find_missing_entry, detail::find_missing_of_error_control,
                          detail::find_missing_of_sync, detail::find_missing_of_records}) {
    const MissingEntry missing = find(tables);
    if (!missing.rule.empty()) return missing;
  }
  return {};
}

namespace detail {

/// Fails to compile if a device lacks a mandatory entry.
template <const auto& layout>
struct WholeDevice {
  static constexpr MissingEntry missing = [] {
    if constexpr (requires { layout.is_partial; }) return MissingEntry{};
    return find_missing(layout.tables());
  }();
  using Wrong =
      wrong::Device<numbered_words<4, missing.object.size()>(missing.index, missing.object),
                    numbered_words<2, missing.entry.size()>(missing.sub, missing.entry),
                    words<missing.rule.size()>(missing.rule)>;
  static constexpr bool is_whole = Must<missing.rule.empty(), Wrong>::hold;
};

}  // namespace detail
}  // namespace canvoy
