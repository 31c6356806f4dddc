#include "canvoy/formats/sheet/chosen_profile.hpp"

#include <algorithm>

namespace canvoy::formats {

const ReadingInfo* find_reading(const Profile& profile, std::string_view name) {
  const auto* found = std::ranges::find(profile.readings, name, &ReadingInfo::name);
  return found == profile.readings.end() ? nullptr : found;
}

ChosenProfile::ChosenProfile(const Profile& profile, const ReadingInfo& reading)
    : objects_(reading.objects.begin(), reading.objects.end()), profile_(profile) {
  const auto is_replaced = [&reading](const ObjectInfo* object) {
    const bool has_other = std::ranges::any_of(reading.objects, [object](const ObjectInfo* other) {
      return other->index == object->index;
    });
    return has_other || std::ranges::find(reading.without, object->index) != reading.without.end();
  };
  std::ranges::remove_copy_if(profile.objects, std::back_inserter(objects_), is_replaced);
  std::ranges::sort(objects_, {}, &ObjectInfo::index);
  profile_.objects = {objects_.data(), objects_.size()};
}

}  // namespace canvoy::formats
