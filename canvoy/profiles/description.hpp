// The vocabulary in which profiles are described: what an object is called, what stands in it, what
// its bits mean and which clause says so.
//
// A profile is constexpr data in these words, once (canvoy/profiles/cia419.hpp). All else is
// derived from it: the dictionary of a node (layout.hpp), typed access (handle.hpp), decoding,
// files, checks and documents. What a node needs on the bus is copied into ObjectRow and EntryRow
// at compile time; names, units and texts stay here, and a device that does not ask for them does
// not carry them. Most of it is written in rows (rows.hpp):
//
//     inline constexpr auto battery_temperature_object =
//         var_object(0x6010, "battery_temperature", "7.2.3", "Temperature of the battery pack.",
//                    entry(integer16, rw, by_default, 0xFFFF, temperature), {.errata = "1, 2"});
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "canvoy/canopen/dictionary/data_type.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/profiles/unit.hpp"

namespace canvoy {

/// A view of constant items that live as long as the program: an array, or one item.
template <class Item>
class Items {
 public:
  constexpr Items() = default;
  constexpr Items(const Item& item)
      : first_(&item), count_(1) {}  // NOLINT(google-explicit-constructor)
  Items(const Item&&) = delete;      // a temporary would not live long enough
  template <std::size_t count>
  constexpr Items(const Item (&items)[count])  // NOLINT(google-explicit-constructor)
      : first_(items), count_(count) {}
  template <std::size_t count>
  constexpr Items(const std::array<Item, count>& items)  // NOLINT(google-explicit-constructor)
      : first_(items.data()), count_(count) {}
  template <std::size_t count>
  Items(const std::array<Item, count>&&) = delete;
  constexpr Items(const Item* first, std::size_t count) : first_(first), count_(count) {}

  constexpr const Item* begin() const { return first_; }
  constexpr const Item* end() const { return first_ + count_; }
  constexpr std::size_t size() const { return count_; }
  constexpr bool empty() const { return count_ == 0; }
  constexpr const Item& operator[](std::size_t position) const { return first_[position]; }

 private:
  const Item* first_ = nullptr;
  std::size_t count_ = 0;
};

/// What a named raw value says of the quantity that it stands in for.
enum class Meaning : std::uint8_t {
  state,            ///< a value like others: an enumerator
  invalid,          ///< there is no value: not measured, not available
  failure,          ///< there is no value, since something is broken
  not_implemented,  ///< there is no value, and never will be: the device does not have it
  do_not_care,      ///< who receives it is to leave its own value as it is
  manufacturer,     ///< the maker of the device gives it a meaning
  reserved,         ///< nobody may send it
  padding,          ///< what reserved bits hold: it says nothing, and nobody looks at it
};

/// A raw value, or several from `first` to `last`, with a name.
struct NamedValue {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string_view name = {};
  Meaning meaning = Meaning::state;

