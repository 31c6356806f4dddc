// Entries of which another entry of the same node tells the unit (ValueInfo::unit_entry), or how
// much one count is (ValueInfo::step).
//
//     if (is_teller(0x6480, 2)) remember(bytes);
//     const Teller teller = teller_of(profile, *object.entry, 0x6481, 1);  // 6480h:02h
//     const ToldEntry grams(*object.entry, told_measure(profile, *object.entry, 0xFD02));
//     show(grams.entry().value.unit);
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "canvoy/profiles/si_unit.hpp"

namespace canvoy::decoder {

/// Where the entry is that tells; index 0: nowhere.
struct Teller {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
};
/// Whether an entry tells something of others in some profile.
bool is_teller(unsigned index, unsigned sub);
/// Which entry tells something of one that is at `index` and `sub`.
Teller teller_of(const Profile& profile, const EntryInfo& entry, unsigned index, unsigned sub);
/// The same where it is known as which object the profile describes that at `index`.
Teller teller_of(const EntryInfo& entry, const ObjectInfo& described, unsigned index, unsigned sub);

/// What one count of an entry is by `held`, the value of its teller; nothing where that is a code
/// that nobody knows, or no number of steps.
std::optional<Measure> told_measure(const Profile& profile, const EntryInfo& entry,
                                    std::uint64_t held);

/// A copy of an entry with what its teller says; without that, its counts have no unit.
class ToldEntry {
 public:
  ToldEntry(const EntryInfo& entry, const std::optional<Measure>& measure);
  ToldEntry(const ToldEntry&) = delete;
  ToldEntry& operator=(const ToldEntry&) = delete;

  const EntryInfo& entry() const { return entry_; }

 private:
  EntryInfo entry_;
  std::vector<FieldInfo> fields_;
};

}  // namespace canvoy::decoder
