// Typed access to the values of a node: degrees, volts, named states, never an index, a shift, a
// mask or a scale.
//
//     Values charger(node.dictionary());
//     charger[cia419::charger_state_of_charge] = 80;                     // percent
//     std::optional<double> t = charger[cia419::battery_temperature].value();  // nothing: invalid
//     charger[cia419::battery_temperature] = std::nullopt;               // writes the sentinel
//     if (charger[cia419::battery_status].is(Readiness::ready)) ...
//
//     Bound<cia419::battery_voltage> voltage(node.dictionary());  // looked up once: for hot code
//
// Values are written through Dictionary::set, so that TPDOs learn of changes. Where a node does not
// have an object, reading it gives nothing, and writing it does nothing.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "canvoy/canopen/dictionary.hpp"
#include "canvoy/canopen/dictionary_layout.hpp"
#include "canvoy/profiles/physical.hpp"

namespace canvoy {

/// The name of an entry or a field as a template argument.
template <std::size_t size>
struct Name {
  char characters[size]{};

  constexpr Name(const char (&text)[size]) {  // NOLINT(google-explicit-constructor)
    std::copy_n(text, size, characters);
  }
  constexpr std::string_view text() const { return {characters, size - 1}; }
};

namespace detail {

/// Of an empty name the variable itself, or the only entry beside sub-index 00h.
constexpr const EntryInfo& entry_named(const ObjectInfo& object, std::string_view name) {
  if (name.empty() && object.subs.empty()) return object.entry;
  if (name.empty() && object.subs.size() == 2) return object.subs[1];
  for (const EntryInfo& entry : object.entries()) {
    if (!name.empty() && entry.name == name) return entry;
  }
  description_is_wrong("the object has no entry of this name");
  return object.entry;
}
/// Of an empty name the only field, or null for the whole entry.
constexpr const FieldInfo* field_named(const EntryInfo& entry, std::string_view name) {
  if (name.empty()) return entry.fields.size() == 1 ? entry.fields.begin() : nullptr;
  for (const FieldInfo& field : entry.fields) {
    if (field.name == name) return &field;
  }
  description_is_wrong("the entry has no field of this name");
  return nullptr;
}

/// What the compiler knows of the place of a value.
template <const ObjectInfo& object_, Name entry_name, Name field_name>
struct Place {
  static constexpr const ObjectInfo& object = object_;
  static constexpr const EntryInfo& entry = entry_named(object_, entry_name.text());
  static constexpr const FieldInfo* field = field_named(entry, field_name.text());
  static constexpr const ValueInfo& value = field != nullptr ? field->value : entry.value;
  static constexpr BitRange bits = field != nullptr ? bits_of(*field) : bits_of(entry);
  static constexpr bool is_whole = field == nullptr;
};

/// The smallest integer that holds so many bits.
template <unsigned bits, bool is_signed>
using Integer = std::conditional_t<
    is_signed,
    std::conditional_t<
        bits <= 8, std::int8_t,
        std::conditional_t<bits <= 16, std::int16_t,
                           std::conditional_t<bits <= 32, std::int32_t, std::int64_t>>>,
    std::conditional_t<
        bits <= 8, std::uint8_t,
        std::conditional_t<bits <= 16, std::uint16_t,
                           std::conditional_t<bits <= 32, std::uint32_t, std::uint64_t>>>>;

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
    other.index_offset_ = static_cast<std::uint16_t>(offset);
    return other;
  }

 private:
  std::uint16_t index_offset_ = 0;
  std::uint8_t sub_offset_ = 0;
};

/// One entry of one node, looked up.
template <class Place_>
class EntryReference {
 public:
  using Place = Place_;

  EntryReference(Dictionary& dictionary, std::uint16_t index, std::uint8_t sub)
      : dictionary_(&dictionary) {
    const Result<Entry> found = dictionary.find(index, sub);
    if (found && found->row->type == Place::entry.type) entry_ = *found;
  }
  EntryReference(const EntryReference&) = default;
  EntryReference& operator=(const EntryReference&) = delete;

  /// Whether the node has the entry, with the described type.
  bool exists() const { return entry_.row != nullptr; }
  const Entry& entry() const { return entry_; }

 protected:
  ~EntryReference() = default;
  std::span<const std::uint8_t> bytes() const { return entry_.bytes(); }
  void set(std::span<const std::uint8_t> value) const { dictionary_->set(entry_, value); }

 private:
  Dictionary* dictionary_;
  Entry entry_;
};

/// The number in it, as it stands on the wire.
template <class Place>
class NumberReference : public EntryReference<Place> {
 public:
  using Raw = Integer<Place::bits.bits, Place::bits.is_signed>;
  static_assert(bit_length(Place::entry.type) != 0, "the entry holds no number");

  using EntryReference<Place>::EntryReference;

