// The vocabulary of profile descriptions: the name of an object, its contents, the meaning of its
// bits and the clause that defines it.
//
// A profile is constexpr data in these terms, written once (canvoy/profiles/cia419.hpp). Everything
// else is derived from it: the dictionary of a node (layout.hpp), typed access (handle.hpp),
// decoding, files, checks and documents. The data that a node needs on the bus is copied into
// ObjectRow and EntryRow at compile time. Names, units and texts stay here, and a device that does
// not use them does not contain them. Most of it is written in rows (rows.hpp):
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
#include "canvoy/profiles/model/unit.hpp"

namespace canvoy {

/// A view of constant items that live as long as the program: an array, or one item.
template <class Item>
class Items {
 public:
  constexpr Items() = default;
  /// One item, which must be static.
  constexpr Items(const Item& item)
      : first_(&item), count_(1) {}  // NOLINT(google-explicit-constructor)
  /// Refused: a temporary would not live long enough.
  Items(const Item&&) = delete;  // a temporary would not live long enough
  /// An array of any length, which must be static.
  template <std::size_t count>
  constexpr Items(const Item (&items)[count])  // NOLINT(google-explicit-constructor)
      : first_(items), count_(count) {}
  /// An array of any length, which must be static.
  template <std::size_t count>
  constexpr Items(const std::array<Item, count>& items)  // NOLINT(google-explicit-constructor)
      : first_(items.data()), count_(count) {}
  /// Refused: a temporary would not live long enough.
  template <std::size_t count>
  Items(const std::array<Item, count>&&) = delete;
  /// Some items of an array, which must be static.
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

/// Meaning of a named raw value for the quantity that it replaces.
enum class Meaning : std::uint8_t {
  state,            ///< a normal value: an enumerator
  invalid,          ///< no value: not measured, not available
  failure,          ///< no value because of a fault
  not_implemented,  ///< never a value: the device does not have it
  do_not_care,      ///< the receiver keeps its own value
  manufacturer,     ///< the maker of the device defines the meaning
  reserved,         ///< must not be sent
  padding,          ///< contents of reserved bits: without meaning, and ignored
};

/// A raw value, or the values from `first` to `last`, with a name.
struct NamedValue {
  std::int64_t first = 0;            ///< the raw number, or the lowest one
  std::int64_t last = 0;             ///< the highest one, included
  std::string_view name = {};        ///< as printed in the specification
  Meaning meaning = Meaning::state;  ///< what it means for the quantity

