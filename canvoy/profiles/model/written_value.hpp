// Type of the value to be written that a hook gets, by the handle or object to which it applies
// (reactions.hpp). A handle gives its own type:
//
// | Number     | its integer, signed where the entry is; std::optional of it: nothing, a sentinel |
// | State      | its enumeration, also where the code has no name                               |
// | Flag       | bool                                                                           |
// | Text       | std::string_view                                                               |
// | Quantity   | the physical value: double, or Amount with its unit (of an integer that can be |
// |            | invalid std::optional of these); of REAL32 float as well. A real is NaN then.  |
// | any number | Raw<std::uint16_t>: the bits of the whole entry, and no more than that         |
//
// An object gives the type of a handle of its only kind of entries, without the names of states: a
// number is an integer or Raw. An object with several kinds of entries gives Raw if all have the
// same size. Sub-index 00h of an array or record does not count as an entry here.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/handle.hpp"
#include "canvoy/profiles/model/words_of_error.hpp"

namespace canvoy {

/// The bits of an entry as transferred, without their meaning: of INTEGER16 and UNSIGNED16
/// Raw<std::uint16_t>, of REAL32 Raw<std::uint32_t>.
template <std::unsigned_integral Bits>
struct Raw {
  Bits bits = 0;  ///< as on the wire

