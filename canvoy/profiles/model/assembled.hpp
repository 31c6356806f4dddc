// Sets the fields of an entry one by one and writes them at once, so that a TPDO that maps the
// entry is not sent before all of them are set.
//
//     const auto call = Assembled(cia417::next_input.whole)
//                           .set(cia417::next_input.function, BasicFunction::standard_hall_call)
//                           .set(cia417::next_input.hall_call_up, true)
//                           .set(cia417::next_input.source_panel, 5);
//     panel[cia417::next_input.whole] = call.raw();
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "canvoy/profiles/model/handle.hpp"

namespace canvoy {

template <class Whole>
class Assembled {
 public:
  /// Fields that are not set keep the value in `whole`.
  constexpr explicit Assembled(const Whole& /*handle*/, std::uint64_t whole = 0) : whole_(whole) {}

  /// `value` is a named state, a flag, a number as on the wire, or for a quantity the value in its
  /// unit.
  template <class Handle, class Value>
  constexpr Assembled set(const Handle& /*handle*/, Value value) const {
    static_assert(&Handle::Place::object == &Whole::Place::object &&
                      &Handle::Place::entry == &Whole::Place::entry,
                  "a field of another entry");
    std::int64_t number = 0;
    if constexpr (std::floating_point<Value>) {
      number = Handle::Place::rules.nearest(value);
    } else {
      number = static_cast<std::int64_t>(value);
    }
    Assembled other = *this;
    other.whole_ = insert(whole_, Handle::Place::bits, number);
    return other;
  }
  /// The whole entry, as on the wire.
  constexpr std::uint64_t raw() const { return whole_; }

 private:
  std::uint64_t whole_;
};

}  // namespace canvoy
