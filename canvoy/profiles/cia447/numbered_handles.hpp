// Handles of fields that have numbers in their printed names: "fl12", "alb5".
//
//     State<Lamp, lamps_object, "", numbered_name<"l", 12>> lamp_12;
//     State<Order, lights_object, entry_with<lights_object, "alb5">, "alb5"> beacon_5;
#pragma once

#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

/// A printed name with its number of one or two digits.
template <Name prefix, unsigned number>
  requires(number < 100)
inline constexpr auto numbered_name = [] {
  constexpr std::size_t digits = number < 10 ? 1 : 2;
  constexpr std::size_t length = prefix.text().size();
  char text[length + digits + 1]{};
  for (std::size_t i = 0; i < length; ++i) text[i] = prefix.characters[i];
  if constexpr (digits == 2) text[length] = static_cast<char>('0' + number / 10);
  text[length + digits - 1] = static_cast<char>('0' + number % 10);
  return Name(text);
}();

/// Index of the entry of an object that has a field of this name.
template <const ObjectInfo& object, Name field>
consteval std::size_t position_with() {
  for (std::size_t i = 0; i < object.subs.size(); ++i) {
    for (const FieldInfo& one : object.subs[i].fields) {
      if (is_named(one.name, one.number, field.text())) return i;
    }
  }
  canvoy::detail::description_is_wrong("the object has no field of this name");
  return 0;
}
/// Name of the entry that has the field.
template <const ObjectInfo& object, Name field>
inline constexpr auto entry_with = [] {
  constexpr std::string_view name = object.subs[position_with<object, field>()].name;
  char text[name.size() + 1]{};
  for (std::size_t i = 0; i < name.size(); ++i) text[i] = name[i];
  return Name(text);
}();

}  // namespace canvoy::cia447
