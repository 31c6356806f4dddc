#include "canvoy/decoder/unit_source.hpp"

#include <algorithm>
#include <bitset>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

/// Address in the text of the profile: for the first object with this unit.
UnitSource written_teller(const ValueInfo& value) {
  if (value.unit_entry.index != 0) return {value.unit_entry.index, value.unit_entry.sub};
  return {value.step.index, value.step.sub};
}

/// The value of an entry, or of one of its fields, with a unit in another entry; or null.
const ValueInfo* reported_value(const EntryInfo& entry) {
  if (written_teller(entry.value).index != 0) return &entry.value;
  for (const FieldInfo& field : entry.fields) {
    if (written_teller(field.value).index != 0) return &field.value;
  }
  return nullptr;
}

/// Entries that give units, for `count` objects in each block of a profile.
struct Tellers {
  UnitSource first;
  unsigned count = 1;
  unsigned blocks = 1;
  unsigned block_pitch = 1;

  bool contains(unsigned index, unsigned sub) const {
    if (index < first.index || (first.sub == 0 ? sub == 0 : sub != first.sub)) return false;
    const unsigned offset = index - first.index;
    return offset / block_pitch < blocks && offset % block_pitch < count;
  }
};

std::vector<Tellers> find_tellers() {
  std::vector<Tellers> all;
  for (const Profile* profile : all_profiles()) {
    for (const ObjectInfo* object : profile->objects) {
      for (const EntryInfo& entry : object->entries()) {
        const ValueInfo* value = reported_value(entry);
        if (value == nullptr) continue;
        const Tellers tellers = {written_teller(*value), object->count, profile->block_count,
                                 profile->block_pitch};
        const bool is_known = std::ranges::any_of(all, [&tellers](const Tellers& known) {
          return known.first.index == tellers.first.index && known.first.sub == tellers.first.sub &&
                 known.count == tellers.count;
        });
        if (!is_known) all.push_back(tellers);
      }
    }
  }
  return all;
}

/// The entries that give units, of all profiles. It is used for each SDO transfer of a log: most
/// indices are not in it.
class TellerTable {
 public:
  TellerTable() {
    for (const Tellers& tellers : all_) {
      for (unsigned block = 0; block < tellers.blocks; ++block) {
        const unsigned first = tellers.first.index + block * tellers.block_pitch;
        for (unsigned i = 0; i < tellers.count; ++i) indices_.set(first + i);
      }
    }
  }
  bool contains(unsigned index, unsigned sub) const {
    if (!indices_.test(index)) return false;
    return std::ranges::any_of(
        all_, [&](const Tellers& tellers) { return tellers.contains(index, sub); });
  }

 private:
  std::vector<Tellers> all_ = find_tellers();
  std::bitset<0x1'0000> indices_;
};

/// The objects of a data sheet are separate: the profile gives the offset from the first.
const Profile& describer_of(const Profile& profile) {
  return profile.base == nullptr ? profile : *profile.base;
}

/// Ratio of the size of one count to the default.
std::optional<Measure> step_measure(const Profile& profile, const ValueInfo& value,
                                    std::uint64_t held) {
  const ObjectInfo* object = find_description(describer_of(profile), value.step.index);
  const EntryInfo* entry = object == nullptr ? nullptr : find_entry(*object, value.step.sub);
  constexpr std::uint64_t held_max = 0xFFFF'FFFF;
  if (entry == nullptr || entry->initial.number <= 0 || held == 0 || held > held_max) {
    return std::nullopt;
  }
  return Measure{.unit = value.unit,
                 .scale = {.numerator = static_cast<std::int64_t>(held),
                           .denominator = entry->initial.number}};
}

}  // namespace

bool is_unit_source(unsigned index, unsigned sub) {
  static const TellerTable table;
  return table.contains(index, sub);
}

UnitSource unit_source_of(const EntryInfo& entry, const ObjectInfo& described, unsigned index,
                          unsigned sub) {
  const ValueInfo* value = reported_value(entry);
  if (value == nullptr) return {};
  UnitSource teller = written_teller(*value);
  teller.index = static_cast<std::uint16_t>(teller.index + index - described.index);
  if (teller.sub == 0) teller.sub = static_cast<std::uint8_t>(sub);
  return teller;
}

UnitSource unit_source_of(const Profile& profile, const EntryInfo& entry, unsigned index,
                          unsigned sub) {
  if (reported_value(entry) == nullptr) return {};
  const ObjectInfo* described = find_description(describer_of(profile), index);
  return described == nullptr ? UnitSource{} : unit_source_of(entry, *described, index, sub);
}

std::optional<Measure> measure_by_source(const Profile& profile, const EntryInfo& entry,
                                         std::uint64_t held) {
  const ValueInfo* value = reported_value(entry);
  if (value == nullptr) return std::nullopt;
  if (value->unit_entry.index != 0) return measure_of(value->unit_entry, held);
  return step_measure(profile, *value, held);
}

EntryWithUnit::EntryWithUnit(const EntryInfo& entry, const std::optional<Measure>& measure)
    : entry_(entry), fields_(entry.fields.begin(), entry.fields.end()) {
  const auto tell = [&measure](ValueInfo& value) {
    if (written_teller(value).index == 0) return;
    if (!measure) value.scale = {};
    value = with_measure(value, measure.value_or(Measure{}));
  };
  tell(entry_.value);
  for (FieldInfo& field : fields_) tell(field.value);
  entry_.fields = Items<FieldInfo>(fields_.data(), fields_.size());
}

}  // namespace canvoy::decoder
