// What the description prints for the enumerators of a handle, for tests only.
//
//     printed<Opening>(door_status_driver, {Opening::open, Opening::closed})  // "Open|Closed"
#pragma once

#include <initializer_list>
#include <string>

#include "canvoy/profiles/handle.hpp"

namespace canvoy::cia447 {

template <class Enumeration, class Handle>
std::string printed(const Handle& /*handle*/, std::initializer_list<Enumeration> states) {
  using Place = typename Handle::Place;
  std::string text;
  for (const Enumeration state : states) {
    const NamedValue* named =
        find_name(Place::value, static_cast<std::int64_t>(state), Place::bits.bits, false);
    text += (text.empty() ? "" : "|") + std::string(named == nullptr ? "?" : named->name);
  }
  return text;
}

}  // namespace canvoy::cia447