  friend constexpr bool operator==(const Raw&, const Raw&) = default;
};

namespace detail {

/// Location of the value of an object with one kind of entries.
template <const ObjectInfo& object_>
struct PlaceOfObject {
  static constexpr const ObjectInfo& object = object_;
  static constexpr const EntryInfo& entry = object_.subs.empty() ? object_.entry : object_.subs[1];
  static constexpr const ValueInfo& value = entry.value;
  static constexpr BitRange bits = bits_of(entry);
  static constexpr NumberRules rules{value, bits};
};

/// For an object with several kinds of entries.
template <const ObjectInfo& object_>
struct PlaceOfSeveral {
  static constexpr const ObjectInfo& object = object_;
  static constexpr const EntryInfo& entry = object_.subs[1];
  static constexpr bool has_one_size = [] {
    for (const EntryInfo& each : object_.subs) {
      const bool is_count = each.sub_first == 0;
      if (!is_count && bit_length(each.type) != bit_length(entry.type)) return false;
    }
    return true;
  }();
};
template <class Place>
struct SeveralReference;

/// The reference that a handle of this object would return.
template <const ObjectInfo& object>
consteval auto reference_of_object() {
  if constexpr (object.subs.size() > 2) {
    return std::type_identity<SeveralReference<PlaceOfSeveral<object>>>{};
  } else {
    using Place = PlaceOfObject<object>;
    if constexpr (is_string(Place::entry.type)) {
      return std::type_identity<TextReference<Place>>{};
    } else if constexpr (Place::entry.type == DataType::boolean) {
      return std::type_identity<FlagReference<Place>>{};
    } else if constexpr (is_real(Place::entry.type) || Place::value.unit != Unit::none) {
      return std::type_identity<QuantityReference<Place>>{};
    } else {
      return std::type_identity<IntegerReference<Place>>{};
    }
  }
}

template <class Place>
std::int64_t number_written(std::span<const std::uint8_t> bytes) {
  return extract(normalized(Place::entry.type, load_unsigned(bytes)), Place::bits);
}

template <class Place>
std::optional<double> physical_written(std::span<const std::uint8_t> bytes) {
  if constexpr (is_real(Place::entry.type)) {
    using Real = std::conditional_t<Place::entry.type == DataType::real32, float, double>;
    const auto number = static_cast<double>(load<Real>(bytes.data()));
    if (number != number) return std::nullopt;
    return to_physical(number, Place::value.scale);
  } else {
    return Place::rules.physical(number_written<Place>(bytes));
  }
}

/// Converts a value written through `Reference` to a `Value`; nothing if that is not possible.
template <class Reference, class Value>
struct Written {};

template <class Place>
struct Written<IntegerReference<Place>, Integer<Place::bits.bits, Place::bits.is_signed>> {
  using Number = Integer<Place::bits.bits, Place::bits.is_signed>;
  static Number value(std::span<const std::uint8_t> bytes) {
    return static_cast<Number>(number_written<Place>(bytes));
  }
};
template <class Place>
struct Written<IntegerReference<Place>,
               std::optional<Integer<Place::bits.bits, Place::bits.is_signed>>> {
  using Number = Integer<Place::bits.bits, Place::bits.is_signed>;
  static std::optional<Number> value(std::span<const std::uint8_t> bytes) {
    const std::int64_t number = number_written<Place>(bytes);
    if (!Place::rules.is_value(number)) return std::nullopt;
    return static_cast<Number>(number);
  }
};
template <class Place, class Enumeration>
struct Written<StateReference<Place, Enumeration>, Enumeration> {
  static Enumeration value(std::span<const std::uint8_t> bytes) {
    return static_cast<Enumeration>(number_written<Place>(bytes));
  }
};
template <class Place>
struct Written<FlagReference<Place>, bool> {
  static bool value(std::span<const std::uint8_t> bytes) {
    return number_written<Place>(bytes) != 0;
  }
};
template <class Place>
struct Written<TextReference<Place>, std::string_view> {
  static std::string_view value(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

template <class Place>
inline constexpr bool is_always_valid =
    is_real(Place::entry.type) || !Place::rules.invalid().has_value();

/// NaN is the invalid value of a real.
template <class Place, class Value>
struct WrittenPhysical {
  static Value value(std::span<const std::uint8_t> bytes) {
    const auto physical = physical_written<Place>(bytes);
    return static_cast<Value>(physical.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
};
template <class Place>
  requires is_always_valid<Place>
struct Written<QuantityReference<Place>, double> : WrittenPhysical<Place, double> {};
template <class Place>
  requires(Place::entry.type == DataType::real32)
struct Written<QuantityReference<Place>, float> : WrittenPhysical<Place, float> {};
template <class Place, Unit unit>
  requires(is_always_valid<Place> && unit == Place::value.unit)
struct Written<QuantityReference<Place>, Amount<unit>> : WrittenPhysical<Place, Amount<unit>> {};
template <class Place>
struct Written<QuantityReference<Place>, std::optional<double>> {
  static std::optional<double> value(std::span<const std::uint8_t> bytes) {
    return physical_written<Place>(bytes);
  }
};
template <class Place, Unit unit>
  requires(unit == Place::value.unit)
struct Written<QuantityReference<Place>, std::optional<Amount<unit>>> {
  static std::optional<Amount<unit>> value(std::span<const std::uint8_t> bytes) {
    return physical_written<Place>(bytes);
  }
};

/// The unsigned integer with as many bits as an entry.
template <class Place>
consteval bool has_raw_bits() {
  if constexpr (requires { Place::has_one_size; }) {
    if (!Place::has_one_size) return false;
  }
  return bit_length(Place::entry.type) != 0;
}
template <template <class...> class Reference, class Place, class... Rest, class Bits>
  requires(has_raw_bits<Place>() &&
           std::same_as<Bits, Integer<bit_length(Place::entry.type), false>>)
struct Written<Reference<Place, Rest...>, Raw<Bits>> {
  static Raw<Bits> value(std::span<const std::uint8_t> bytes) {
    return {static_cast<Bits>(load_unsigned(bytes))};
  }
};

template <class Reference, class Value>
inline constexpr bool is_written_as =
    requires(std::span<const std::uint8_t> bytes) { Written<Reference, Value>::value(bytes); };

template <const auto& place>
consteval auto reference_at() {
  using Kind = std::remove_cvref_t<decltype(place)>;
  if constexpr (std::same_as<Kind, ObjectInfo>) {
    return reference_of_object<place>();
  } else {
    return std::type_identity<typename Kind::Reference>{};
  }
}
template <const auto& place>
consteval auto words_of_place() {
  using Kind = std::remove_cvref_t<decltype(place)>;
  if constexpr (std::same_as<Kind, ObjectInfo>) {
    return words_of<place>();
  } else {
    return words_of<Kind::Place::object>();
  }
}
/// True if sub-index 00h of the location counts the others.
template <const auto& place>
consteval bool is_counted() {
  if constexpr (std::same_as<std::remove_cvref_t<decltype(place)>, ObjectInfo>) {
    return !place.subs.empty();
  } else {
    return false;
  }
}

/// For one location. The entries of a range may have values of any kind.
template <class Value, const auto& place, const auto&... rest>
struct WrittenAt : Written<typename decltype(reference_at<place>())::type, Value> {
  static constexpr bool is_behind_count = is_counted<place>();
  static constexpr bool is_one = sizeof...(rest) == 0;
  static constexpr bool is_known =
      is_one && is_written_as<typename decltype(reference_at<place>())::type, Value>;

  static_assert(Must<is_known, wrong::HookArgument<words_of_place<place>(),
                                                   "not the type of its handle", Value>>::hold);
};

}  // namespace detail
}  // namespace canvoy
