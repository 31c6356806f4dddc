#include "canvoy/canopen/pdo/pdo_mapping.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/pdo/pdo.hpp"

namespace canvoy {

namespace {

constexpr unsigned pdo_bits_max = pdo_bytes_max * 8;

/// Copies bytes; one, two, four or eight take one load and one store.
void copy_bytes(std::uint8_t* to, const std::uint8_t* from, unsigned size) {
  switch (size) {
    case 1:
      *to = *from;
      return;
    case 2:
      std::memcpy(to, from, 2);
      return;
    case 4:
      std::memcpy(to, from, 4);
      return;
    case 8:
      std::memcpy(to, from, 8);
      return;
    default:
      std::memcpy(to, from, size);
  }
}

/// Gathers values of one size, which fill the PDO.
template <class Unit>
void gather(std::uint8_t* image, const MappedValue* values) {
  for (unsigned i = 0; i < pdo_bytes_max / sizeof(Unit); ++i) {
    store(image + i * sizeof(Unit), load<Unit>(values[i].value()));
  }
}

/// Copies bit by bit to a place that is zero, for a small machine, which saves memory at the cost
/// of speed.
[[maybe_unused]] void copy_bits(std::uint8_t* to, unsigned to_bit, const std::uint8_t* from,
                                unsigned from_bit, unsigned count) {
  for (; count != 0; --count, ++to_bit, ++from_bit) {
    const unsigned bit = from[from_bit / 8] >> from_bit % 8 & 1;
    to[to_bit / 8] = static_cast<std::uint8_t>(to[to_bit / 8] | bit << to_bit % 8);
  }
}

/// Extracts 1 to 64 bits from the eight bytes of a PDO into the least number of bytes, which are
/// zero: for small machines.
[[maybe_unused]] void extract(const std::uint8_t* data, unsigned position, unsigned bits,
                              std::uint8_t* value) {
  check_invariant(bits != 0 && position + bits <= pdo_bits_max);
  copy_bits(value, 0, data, position, bits);
}

/// Inserts 0 to 64 bits of a value where a PDO is zero. A Boolean is true unless its byte is 0.
void insert(std::uint8_t* data, unsigned position, unsigned bits, const std::uint8_t* value) {
  check_invariant(position + bits <= pdo_bits_max);
  if constexpr (!Pdo::has_plans) {
    const std::uint8_t is_true = *value != 0 ? 1 : 0;
    return copy_bits(data, position, bits == 1 ? &is_true : value, 0, bits);
  }
  if (bits == 0) return;
  data += position / 8;
  const unsigned shift = position % 8;
  if (shift == 0 && bits % 8 == 0) return copy_bytes(data, value, bits / 8);
  for (;; bits -= 8) {
    unsigned byte = *value++;
    if (bits < 8) byte = bits == 1 ? byte != 0 : byte & (0xFFU >> (8 - bits));
    byte <<= shift;
    *data = static_cast<std::uint8_t>(*data | byte);
    ++data;
    if (byte > 0xFF) *data = static_cast<std::uint8_t>(byte >> 8);
    if (bits <= 8) return;
  }
}

}  // namespace

/// Finds the object in a mapping entry (index, sub-index, bits), or the reason why a PDO of this
/// direction cannot carry it; none for dummy entries (0001h to 0007h), which are for RPDOs only.
AbortCode PdoService::find_mapped(std::uint32_t mapped, Entry& entry) const {
  constexpr unsigned dummy_first = 0x0001;
  constexpr unsigned dummy_last = 0x0007;
  const auto index = static_cast<std::uint16_t>(mapped >> 16);
  const auto sub = static_cast<std::uint8_t>(mapped >> 8);
  const auto bits = static_cast<std::uint8_t>(mapped);
  unsigned length = 0;
  entry.row = nullptr;
  if (index - dummy_first <= dummy_last - dummy_first) {
    if (sub != 0) return AbortCode::no_sub_index;
    if (is_receive()) length = bit_length(static_cast<DataType>(index));
  } else {
    entry.index = index;
    entry.sub = sub;
    const AbortCode answer = node_.dictionary().locate_for_bus(entry);
    if (answer != AbortCode::none) return answer;
    const EntryShape& row = *entry.row;
    if (Pdo::has_plans && entry.value - node_.dictionary().values() > MappedValue::offset_max) {
      return AbortCode::not_mappable;
    }
    if (allows(row.access, kind_.mappable)) length = row.is_text() ? row.capacity * 8U : row.bits;
  }
  return bits != 0 && bits == length ? AbortCode::none : AbortCode::not_mappable;
}

/// Maps the first `count` entries of the record, or nothing. Logarithmic for each entry. Aborts:
/// value_range if `count` is too large, pdo_length for more than 64 bits, and those of
/// find_mapped().
AbortCode PdoService::map(Pdo& pdo, unsigned count) {
  pdo.bits_ = 0;
  if constexpr (Pdo::has_plans) forget_plan(pdo);
  if (count > (Pdo::has_plans ? places_.value.share : pdo_values_max))
    return AbortCode::value_range;
  unsigned bits = 0;
  for (unsigned i = 0; i < count; ++i) {
    const std::uint32_t written = mapped(pdo, i + 1);
    if (written == nothing) return AbortCode::value_range;
    Entry entry;
    const AbortCode answer = find_mapped(written, entry);
    if (answer != AbortCode::none) return answer;
    const auto size = static_cast<std::uint8_t>(written);
    bits += size;
    if (bits > pdo_bits_max) return AbortCode::pdo_length;
    if constexpr (Pdo::has_plans) keep_place(pdo, i, entry, size);
  }
  pdo.bits_ = static_cast<std::uint8_t>(bits);
  return AbortCode::none;
}

/// Discards properties that depend on the values; they are determined with the next frame.
inline void PdoService::forget_plan(Pdo& pdo) {
  // A mapping without entries is counted as well: announce_values() sees a change by the number.
  node_.count_mapping_read();
  pdo.plan_ = Pdo::mixed;
  pdo.deeds_.value = MappedValue::apart;
  pdo.quick_ = false;
  pdo.stale_ = true;
}

inline void PdoService::keep_place(Pdo& pdo, unsigned position, const Entry& entry, unsigned bits) {
  MappedValue& value = values_of(pdo)[position];
  const bool is_dummy = entry.row == nullptr;
  const bool is_other =
      value.set(is_dummy ? Entry{.value = node_.dictionary().values()} : entry, bits);
  if (is_other) places_.value.are_found = false;
  if (is_dummy) return value.resolve(MappedValue::skip);
  value.resolve(entry.row->is_text() ? MappedValue::set_text : MappedValue::nothing_more);
}

/// Determines the operations on each of its values, and on all of them.
void PdoService::resolve(Pdo& pdo) {
  pdo.stale_ = false;
  unsigned deeds = 0;
  MappedValue* value = values_of(pdo);
  for (unsigned bits = 0; bits < pdo.bits_; bits += value++->bits()) {
    check_invariant(value->bits() != 0);
    deeds |= resolve(*value);
  }
  constexpr unsigned one_by_one = MappedValue::set_text | MappedValue::skip | MappedValue::refresh;
  pdo.plan_ = Pdo::mixed;
  if ((deeds & one_by_one) == 0) pdo.plan_ = plan_copies(pdo) & Pdo::plan_mask;
  if (pdo.plan_ == Pdo::mixed) deeds |= MappedValue::apart;
  pdo.deeds_.value = static_cast<std::uint8_t>(deeds);
}

/// Determines the operations on a value with a place.
inline unsigned PdoService::resolve(MappedValue& value) {
  constexpr unsigned accesses = ServiceEvent::all_accesses;
  unsigned deeds = value.deeds() & (MappedValue::skip | MappedValue::set_text);
  if ((deeds & MappedValue::skip) != 0) return deeds;
  Dictionary& dictionary = node_.dictionary();
  const Entry& entry = value.entry();
  const EntryHooks hooks = entry.is_hooked(accesses) ? dictionary.find_hooks(entry) : EntryHooks{};
  if (!is_receive()) {
    if (hooks.reads) deeds |= MappedValue::refresh;
    value.resolve(deeds);
    return deeds;
  }
  const EntryShape& row = *entry.row;
  // A value with as many bits as its type has no unused bits to check.
  if (canvoy::has(row.traits, EntryTraits::limited)) {
    deeds |= MappedValue::limit;
    const std::int64_t* const limits = dictionary.tables().numbers.data() + row.limits;
    const bool is_range =
        canvoy::has(row.traits, EntryTraits::has_sign)
            ? limits[0] <= limits[1]
            : static_cast<std::uint64_t>(limits[0]) <= static_cast<std::uint64_t>(limits[1]);
    // If nearly every number is refused, each one is checked separately.
    if (!is_range) deeds |= MappedValue::ask;
  }
  if (hooks.ask != nullptr) deeds |= MappedValue::ask;
  if (hooks.notify != nullptr) deeds |= MappedValue::notify;
  // A string is set by the dictionary, which sees a change by itself.
  const EntryWatchers watchers = row.is_text() ? EntryWatchers{} : dictionary.find_watchers(entry);
  if (watchers.are_there) deeds |= MappedValue::watch;
  value.resolve(deeds, hooks, find_watcher(watchers));
  return deeds;
}

/// The position from 1 of a PDO that alone is concerned, among those of its service; 0 if there is
/// none, or another service has one already.
inline unsigned PdoService::find_watcher(const EntryWatchers& watchers) {
  if (watchers.only == nullptr) return 0;
  const Pdo& only = *static_cast<const Pdo*>(watchers.only);
  const Pdo* const first = only.owner_.value->pdos_;
  if (places_.value.watching == nullptr) places_.value.watching = first;
  return places_.value.watching == first ? static_cast<unsigned>(&only - first) + 1 : 0;
}

/// One copy of all, or full frames of values of one size.
std::uint8_t PdoService::plan_copies(const Pdo& pdo) const {
  if (pdo.bits_ % 8 != 0 || pdo.bits_ == 0) return Pdo::mixed;
  const MappedValue* values = values_of(pdo);
  const unsigned size = values[0].bits();
  const std::uint8_t* end = values[0].value();
  bool is_adjacent = true;
  bool is_uniform = pdo.bits_ == pdo_bits_max;
  for (unsigned i = 0, position = 0; position < pdo.bits_; ++i) {
    const unsigned bits = values[i].bits();
    check_invariant(bits != 0 && position + bits <= pdo.bits_);
    is_adjacent = is_adjacent && values[i].value() == end && bits % 8 == 0;
    is_uniform = is_uniform && bits == size;
    end += bits / 8;
    position += bits;
  }
  if (is_adjacent) return pdo.bits_ == pdo_bits_max ? Pdo::whole : Pdo::adjacent;
  if (!is_uniform) return Pdo::mixed;
  switch (size) {
    case 8:
      return Pdo::bytes;
    case 16:
      return Pdo::words;
    case 32:
      return Pdo::longs;
    default:
      return Pdo::mixed;
  }
}

void PdoService::look_again(Pdo& pdo) {
  const Dictionary& dictionary = node_.dictionary();
  if (places_.value.revision != dictionary.revision()) {
    places_.value.revision = dictionary.revision();
    for (Pdo& each : all()) {
      each.stale_ = true;
      each.quick_ = false;
    }
  }
  if (pdo.stale_) resolve(pdo);
}

/// The mapping was checked when it was written, or by the compiler. The indices of data types,
/// which dummy entries name, have no object.
[[gnu::always_inline]] inline bool PdoService::is_there(std::uint32_t mapped, Entry& entry) const {
  entry.index = static_cast<std::uint16_t>(mapped >> 16);
  entry.sub = static_cast<std::uint8_t>(mapped >> 8);
  return node_.dictionary().locate_for_bus(entry) == AbortCode::none;
}

void PdoService::pack_any(const Pdo& pdo, PdoImage& image, bool asks) {
  image = {};
  if constexpr (Pdo::has_plans) {
    const MappedValue* values = values_of(pdo);
    switch (pdo.plan_) {
      case Pdo::adjacent:
        return copy_bytes(image.data(), values->value(), pdo.length_);
      case Pdo::bytes:
        return gather<std::uint8_t>(image.data(), values);
      case Pdo::words:
        return gather<std::uint16_t>(image.data(), values);
      case Pdo::longs:
        return gather<std::uint32_t>(image.data(), values);
      default:
        break;
    }
  }
  if constexpr (Pdo::has_plans) {
    pack_values(pdo, image, asks);
  } else {
    go_through(pdo, image.data(), asks ? Step::refresh : Step::read);
  }
}

// Hosts use the resolved mapping.

/// A hook that refuses leaves the value unchanged.
void PdoService::pack_values(const Pdo& pdo, PdoImage& image, bool asks) {
  Dictionary& dictionary = node_.dictionary();
  for_values(pdo, [&](const MappedValue& value, unsigned start) {
    const unsigned bits = value.bits();
    if (!value.is(MappedValue::set_text | MappedValue::refresh)) {
      insert(image.data(), start, bits, value.value());
      return true;
    }
    const Entry entry = value.entry();
    if (asks && value.is(MappedValue::refresh)) static_cast<void>(dictionary.open_read(entry));
    const std::span<const std::uint8_t> present = entry.bytes();
    insert(image.data(), start, std::min(bits, static_cast<unsigned>(present.size() * 8)),
           present.data());
    return true;
  });
}

// A small machine reads the mapping record for each frame.

std::uint32_t PdoService::go_through(const Pdo& pdo, std::uint8_t* image, Step step) {
  if constexpr (Pdo::has_plans) return 0;
  Entry entry;
  unsigned bits = 0;
  // A hook may change the mapping meanwhile: bits_ is read again.
  for (unsigned i = 0, start = 0; start < pdo.bits_; ++i, start += bits) {
    const std::uint32_t written = mapped(pdo, i + 1);
    bits = written % 256;
    // The application may have written another record, without any hook.
    if (bits == 0 || start + bits > pdo.bits_) break;
    if (!is_there(written, entry)) continue;
    if (!access(image, {start, bits}, step, entry)) {
      return static_cast<std::uint32_t>(entry.index) << 16 | unsigned{entry.sub} << 8;
    }
  }
  return 0;
}

/// Carries out one step for one value.
inline bool PdoService::access(std::uint8_t* image, BitField field, Step step, Entry& entry) {
  Dictionary& dictionary = node_.dictionary();
  if (step <= Step::refresh) {
    // A hook that refuses leaves the value unchanged.
    if (step == Step::refresh) static_cast<void>(dictionary.open_read(entry));
    const std::span<const std::uint8_t> present = entry.bytes();
    const auto bits = std::min(field.bits, static_cast<unsigned>(present.size() * 8));
    insert(image, field.start, bits, present.data());
    return true;
  }
  std::array<std::uint8_t, MappedValue::bytes_max> value{};
  extract(image, field.start, field.bits, value.data());
  const std::span<const std::uint8_t> unpacked(value.data(), (field.bits + 7) / 8);
  if (step == Step::check) return dictionary.check(entry, unpacked) == AbortCode::none;
  if (step == Step::write) {
    dictionary.set(entry, unpacked);
  } else {
    dictionary.announce(entry, Source::pdo);
  }
  return true;
}

}  // namespace canvoy
