// Typed access to the values of a node: degrees, volts and named states instead of indices, shifts,
// masks and scales.
//
//     Values charger(node.dictionary());
//     charger[cia419::charger_state_of_charge] = 80;                     // percent
//     std::optional<double> t = charger[cia419::battery_temperature].value();  // nothing: invalid
//     charger[cia419::battery_temperature] = std::nullopt;               // writes the sentinel
//     if (charger[cia419::battery_status].is(Readiness::ready)) ...
//     panel[cia417::output.property(3, 17)] = cia417::Property::flashing;  // output 17 of group 3
//
//     Bound<cia419::battery_voltage> voltage(node.dictionary());  // looked up once: for hot code
//
// Values are written through Dictionary::set, so that TPDOs are notified of changes. Where a node
// does not have an object, reading returns nothing and writing does nothing: Values::find() and
// set() return the reason. Such access does not compile for a device with a known description
// (device_values.hpp).
#pragma once

#include <cstdint>
#include <type_traits>

#include "canvoy/profiles/model/reference.hpp"

namespace canvoy {

namespace detail {

/// Location of a value. In arrays and objects of one shape, a handle refers to the first.
template <class Self>
class Located {
 public:
  std::uint16_t index() const {
    return static_cast<std::uint16_t>(Self::Place::object.index + index_offset_);
  }
  std::uint8_t sub() const {
    return static_cast<std::uint8_t>(Self::Place::entry.sub_first + sub_offset_);
  }

  /// Of entries of one shape, the one with sub-index `sub`.
  constexpr Self operator[](unsigned sub) const {
    Self other = static_cast<const Self&>(*this);
    other.sub_offset_ = static_cast<std::uint8_t>(sub - Self::Place::entry.sub_first);
    return other;
  }
  /// The corresponding value in an object with an index that is `offset` higher: another of objects
  /// of one shape, or another block.
  constexpr Self shifted(unsigned offset) const {
    Self other = static_cast<const Self&>(*this);
    other.index_offset_ = static_cast<std::uint16_t>(index_offset_ + offset);
    return other;
  }
  /// Of several values that differ by a number in their name, the one with this number: of the
  /// objects where there are several, otherwise of the entries. It has to exist.
  constexpr Self operator()(unsigned number) const {
    if constexpr (is_one_of_many_objects()) {
      return shifted(number - Self::Place::object.first_number);
    } else {
      return (*this)[Self::Place::entry.sub_first + number - Self::Place::entry.first_number];
    }
  }
  /// Selects an entry in one of several objects: input 17 of group 3.
  constexpr Self operator()(unsigned object_number, unsigned number) const {
    static_assert(is_one_of_many_objects(), "there is only one object");
    return (*this)(
        object_number)[Self::Place::entry.sub_first + number - Self::Place::entry.first_number];
  }

 private:
  static constexpr bool is_one_of_many_objects() { return Self::Place::object.count > 1; }

  std::uint16_t index_offset_ = 0;
  std::uint8_t sub_offset_ = 0;
};

}  // namespace detail

// The handles themselves. They are empty except for a location in arrays, and made once for each
// profile.

/// Handle of a physical value, with a unit, or of a REAL32 or REAL64.
template <const ObjectInfo& object, Name entry = "", Name field = "">
class Quantity : public detail::Located<Quantity<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;  ///< object, entry and bits
  using Reference = QuantityReference<Place>;         ///< what Values gives for it
};
/// Handle of a number without a unit.
template <const ObjectInfo& object, Name entry = "", Name field = "">
class Number : public detail::Located<Number<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;  ///< object, entry and bits
  using Reference = IntegerReference<Place>;          ///< what Values gives for it
};
/// Handle of a value with named states, which are an enumeration.
template <class Enumeration, const ObjectInfo& object, Name entry = "", Name field = "">
class State : public detail::Located<State<Enumeration, object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;     ///< object, entry and bits
  using Reference = StateReference<Place, Enumeration>;  ///< what Values gives for it
};
/// Handle of one bit.
template <const ObjectInfo& object, Name entry = "", Name field = "">
class Flag : public detail::Located<Flag<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;  ///< object, entry and bit
  using Reference = FlagReference<Place>;             ///< what Values gives for it
};
/// Handle of a string.
template <const ObjectInfo& object, Name entry = "">
class Text : public detail::Located<Text<object, entry>> {
 public:
  using Place = detail::Place<object, entry, "">;  ///< object and entry
  using Reference = TextReference<Place>;          ///< what Values gives for it
};

/// Handle of characters that several numbers of an array hold.
template <const ObjectInfo& object, Name entry = "">
class PackedText : public detail::Located<PackedText<object, entry>> {
 public:
  using Place = detail::Place<object, entry, "">;  ///< object and first entry
  using Reference = PackedTextReference<Place>;    ///< what Values gives for it
};

/// The values of one node, by handle. Each access costs a look-up in logarithmic time.
class Values {
 public:
  /// Takes the dictionary of a node, which must outlive this object.
  explicit Values(Dictionary& dictionary) : dictionary_(&dictionary) {}

  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle) const {
    return {*dictionary_, handle.index(), handle.sub()};
  }

  /// none: the node has the value. Otherwise no_object, no_sub_index, or length where its type
  /// differs.
  template <class Handle>
  [[nodiscard]] AbortCode find(const Handle& handle) const {
    const Result<Entry> entry = dictionary_->find(handle.index(), handle.sub());
    if (!entry) return entry.abort();
    return entry->row->type == Handle::Place::entry.type ? AbortCode::none : AbortCode::length;
  }
  /// Writes the value like an assignment, or returns the reason like find().
  template <class Handle, class Value>
  [[nodiscard]] AbortCode set(const Handle& handle, const Value& value) const {
    const AbortCode missing = find(handle);
    if (missing == AbortCode::none) (*this)[handle] = value;
    return missing;
  }

 private:
  Dictionary* dictionary_;
};

/// A value that is looked up once. Each access then costs a load or a store.
template <const auto& handle>
class Bound : public std::remove_cvref_t<decltype(handle)>::Reference {
 public:
  /// What an unbound handle gives: the same, with a look-up.
  using Reference = typename std::remove_cvref_t<decltype(handle)>::Reference;

  /// Looks the value up; the dictionary must outlive this object.
  explicit Bound(Dictionary& dictionary) : Reference(dictionary, handle.index(), handle.sub()) {}
  using Reference::operator=;
};

}  // namespace canvoy