  constexpr NamedValue() = default;
  template <class Value>
    requires(std::is_enum_v<Value> || std::integral<Value>)
  constexpr NamedValue(Value value, std::string_view value_name,
                       Meaning value_meaning = Meaning::state)
      : NamedValue(value, value, value_name, value_meaning) {}
  template <class Value>
    requires(std::is_enum_v<Value> || std::integral<Value>)
  constexpr NamedValue(Value first_value, Value last_value, std::string_view value_name,
                       Meaning value_meaning)
      : first(static_cast<std::int64_t>(first_value)),
        last(static_cast<std::int64_t>(last_value)),
        name(value_name),
        meaning(value_meaning) {}
};

/// Which raw values are allowed beside the named ones.
struct Limits {
  enum class Kind : std::uint8_t {
    none,      ///< all that the type has
    absolute,  ///< others are refused
    minimum,   ///< these have to be supported; a device may support more
  };
  Kind kind = Kind::none;
  std::int64_t low = 0;
  std::int64_t high = 0;
};
constexpr Limits within(std::int64_t low, std::int64_t high) {
  return {Limits::Kind::absolute, low, high};
}
constexpr Limits at_least(std::int64_t low, std::int64_t high) {
  return {Limits::Kind::minimum, low, high};
}

/// In which form people read a number.
enum class Notation : std::uint8_t {
  number,
  hexadecimal,  ///< codes: COB-IDs, device types, CRCs
  bcd,          ///< binary coded decimal digits
  characters,   ///< bytes are characters, the first in the least significant byte
  bit_mask,     ///< each bit for itself
};

/// Raw values from `first` to `last` that have a scale of their own.
struct Piece {
  std::int64_t first = 0;
  std::int64_t last = 0;
  Scale scale = {};
  std::string_view name = {};  ///< what is special of them: "north", "west"
};

/// Another entry, which says how many scale steps one count is. Of values in several objects its
/// index is that of the first, and those of the others stand as far from it.
struct StepEntry {
  std::uint16_t index = 0;  ///< 0: there is none
  std::uint8_t sub = 0;     ///< 0: that of the value
};

/// Another entry, which says what the unit is: by a byte with a code of CiA 303-2 from `first_bit`
/// on, and one above it with that of a prefix (si_unit.hpp). It stands where a StepEntry does.
struct UnitEntry {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint8_t first_bit = 0;
};

/// Whether a number without a unit stands for an amount.
enum class Counting : std::uint8_t {
  by_names,    ///< where some of its raw values say that there is none, and others have no name
  counts,      ///< it counts or measures
  identifies,  ///< it is a code: nobody adds two of them up
};

/// What the raw number in an entry, or in some bits of it, stands for.
struct ValueInfo {
  Unit unit = Unit::none;
  Scale scale = {};
  Limits limits = {};
  Items<NamedValue> names = {};  ///< raw values with a name: enumerators, sentinels, reserved codes
  Notation notation = Notation::number;
  Items<Piece> pieces = {};  ///< where the scale is not the same for all numbers: in place of it
  /// Where the device says the scale itself: `scale` holds while that entry has its default, and
  /// grows in proportion with it.
  StepEntry step = {};
  /// Where the device says the unit itself: `unit` holds while that entry has its default, or is
  /// not there.
  UnitEntry unit_entry = {};
  Counting counting = Counting::by_names;
};

/// That another field of the same entry has one of the values from `first` to `last`.
struct FieldCondition {
  std::string_view field = {};
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// Some bits of an entry. What they mean may depend on other bits: then several fields describe the
/// same bits, each with the conditions under which it holds.
struct FieldInfo {
  std::uint8_t first_bit = 0;
  std::uint8_t bits = 1;
  std::string_view name = {};  ///< `#` stands for `number`
  bool is_signed = false;
  ValueInfo value = {};
  std::string_view description = {};
  Items<FieldCondition> when = {};  ///< all of them must hold; of the same field: one of them
  std::uint16_t number = 0;         ///< of one among several of a kind
};

/// Bits without a meaning: what they are to hold is padding, all else is reserved.
constexpr bool is_reserved(const FieldInfo& field) {
  bool has_padding = false;
  for (const NamedValue& named : field.value.names) {
    if (named.meaning != Meaning::padding && named.meaning != Meaning::reserved) return false;
    has_padding = has_padding || named.meaning == Meaning::padding;
  }
  return has_padding;
}

/// Fields of one shape, side by side from `first.first_bit` on, numbered from `first.number` (0:
/// from 1) upward.
template <std::size_t count>
constexpr std::array<FieldInfo, count> repeat_field(const FieldInfo& first) {
  std::array<FieldInfo, count> fields{};
  for (std::size_t i = 0; i < count; ++i) {
    fields[i] = first;
    fields[i].first_bit = static_cast<std::uint8_t>(first.first_bit + i * first.bits);
    fields[i].number =
        static_cast<std::uint16_t>((first.number == 0 ? 1U : unsigned{first.number}) + i);
  }
  return fields;
}

namespace detail {
template <class Part>
inline constexpr std::size_t field_count = 1;
template <std::size_t count>
inline constexpr std::size_t field_count<std::array<FieldInfo, count>> = count;
}  // namespace detail

/// Fields and arrays of them as one array.
template <class... Parts>
constexpr auto join_fields(const Parts&... parts) {
  std::array<FieldInfo, (detail::field_count<Parts> + ...)> all{};
  std::size_t next = 0;
  const auto add = [&](const auto& part) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(part)>, FieldInfo>) {
      all[next++] = part;
    } else {
      for (const FieldInfo& field : part) all[next++] = field;
    }
  };
  (add(parts), ...);
  return all;
}

