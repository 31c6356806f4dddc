// A profile with another reading of its text (Profile::readings).
//
//     const ChosenProfile chosen(cia852::profile, *find_reading(cia852::profile, "wide-displays"));
//     find_object(chosen.profile(), 0x6411);
#pragma once

#include <string_view>
#include <vector>

#include "canvoy/profiles/model/description.hpp"

namespace canvoy::formats {

/// The reading with this name, or null.
const ReadingInfo* find_reading(const Profile& profile, std::string_view name);

class ChosenProfile {
 public:
  /// Makes a copy of the profile with the objects of the reading. Both must outlive it.
  ChosenProfile(const Profile& profile, const ReadingInfo& reading);
  ChosenProfile(const ChosenProfile&) = delete;
  ChosenProfile& operator=(const ChosenProfile&) = delete;

  /// The profile; valid as long as this.
  const Profile& profile() const { return profile_; }

 private:
  std::vector<const ObjectInfo*> objects_;
  Profile profile_;
};

}  // namespace canvoy::formats
