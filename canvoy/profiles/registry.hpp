// All profiles by number, and their objects by name: for tools, which learn at run time what they
// look at.
//
//     const Profile* profile = find_profile(0x0000'01A3);  // CiA 419, from 1000h of a node
//     std::optional<ObjectAddress> where = find_address(*profile, "battery temperature");
//     where->index;                                        // 6010h
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "canvoy/profiles/description.hpp"

namespace canvoy {

/// In the order of their numbers; CiA 301 is the first.
std::span<const Profile* const> all_profiles();
/// CiA 301: what every node has.
const Profile& base_profile();

/// The profile that a device type (1000h) names in its low word, or null. Profiles that are built
/// on another one are told from it by the other bits (Profile::device_types).
const Profile* find_profile(std::uint32_t device_type);

/// The profile of this name, or null: `447-3`, `447`, `CiA 447-3`.
const Profile* find_profile(std::string_view name);
/// `447-3`
std::string_view short_name(const Profile& profile);

/// The description of an object in a node of this profile: the profile's own, or that of the
/// profile which it is built on, or that of CiA 301 or 302; null where none knows the index.
const ObjectInfo* find_description(const Profile& profile, unsigned index);

/// Where an entry is, and what is known of it.
struct ObjectAddress {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  const ObjectInfo* object = nullptr;  ///< null: the profile does not know the index
  const EntryInfo* entry = nullptr;    ///< null: the profile does not know the sub-index
};
/// Reads what people write: an index with or without a sub-index (`6010`, `6020h:02h`, `0x6020 2`,
/// all hexadecimal), or names as the specification prints them, in any case, with blanks,
/// underscores and hyphens as one likes (`battery temperature`, `Battery_Parameters:AH-capacity`).
/// The name of an entry alone will do where only one object has it. Nothing: no such name, several
/// of them, or no index.
std::optional<ObjectAddress> find_address(const Profile& profile, std::string_view text);

/// Whether two names are the same but for case, blanks, underscores and hyphens.
bool same_name(std::string_view a, std::string_view b);
/// The same, and `#` in the pattern stands for a number: that number, and 0 where the text or the
/// pattern has none. Nothing: they are not the same.
std::optional<unsigned> match_name(std::string_view pattern, std::string_view text);

}  // namespace canvoy
