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
void gather(std::uint8_t* image, const MappedValue* values, const std::uint8_t* block) {
  for (unsigned i = 0; i < pdo_bytes_max / sizeof(Unit); ++i) {
    store(image + i * sizeof(Unit), load<Unit>(block + values[i].offset()));
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

// Hosts work with numbers.

/// Mask of 1 to 64 bits.
constexpr std::uint64_t mask_of(unsigned bits) {
  return ~std::uint64_t{0} >> (64 - bits);
}
[[maybe_unused]] inline std::uint64_t number_in(const PdoImage& image, unsigned position,
                                                unsigned bits) {
  check_invariant(bits != 0 && position + bits <= pdo_bits_max);
  return load<std::uint64_t>(image.data()) >> position & mask_of(bits);
}

/// A value in the form of the dictionary.
struct ValueBytes {
  explicit ValueBytes(std::uint64_t number, unsigned bits) : size((bits + 7) / 8) {
    store(bytes.data(), number);
  }
  std::span<const std::uint8_t> span() const { return {bytes.data(), size}; }
  std::uint64_t number() const { return load<std::uint64_t>(bytes.data()); }

  std::array<std::uint8_t, sizeof(std::uint64_t)> bytes;
  unsigned size;
};

/// True if the lower bits of a number are not those of a value in the dictionary.
[[maybe_unused]] inline bool differs(const std::uint8_t* value, unsigned bits,
                                     std::uint64_t number) {
  if (bits == 32) return load<std::uint32_t>(value) != static_cast<std::uint32_t>(number);
  if (bits == 16) return load<std::uint16_t>(value) != static_cast<std::uint16_t>(number);
  if (bits == 8) return *value != static_cast<std::uint8_t>(number);
  return load_unsigned({value, (bits + 7) / 8}) != (number & mask_of(bits));
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
  pdo.plan_ = Pdo::mixed;
  pdo.deeds_.value = MappedValue::apart;
  pdo.quick_ = false;
  pdo.stale_ = true;
}

inline void PdoService::keep_place(Pdo& pdo, unsigned position, const Entry& entry, unsigned bits) {
  EntryPlace place;
  unsigned deeds = MappedValue::skip;
  if (entry.row != nullptr) {
    place = node_.dictionary().place_of(entry);
    deeds = entry.row->is_text() ? MappedValue::set_text : MappedValue::nothing_more;
  }
  MappedValue& value = values_of(pdo)[position];
  if (value.set(place, bits)) places_.value.are_found = false;
  value.resolve(deeds);
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
inline unsigned PdoService::resolve(MappedValue& value) const {
  constexpr unsigned accesses = ServiceEvent::all_accesses;
  unsigned deeds = value.deeds() & (MappedValue::skip | MappedValue::set_text);
  if ((deeds & MappedValue::skip) != 0) return deeds;
  Dictionary& dictionary = node_.dictionary();
  const Entry entry = dictionary.entry_at(value.place());
  const EntryHooks hooks = entry.is_hooked(accesses) ? dictionary.find_hooks(entry) : EntryHooks{};
  if (!is_receive()) {
    if (hooks.reads) deeds |= MappedValue::refresh;
    value.resolve(deeds);
    return deeds;
  }
  const EntryShape& row = *entry.row;
  // A value with as many bits as its type has no unused bits to check.
  const std::int64_t* limits = nullptr;
  if (canvoy::has(row.traits, EntryTraits::limited)) {
    deeds |= MappedValue::limit;
    limits = dictionary.tables().numbers.data() + row.limits;
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
  if (!row.is_text() && dictionary.is_watched(entry)) deeds |= MappedValue::watch;
  value.resolve(deeds, limits, hooks);
  return deeds;
}

/// One copy of all, or full frames of values of one size.
std::uint8_t PdoService::plan_copies(const Pdo& pdo) const {
  if (pdo.bits_ % 8 != 0 || pdo.bits_ == 0) return Pdo::mixed;
  const MappedValue* values = values_of(pdo);
  const unsigned size = values[0].bits();
  unsigned end = values[0].offset();
  bool is_adjacent = true;
  bool is_uniform = pdo.bits_ == pdo_bits_max;
  for (unsigned i = 0, position = 0; position < pdo.bits_; ++i) {
    const unsigned bits = values[i].bits();
    check_invariant(bits != 0 && position + bits <= pdo.bits_);
    is_adjacent = is_adjacent && values[i].offset() == end && bits % 8 == 0;
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
    const std::uint8_t* block = node_.dictionary().values();
    const MappedValue* values = values_of(pdo);
    switch (pdo.plan_) {
      case Pdo::adjacent:
        return copy_bytes(image.data(), block + values->offset(), pdo.length_);
      case Pdo::bytes:
        return gather<std::uint8_t>(image.data(), values, block);
      case Pdo::words:
        return gather<std::uint16_t>(image.data(), values, block);
      case Pdo::longs:
        return gather<std::uint32_t>(image.data(), values, block);
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
      insert(image.data(), start, bits, dictionary.values() + value.offset());
      return true;
    }
    const Entry entry = dictionary.entry_at(value.place());
    if (asks && value.is(MappedValue::refresh)) static_cast<void>(dictionary.open_read(entry));
    const std::span<const std::uint8_t> present = entry.bytes();
    insert(image.data(), start, std::min(bits, static_cast<unsigned>(present.size() * 8)),
           present.data());
    return true;
  });
}

namespace {

/// True outside of its limits: in the arithmetic of its bits, which is independent of the sign. The
/// lower bits of `number` count.
[[gnu::always_inline]] inline bool is_outside(const MappedValue& value, std::uint64_t number) {
  const std::int64_t* const limits = value.limits();
  const auto low = static_cast<std::uint64_t>(limits[0]);
  const std::uint64_t range = static_cast<std::uint64_t>(limits[1]) - low;
  const unsigned unused = 64 - value.bits();
  return (number - low) << unused > range << unused;
}

/// Reason of a refusal; the sentinel is allowed beside the limits.
AbortCode check_number_of(const Dictionary& dictionary, const MappedValue& value,
                          std::uint64_t number) {
  if (!value.is(MappedValue::limit)) return AbortCode::none;
  const DictionaryTables& tables = dictionary.tables();
  const ValueBytes bytes(number, value.bits());
  return check_number(tables, tables.entries[value.place().row], bytes.bytes.data());
}

std::uint32_t refused_at(const MappedValue& value) {
  const EntryPlace place = value.place();
  return static_cast<std::uint32_t>(place.index) << 16 | unsigned{place.sub} << 8;
}

}  // namespace

/// A number outside may be a sentinel. Zeros follow the last bit of 64.
[[gnu::always_inline]] inline bool PdoService::are_within_limits(const Pdo& pdo,
                                                                 const PdoImage& image) {
  const MappedValue* value = values_of(pdo);
  auto rest = canvoy::load<std::uint64_t>(image.data());
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    if (value->is(MappedValue::limit) && is_outside(*value, rest)) [[unlikely]]
      return false;
    left -= bits;
    rest = rest >> (bits - 1) >> 1;
  }
  return true;
}

/// The first object that cannot take its value, or 0.
[[gnu::noinline]] std::uint32_t PdoService::ask_for_values(const Pdo& pdo,
                                                           const PdoImage& image) const {
  const Dictionary& dictionary = node_.dictionary();
  std::uint32_t refused = 0;
  for_values(pdo, [&](const MappedValue& value, unsigned start) {
    const ValueBytes bytes(number_in(image, start, value.bits()), value.bits());
    const std::uint32_t object = refused_at(value);
    AbortCode answer = check_number_of(dictionary, value, bytes.number());
    if (answer == AbortCode::none && value.asks()) {
      answer = value.ask_for(dictionary.entry_at(value.place()), bytes.span());
    }
    if (answer != AbortCode::none) refused = object;
    return refused == 0;
  });
  return refused;
}

/// Before they are written.
[[gnu::noinline]] void PdoService::note_changes(const Pdo& pdo, const PdoImage& image) {
  Dictionary& dictionary = node_.dictionary();
  const std::uint8_t* const block = dictionary.values();
  auto rest = canvoy::load<std::uint64_t>(image.data());
  const MappedValue* value = values_of(pdo);
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    if (value->is(MappedValue::watch) && differs(block + value->offset(), bits, rest)) {
      dictionary.note_change(value->place());
    }
    left -= bits;
    rest = rest >> (bits - 1) >> 1;
  }
}

[[gnu::noinline]] void PdoService::write_one_by_one(const Pdo& pdo, const PdoImage& image) {
  Dictionary& dictionary = node_.dictionary();
  const MappedValue* value = values_of(pdo);
  auto rest = canvoy::load<std::uint64_t>(image.data());
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    std::uint8_t* const place = dictionary.values() + value->offset();
    // Special values first: they have 8, 16 and 32 bits as well.
    // NOLINTNEXTLINE(bugprone-branch-clone)
    if (value->is(MappedValue::set_text | MappedValue::skip)) [[unlikely]] {
      const ValueBytes bytes(rest, bits);
      if (value->is(MappedValue::set_text)) {
        dictionary.set(dictionary.entry_at(value->place()), bytes.span());
      }
    } else if (bits == 32) {
      store(place, static_cast<std::uint32_t>(rest));
    } else if (bits == 16) {
      store(place, static_cast<std::uint16_t>(rest));
    } else if (bits == 8) {
      *place = static_cast<std::uint8_t>(rest);
    } else {
      const ValueBytes bytes(rest & mask_of(bits), bits);
      copy_bytes(place, bytes.bytes.data(), bytes.size);
    }
    left -= bits;
    rest = rest >> (bits - 1) >> 1;
  }
}