/// Whether a PDO may carry an entry.
enum class Mapping : std::uint8_t { no, optional, by_default };

enum class Category : std::uint8_t { mandatory, optional, conditional };

/// The value of an entry after power-on.
struct Default {
  enum class Kind : std::uint8_t { none, number, plus_node_id, text, highest_sub };
  Kind kind = Kind::none;
  std::int64_t number = 0;
  std::string_view text = {};

  constexpr Default() = default;
  template <std::integral Number>
  constexpr Default(Number value)  // NOLINT(google-explicit-constructor)
      : kind(Kind::number), number(static_cast<std::int64_t>(value)) {}
  constexpr Default(const char* value)  // NOLINT(google-explicit-constructor)
      : kind(Kind::text), text(value) {}
  constexpr explicit operator bool() const { return kind != Kind::none; }
};
/// `base` plus the node-ID, as the CAN-IDs of the pre-defined connection set are made.
constexpr Default plus_node_id(std::uint32_t base) {
  Default made(base);
  made.kind = Default::Kind::plus_node_id;
  return made;
}

/// Of sub-index 00h: the highest sub-index that the device has. `printed` is what the specification
/// says that it is, 0 where it leaves that to the device.
constexpr Default highest_sub(std::uint8_t printed = 0) {
  Default made(printed);
  made.kind = Default::Kind::highest_sub;
  return made;
}

/// Entries of one shape: one sub-index, or those from sub_first to sub_last.
struct EntryInfo {
  std::uint8_t sub_first = 0;
  std::uint8_t sub_last = 0;  ///< below sub_first: there is only sub_first
  /// As the specification prints it. `#` stands for a number that counts with the sub-index: the
  /// first entry has `first_number`.
  std::string_view name = {};
  std::uint16_t first_number = 1;
  DataType type = DataType::unsigned8;
  /// Of the device that provides the object; CiA 407 and 447 give those who consume it another one.
  Access access = Access::ro;
  Access consumer_access = Access::none;  ///< none: no other than `access`
  /// The virtual device says what it is (DeviceObject::access); `access` is the widest of them.
  bool access_by_device = false;
  bool or_const = false;  ///< the maker may choose const in place of `access`: "rw or const"
  Mapping mapping = Mapping::no;
  Category category = Category::mandatory;
  std::string_view condition = {};   ///< when a conditional entry has to be there
  std::uint16_t capacity = 0;        ///< of a string: the most bytes that it may have
  bool capacity_is_printed = false;  ///< the specification says so; else it is our choice
  Default initial = {};  ///< none: the first value that says "invalid", or 0, or the lowest allowed
  Default consumer_initial = {};  ///< none: no other than `initial`
  ValueInfo value = {};
  Items<FieldInfo> fields = {};  ///< where the bits have meanings of their own
  std::string_view clause = {};  ///< where it is not the object's
  std::string_view errata = {};  ///< numbers of the findings that decided something
  std::string_view description = {};

  constexpr std::uint8_t last_sub() const { return sub_last < sub_first ? sub_first : sub_last; }
};

/// The field of an entry that has only one beside reserved bits, or null.
constexpr const FieldInfo* only_field(const EntryInfo& entry) {
  const FieldInfo* only = nullptr;
  for (const FieldInfo& field : entry.fields) {
    if (is_reserved(field)) continue;
    if (only != nullptr) return nullptr;
    only = &field;
  }
  return only;
}

enum class ObjectCode : std::uint8_t { domain = 2, var = 7, array = 8, record = 9 };

/// An object, or `count` objects of one shape with consecutive indices.
struct ObjectInfo {
  std::uint16_t index = 0;
  std::uint16_t count = 1;
  ObjectCode code = ObjectCode::var;
  std::string_view name = {};      ///< as the specification prints it; `#` is the number
  std::uint16_t first_number = 1;  ///< of the first of `count` objects, or of the only one
  Category category = Category::mandatory;
  /// When a conditional object has to be there. Beside that, an object has to be there in all
  /// devices that have a PDO that maps it.
  std::string_view condition = {};
  std::string_view clause = {};
  std::string_view errata = {};
  std::string_view description = {};
  /// Of the physical device: there is one of it, not one in each block (Profile::block_pitch).
  bool once = false;
  EntryInfo entry = {};        ///< of a variable or domain
  Items<EntryInfo> subs = {};  ///< of an array or record: sub-index 00h first

