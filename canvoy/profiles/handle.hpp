// Typed access to the values of a node: degrees, volts, named states, never an index, a shift, a
// mask or a scale.
//
//     Values charger(node.dictionary());
//     charger[cia419::charger_state_of_charge] = 80;                     // percent
//     std::optional<double> t = charger[cia419::battery_temperature].value();  // nothing: invalid
//     charger[cia419::battery_temperature] = std::nullopt;               // writes the sentinel
//     if (charger[cia419::battery_status].is(Readiness::ready)) ...
//     panel[cia417::input_group.call(3, 17)] = ...  // of group 3 the input 17
//
//     Bound<cia419::battery_voltage> voltage(node.dictionary());  // looked up once: for hot code
//
// Values are written through Dictionary::set, so that TPDOs learn of changes. Where a node does not
// have an object, reading it gives nothing, and writing it does nothing: Values::find() and set()
// say why. A device whose description is known does not compile then (device_values.hpp).
#pragma once

#include <cstdint>
#include <type_traits>

#include "canvoy/profiles/reference.hpp"

namespace canvoy {

namespace detail {

/// Where a handle points to. Of arrays and objects of one shape a handle points to the first.
template <class Self>
class Located {
 public:
  std::uint16_t index() const {
    return static_cast<std::uint16_t>(Self::Place::object.index + index_offset_);
  }
  std::uint8_t sub() const {
    return static_cast<std::uint8_t>(Self::Place::entry.sub_first + sub_offset_);
  }

  /// Of entries of one shape the one with sub-index `sub`.
  constexpr Self operator[](unsigned sub) const {
    Self other = static_cast<const Self&>(*this);
    other.sub_offset_ = static_cast<std::uint8_t>(sub - Self::Place::entry.sub_first);
    return other;
  }
  /// The same in an object `offset` indices above: another of objects of one shape, another block.
  constexpr Self shifted(unsigned offset) const {
    Self other = static_cast<const Self&>(*this);
    other.index_offset_ = static_cast<std::uint16_t>(index_offset_ + offset);
    return other;
  }
  /// Of several that are told apart by a number in their name, the one with this number: of the
  /// objects where there are several, else of the entries. There has to be one.
  constexpr Self operator()(unsigned number) const {
    if constexpr (is_one_of_many_objects()) {
      return shifted(number - Self::Place::object.first_number);
    } else {
      return (*this)[Self::Place::entry.sub_first + number - Self::Place::entry.first_number];
    }
  }
  /// The same of an entry in one of several objects: input 17 of group 3.
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

// The handles themselves: empty but for a place in arrays, made once for each profile.

template <const ObjectInfo& object, Name entry = "", Name field = "">
class Quantity : public detail::Located<Quantity<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;
  using Reference = QuantityReference<Place>;
};
template <const ObjectInfo& object, Name entry = "", Name field = "">
class Number : public detail::Located<Number<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;
  using Reference = IntegerReference<Place>;
};
template <class Enumeration, const ObjectInfo& object, Name entry = "", Name field = "">
class State : public detail::Located<State<Enumeration, object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;
  using Reference = StateReference<Place, Enumeration>;
};
template <const ObjectInfo& object, Name entry = "", Name field = "">
class Flag : public detail::Located<Flag<object, entry, field>> {
 public:
  using Place = detail::Place<object, entry, field>;
  using Reference = FlagReference<Place>;
};
template <const ObjectInfo& object, Name entry = "">
class Text : public detail::Located<Text<object, entry>> {
 public:
  using Place = detail::Place<object, entry, "">;
  using Reference = TextReference<Place>;
};

template <const ObjectInfo& object, Name entry = "">
class PackedText : public detail::Located<PackedText<object, entry>> {
 public:
  using Place = detail::Place<object, entry, "">;
  using Reference = PackedTextReference<Place>;
};

/// The values of one node, by handle: looked up at each access, in logarithmic time.
class Values {
 public:
  explicit Values(Dictionary& dictionary) : dictionary_(&dictionary) {}

  template <class Handle>
  typename Handle::Reference operator[](const Handle& handle) const {
    return {*dictionary_, handle.index(), handle.sub()};
  }

  /// Whether the node has the value: none, or no_object, no_sub_index, or length where its type is
  /// another one.
  template <class Handle>
  [[nodiscard]] AbortCode find(const Handle& handle) const {
    const Result<Entry> entry = dictionary_->find(handle.index(), handle.sub());
    if (!entry) return entry.abort();
    return entry->row->type == Handle::Place::entry.type ? AbortCode::none : AbortCode::length;
  }
  /// Writes it as an assignment does, or says as find() why not.
  template <class Handle, class Value>
  [[nodiscard]] AbortCode set(const Handle& handle, const Value& value) const {
    const AbortCode missing = find(handle);
    if (missing == AbortCode::none) (*this)[handle] = value;
    return missing;
  }

 private:
  Dictionary* dictionary_;
};

/// A value that is looked up once, and then costs a load or a store.
template <const auto& handle>
class Bound : public std::remove_cvref_t<decltype(handle)>::Reference {
 public:
  using Reference = typename std::remove_cvref_t<decltype(handle)>::Reference;

  explicit Bound(Dictionary& dictionary) : Reference(dictionary, handle.index(), handle.sub()) {}
  using Reference::operator=;
};

}  // namespace canvoy