[[gnu::always_inline]] inline std::uint32_t PdoService::check_values(const Pdo& pdo,
                                                                     const PdoImage& image) const {
  const unsigned deeds = pdo.deeds_.value;
  const bool is_doubtful = (deeds & MappedValue::ask) != 0 ||
                           ((deeds & MappedValue::limit) != 0 && !are_within_limits(pdo, image));
  return is_doubtful ? ask_for_values(pdo, image) : 0;
}

/// Without any callback.
[[gnu::always_inline]] inline void PdoService::write_values(const Pdo& pdo, const PdoImage& image) {
  const unsigned deeds = pdo.deeds_.value;
  if ((deeds & MappedValue::watch) != 0) note_changes(pdo, image);
  (deeds & MappedValue::apart) != 0 ? write_one_by_one(pdo, image) : copy(pdo, image);
}

[[gnu::noinline]] void PdoService::announce_values(const Pdo& pdo) const {
  const Dictionary& dictionary = node_.dictionary();
  for_values(pdo, [&](const MappedValue& value, unsigned) {
    if (value.is(MappedValue::notify)) value.notify_of(dictionary.entry_at(value.place()));
    return true;
  });
}

std::uint32_t PdoService::take_values(const Pdo& pdo, const PdoImage& image) {
  const std::uint32_t refused = check_values(pdo, image);
  if (refused != 0) [[unlikely]]
    return refused;
  write_values(pdo, image);
  if ((pdo.deeds_.value & MappedValue::notify) != 0) announce_values(pdo);
  return 0;
}

std::uint32_t PdoService::carry_out(const Pdo& pdo, const PdoImage& image, Step step) {
  if (step == Step::check) return check_values(pdo, image);
  if (step == Step::write) {
    write_values(pdo, image);
  } else if ((pdo.deeds_.value & MappedValue::notify) != 0) {
    announce_values(pdo);
  }
  return 0;
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