  constexpr NamedValue() = default;
  /// Names one raw value.
  template <class Value>
    requires(std::is_enum_v<Value> || std::integral<Value>)
  constexpr NamedValue(Value value, std::string_view value_name,
                       Meaning value_meaning = Meaning::state)
      : NamedValue(value, value, value_name, value_meaning) {}
  /// Names the raw values from `first_value` to `last_value`, both included.
  template <class Value>
    requires(std::is_enum_v<Value> || std::integral<Value>)
  constexpr NamedValue(Value first_value, Value last_value, std::string_view value_name,
                       Meaning value_meaning)
      : first(static_cast<std::int64_t>(first_value)),
        last(static_cast<std::int64_t>(last_value)),
        name(value_name),
        meaning(value_meaning) {}
};

/// Raw values that are allowed beside the named ones.
struct Limits {
  /// What becomes of other values.
  enum class Kind : std::uint8_t {
    none,      ///< all values of the type
    absolute,  ///< others are refused
    minimum,   ///< these must be supported; a device may support more
  };
  Kind kind = Kind::none;  ///< none: `low` and `high` mean nothing
  std::int64_t low = 0;    ///< raw, included
  std::int64_t high = 0;   ///< raw, included
};
/// Limits beyond which a value is refused (0609 0030h to 0032h).
constexpr Limits within(std::int64_t low, std::int64_t high) {
  return {Limits::Kind::absolute, low, high};
}
/// Limits that each device must support; a wider range is allowed.
constexpr Limits at_least(std::int64_t low, std::int64_t high) {
  return {Limits::Kind::minimum, low, high};
}

/// Form in which a number is displayed and entered.
enum class Notation : std::uint8_t {
  number,
  hexadecimal,  ///< for codes: COB-IDs, device types, CRCs
  bcd,          ///< binary coded decimal digits
  characters,   ///< bytes are characters, the first in the least significant byte
  bit_mask,     ///< each bit separately
};

/// Raw values from `first` to `last` that have a separate scale.
struct Piece {
  std::int64_t first = 0;      ///< raw, included
  std::int64_t last = 0;       ///< raw, included
  Scale scale = {};            ///< for the range
  std::string_view name = {};  ///< name of the range: "north", "west"
};

/// Another entry that gives the number of scale steps in one count. For values in several objects,
/// its index is that of the first object, and the entries for the others have the same distance
/// from it as the values.
struct StepEntry {
  std::uint16_t index = 0;  ///< 0: none
  std::uint8_t sub = 0;     ///< 0: that of the value
};

/// Another entry that gives the unit: a byte with a code of CiA 303-2 from `first_bit` on, and
/// above it a byte with the code of a prefix (si_unit.hpp). It is located like a StepEntry.
struct UnitEntry {
  std::uint16_t index = 0;     ///< 0: none
  std::uint8_t sub = 0;        ///< 0: that of the value
  std::uint8_t first_bit = 0;  ///< of the code of the unit
};

/// Whether a number without a unit is an amount.
enum class Counting : std::uint8_t {
  by_names,    ///< where some raw values mean that there is none, and others have no name
  counts,      ///< it counts or measures
  identifies,  ///< it is a code: it cannot be added
};

/// Meaning of the raw number in an entry, or in some bits of it.
struct ValueInfo {
  Unit unit = Unit::none;        ///< of the physical value
  Scale scale = {};              ///< from the raw number to the unit
  Limits limits = {};            ///< of raw numbers
  Items<NamedValue> names = {};  ///< raw values with a name: enumerators, sentinels, reserved codes
  Notation notation = Notation::number;  ///< for people and files
  Items<Piece> pieces = {};  ///< where the scale differs between ranges: used instead of it
  /// Set where the device defines the scale: `scale` holds while that entry has its default, and
  /// grows in proportion with it.
  StepEntry step = {};
  /// Set where the device defines the unit: `unit` holds while that entry has its default, or does
  /// not exist.
  UnitEntry unit_entry = {};
  Counting counting = Counting::by_names;  ///< whether it is an amount
};

/// Holds while another field of the same entry has one of the values from `first` to `last`.
struct FieldCondition {
  std::string_view field = {};  ///< name of the other field, as printed
  std::int64_t first = 0;       ///< raw, included
  std::int64_t last = 0;        ///< raw, included
};

/// Some bits of an entry. Their meaning may depend on other bits: then several fields describe the
/// same bits, each with the conditions under which it holds.
struct FieldInfo {
  std::uint8_t first_bit = 0;         ///< 0: the least significant
  std::uint8_t bits = 1;              ///< number of bits
  std::string_view name = {};         ///< `#` stands for `number`
  bool is_signed = false;             ///< two's complement
  ValueInfo value = {};               ///< meaning of the number in the bits
  std::string_view description = {};  ///< a sentence for documents; may be empty
  Items<FieldCondition> when = {};    ///< all must hold; of those on the same field, one
  std::uint16_t number = 0;           ///< number of this field among several of a kind
};

/// True for bits without a meaning: their required contents are padding, all other values are
/// reserved.
constexpr bool is_reserved(const FieldInfo& field) {
  bool has_padding = false;
  for (const NamedValue& named : field.value.names) {
    if (named.meaning != Meaning::padding && named.meaning != Meaning::reserved) return false;
    has_padding = has_padding || named.meaning == Meaning::padding;
  }
  return has_padding;
}

/// Fields of one shape, adjacent from `first.first_bit` on, numbered upward from `first.number` (0:
/// from 1).
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

/// Fields and arrays of fields as one array.
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

/// Whether a device must have an object or entry; conditional: where a condition holds.
enum class Category : std::uint8_t { mandatory, optional, conditional };

/// The value of an entry after power-on.
struct Default {
  /// Where the value comes from; highest_sub: from the entries that the device has.
  enum class Kind : std::uint8_t { none, number, plus_node_id, text, highest_sub };
  Kind kind = Kind::none;      ///< none: see EntryInfo::initial
  std::int64_t number = 0;     ///< a number, or what the node-ID is added to
  std::string_view text = {};  ///< of a string