  /// The number without scale and unit; 0 where there is no such entry.
  Raw raw() const { return static_cast<Raw>(number()); }
  void set_raw(Raw raw) const { set_number(static_cast<std::int64_t>(raw)); }

 protected:
  static constexpr std::size_t length = byte_length(Place::entry.type);

  ~NumberReference() = default;
  std::uint64_t whole() const {
    return this->exists() ? load_unsigned({this->entry().value, length}) : 0;
  }
  std::int64_t number() const { return extract(whole(), Place::bits); }
  void set_number(std::int64_t number) const {
    if (!this->exists()) return;
    std::uint8_t bytes[8];
    store(bytes, insert(Place::is_whole ? 0 : whole(), Place::bits, number));
    this->set({bytes, length});
  }
};

}  // namespace detail

// What a handle gives of one node. Copies refer to the same entry; assignment writes the value.

/// A physical value. Plain numbers are in the object's own unit; amounts and other values of
/// another unit do not compile.
template <class Place>
class QuantityReference : public detail::NumberReference<Place> {
 public:
  static constexpr Unit unit = Place::value.unit;
  static_assert(unit != Unit::none, "a number without a unit is a Number");
  static constexpr bool can_be_invalid =
      is_real(Place::entry.type) || find_invalid(Place::value) != nullptr;

  using detail::NumberReference<Place>::NumberReference;
  QuantityReference(const QuantityReference&) = default;

  /// Nothing: the value is invalid, or out of its limits, or there is no such entry.
  std::optional<double> value() const {
    if (!this->exists()) return std::nullopt;
    if constexpr (is_real(Place::entry.type)) {
      const double number = real();
      if (number != number) return std::nullopt;
      return to_physical(number, Place::value.scale);
    } else {
      return physical_from_number(Place::value, Place::bits, this->number());
    }
  }
  /// The same with its unit.
  std::optional<Amount<unit>> amount() const { return value(); }
  bool is_valid() const { return value().has_value(); }

  /// Rounds to the nearest step, stays within the limits, and passes the sentinel over.
  const QuantityReference& operator=(double physical) const {
    if constexpr (is_real(Place::entry.type)) {
      set_real(to_raw(physical, Place::value.scale));
    } else {
      this->set_number(nearest_number(Place::value, Place::bits, physical));
    }
    return *this;
  }
  const QuantityReference& operator=(Amount<unit> amount) const { return *this = amount.number(); }
  /// Invalid.
  const QuantityReference& operator=(std::nullopt_t) const
    requires can_be_invalid
  {
    if constexpr (is_real(Place::entry.type)) {
      set_real(std::numeric_limits<double>::quiet_NaN());
    } else {
      this->set_number(find_invalid(Place::value)->first);
    }
    return *this;
  }
  const QuantityReference& operator=(std::optional<double> physical) const
    requires can_be_invalid
  {
    return physical ? *this = *physical : *this = std::nullopt;
  }
  const QuantityReference& operator=(const QuantityReference& other) const {
    return assign(other.value());
  }
  /// Another object of the same unit; scales are converted.
  template <class Other>
    requires(QuantityReference<Other>::unit == unit)
  const QuantityReference& operator=(const QuantityReference<Other>& other) const {
    return assign(other.value());
  }

 private:
  const QuantityReference& assign(std::optional<double> physical) const {
    if constexpr (can_be_invalid) {
      return *this = physical;
    } else {
      return physical ? *this = *physical : *this;
    }
  }
  double real() const {
    if constexpr (Place::entry.type == DataType::real32) {
      return static_cast<double>(load<float>(this->entry().value));
    } else {
      return load<double>(this->entry().value);
    }
  }
  void set_real(double number) const {
    if (!this->exists()) return;
    std::uint8_t bytes[8];
    if constexpr (Place::entry.type == DataType::real32) {
      store(bytes, static_cast<float>(number));
    } else {
      store(bytes, number);
    }
    this->set({bytes, detail::NumberReference<Place>::length});
  }
};

/// A number that counts or names something, without a unit.
template <class Place>
class IntegerReference : public detail::NumberReference<Place> {
 public:
  using typename detail::NumberReference<Place>::Raw;
  static_assert(is_integer(Place::entry.type), "the entry holds no integer");

  using detail::NumberReference<Place>::NumberReference;
  IntegerReference(const IntegerReference&) = default;

  /// Nothing: a sentinel, or out of its limits, or there is no such entry.
  std::optional<Raw> value() const {
    const std::int64_t number = this->number();
    if (!this->exists() || is_no_value(Place::value, Place::bits, number)) return std::nullopt;
    return static_cast<Raw>(number);
  }
  /// Stays within the limits.
  template <std::integral Number>
  const IntegerReference& operator=(Number number) const {
    const NumberRange range = range_of(Place::value, Place::bits);
    if (std::cmp_less(number, range.low)) {
      this->set_number(range.low);
    } else if (std::cmp_greater(number, range.high) && Place::bits.bits < 64) {
      this->set_number(range.high);
    } else {
      this->set_number(static_cast<std::int64_t>(number));
    }
    return *this;
  }
  const IntegerReference& operator=(std::nullopt_t) const
    requires(find_invalid(Place::value) != nullptr)
  {
    this->set_number(find_invalid(Place::value)->first);
    return *this;
  }
  const IntegerReference& operator=(const IntegerReference& other) const {
    this->set_number(static_cast<std::int64_t>(other.raw()));
    return *this;
  }
};

