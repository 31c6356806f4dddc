// The values of one node as typed handles (handle.hpp) give them: after one look-up, each access
// costs a load or a store. Copies refer to the same entry; assignment writes the value.
//
//     auto temperature = charger[cia419::battery_temperature];
//     temperature = 21.5;
//     temperature.raw();  // 172
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/profiles/model/number_rules.hpp"
#include "canvoy/profiles/model/numbered_name.hpp"

namespace canvoy {

/// "Lift 3": a name that ends in a number, from 0 to 9.
template <std::size_t size>
constexpr Name<size + 1> numbered(const char (&front)[size], unsigned number) {
  char text[size + 1]{};
  std::copy_n(front, size - 1, text);
  text[size - 1] = static_cast<char>('0' + number);
  return {text};
}

namespace detail {

/// For an empty name, the variable itself, or the only entry beside sub-index 00h.
constexpr const EntryInfo& entry_named(const ObjectInfo& object, std::string_view name) {
  if (name.empty() && object.subs.empty()) return object.entry;
  if (name.empty() && object.subs.size() == 2) return object.subs[1];
  for (const EntryInfo& entry : object.entries()) {
    if (!name.empty() && entry.name == name) return entry;
  }
  description_is_wrong("the object has no entry of this name");
  return object.entry;
}
/// The last sub-index of the entry and of those behind it with the same name, for example where
/// some of them are optional.
constexpr std::uint8_t last_of_name(const ObjectInfo& object, const EntryInfo& first) {
  std::uint8_t last = first.last_sub();
  for (const EntryInfo& entry : object.entries()) {
    if (entry.sub_first > last && entry.name == first.name) last = entry.last_sub();
  }
  return last;
}
/// For an empty name, the only field that is not reserved, or null for the whole entry.
constexpr const FieldInfo* field_named(const EntryInfo& entry, std::string_view name) {
  if (name.empty()) return only_field(entry);
  for (const FieldInfo& field : entry.fields) {
    if (is_named(field.name, field.number, name)) return &field;
  }
  description_is_wrong("the entry has no field of this name");
  return nullptr;
}

/// What is known of the location of a value at compile time.
template <const ObjectInfo& object_, Name entry_name, Name field_name>
struct Place {
  static constexpr const ObjectInfo& object = object_;
  static constexpr const EntryInfo& entry = entry_named(object_, entry_name.text());
  static constexpr const FieldInfo* field = field_named(entry, field_name.text());
  static constexpr const ValueInfo& value = field != nullptr ? field->value : entry.value;
  static constexpr BitRange bits = field != nullptr ? bits_of(*field) : bits_of(entry);
  static constexpr bool is_whole = field == nullptr;
  static constexpr NumberRules rules{value, bits};
};

/// Numbers of the named states, without their names. Reserved ones are empty ranges.
template <class Place>
inline constexpr auto states = [] {
  std::array<NumberRange, Place::value.names.size()> ranges{};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const NamedValue& named = Place::value.names[i];
    ranges[i] =
        named.meaning == Meaning::reserved ? NumberRange{1, 0} : range_of(named, Place::bits);
  }
  return ranges;
}();

/// The smallest integer type with so many bits.
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

/// One entry of one node, looked up.
template <class Place>
class EntryReference {
 public:
  EntryReference(Dictionary& dictionary, std::uint16_t index, std::uint8_t sub)
      : dictionary_(&dictionary) {
    const Result<Entry> found = dictionary.find(index, sub);
    if (found && found->row->type == Place::entry.type) entry_ = *found;
  }
  EntryReference(const EntryReference&) = default;
  EntryReference& operator=(const EntryReference&) = delete;

  /// True if the node has the entry, with the described type.
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

/// The number in it, as on the wire.
template <class Place>
class NumberReference : public EntryReference<Place> {
 public:
  using Raw = Integer<Place::bits.bits, Place::bits.is_signed>;
  static_assert(bit_length(Place::entry.type) != 0, "the entry holds no number");

  using EntryReference<Place>::EntryReference;

  /// The number without scale and unit; 0 if there is no such entry.
  Raw raw() const { return static_cast<Raw>(number()); }
  void set_raw(Raw raw) const { set_number(static_cast<std::int64_t>(raw)); }

 protected:
  static constexpr std::size_t length = byte_length(Place::entry.type);

