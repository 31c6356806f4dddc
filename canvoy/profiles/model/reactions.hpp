// Reactions of a unit to accesses from the bus: rows of a table that is compiled once for all units
// of its class. A row names a member function, and by handle or object the values to which it
// applies. The function takes the parameters of the access that it needs.
//
//     struct Scale {
//       AbortCode check_load(std::optional<Amount<Unit::kilogram>> wanted);  // a Quantity
//       AbortCode check_unit(Raw<std::uint16_t> wanted);  // the bits, whatever they mean
//       void look_again();
//       void reset(ResetScope scope);
//     };
//     constexpr AccessHandlers hooks[] = {
//         before_write<&Scale::check_load, cia417::absolute_load_value>,
//         before_write<&Scale::check_unit, cia417::load_si_unit>,
//         after_write<&Scale::look_again, cia417::rope_ratio_nominator>};
//     constexpr ServiceHandlers calls = {.reset = method<&Scale::reset>, .hooks = hooks};
//
//     HandlerBinding binding(&calls, &scale);
//     node.attach(binding);
//
// An object stands for all of its entries; a handle for the entries of its name, in all objects of
// their shape; two of either for the objects from the first to the last. Rows are called from the
// first to the last, and units in the order in which they were attached.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>

#include "canvoy/canopen/service/service.hpp"
#include "canvoy/profiles/model/handle.hpp"
#include "canvoy/profiles/model/written_value.hpp"

namespace canvoy {

namespace detail {

/// The entries of a row, without its functions.
template <const auto& place>
consteval AccessHandlers range_of_place() {
  using Kind = std::remove_cvref_t<decltype(place)>;
  if constexpr (std::same_as<Kind, ObjectInfo>) {
    return {.first = place.index,
            .last = static_cast<std::uint16_t>(place.index + place.count - 1)};
  } else {
    using Place = typename Kind::Place;
    AccessHandlers range = range_of_place<Place::object>();
    range.sub_first = Place::entry.sub_first;
    range.sub_last = last_of_name(Place::object, Place::entry);
    return range;
  }
}
template <const auto& first, const auto& last>
consteval AccessHandlers range_of_place() {
  return {.first = range_of_place<first>().first, .last = range_of_place<last>().last};
}

template <class Unit, class Function>
Unit& unit_of(Function Unit::*);

/// Parameters of a hook: the value, and before it optionally the entry.
template <class Argument>
struct Takes {
  using Value = std::remove_cvref_t<Argument>;
};
template <class Unit, class Value>
Takes<Value> taken_by(AbortCode (Unit::*)(Value));
template <class Unit, class Value>
Takes<Value> taken_by(AbortCode (Unit::*)(Value) const);
template <class Unit, class Value>
Takes<Value> taken_by(AbortCode (Unit::*)(const Entry&, Value));
template <class Unit, class Value>
Takes<Value> taken_by(AbortCode (Unit::*)(const Entry&, Value) const);

/// A member function of a unit in the form that AccessHandlers needs.
template <auto function>
struct Reaction {
  using Unit = decltype(unit_of(function));
  template <class... Arguments>
  static constexpr bool takes = std::is_invocable_v<decltype(function), Unit, Arguments...>;

  template <class... Arguments>
  static AbortCode call(void* unit, Arguments... arguments) {
    Unit self = *static_cast<std::remove_reference_t<Unit>*>(unit);
    if constexpr (std::is_void_v<std::invoke_result_t<decltype(function), Unit, Arguments...>>) {
      std::invoke(function, self, arguments...);
      return AbortCode::none;
    } else {
      return std::invoke(function, self, arguments...);
    }
  }

