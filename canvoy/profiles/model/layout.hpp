// The dictionary tables of a node, made at compile time from the description of its kind.
//
//     constexpr auto layout = lay_out_device<my_charger>();
//     DeviceNode<layout> device(port, 5);
//
// An inconsistent description does not compile. The first error names object, entry and reason: a
// default outside its range, a mapped object that does not exist or cannot be mapped, a mapping of
// the wrong length or of more than 8 bytes, a missing mandatory object of the profile, gaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/words_of_error.hpp"

namespace canvoy {

namespace detail {

/// Keeps the first reason.
class Reason {
 public:
  constexpr void blame(std::string_view reason) {
    if (text_.empty()) text_ = reason;
  }
  constexpr std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

/// Access of SDO and PDO to an entry with this access and mapping.
constexpr Access access_on_bus(Access access, Mapping mapping) {
  constexpr Access directions = Access::tpdo | Access::rpdo;
  const bool direction_given =
      (static_cast<unsigned>(access) & static_cast<unsigned>(directions)) != 0;
  if (mapping == Mapping::no || direction_given) return access;
  if (allows(access, Access::sdo_read)) access = access | Access::tpdo;
  if (allows(access, Access::sdo_write)) access = access | Access::rpdo;
  return access;
}

constexpr Access access_of(const Part& part, const EntryInfo& entry) {
  const bool mirrored = part.is_consumed() && entry.consumer_access != Access::none;
  const bool by_device = entry.access_by_device && part.device_access() != Access::none;
  const Part::Change* change = part.find_change(Part::Change::Kind::access, entry.sub_first);
  const Access access = change != nullptr ? change->access
                        : by_device       ? part.device_access()
                        : mirrored        ? entry.consumer_access
                                          : entry.access;
  if (part.is_constant() && allows(access, Access::sdo_read)) return Access::const_;
  return access_on_bus(access, entry.mapping);
}

/// The value of an entry of fields before it is set: "no value" in each field, the fixed contents
/// in reserved bits, and 0 where a field has no such code.
constexpr std::int64_t resting_value(const EntryInfo& entry) {
  std::uint64_t whole = 0;
  for (const FieldInfo& field : entry.fields) {
    if (!field.when.empty()) continue;
    const NamedValue* nothing = find_invalid(field.value);
    for (const NamedValue& named : field.value.names) {
      if (named.meaning == Meaning::padding) nothing = &named;
    }
    if (nothing != nullptr) whole = insert(whole, bits_of(field), nothing->first);
  }
  return static_cast<std::int64_t>(whole);
}

constexpr Default initial_of(const Part& part, const EntryInfo& entry) {
  const Part::Change* change = part.find_change(Part::Change::Kind::initial, entry.sub_first);
  if (change != nullptr) return change->initial;
  if (part.is_consumed() && entry.consumer_initial) return entry.consumer_initial;
  if (entry.initial) return entry.initial;
  if (const NamedValue* invalid = find_invalid(entry.value)) return invalid->first;
  if (const std::int64_t resting = resting_value(entry); resting != 0) return resting;
  const Limits& limits = entry.value.limits;
  const bool zero_is_refused =
      limits.kind == Limits::Kind::absolute && (limits.low > 0 || limits.high < 0);
  return zero_is_refused ? Default(limits.low) : Default();
}

/// Sets the limits of a row from the described limits and the named values beside them. A row has
/// room for one sentinel; further ones widen the limits, so that no legal value is refused.
constexpr void limit(EntryRow& row, const EntryInfo& entry, Reason& reason) {
  if (entry.value.limits.kind != Limits::Kind::absolute) return;
  if (!is_integer(entry.type)) reason.blame("limits of a type that has no order");
  row.traits = row.traits | EntryTraits::limited;
  row.low = entry.value.limits.low;
  row.high = entry.value.limits.high;
  if (row.low > row.high) reason.blame("limits are exchanged");
  for (const NamedValue& named : entry.value.names) {
    if (named.meaning == Meaning::reserved) continue;
    const auto number = [&](std::int64_t pattern) {
      return number_of(static_cast<std::uint64_t>(pattern), bit_length(entry.type),
                       is_signed(entry.type));
    };
    const std::int64_t first = number(named.first);
    const std::int64_t last = number(named.last);
    if (first >= row.low && last <= row.high) continue;
    if (first == last && !has(row.traits, EntryTraits::has_sentinel)) {
      row.traits = row.traits | EntryTraits::has_sentinel;
      row.sentinel = first;
    } else {
      row.low = first < row.low ? first : row.low;
      row.high = last > row.high ? last : row.high;
    }
  }
}

constexpr void set_initial(EntryRow& row, const Default& initial, const Part& part,
                           Reason& reason) {
  switch (initial.kind) {
    case Default::Kind::none:
      break;
    case Default::Kind::text:
      if (!is_string(row.type)) reason.blame("a text is the default of a number");
      if (initial.text.size() > row.capacity) reason.blame("a default is too long");
      row.initial_text = initial.text;
      break;
    case Default::Kind::highest_sub:
      row.initial = part.highest_sub();
      if (initial.number != 0 && initial.number != row.initial) {
        reason.blame("not the printed highest sub-index");
      }
      break;
    case Default::Kind::plus_node_id:
      row.traits = row.traits | EntryTraits::plus_node_id;
      row.initial = initial.number;
      break;
    case Default::Kind::number:
      if (is_string(row.type)) reason.blame("a number as default of a string");
      row.initial = initial.number;
      break;
  }
}

constexpr void check_initial(const EntryRow& row, Reason& reason) {
  if (!is_integer(row.type)) return;
  const unsigned bits = bit_length(row.type);
  const std::int64_t number =
      number_of(static_cast<std::uint64_t>(row.initial), bits, is_signed(row.type));
  // -1 and FFFFh both denote the same 16 bits.
  const std::int64_t pattern =
      number_of(static_cast<std::uint64_t>(row.initial), bits, !is_signed(row.type));
  if (number != row.initial && pattern != row.initial) {
    reason.blame("a default does not fit its type");
  }
  const bool is_sentinel = has(row.traits, EntryTraits::has_sentinel) && number == row.sentinel;
  const bool outside =
      has(row.traits, EntryTraits::limited) &&
      (is_signed(row.type)
           ? number < row.low || number > row.high
           : static_cast<std::uint64_t>(number) < static_cast<std::uint64_t>(row.low) ||
                 static_cast<std::uint64_t>(number) > static_cast<std::uint64_t>(row.high));
  if (outside && !is_sentinel) reason.blame("a default is out of its range");
}

/// A value that a PDO carries by default is a process value, not a parameter: storage does not keep
/// it, unless the device says otherwise.
constexpr bool is_stored(const Part& part, const EntryInfo& entry, Access access) {
  if (part.retention() != Part::Retention::by_mapping) {
    return part.retention() == Part::Retention::stored;
  }
  return entry.mapping != Mapping::by_default ||
         (!allows(access, Access::tpdo) && !allows(access, Access::rpdo));
}

constexpr EntryRow row_of(const Part& part, const EntryInfo& entry, Reason& reason) {
  EntryRow row;
  row.sub_first = entry.sub_first;
  row.sub_last = part.last_sub(entry);
  row.type = entry.type;
  row.access = access_of(part, entry);
  if (!allows(row.access, Access::sdo_read) && !allows(row.access, Access::sdo_write)) {
    reason.blame("an entry without access");
  }
  row.capacity = is_string(entry.type) && part.capacity() != 0 ? part.capacity() : entry.capacity;
  if (!is_stored(part, entry, row.access)) row.traits = row.traits | EntryTraits::not_stored;
  if (is_string(entry.type) && entry.capacity == 0) {
    reason.blame("a string without a capacity");
  }
  limit(row, entry, reason);
  set_initial(row, initial_of(part, entry), part, reason);
  check_initial(row, reason);
  return row;
}

constexpr void check_object(const ObjectInfo& object, Reason& reason) {
  const bool is_variable = object.code == ObjectCode::var || object.code == ObjectCode::domain;
  if (object.count == 0 || object.index == 0) reason.blame("an object without an index");
  if (object.name.empty()) reason.blame("an object without a name");
  if (is_variable != object.subs.empty()) {
    reason.blame("variables have no subs, others do");
  }
  if (is_variable) return;
  const EntryInfo& first = object.subs[0];
  if (first.sub_first != 0 || first.last_sub() != 0 || first.type != DataType::unsigned8) {
    reason.blame("sub-index 00h is an Unsigned8");
  }
}

template <std::size_t capacity>
constexpr std::size_t count_entries(const DeviceDescription<capacity>& device) {
  std::size_t count = 0;
  for (const Part& part : device) {
    for (const EntryInfo& entry : part.object().entries()) count += part.has(entry) ? 1U : 0U;
  }
  return count;
}

/// The row that describes an entry, or null. Each half is searched in turn, since compilers limit
/// the number of evaluation steps.
constexpr const EntryRow* find_row(std::span<const ObjectRow> objects,
                                   std::span<const EntryRow> entries, unsigned index,
                                   unsigned sub) {
  while (objects.size() > 1) {
    const std::size_t half = objects.size() / 2;
    objects = objects[half].index <= index ? objects.subspan(half) : objects.first(half);
  }
  if (objects.empty()) return nullptr;
  const ObjectRow& object = objects.front();
  if (index < object.index || index - object.index >= object.count) return nullptr;
  entries = entries.subspan(object.entry_first, object.entry_count);
  while (entries.size() > 1) {
    const std::size_t half = entries.size() / 2;
    entries = entries[half].sub_first <= sub ? entries.subspan(half) : entries.first(half);
  }
  if (entries.empty()) return nullptr;
  const EntryRow& row = entries.front();
  return sub >= row.sub_first && sub <= row.sub_last ? &row : nullptr;
}

constexpr unsigned check_mapped(std::span<const ObjectRow> objects,
                                std::span<const EntryRow> entries, const MappingValue& mapping,
                                Access direction, Reason& reason) {
  if (direction == Access::rpdo && mapping.is_dummy()) return mapping.bits;
  const EntryRow* row = find_row(objects, entries, mapping.index, mapping.sub);
  if (row == nullptr) {
    reason.blame("a PDO maps what is not there");
  } else if (!allows(row->access, direction)) {
    reason.blame("the mapped entry cannot be mapped");
  } else if (bit_length(row->type) != mapping.bits) {
    reason.blame("not the length of the mapped entry");
  }
  return mapping.bits;
}

/// Location and kind of a fault.
struct DescriptionFault {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::string_view object = {};
  std::string_view entry = {};
  std::string_view reason = {};

