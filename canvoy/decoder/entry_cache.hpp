// Results of lookups in profiles, for the entries that appear on a bus. For each hash the latest
// result is kept, since a lookup takes longer than the rest of a message.
//
//     EntryCache<std::string, 256> names;
//     const std::string& name = names.at(profile, {0x6010, 0}, [] { return look_it_up(); });
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/canopen/sdo/sdo.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::decoder {

/// Takes no memory before the first at(), and that of `count` values from then on.
template <class Value, std::size_t count>
class EntryCache {
 public:
  /// Returns the value of an entry, valid until the next call. `make` creates it if it is not
  /// cached. A profile is identified by its address and must live as long as the cache.
  template <class Make>
  const Value& at(const Profile& profile, sdo::Multiplexer entry, const Make& make) {
    if (places_.empty()) places_.resize(count);
    const auto of_profile = reinterpret_cast<std::uintptr_t>(&profile) / alignof(Profile);
    constexpr unsigned subs = 8;  // neighbours get slots of their own
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
