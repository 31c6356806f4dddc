// Finds the entry of the same node that gives the unit (ValueInfo::unit_entry) or the size of one
// count (ValueInfo::step) of another entry.
//
//     if (is_unit_source(0x6480, 2)) remember(bytes);
//     const UnitSource teller = unit_source_of(profile, *object.entry, 0x6481, 1);  // 6480h:02h
//     const EntryWithUnit grams(*object.entry, measure_by_source(profile, *object.entry, 0xFD02));
//     show(grams.entry().value.unit);
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/profiles/model/si_unit.hpp"

namespace canvoy::decoder {

/// Address of the entry that gives the unit; index 0: none.
struct UnitSource {
  std::uint16_t index = 0;  ///< of the entry that gives it; 0: none
  std::uint8_t sub = 0;     ///< sub-index
};
/// True if in some profile this entry gives the unit of others.
bool is_unit_source(unsigned index, unsigned sub);
/// The entry that gives the unit of the entry at `index` and `sub`.
UnitSource unit_source_of(const Profile& profile, const EntryInfo& entry, unsigned index,
                          unsigned sub);
/// Like the function above, but for a known description of the object at `index`.
UnitSource unit_source_of(const EntryInfo& entry, const ObjectInfo& described, unsigned index,
                          unsigned sub);

/// Size of one count of an entry if the entry that gives it has the value `held`; nothing if that
/// is an unknown code, or no number of steps.
std::optional<Measure> measure_by_source(const Profile& profile, const EntryInfo& entry,
                                         std::uint64_t held);

/// A copy of an entry with the unit that another entry gives; without one, its counts have no unit.
class EntryWithUnit {
 public:
  /// Copies the description; the entry must outlive the copy, for its names.
  EntryWithUnit(const EntryInfo& entry, const std::optional<Measure>& measure);
  EntryWithUnit(const EntryWithUnit&) = delete;
  EntryWithUnit& operator=(const EntryWithUnit&) = delete;

  /// The copy; valid as long as this object.
  const EntryInfo& entry() const { return entry_; }

 private:
  EntryInfo entry_;
  std::vector<FieldInfo> fields_;
};

}  // namespace canvoy::decoder