  /// Keeps the first fault.
  constexpr void note(const Part& part, unsigned wrong_sub, const Reason& why) {
    if (!reason.empty() || why.text().empty()) return;
    const EntryInfo* info = find_entry(part.object(), wrong_sub);
    *this = {part.index(), static_cast<std::uint8_t>(wrong_sub), part.object().name,
             info == nullptr ? std::string_view() : info->name, why.text()};
  }
};

/// Checks the mapping of one PDO that holds after power-on. Returns the sub-index that is wrong, if
/// any.
constexpr unsigned check_mapping(std::span<const ObjectRow> objects,
                                 std::span<const EntryRow> entries, const ObjectRow& object,
                                 Reason& reason) {
  const Access direction = is_rpdo_mapping(object.index) ? Access::rpdo : Access::tpdo;
  const EntryRow* number = find_row(objects, entries, object.index, 0);
  // Values above 64 mark multiplexed PDOs (FEh, FFh), which have no mapping of this kind.
  if (number == nullptr || number->initial > pdo_bits_max) return 0;
  unsigned bits = 0;
  for (unsigned sub = 1; sub <= static_cast<unsigned>(number->initial); ++sub) {
    const EntryRow* row = find_row(objects, entries, object.index, sub);
    if (row == nullptr) {
      reason.blame("more entries than the mapping has");
      return 0;
    }
    bits += check_mapped(objects, entries, MappingValue(static_cast<std::uint32_t>(row->initial)),
                         direction, reason);
    if (bits > pdo_bits_max) reason.blame("a PDO maps more than 8 bytes");
    if (!reason.text().empty()) return sub;
  }
  return 0;
}

/// Checks the mandatory objects of the profiles.
template <std::size_t capacity>
constexpr DescriptionFault find_missing_of_profiles(const DeviceDescription<capacity>& device) {
  for (const Profile* profile : device.profiles()) {
    if (profile == nullptr) continue;
    for (const ObjectInfo* object : profile->objects) {
      if (object->category == Category::mandatory && device.find(object->index) == nullptr) {
        return {object->index, 0, object->name, {}, "a mandatory object of the profile"};
      }
    }
  }
  return {};
}

/// The tables of a description, and its first fault.
template <class Tables>
struct LaidOut {
  Tables tables;
  DescriptionFault fault;
};

template <const auto& device>
constexpr auto lay_out_parts() {
  std::array<ObjectRow, device.size()> objects{};
  std::array<EntryRow, count_entries(device)> entries{};
  std::size_t object_position = 0;
  std::size_t entry_position = 0;
  DescriptionFault fault;
  for (const Part& part : device) {
    Reason of_object;
    check_object(part.object(), of_object);
    fault.note(part, 0, of_object);
    ObjectRow& object = objects[object_position++];
    object.index = part.index();
    object.count = part.count();
    for (const EntryInfo& entry : part.object().entries()) {
      if (!part.has(entry)) continue;
      Reason of_entry;
      entries[entry_position++] = row_of(part, entry, of_entry);
      fault.note(part, entry.sub_first, of_entry);
      ++object.entry_count;
    }
  }
  const auto tables = lay_out(objects, entries);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!is_pdo_mapping(objects[i].index)) continue;
    Reason of_mapping;
    const unsigned sub = check_mapping(tables.objects, entries, objects[i], of_mapping);
    fault.note(device.begin()[i], sub, of_mapping);
  }
  if (fault.reason.empty()) fault = find_missing_of_profiles(device);
  return LaidOut<std::remove_const_t<decltype(tables)>>{tables, fault};
}

}  // namespace detail

/// Tables that hold their description: see DeviceValues.
template <const auto& device, class Tables>
struct DeviceLayout : Tables {
  static constexpr const auto& description = device;  ///< of the device
};

/// The tables of the kind of node that `device` describes.
template <const auto& device>
constexpr auto lay_out_device() {
  constexpr auto made = detail::lay_out_parts<device>();
  constexpr detail::DescriptionFault fault = made.fault;
  using Wrong =
      wrong::Device<detail::numbered_words<4, fault.object.size()>(fault.index, fault.object),
                    detail::numbered_words<2, fault.entry.size()>(fault.sub, fault.entry),
                    detail::words<fault.reason.size()>(fault.reason)>;
  static_assert(Must<fault.reason.empty(), Wrong>::hold);
  return DeviceLayout<device, std::remove_cvref_t<decltype(made.tables)>>{made.tables};
}

}  // namespace canvoy