  constexpr Default() = default;
  /// A number, or the bits of a real.
  template <std::integral Number>
  constexpr Default(Number value)  // NOLINT(google-explicit-constructor)
      : kind(Kind::number), number(static_cast<std::int64_t>(value)) {}
  /// The text of a string, which must be static.
  constexpr Default(const char* value)  // NOLINT(google-explicit-constructor)
      : kind(Kind::text), text(value) {}
  constexpr explicit operator bool() const { return kind != Kind::none; }
};
/// `base` plus the node-ID, like the CAN-IDs of the pre-defined connection set.
constexpr Default plus_node_id(std::uint32_t base) {
  Default made(base);
  made.kind = Default::Kind::plus_node_id;
  return made;
}

/// Default of sub-index 00h: the highest sub-index of the device. `printed` is the value in the
/// specification, 0 where the device defines it.
constexpr Default highest_sub(std::uint8_t printed = 0) {
  Default made(printed);
  made.kind = Default::Kind::highest_sub;
  return made;
}

/// Entries of one shape: one sub-index, or those from sub_first to sub_last.
struct EntryInfo {
  std::uint8_t sub_first = 0;  ///< the first sub-index, or the only one
  std::uint8_t sub_last = 0;   ///< below sub_first: only sub_first
  /// As printed in the specification. `#` stands for a number that counts with the sub-index: the
  /// first entry has `first_number`.
  std::string_view name = {};
  std::uint16_t first_number = 1;       ///< number in the name of the first entry
  DataType type = DataType::unsigned8;  ///< on the wire
  /// Access in the provider of the object. In CiA 407 and 447, consumers have another one.
  Access access = Access::ro;
  Access consumer_access = Access::none;  ///< none: the same as `access`
  /// The virtual device defines the access (DeviceObject::access); `access` is the widest one.
  bool access_by_device = false;
  bool or_const = false;          ///< the maker may choose const instead of `access`: "rw or const"
  Mapping mapping = Mapping::no;  ///< into a PDO
  Category category = Category::mandatory;  ///< whether an object must have it
  std::string_view condition = {};          ///< when a conditional entry is mandatory
  std::uint16_t capacity = 0;               ///< maximum number of bytes of a string
  bool capacity_is_printed = false;         ///< from the specification; otherwise our choice
  Default initial = {};  ///< none: the first value that says "invalid", or 0, or the lowest allowed
  Default consumer_initial = {};      ///< none: the same as `initial`
  ValueInfo value = {};               ///< meaning of the number, without fields
  Items<FieldInfo> fields = {};       ///< where the bits have separate meanings
  std::string_view clause = {};       ///< where it differs from the object's
  std::string_view errata = {};       ///< numbers of the findings that decided something
  std::string_view description = {};  ///< a sentence for documents; may be empty

  /// The last sub-index that it describes.
  constexpr std::uint8_t last_sub() const { return sub_last < sub_first ? sub_first : sub_last; }
};

/// The only field of an entry beside reserved bits, or null if there are none or several.
constexpr const FieldInfo* only_field(const EntryInfo& entry) {
  const FieldInfo* only = nullptr;
  for (const FieldInfo& field : entry.fields) {
    if (is_reserved(field)) continue;
    if (only != nullptr) return nullptr;
    only = &field;
  }
  return only;
}

/// Object code, with its number in EDS files (CiA 301, 7.4.3).
enum class ObjectCode : std::uint8_t { domain = 2, var = 7, array = 8, record = 9 };

/// An object, or `count` objects of one shape with consecutive indices.
struct ObjectInfo {
  std::uint16_t index = 0;            ///< of the first object
  std::uint16_t count = 1;            ///< of objects with consecutive indices
  ObjectCode code = ObjectCode::var;  ///< variable, array, record or domain
  std::string_view name = {};      ///< as printed in the specification; `#` stands for the number
  std::uint16_t first_number = 1;  ///< of the first of `count` objects, or of the only one
  Category category = Category::mandatory;  ///< whether a device must have it
  /// When a conditional object is mandatory. In addition, an object is mandatory in all devices
  /// that have a PDO that maps it.
  std::string_view condition = {};
  std::string_view clause = {};       ///< of the specification
  std::string_view errata = {};       ///< numbers of the findings that decided something
  std::string_view description = {};  ///< a sentence for documents; may be empty
  /// True for an object of the physical device, which exists once and not in each block
  /// (Profile::block_pitch).
  bool once = false;
  EntryInfo entry = {};        ///< for a variable or domain
  Items<EntryInfo> subs = {};  ///< for an array or record: sub-index 00h first