  static AbortCode before_read(void* unit, const Entry& entry) {
    if constexpr (takes<const Entry&>) {
      return call<const Entry&>(unit, entry);
    } else {
      return call(unit);
    }
  }
  /// Bytes of any entries.
  static AbortCode before_write(void* unit, const Entry& entry,
                                std::span<const std::uint8_t> value) {
    return call<const Entry&, std::span<const std::uint8_t>>(unit, entry, value);
  }
  /// The value of one kind of entries.
  template <class Written>
  static AbortCode before_value(void* unit, const Entry& entry,
                                std::span<const std::uint8_t> bytes) {
    using Value = typename decltype(taken_by(function))::Value;
    if constexpr (takes<const Entry&, Value>) {
      return call<const Entry&, Value>(unit, entry, Written::value(bytes));
    } else {
      return call<Value>(unit, Written::value(bytes));
    }
  }
  static void after_write(void* unit, const Entry& entry, Source source) {
    if constexpr (takes<const Entry&, Source>) {
      call<const Entry&, Source>(unit, entry, source);
    } else if constexpr (takes<const Entry&>) {
      call<const Entry&>(unit, entry);
    } else if constexpr (takes<Source>) {
      call(unit, source);
    } else {
      call(unit);
    }
  }
};

template <const auto& first, const auto&...>
consteval auto words_of_first() {
  return words_of_place<first>();
}
/// True if the function returns AbortCode, and takes a value or the bytes of any.
template <auto function>
consteval bool checks_values() {
  using Bytes = std::span<const std::uint8_t>;
  using Reaction = Reaction<function>;
  if constexpr (Reaction::template takes<const Entry&, Bytes>) {
    using Answer =
        std::invoke_result_t<decltype(function), typename Reaction::Unit, const Entry&, Bytes>;
    return std::same_as<Answer, AbortCode>;
  } else {
    return requires { taken_by(function); };
  }
}

}  // namespace detail

/// `function` may refresh the value or refuse the access. It returns AbortCode or void, and takes
/// (const Entry&) or nothing.
template <auto function, const auto&... places>
inline constexpr AccessHandlers before_read = [] {
  using Reaction = detail::Reaction<function>;
  // NOLINTNEXTLINE(misc-redundant-expression): their arguments differ
  static_assert(Must < Reaction::template takes<const Entry&> || Reaction::template takes<>,
                wrong::HookFunction < detail::words_of_first<places...>(),
                "takes the entry, or nothing", decltype(function) >> ::hold);
  AccessHandlers row = detail::range_of_place<places...>();
  row.before_read = Reaction::before_read;
  return row;
}();

/// `function` may refuse a value to be written. It returns AbortCode, and takes the type that a
/// handle of the entry gives (written_value.hpp; preceded by const Entry& to distinguish several
/// entries), or (const Entry&, std::span<const std::uint8_t>). Anything else does not compile. See
/// Hook::before_write.
template <auto function, const auto&... places>
inline constexpr AccessHandlers before_write = [] {
  using Reaction = detail::Reaction<function>;
  static_assert(
      Must<detail::checks_values<function>(),
           wrong::HookFunction<detail::words_of_first<places...>(),
                               "returns AbortCode, takes the value", decltype(function)>>::hold);
  AccessHandlers row = detail::range_of_place<places...>();
  if constexpr (Reaction::template takes<const Entry&, std::span<const std::uint8_t>>) {
    row.before_write = Reaction::before_write;
  } else {
    using Value = typename decltype(detail::taken_by(function))::Value;
    using Written = detail::WrittenAt<Value, places...>;
    if (Written::is_behind_count) row.sub_first = 1;
    row.before_write = Reaction::template before_value<Written>;
  }
  return row;
}();

/// `function` reacts to a written value. It returns void, and takes (const Entry&, Source), one of
/// them, or nothing.
template <auto function, const auto&... places>
inline constexpr AccessHandlers after_write = [] {
  using Reaction = detail::Reaction<function>;
  // NOLINTNEXTLINE(misc-redundant-expression): their arguments differ
  static_assert(Must < Reaction::template takes<const Entry&, Source> ||
                    Reaction::template takes<const Entry&> || Reaction::template takes<Source> ||
                    Reaction::template takes<>,
                wrong::HookFunction < detail::words_of_first<places...>(),
                "takes entry, source, not a value", decltype(function) >> ::hold);
  AccessHandlers row = detail::range_of_place<places...>();
  row.after_write = Reaction::after_write;
  return row;
}();

}  // namespace canvoy
