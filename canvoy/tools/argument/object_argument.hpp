// An object given by the user: `6010`, `6383:1`, `0x1018:4`, its name in the profile
// (`battery_parameters:ah_capacity`, or `battery_parameters, ah_capacity` as printed), an
// unambiguous part of a name, or the name of the same value in the profile of the partner.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::tools {

/// Whether the node has an object.
using HasObject = std::function<bool(std::uint16_t index, std::uint8_t sub)>;

/// What says which objects a node has.
struct ProfileChoice {
  // Either is what callers have: both convert.
  constexpr ProfileChoice(unsigned chosen = 0) : number(chosen) {}
  explicit constexpr ProfileChoice(const Profile& own) : sheet(&own) {}

  unsigned number = 0;             ///< of a profile, or a device type (1000h); 0: not known
  const Profile* sheet = nullptr;  ///< the objects of its data sheet, which come first; or null
};

/// Looks in the data sheet or profile (if neither is known: in all profiles), then in CiA 301.
/// Throws UsageError if there is no such object; if there are several, with the candidates: those
/// that the node has, of which 16 at most are asked for.
ObjectAddress parse_object(std::string_view text, const ProfileChoice& profile = {},
                           const HasObject& has = {});

/// Throws UsageError if no possible profile has such an object.
void check_object(std::string_view text, const ProfileChoice& profile = {});

/// True if finding the object needs the profile of the node: the text is a name, or an index of the
/// profile area.
bool needs_profile(std::string_view text);

/// Name in the form that parse_object() reads: `temperature`, `battery_parameters, ah_capacity`.
std::string described_name(const ObjectInfo& object, const EntryInfo& entry);
/// Name of an address in that form, or `6010h:00h` if unknown.
std::string described_name(const ObjectAddress& address);

}  // namespace canvoy::tools
