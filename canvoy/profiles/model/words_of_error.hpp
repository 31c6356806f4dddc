// Names of described objects for the first line of a compiler's error: see
// canvoy/canopen/dictionary/words_of_error.hpp.
//
//     static_assert(Must<fits, wrong::HookArgument<words_of<object>(), "...", Argument>>::hold);
#pragma once

#include "canvoy/canopen/dictionary/words_of_error.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// `6010h temperature`.
template <const ObjectInfo& object>
consteval auto words_of() {
  return detail::numbered_words<4, object.name.size()>(object.index, object.name);
}
/// `01h vendor_id`; for a variable `00h`. `Place` is that of reference.hpp.
template <class Place>
consteval auto words_of_entry() {
  return detail::numbered_words<2, Place::entry.name.size()>(Place::entry.sub_first,
                                                             Place::entry.name);
}

namespace wrong {

/// Reports a hook with a parameter that is not of the type written at its location.
template <Words object, Words rule, class Argument>
struct HookArgument;
/// Reports a hook with a function of another form.
template <Words object, Words rule, class Function>
struct HookFunction;

}  // namespace wrong
}  // namespace canvoy