  /// Whatever its code, in the order of the sub-indices.
  constexpr std::span<const EntryInfo> entries() const {
    if (subs.empty()) return {&entry, 1};
    return {subs.begin(), subs.size()};
  }
};

/// The entry of an object with this sub-index, or null.
constexpr const EntryInfo* find_entry(const ObjectInfo& object, unsigned sub) {
  for (const EntryInfo& entry : object.entries()) {
    if (sub >= entry.sub_first && sub <= entry.last_sub()) return &entry;
  }
  return nullptr;
}
/// The name of an entry; of a variable that of the object.
constexpr std::string_view name_of(const ObjectInfo& object, const EntryInfo& entry) {
  return entry.name.empty() ? object.name : entry.name;
}

/// A raw bit pattern of an entry or field as a number: with its sign where it has one.
constexpr std::int64_t number_of(std::uint64_t pattern, unsigned bits, bool is_signed) {
  if (is_signed) return sign_extend(pattern, bits);
  return static_cast<std::int64_t>(bits >= 64 ? pattern : pattern & ((1ULL << bits) - 1));
}

/// The named value that contains a raw number, or null.
constexpr const NamedValue* find_name(const ValueInfo& value, std::int64_t number, unsigned bits,
                                      bool is_signed) {
  for (const NamedValue& named : value.names) {
    const auto first = number_of(static_cast<std::uint64_t>(named.first), bits, is_signed);
    const auto last = number_of(static_cast<std::uint64_t>(named.last), bits, is_signed);
    if (number >= first && number <= last) return &named;
  }
  return nullptr;
}
/// The scale that holds for a raw number.
constexpr const Scale& scale_of(const ValueInfo& value, std::int64_t number) {
  for (const Piece& piece : value.pieces) {
    if (number >= piece.first && number <= piece.last) return piece.scale;
  }
  return value.scale;
}
/// The first value that says that there is no value, or null.
constexpr const NamedValue* find_invalid(const ValueInfo& value) {
  for (const NamedValue& named : value.names) {
    if (named.meaning == Meaning::invalid) return &named;
  }
  return nullptr;
}

/// Emergency error codes that a profile gives a meaning to (CiA 301, 7.2.7).
struct ErrorCodeInfo {
  std::uint16_t code = 0;
  std::string_view text = {};
  std::string_view clause = {};
  std::string_view description = {};
};

/// What a PDO is beside a plain one (CiA 301, 7.2.2.5).
enum class MpdoKind : std::uint8_t { no, source, destination };

/// A data type of a profile's own that is a record (0040h to 007Fh).
struct RecordTypeInfo {
  std::uint16_t index = 0;
  std::string_view name = {};
  std::string_view clause = {};
  Items<EntryInfo> members = {};  ///< sub-index 00h first
};

/// Objects that a virtual device has: one, or those from `index` to `last`.
struct DeviceObject {
  std::uint16_t index = 0;
  Category category = Category::mandatory;
  Access access = Access::none;  ///< none: as the object's description says
  std::string_view condition = {};
  std::uint16_t last = 0;  ///< 0: there is only `index`
  bool consumed = false;   ///< the device takes it from another one that provides it
  /// What the clause of the device prints, where that is not what holds (`errata`).
  Access printed_access = Access::none;
  std::string_view errata = {};
};

/// A function that a device may have or leave, with the objects that belong to it. Each combination
/// of class and subclass is one; 0 where the specification uses none.
struct VirtualDeviceInfo {
  std::uint8_t code = 0;
  std::uint8_t device_class = 0;
  std::uint8_t subclass = 0;
  std::string_view name = {};
  std::string_view class_name = {};
  std::string_view subclass_name = {};
  Items<DeviceObject> objects = {};  ///< in the order of their indices
  std::string_view clause = {};
  std::string_view errata = {};
  std::string_view description = {};
};