/// A named state.
template <class Place, class Enumeration>
class StateReference : public detail::NumberReference<Place> {
 public:
  static_assert(std::is_enum_v<Enumeration>);

  using detail::NumberReference<Place>::NumberReference;
  StateReference(const StateReference&) = default;

  bool is(Enumeration state) const {
    return this->exists() && this->number() == static_cast<std::int64_t>(state);
  }
  /// Nothing: a value that has no name, or there is no such entry.
  std::optional<Enumeration> value() const {
    const std::int64_t number = this->number();
    const bool is_named =
        find_name(Place::value, number, Place::bits.bits, Place::bits.is_signed) != nullptr;
    if (!this->exists() || !is_named) return std::nullopt;
    return static_cast<Enumeration>(number);
  }
  /// Other bits of the entry stay as they are.
  const StateReference& operator=(Enumeration state) const {
    this->set_number(static_cast<std::int64_t>(state));
    return *this;
  }
  const StateReference& operator=(const StateReference& other) const {
    this->set_number(static_cast<std::int64_t>(other.raw()));
    return *this;
  }
};

/// One bit.
template <class Place>
class FlagReference : public detail::NumberReference<Place> {
 public:
  static_assert(Place::bits.bits == 1, "a flag is one bit");

  using detail::NumberReference<Place>::NumberReference;
  FlagReference(const FlagReference&) = default;

  bool is_set() const { return this->number() != 0; }
  /// Other bits of the entry stay as they are.
  const FlagReference& operator=(std::same_as<bool> auto flag) const {
    this->set_number(flag ? 1 : 0);
    return *this;
  }
  const FlagReference& operator=(const FlagReference& other) const {
    return *this = other.is_set();
  }
};

/// A string.
template <class Place>
class TextReference : public detail::EntryReference<Place> {
 public:
  static_assert(is_string(Place::entry.type), "the entry holds no text");

  using detail::EntryReference<Place>::EntryReference;
  TextReference(const TextReference&) = default;

  /// Valid until it is written; empty where there is no such entry.
  std::string_view value() const {
    if (!this->exists()) return {};
    const auto bytes = this->bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  /// What is longer than the entry's capacity is cut.
  const TextReference& operator=(std::string_view text) const {
    if (this->exists())
      this->set({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return *this;
  }
  const TextReference& operator=(const TextReference& other) const { return *this = other.value(); }
};

/// Characters that stand four and four in the numbers of an array, with zeros behind the last.
template <class Place>
class PackedTextReference {
 public:
  static constexpr std::size_t capacity =
      byte_length(Place::entry.type) * (Place::entry.last_sub() - Place::entry.sub_first + 1U);
  static_assert(Place::value.notation == Notation::characters, "the entries hold no characters");

  PackedTextReference(Dictionary& dictionary, std::uint16_t index, std::uint8_t /*sub*/)
      : dictionary_(&dictionary), index_(index) {}
  PackedTextReference(const PackedTextReference&) = default;

  /// The text, in `buffer`; empty where there is no such object.
  std::string_view value(std::span<char, capacity> buffer) const {
    std::size_t length = 0;
    for (unsigned sub = Place::entry.sub_first; sub <= Place::entry.last_sub(); ++sub) {
      std::uint64_t number = dictionary_->number(index_, static_cast<std::uint8_t>(sub));
      for (std::size_t i = 0; i < byte_length(Place::entry.type); ++i, number >>= 8) {
        buffer[length++] = static_cast<char>(number & 0xFF);
      }
    }
    const std::string_view text(buffer.data(), length);
    return text.substr(0, text.find('\0'));
  }
  /// What is longer than the capacity is cut.
  const PackedTextReference& operator=(std::string_view text) const {
    for (unsigned sub = Place::entry.sub_first; sub <= Place::entry.last_sub(); ++sub) {
      const std::string_view piece = text.substr(0, byte_length(Place::entry.type));
      text.remove_prefix(piece.size());
      std::uint64_t number = 0;
      std::memcpy(&number, piece.data(), piece.size());
      dictionary_->set_number(index_, static_cast<std::uint8_t>(sub), number);
    }
    return *this;
  }
  PackedTextReference& operator=(const PackedTextReference&) = delete;

 private:
  Dictionary* dictionary_;
  std::uint16_t index_;
};

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
template <const ObjectInfo& object, Name entry, Name field>
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
