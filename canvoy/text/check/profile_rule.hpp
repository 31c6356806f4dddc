// One object of a profile as a rule for a device: what it must have, by its virtual device or by
// the object itself, and the judges of its entries. profile_cases.cpp makes cases of them.
//
//     const Verdict verdict = judge_type(bench, {&cia419::profile,
//     &cia419::battery_status_object});
#pragma once

#include <optional>

#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

/// An object of a profile, and its location.
struct Ruled {
  const Profile* profile;    ///< that has the object
  const ObjectInfo* object;  ///< in the profile
  std::uint16_t above = 0;   ///< for a profile with several blocks: offset from the first block

  /// In the dictionary of the device.
  std::uint16_t index() const { return static_cast<std::uint16_t>(object->index + above); }
  /// True for an object of the communication profile (1000h to 1FFFh).
  bool is_communication() const;
};

/// The rule for the object: from its virtual device, or from the object itself.
struct Claim {
  const VirtualDeviceInfo* device = nullptr;  ///< null: the rule is that of the object itself
  const DeviceObject* as = nullptr;           ///< the object in this virtual device; or null
  bool is_mandatory = false;                  ///< each such device must have it
};
/// Reads 1000h.
Claim claim_of(Bench& bench, const Ruled& ruled);
/// Access on the bus to an entry.
Access access_of_claim(const Claim& claim, const ObjectInfo& object, const EntryInfo& entry);

/// The number that the profile prints as the default of an entry of an integer type; nothing if it
/// prints none, or one that depends on the node-ID or the device.
std::optional<std::int64_t> printed_default(const EntryInfo& entry);
/// True if the field names some of its values as reserved, or has absolute limits.
bool has_reserved_values(const FieldInfo& field);
/// The code of an entry for "no value" or "do not care"; nothing if it has none, or if it is one of
/// the usual values.
std::optional<std::int64_t> sentinel_of(const EntryInfo& entry);
/// True for an entry of which the value after a reset is the printed default: a process value that
/// others write.
bool has_default_after_reset(const EntryInfo& entry);
/// True if the entry is written, and its type has a number beyond its range.
bool has_range(const EntryInfo& entry);
/// True for a plain number of which some values are reserved, or out of range.
bool has_unknown_values(const EntryInfo& entry);
/// True if the access of the entry is not the maker's choice.
bool has_access_rule(const EntryInfo& entry);
/// True if the access is that of the virtual device, which provides or consumes the entry.
bool has_access_by_device(const EntryInfo& entry);

// Judges of an object; each names the first violation.

/// A mandatory object exists.
Verdict judge_there(Bench& bench, const Ruled& ruled);
/// Values have the length of their type.
Verdict judge_type(Bench& bench, const Ruled& ruled);
/// Entries are read and written as the profile says. Only the value that was read is written.
Verdict judge_access(Bench& bench, const Ruled& ruled);
/// Numbers without fields are neither reserved nor out of their range.
Verdict judge_value(Bench& bench, const Ruled& ruled);
/// Fields of numbers are neither reserved nor out of their range.
Verdict judge_fields(Bench& bench, const Ruled& ruled);
/// Numbers beyond the range are refused.
Verdict judge_range(Bench& bench, const Ruled& ruled);
/// The code for "no value" is taken.
Verdict judge_sentinel(Bench& bench, const Ruled& ruled);
/// The value after a reset is the printed default.
Verdict judge_default(Bench& bench, const Ruled& ruled);

}  // namespace canvoy::conformance
