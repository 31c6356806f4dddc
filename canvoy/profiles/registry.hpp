// All profiles by number, and their objects by name, for tools that get them at run time.
//
//     const Profile* profile = find_profile(0x0000'01A3);  // CiA 419, from 1000h of a node
//     std::optional<ObjectAddress> where = find_address(*profile, "battery temperature");
//     where->index;                                        // 6010h
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// All profiles, sorted by number; CiA 301 is the first.
std::span<const Profile* const> all_profiles();
/// CiA 301, which applies to each node.
const Profile& base_profile();

/// The profile that a device type (1000h) names in its low word, or null. Profiles that are built
/// on another one differ from it by the other bits (Profile::device_types).
const Profile* find_profile(std::uint32_t device_type);

/// The profile of this name, or null: `447-3`, `447`, `CiA 447-3`.
const Profile* find_profile(std::string_view name);
/// `447-3`
std::string_view short_name(const Profile& profile);

/// The description of an object in a node of this profile: of the profile, of the profile on which
/// it is built, or of CiA 301 or 302. Null if none of them has the index.
const ObjectInfo* find_description(const Profile& profile, unsigned index);

/// Location of an entry, with its descriptions.
struct ObjectAddress {
  std::uint16_t index = 0;             ///< of the object
  std::uint8_t sub = 0;                ///< 0 where the input gives none
  const ObjectInfo* object = nullptr;  ///< null: the profile has no such index
  const EntryInfo* entry = nullptr;    ///< null: the profile has no such sub-index
};
/// Parses user input: an index with or without a sub-index (`6010`, `6020h:02h`, `0x6020 2`, all
/// hexadecimal), or names as printed in the specification, in any case, with any blanks,
/// underscores and hyphens (`battery temperature`, `Battery_Parameters:AH-capacity`). The name of
/// an entry alone is sufficient if only one object has it. Nothing: no such name, several of them,
/// or no index.
std::optional<ObjectAddress> find_address(const Profile& profile, std::string_view text);

/// True if two names are equal except for case, blanks, underscores and hyphens.
bool same_name(std::string_view a, std::string_view b);
/// Compares like same_name(), where `#` in the pattern stands for a number. Returns that number, or
/// 0 if the text or the pattern has none. Nothing: the names differ.
std::optional<unsigned> match_name(std::string_view pattern, std::string_view text);

}  // namespace canvoy