  ~NumberReference() = default;
  std::uint64_t whole() const {
    if (!this->exists()) return 0;
    return normalized(Place::entry.type, load_unsigned({this->entry().value, length}));
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

/// A physical value. Plain numbers are in the object's own unit; amounts and other values of
/// another unit do not compile.
template <class Place>
class QuantityReference : public detail::NumberReference<Place> {
 public:
  static constexpr Unit unit = Place::value.unit;  ///< of the value
  static_assert(unit != Unit::none || is_real(Place::entry.type),
                "an integer without a unit is a Number");
  /// True if it can be set to "no value": a real, or a number with such a sentinel.
  static constexpr bool can_be_invalid =
      is_real(Place::entry.type) || Place::rules.invalid().has_value();

  using detail::NumberReference<Place>::NumberReference;
  QuantityReference(const QuantityReference&) = default;

  /// Nothing if the value is invalid or out of its limits, or if there is no such entry.
  std::optional<double> value() const {
    if (!this->exists()) return std::nullopt;
    if constexpr (is_real(Place::entry.type)) {
      const double number = real();
      if (number != number) return std::nullopt;
      return to_physical(number, Place::value.scale);
    } else {
      return Place::rules.physical(this->number());
    }
  }
  /// The value with its unit.
  std::optional<Amount<unit>> amount() const { return value(); }
  /// True if there is a value: see value().
  bool is_valid() const { return value().has_value(); }

  /// Rounds to the nearest step, clamps to the limits, and skips the sentinel.
  const QuantityReference& operator=(double physical) const {
    if constexpr (is_real(Place::entry.type)) {
      set_real(to_raw(physical, Place::value.scale));
    } else {
      this->set_number(Place::rules.nearest(physical));
    }
    return *this;
  }
  const QuantityReference& operator=(Amount<unit> amount) const { return *this = amount.number(); }
  /// Sets it to invalid.
  const QuantityReference& operator=(std::nullopt_t) const
    requires can_be_invalid
  {
    if constexpr (is_real(Place::entry.type)) {
      set_real(std::numeric_limits<double>::quiet_NaN());
    } else {
      this->set_number(Place::rules.invalid().value_or(0));
    }
    return *this;
  }
  const QuantityReference& operator=(std::optional<double> physical) const
    requires can_be_invalid
  {
    return physical ? *this = *physical : *this = std::nullopt;
  }
  const QuantityReference& operator=(std::optional<Amount<unit>> amount) const
    requires can_be_invalid
  {
    return amount ? *this = *amount : *this = std::nullopt;
  }
  const QuantityReference& operator=(const QuantityReference& other) const {
    return assign(other.value());
  }
  /// Takes the value of another object of the same unit; scales are converted.
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

/// A number that counts or identifies something, without a unit.
template <class Place>
class IntegerReference : public detail::NumberReference<Place> {
 public:
  using typename detail::NumberReference<Place>::Raw;
  static_assert(is_integer(Place::entry.type), "the entry holds no integer");

  using detail::NumberReference<Place>::NumberReference;
  IntegerReference(const IntegerReference&) = default;

  /// Nothing if the value is a sentinel or out of its limits, or if there is no such entry.
  std::optional<Raw> value() const {
    const std::int64_t number = this->number();
    if (!this->exists() || !Place::rules.is_value(number)) return std::nullopt;
    return static_cast<Raw>(number);
  }
  /// Clamps to the limits, and skips the sentinel.
  template <std::integral Number>
  const IntegerReference& operator=(Number number) const {
    constexpr NumberRange range = Place::rules.range();
    std::int64_t settled = static_cast<std::int64_t>(number);
    if (std::cmp_less(number, range.low)) settled = range.low;
    // The range of 64 unsigned bits has 63, but all may be written.
    if (Place::bits.bits < 64 && std::cmp_greater(number, range.high)) settled = range.high;
    this->set_number(Place::rules.settle(settled, static_cast<double>(settled)));
    return *this;
  }
  const IntegerReference& operator=(std::nullopt_t) const
    requires(Place::rules.invalid().has_value())
  {
    this->set_number(Place::rules.invalid().value_or(0));
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
  static_assert(std::is_enum_v<Enumeration>, "the states of a State are an enumeration");

  using detail::NumberReference<Place>::NumberReference;
  StateReference(const StateReference&) = default;

  /// True if the value is this one; without the entry never.
  bool is(Enumeration state) const {
    return this->exists() && this->number() == static_cast<std::int64_t>(state);
  }
  /// Nothing if the value has no name or is reserved, or if there is no such entry.
  std::optional<Enumeration> value() const {
    const std::int64_t number = this->number();
    const bool is_state = std::ranges::any_of(
        detail::states<Place>, [&](const NumberRange& state) { return state.contains(number); });
    if (!this->exists() || !is_state) return std::nullopt;
    return static_cast<Enumeration>(number);
  }
  /// Leaves the other bits of the entry as they are.
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

  /// True if the bit is 1; without the entry never.
  bool is_set() const { return this->number() != 0; }
  /// Leaves the other bits of the entry as they are.
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

  /// Valid until the string is written; empty if there is no such entry.
  std::string_view value() const {
    if (!this->exists()) return {};
    const auto bytes = this->bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  /// Cuts a text that is longer than the entry's capacity.
  const TextReference& operator=(std::string_view text) const {
    if (this->exists())
      this->set({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return *this;
  }
  const TextReference& operator=(const TextReference& other) const { return *this = other.value(); }
};

/// Characters in the numbers of an array, one or several in each, with zeros behind the last.
template <class Place>
class PackedTextReference {
 public:
  /// Of the characters.
  static constexpr unsigned last_sub = detail::last_of_name(Place::object, Place::entry);
  /// Bytes that the entries hold together.
  static constexpr std::size_t capacity =
      byte_length(Place::entry.type) * (last_sub - Place::entry.sub_first + 1U);
  static_assert(Place::value.notation == Notation::characters, "the entries hold no characters");

  /// Names the object in a dictionary, which must outlive this object.
  PackedTextReference(Dictionary& dictionary, std::uint16_t index, std::uint8_t /*sub*/)
      : dictionary_(&dictionary), index_(index) {}
  PackedTextReference(const PackedTextReference&) = default;

  /// The text, in `buffer`; empty if there is no such object.
  std::string_view value(std::span<char, capacity> buffer) const {
    std::size_t length = 0;
    for (unsigned sub = Place::entry.sub_first; sub <= last_sub; ++sub) {
      std::uint64_t number = dictionary_->number(index_, static_cast<std::uint8_t>(sub));
      for (std::size_t i = 0; i < byte_length(Place::entry.type); ++i, number >>= 8) {
        buffer[length++] = static_cast<char>(number & 0xFF);
      }
    }
    const std::string_view text(buffer.data(), length);
    return text.substr(0, text.find('\0'));
  }
  /// Cuts a text that is longer than the capacity.
  const PackedTextReference& operator=(std::string_view text) const {
    for (unsigned sub = Place::entry.sub_first; sub <= last_sub; ++sub) {
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

}  // namespace canvoy
