// Changes of the rows of a paper device that break one rule of a profile each: by the name of the
// case that must find them.
//
//     for (const PaperDevice::Change& change : ways_to_break(cia419::profile, "419-6001-type")) ...
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/testing/paper_device.hpp"

namespace canvoy::conformance {

using Changes = std::vector<PaperDevice::Change>;

/// What the name of a case says: `419-6001-type`, `417-4-tpdo-259b-can-id`.
struct CaseName {
  std::uint16_t index = 0;             ///< of the object, or of the parameters of the PDO
  std::string_view row = {};           ///< `type`, `can-id`
  const ObjectInfo* object = nullptr;  ///< null for a PDO
};
inline std::optional<CaseName> parse_case(const Profile& profile, std::string_view id) {
  id.remove_prefix(short_name(profile).size() + 1);
  CaseName name;
  unsigned number = 0;
  const bool is_tpdo = id.starts_with("tpdo-");
  const bool is_pdo = is_tpdo || id.starts_with("rpdo-");
  if (is_pdo) id.remove_prefix(5);
  const auto [end, error] =
      std::from_chars(id.data(), id.data() + id.size(), number, is_pdo ? 10 : 16);
  if (error != std::errc{}) return std::nullopt;
  id.remove_prefix(id.find('-') + 1);
  name.row = id;
  const unsigned first =
      is_tpdo ? object_index::tpdo_parameter : unsigned{object_index::rpdo_parameter};
  name.index = static_cast<std::uint16_t>(is_pdo ? first + number - 1 : number);
  if (!is_pdo) name.object = find_object(profile, name.index);
  return name;
}

/// Sets the default of each entry in turn to the numbers that `bad` gives for it.
template <class Bad>
Changes wrong_defaults(const ObjectInfo& object, std::uint16_t index, Bad bad) {
  Changes changes;
  for (const EntryInfo& entry : object.entries()) {
    changes.push_back([&entry, index, bad](PaperRows& rows) {
      for (EntryRow& row : rows.at(index)) {
        if (row.sub_first != entry.sub_first) continue;
        if (const auto number = bad(entry, row)) row.initial = *number;
      }
    });
  }
  return changes;
}

/// A number of the entry that is reserved or beyond its range, and is not printed as its default.
inline std::optional<std::int64_t> reserved_number(const EntryInfo& entry, const EntryRow& row) {
  if (!is_integer(entry.type)) return std::nullopt;
  const auto is_printed = [&entry](std::int64_t number) {
    return printed_default(entry) == number;
  };
  if (entry.fields.empty()) {
    for (const NamedValue& each : entry.value.names) {
      if (each.meaning == Meaning::reserved) return is_printed(each.first) ? each.last : each.first;
    }
    if (entry.value.limits.kind != Limits::Kind::absolute) return std::nullopt;
    const NumberRange all = range_of_type(bit_length(entry.type), is_signed(entry.type));
    for (const std::int64_t each : {entry.value.limits.low - 1, entry.value.limits.high + 1}) {
      const bool is_named =
          find_name(entry.value, each, bit_length(entry.type), is_signed(entry.type)) != nullptr;
      if (all.contains(each) && !is_named && !is_printed(each)) return each;
    }
    return std::nullopt;
  }
  for (const FieldInfo& field : entry.fields) {
    for (const NamedValue& each : field.value.names) {
      if (each.meaning != Meaning::reserved) continue;
      const auto number = static_cast<std::int64_t>(
          insert(static_cast<std::uint64_t>(row.initial), bits_of(field), each.last));
      if (reserved_field(entry, number) != nullptr && !is_printed(number)) return number;
    }
    const Limits& limits = field.value.limits;
    if (limits.kind != Limits::Kind::absolute) continue;
    for (const std::int64_t each : {limits.low - 1, limits.high + 1}) {
      const auto number = static_cast<std::int64_t>(
          insert(static_cast<std::uint64_t>(row.initial), bits_of(field), each));
      if (reserved_field(entry, number) != nullptr && !is_printed(number)) return number;
    }
  }
  return std::nullopt;
}

/// Another number than the printed default that is allowed as well.
inline std::optional<std::int64_t> other_number(const EntryInfo& entry, const EntryRow& row) {
  if (!has_default_after_reset(entry)) return std::nullopt;
  for (const std::int64_t each : {row.initial + 1, row.initial - 1, std::int64_t{0},
                                  entry.value.limits.low, entry.value.limits.high}) {
    const std::int64_t allowed = with_nothing_reserved(entry, each);
    const unsigned bits = bit_length(entry.type);
    const bool is_other = number_of(static_cast<std::uint64_t>(allowed), bits, false) !=
                          number_of(static_cast<std::uint64_t>(row.initial), bits, false);
    if (is_other) return allowed;
  }
  return std::nullopt;
}

inline Changes other_types(const ObjectInfo& object, std::uint16_t index) {
  Changes changes;
  for (const EntryInfo& entry : object.entries()) {
    if (byte_length(entry.type) == 0) continue;
    changes.push_back([&entry, index](PaperRows& rows) {
      EntryRow& row = row_at(rows, index, entry.sub_first);
      const bool is_byte = byte_length(row.type) == 1;
      row.type = is_byte ? DataType::unsigned16 : DataType::unsigned8;
      row.traits = EntryTraits::none;
      row.initial &= 0xFF;
    });
  }
  return changes;
}

/// Each entry with another access: what is read only is written, and what is read is not.
inline Changes other_accesses(const ObjectInfo& object, std::uint16_t index) {
  Changes changes;
  for (const EntryInfo& entry : object.entries()) {
    for (const Access access : {Access::rw, Access::wo}) {
      changes.push_back([&entry, index, access](PaperRows& rows) {
        row_at(rows, index, entry.sub_first).access = access;
      });
    }
  }
  return changes;
}

inline PaperDevice::Change without_range(std::uint16_t index) {
  return [index](PaperRows& rows) {
    for (EntryRow& row : rows.at(index)) row.traits = EntryTraits::none;
  };
}

/// The entry refuses its code for "no value".
inline Changes without_sentinel(const ObjectInfo& object, std::uint16_t index) {
  Changes changes;
  for (const EntryInfo& entry : object.entries()) {
    const auto code = sentinel_of(entry);
    if (!code) continue;
    changes.push_back([&entry, index, code](PaperRows& rows) {
      EntryRow& row = row_at(rows, index, entry.sub_first);
      const unsigned bits = bit_length(entry.type);
      const NumberRange all = range_of_type(bits, is_signed(entry.type));
      const std::int64_t number =
          number_of(static_cast<std::uint64_t>(*code), bits, is_signed(entry.type));
      const Limits& limits = entry.value.limits;
      const bool is_limited = limits.kind == Limits::Kind::absolute;
      row.low = is_limited ? limits.low : all.low;
      row.high = is_limited ? limits.high : all.high;
      const bool is_within = number >= row.low && number <= row.high;
      if (is_within && number < 0) row.low = number + 1;
      if (is_within && number >= 0) row.high = number - 1;
      row.traits = EntryTraits::limited;
    });
  }
  return changes;
}

inline Changes other_pdos(std::uint16_t parameter, std::string_view row) {
  const auto mapping = static_cast<std::uint16_t>(parameter + 0x200);
  if (row == "can-id" || row == "off") {
    return {[parameter](PaperRows& rows) {
      // What is stored in a device may be its own choice.
      rows.erase(object_index::store_parameters);
      rows.erase(object_index::restore_parameters);
      EntryRow& cob_id = row_at(rows, parameter, 1);
      cob_id.initial = (cob_id.initial & 0x7FF) == 0x1A0 ? 0x1A1 : 0x1A0;
      cob_id.traits = EntryTraits::none;
    }};
  }
  if (row == "type") {
    return {[parameter](PaperRows& rows) { row_at(rows, parameter, 2).initial = 1; }};
  }
  if (row == "mpdo") {
    return {[parameter, mapping](PaperRows& rows) {
      row_at(rows, parameter, 1).initial &= ~std::int64_t{CobId::bit31};
      row_at(rows, mapping, 0).initial = 0;
    }};
  }
  // The error register behind its entries, or in the place of the last.
  return {[mapping](PaperRows& rows) {
    std::vector<EntryRow>& entries = rows.at(mapping);
    constexpr std::int64_t error_register = 0x1001'0008;
    if (entries.size() > 2) {
      entries.back().initial = error_register;
      return;
    }
    EntryRow more = entries.back();
    more.sub_first = more.sub_last = static_cast<std::uint8_t>(more.sub_last + 1);
    more.initial = error_register;
    entries.push_back(more);
    entries.front().initial += 1;
  }};
}

/// Devices that break what the case is about; one of them at least must be found by it.
inline Changes ways_to_break(const Profile& profile, std::string_view id) {
  const auto name = parse_case(profile, id);
  if (!name) return {};
  if (name->object == nullptr && name->index >= object_index::rpdo_parameter) {
    return other_pdos(name->index, name->row);
  }
  const std::uint16_t index = name->index;
  static std::map<const Profile*, ObjectInfo> device_types;
  const ObjectInfo* object = name->object;
  if (object == nullptr) {
    ObjectInfo& made = device_types[&profile];
    made = cia301::device_type_object;
    made.entry.fields = profile.device_type;
    object = &made;
  }
  if (name->row == "there") return {[index](PaperRows& rows) { rows.erase(index); }};
  if (name->row == "type") return other_types(*object, index);
  if (name->row == "access") return other_accesses(*object, index);
  if (name->row == "range") return {without_range(index)};
  if (name->row == "sentinel") return without_sentinel(*object, index);
  if (name->row == "default") return wrong_defaults(*object, index, other_number);
  return wrong_defaults(*object, index, reserved_number);
}

/// True if what breaks the rule of `id` breaks that of `other` by its nature as well: a reserved
/// default is not the printed one, and a reserved transmission type neither.
inline bool breaks_as_well(const Profile& profile, std::string_view id, std::string_view other) {
  const auto name = parse_case(profile, id);
  const auto name_of_other = parse_case(profile, other);
  if (!name || !name_of_other || name->index != name_of_other->index) return false;
  const bool is_about_value = name->row == "value" || name->row == "fields";
  const bool is_printed = name_of_other->row == "default" || name_of_other->row == "type";
  const bool is_of_pdo = name_of_other->object == nullptr;
  return is_about_value && is_printed && is_of_pdo == (name_of_other->row == "type");
}

}  // namespace canvoy::conformance
