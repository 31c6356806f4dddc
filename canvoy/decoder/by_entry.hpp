// What was found out of entries of profiles, for those that a bus speaks of: the latest one of each
// hash is kept, as to look through the profiles takes longer than the rest of a message.
//
//     ByEntry<std::string, 256> names;
//     const std::string& name = names.at(profile, {0x6010, 0}, [] { return look_it_up(); });
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::decoder {

/// It takes no memory before the first at(), and then that of `count` values.
template <class Value, std::size_t count>
class ByEntry {
 public:
  /// Until the next call. `make` returns it where it is not kept. A profile is known by its
  /// address, and has to live as long.
  template <class Make>
  const Value& at(const Profile& profile, sdo::Multiplexer entry, const Make& make) {
    if (places_.empty()) places_.resize(count);
    const auto of_profile = reinterpret_cast<std::uintptr_t>(&profile) / alignof(Profile);
    constexpr unsigned subs = 8;  // Neighbours get places of their own.
    Place& place = places_[(entry.index() * subs + entry.sub() + of_profile) % count];
    if (place.profile != &profile || place.entry != entry) place = {&profile, entry, make()};
    return place.value;
  }

 private:
  struct Place {
    const Profile* profile = nullptr;
    sdo::Multiplexer entry;
    Value value;
  };

  std::vector<Place> places_;
};

}  // namespace canvoy::decoder