  /// All entries, for any object code, in the order of the sub-indices.
  constexpr std::span<const EntryInfo> entries() const {
    if (subs.empty()) return {&entry, 1};
    return {subs.begin(), subs.size()};
  }
};

/// The entry with this sub-index, or null.
constexpr const EntryInfo* find_entry(const ObjectInfo& object, unsigned sub) {
  for (const EntryInfo& entry : object.entries()) {
    if (sub >= entry.sub_first && sub <= entry.last_sub()) return &entry;
  }
  return nullptr;
}
/// Name of an entry; for a variable, the name of the object.
constexpr std::string_view name_of(const ObjectInfo& object, const EntryInfo& entry) {
  return entry.name.empty() ? object.name : entry.name;
}

/// A raw bit pattern of an entry or field as a number, signed where the type is.
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
/// The scale that applies to a raw number.
constexpr const Scale& scale_of(const ValueInfo& value, std::int64_t number) {
  for (const Piece& piece : value.pieces) {
    if (number >= piece.first && number <= piece.last) return piece.scale;
  }
  return value.scale;
}
/// The first named value that means "no value", or null.
constexpr const NamedValue* find_invalid(const ValueInfo& value) {
  for (const NamedValue& named : value.names) {
    if (named.meaning == Meaning::invalid) return &named;
  }
  return nullptr;
}

/// Emergency error codes that a profile defines (CiA 301, 7.2.7).
struct ErrorCodeInfo {
  std::uint16_t code = 0;             ///< as in the emergency object
  std::string_view text = {};         ///< for people, as short as a label
  std::string_view clause = {};       ///< of the specification
  std::string_view description = {};  ///< a sentence for documents; may be empty
};

/// Kind of a multiplexed PDO; `no` for a plain one (CiA 301, 7.2.2.5).
enum class MpdoKind : std::uint8_t { no, source, destination };

/// A record data type that a profile defines (0040h to 007Fh).
struct RecordTypeInfo {
  std::uint16_t index = 0;        ///< 0040h to 007Fh
  std::string_view name = {};     ///< as printed in the specification
  std::string_view clause = {};   ///< of the specification
  Items<EntryInfo> members = {};  ///< sub-index 00h first
};

/// Objects that a virtual device has: one, or those from `index` to `last`.
struct DeviceObject {
  std::uint16_t index = 0;                  ///< the first index
  Category category = Category::mandatory;  ///< whether the virtual device must have it
  Access access = Access::none;             ///< none: as in the object's description
  std::string_view condition = {};          ///< when a conditional object is mandatory
  std::uint16_t last = 0;                   ///< 0: only `index`
  bool consumed = false;  ///< the device consumes it from another one that provides it
  /// Access that the clause of the device prints, where another one applies (`errata`).
  Access printed_access = Access::none;
  std::string_view errata = {};  ///< numbers of the findings that decided something
};

/// An optional function of a device, with its objects. Each combination of class and subclass is a
/// separate function; 0 where the specification uses none.
struct VirtualDeviceInfo {
  std::uint8_t code = 0;                ///< number of the virtual device
  std::uint8_t device_class = 0;        ///< 0: the specification uses none
  std::uint8_t subclass = 0;            ///< 0: the specification uses none
  std::string_view name = {};           ///< as printed in the specification
  std::string_view class_name = {};     ///< empty where there is no class
  std::string_view subclass_name = {};  ///< empty where there is no subclass
  Items<DeviceObject> objects = {};     ///< in the order of their indices
  std::string_view clause = {};         ///< of the specification
  std::string_view errata = {};         ///< numbers of the findings that decided something
  std::string_view description = {};    ///< a sentence for documents; may be empty
};

/// A PDO that a profile pre-defines, or several of one shape: number and CAN-ID of the n-th after
/// the first are n higher. PDOs that a profile describes as objects (1400h to 1BFFh) are not
/// repeated here.
struct PdoInfo {
  /// As the described device sees it: TPDO or RPDO.
  enum class Direction : std::uint8_t { transmit, receive };
  Direction direction = Direction::transmit;  ///< TPDO or RPDO
  std::uint16_t number = 1;                   ///< 0: not known
  std::uint16_t last_number = 0;              ///< 0: only `number`
  std::uint32_t cob_id = 0;           ///< as in 1400h to 15FFh and 1800h to 19FFh: bit 31: invalid
  bool plus_node_id = false;          ///< the CAN-ID is that plus the node-ID
  Items<std::uint32_t> mapping = {};  ///< entries of the mapping record
  MpdoKind multiplexed = MpdoKind::no;   ///< value of sub-index 00h instead of their number
  std::uint8_t transmission_type = 255;  ///< see transmission_type
  std::uint16_t inhibit_time = 0;        ///< in 100 microseconds
  std::uint16_t event_timer = 0;         ///< in milliseconds
  std::string_view name = {};            ///< as printed in the specification
  Items<std::uint8_t> devices = {};      ///< codes of virtual devices; empty: not specified
  std::string_view condition = {};       ///< when a device must have it
  std::string_view clause = {};          ///< of the specification
  std::string_view errata = {};          ///< numbers of the findings that decided something
};

/// Another reading of a specification that contradicts itself, where devices in the field may
/// differ.
struct ReadingInfo {
  std::string_view name = {};             ///< one word, for selection by users
  std::string_view description = {};      ///< a sentence for users
  std::string_view errata = {};           ///< numbers of the findings that it is about
  Items<const ObjectInfo*> objects = {};  ///< replace those with the same indices
  Items<std::uint16_t> without = {};      ///< indices of objects that this reading does not have
};

/// Bits of 1000h and their contents.
struct DeviceTypeMatch {
  std::uint32_t mask = 0;   ///< bits that count; 0: fits nothing
  std::uint32_t value = 0;  ///< of these bits