/// A PDO that a profile defines beforehand, or several of one shape: the n-th after the first has
/// the number and the CAN-ID n above. PDOs that a profile describes as objects (1400h to 1BFFh) are
/// not repeated here.
struct PdoInfo {
  enum class Direction : std::uint8_t { transmit, receive };
  Direction direction = Direction::transmit;
  std::uint16_t number = 1;       ///< 0: not known
  std::uint16_t last_number = 0;  ///< 0: there is only `number`
  std::uint32_t cob_id = 0;       ///< as 1400h to 15FFh and 1800h to 19FFh have it: bit 31 invalid
  bool plus_node_id = false;
  Items<std::uint32_t> mapping = {};    ///< entries of the mapping record
  MpdoKind multiplexed = MpdoKind::no;  ///< what stands in sub-index 00h in place of their number
  std::uint8_t transmission_type = 255;
  std::uint16_t inhibit_time = 0;  ///< in 100 microseconds
  std::uint16_t event_timer = 0;   ///< in milliseconds
  std::string_view name = {};
  Items<std::uint8_t> devices = {};  ///< codes of the virtual devices that have it; empty: not said
  std::string_view condition = {};
  std::string_view clause = {};
  std::string_view errata = {};
};

/// Another reading of a specification that contradicts itself, where devices in the field will
/// differ.
struct ReadingInfo {
  std::string_view name = {};  ///< one word, as people select it
  std::string_view description = {};
  std::string_view errata = {};
  Items<const ObjectInfo*> objects = {};  ///< in place of those with the same indices
  Items<std::uint16_t> without = {};      ///< indices of objects that this reading does not have
};

/// Bits of 1000h, and what is in them.
struct DeviceTypeMatch {
  std::uint32_t mask = 0;
  std::uint32_t value = 0;

  constexpr bool fits(std::uint32_t device_type) const {
    return mask != 0 && (device_type & mask) == value;
  }
};

struct Provisions;

/// One profile. Where several logical devices share a dictionary, the objects of the n-th stand
/// (n - 1) x block_pitch above the described ones.
struct Profile {
  std::uint16_t number = 0;    ///< the low word of 1000h, but where `device_types` says otherwise
  std::string_view name = {};  ///< "CiA 417-4"
  std::string_view title = {};
  Items<const ObjectInfo*> objects = {};  ///< in the order of their indices
  std::uint16_t block_count = 1;
  std::uint16_t block_pitch = 0x800;
  Items<FieldInfo> device_type = {};  ///< of 1000h, the profile's number included
  /// Of a profile that is built on another one, and has its number in 1000h.
  DeviceTypeMatch device_types = {};
  const Profile* base = nullptr;  ///< that one: what is not described here is as it says
  Items<VirtualDeviceInfo> virtual_devices = {};
  /// 1000h of a virtual device; null: the number alone.
  std::uint32_t (*device_type_of)(const VirtualDeviceInfo& device) = nullptr;
  Items<PdoInfo> pdos = {};
  Items<ErrorCodeInfo> error_codes = {};
  Items<RecordTypeInfo> record_types = {};
  Items<ReadingInfo> readings = {};
  const Provisions* provisions = nullptr;  ///< provisions.hpp; null: none
};

/// The object of a profile at an index, or null; a block above the first is folded into it.
constexpr const ObjectInfo* find_object(const Profile& profile, unsigned index) {
  constexpr unsigned application_first = 0x6000;
  unsigned block = 0;
  if (index >= application_first) block = (index - application_first) / profile.block_pitch;
  if (block >= profile.block_count) block = 0;
  index -= block * profile.block_pitch;
  const ObjectInfo* const* first = profile.objects.begin();
  for (std::size_t count = profile.objects.size(); count > 1;) {
    const std::size_t half = count / 2;
    if (first[half]->index <= index) first += half;
    count -= half;
  }
  if (first == profile.objects.end() || index < (*first)->index) return nullptr;
  if (block > 0 && (*first)->once) return nullptr;
  return index - (*first)->index < (*first)->count ? *first : nullptr;
}

}  // namespace canvoy
