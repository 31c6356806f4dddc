// What a unit does when its values are accessed from the bus: rows of a table that is compiled once
// for all units of its class. A row names a member function, and by handle or object the values
// that it is for; the function takes of the access what it needs.
//
//     AbortCode check_mode(Mode wanted);                            // State<Mode, ...>
//     AbortCode check_speed(std::optional<Amount<Unit::volt>> wanted);  // Quantity of volts
//     AbortCode check_unit(Raw<std::uint16_t> wanted);              // the bits, whatever they mean
//
//     constexpr HookCalls LoadMeasuringUnit::hook_calls[] = {
//         before_write<&LoadMeasuringUnit::check_unit, load_si_unit>,
//         after_write<&LoadMeasuringUnit::look_again, absolute_load_value, rope_ratio_nominator>};
//     constexpr ServiceCalls LoadMeasuringUnit::service_calls = {
//         .reset = method<&LoadMeasuringUnit::reset>, .hooks = hook_calls};
//
//     ServiceLink service_{&service_calls, this};  // node.attach(service_)
//
// An object stands for all of its entries; a handle for the entries of its name, in all objects of
// their shape; two of either for the objects from the first to the last. Rows are asked and told
// from the first to the last, as are units in the order in which they were attached.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>

#include "canvoy/canopen/service.hpp"
#include "canvoy/profiles/handle.hpp"
#include "canvoy/profiles/written_value.hpp"

namespace canvoy {

namespace detail {

/// The entries of a row, without its functions.
template <const auto& place>
consteval HookCalls range_of_place() {
  using Kind = std::remove_cvref_t<decltype(place)>;
  if constexpr (std::same_as<Kind, ObjectInfo>) {
    return {.first = place.index,
            .last = static_cast<std::uint16_t>(place.index + place.count - 1)};
  } else {
    using Place = typename Kind::Place;
    HookCalls range = range_of_place<Place::object>();
    range.sub_first = Place::entry.sub_first;
    range.sub_last = last_of_name(Place::object, Place::entry);
    return range;
  }
}
template <const auto& first, const auto& last>
consteval HookCalls range_of_place() {
  return {.first = range_of_place<first>().first, .last = range_of_place<last>().last};
}

template <class Unit, class Function>
Unit& unit_of(Function Unit::*);

/// What a hook takes: the value, and before it, where it asks for that, the entry.
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

/// A member function of a unit as HookCalls wants it.
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

}  // namespace detail

/// `function` may refresh the value, or refuse: AbortCode or void, of (const Entry&) or nothing.
template <auto function, const auto&... places>
inline constexpr HookCalls before_read = [] {
  HookCalls row = detail::range_of_place<places...>();
  row.before_read = detail::Reaction<function>::before_read;
  return row;
}();

/// `function` may refuse what is to be written: AbortCode, of what a handle of the entry gives
/// (written_value.hpp; with const Entry& before it, of which of several entries), or of (const
/// Entry&, std::span<const std::uint8_t>). Anything else does not compile. See Hook::before_write.
template <auto function, const auto&... places>
inline constexpr HookCalls before_write = [] {
  using Reaction = detail::Reaction<function>;
  HookCalls row = detail::range_of_place<places...>();
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

/// `function` reacts to what was written: void, of (const Entry&, Source), one of them, or nothing.
template <auto function, const auto&... places>
inline constexpr HookCalls after_write = [] {
  HookCalls row = detail::range_of_place<places...>();
  row.after_write = detail::Reaction<function>::after_write;
  return row;
}();

}  // namespace canvoy