  /// True if a value of 1000h has these bits.
  constexpr bool fits(std::uint32_t device_type) const {
    return mask != 0 && (device_type & mask) == value;
  }
};

struct Provisions;

/// One profile. Where several logical devices share a dictionary, the objects of the n-th are (n -
/// 1) x block_pitch above the described ones.
struct Profile {
  std::uint16_t number = 0;               ///< the low word of 1000h, unless `device_types` differs
  std::string_view name = {};             ///< "CiA 417-4"
  std::string_view title = {};            ///< as the specification is called
  Items<const ObjectInfo*> objects = {};  ///< in the order of their indices
  std::uint16_t block_count = 1;          ///< logical devices in one dictionary, 1 to 8
  std::uint16_t block_pitch = 0x800;      ///< distance of their objects
  Items<FieldInfo> device_type = {};      ///< fields of 1000h, the profile's number included
  /// For a profile that is built on another one and has its number in 1000h.
  DeviceTypeMatch device_types = {};
  const Profile* base = nullptr;  ///< the other profile: it defines what is not described here
  Items<VirtualDeviceInfo> virtual_devices = {};  ///< all functions that it describes
  /// 1000h of a virtual device; null: only the number.
  std::uint32_t (*device_type_of)(const VirtualDeviceInfo& device) = nullptr;
  Items<PdoInfo> pdos = {};                 ///< by default
  Items<ErrorCodeInfo> error_codes = {};    ///< in the order of their codes
  Items<RecordTypeInfo> record_types = {};  ///< that its objects have
  Items<ReadingInfo> readings = {};         ///< that users can choose
  const Provisions* provisions = nullptr;   ///< provisions.hpp; null: none
};

/// The object of a profile at an index, or null. A block above the first is folded into it.
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
