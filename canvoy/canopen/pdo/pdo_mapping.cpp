#include "canvoy/canopen/pdo/pdo_mapping.hpp"

#include <algorithm>

#include "canvoy/can/must_hold.hpp"
#include "canvoy/canopen/pdo/pdo.hpp"

namespace canvoy {

namespace {

constexpr unsigned pdo_bits_max = pdo_bytes_max * 8;

/// Of one, two, four or eight bytes it is one load and one store.
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

/// Values of one size, which fill the PDO.
template <class Unit>
void gather(std::uint8_t* image, const MappedValue* values, const std::uint8_t* block) {
  for (unsigned i = 0; i < pdo_bytes_max / sizeof(Unit); ++i) {
    store(image + i * sizeof(Unit), load<Unit>(block + values[i].offset()));
  }
}

/// Bit after bit, to where all is zero: what a small machine has not in speed, it has in memory.
[[maybe_unused]] void copy_bits(std::uint8_t* to, unsigned to_bit, const std::uint8_t* from,
                                unsigned from_bit, unsigned count) {
  for (; count != 0; --count, ++to_bit, ++from_bit) {
    const unsigned bit = from[from_bit / 8] >> from_bit % 8 & 1;
    to[to_bit / 8] = static_cast<std::uint8_t>(to[to_bit / 8] | bit << to_bit % 8);
  }
}

/// Takes 1 to 64 bits out of the eight bytes of a PDO, into as many whole bytes as they need, which
/// are zero.
void extract(const std::uint8_t* data, unsigned position, unsigned bits, std::uint8_t* value) {
  must_hold(bits != 0 && position + bits <= pdo_bits_max);
  if constexpr (!Pdo::has_plans) return copy_bits(value, 0, data, position, bits);
  const std::uint64_t number =
      load<std::uint64_t>(data) >> position & ~std::uint64_t{0} >> (64 - bits);
  if (bits <= 8) {
    *value = static_cast<std::uint8_t>(number);
    return;
  }
  std::array<std::uint8_t, sizeof number> bytes;
  store(bytes.data(), number);
  copy_bytes(value, bytes.data(), (bits + 7) / 8);
}

/// Puts 0 to 64 bits of a value where a PDO is zero. A Boolean is true whatever its byte is but 0.
void insert(std::uint8_t* data, unsigned position, unsigned bits, const std::uint8_t* value) {
  must_hold(position + bits <= pdo_bits_max);
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

/// The object that a mapping entry names (index, sub-index, bits), or why a PDO of this direction
/// cannot carry it; none for dummy entries (0001h to 0007h), which are for RPDOs only.
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
    if (allows(row.access, kind_.mappable)) length = row.is_text() ? row.capacity * 8U : row.bits;
  }
  return bits != 0 && bits == length ? AbortCode::none : AbortCode::not_mappable;
}

/// Maps what the first `count` entries of the record say, or nothing. Logarithmic for each entry.
/// Aborts: value_range where `count` is too large, pdo_length where there are more than 64 bits,
/// and those of find_mapped().
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
  if constexpr (Pdo::has_plans) pdo.plan_ = plan_copies(pdo) & Pdo::plan_mask;
  return AbortCode::none;
}

inline void PdoService::forget_plan(Pdo& pdo) {
  pdo.plan_ = Pdo::mixed;
  pdo.special_ = pdo.stale_ = pdo.simple_ = false;
  places_.value.found.pdo = nullptr;
}

inline void PdoService::keep_place(Pdo& pdo, unsigned position, const Entry& entry, unsigned bits) {
  const bool is_special = needs_more(entry);
  if (values_of(pdo)[position].set(place_of(entry), bits, is_special)) {
    places_.value.are_found = false;
  }
  if (is_special) pdo.special_ = true;
}

inline bool PdoService::is_special(const Pdo& pdo, unsigned position) const {
  return !Pdo::has_plans || values_of(pdo)[position].is_special();
}
inline std::uint8_t* PdoService::place_of(const Pdo& pdo, unsigned position) const {
  return node_.dictionary().values() + values_of(pdo)[position].offset();
}

/// From the start of the dictionary's values.
inline unsigned PdoService::place_of(const Entry& entry) const {
  return static_cast<unsigned>(entry.value - node_.dictionary().values());
}

/// What there is to know of its object must be looked up when the value is accessed.
inline bool PdoService::needs_more(const Entry& entry) const {
  constexpr unsigned received = ServiceEvent::bit_of(ServiceEvent::before_write) |
                                ServiceEvent::bit_of(ServiceEvent::after_write);
  constexpr unsigned sent = ServiceEvent::bit_of(ServiceEvent::before_read);
  if (entry.row == nullptr || entry.row->is_text()) return true;
  if (entry.is_hooked(is_receive() ? received : sent)) return true;
  const bool is_checked =
      entry.watchers() != 0 || canvoy::has(entry.row->traits, EntryTraits::limited);
  return (is_receive() && is_checked) || place_of(entry) > MappedValue::offset_max;
}

/// One copy of all, or full frames of values of one size.
std::uint8_t PdoService::plan_copies(const Pdo& pdo) const {
  if (pdo.bits_ % 8 != 0 || pdo.bits_ == 0 || pdo.special_) return Pdo::mixed;
  const MappedValue* values = values_of(pdo);
  const unsigned size = values[0].bits();
  unsigned end = values[0].offset();
  bool is_adjacent = true;
  bool is_uniform = pdo.bits_ == pdo_bits_max;
  for (unsigned i = 0, position = 0; position < pdo.bits_; ++i) {
    const unsigned bits = values[i].bits();
    must_hold(bits != 0 && position + bits <= pdo.bits_);
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
      each.simple_ = false;
    }
  }
  if (!pdo.stale_) return;
  map(pdo, mapped(pdo, 0));
}

/// What is mapped was checked when it was written, or by the compiler. Nothing stands where the
/// data types do, which dummy entries name.
[[gnu::always_inline]] inline bool PdoService::is_there(std::uint32_t mapped, Entry& entry) const {
  entry.index = static_cast<std::uint16_t>(mapped >> 16);
  entry.sub = static_cast<std::uint8_t>(mapped >> 8);
  return node_.dictionary().locate_for_bus(entry) == AbortCode::none;
}

bool PdoService::find_value(const Pdo& pdo, unsigned position, Entry& entry) const {
  const std::uint32_t written = mapped(pdo, position + 1);
  if (!is_there(written, entry)) return false;
  // The application may have written another record, past all hooks.
  return !Pdo::has_plans || static_cast<std::uint8_t>(written) == values_of(pdo)[position].bits();
}

/// The same, remembered from one step to the next.
inline bool PdoService::find_once(const Pdo& pdo, unsigned position, Entry& entry) {
  FoundValue& found = places_.value.found;
  if (found.pdo == &pdo && found.position == position) {
    entry = found.entry;
    return true;
  }
  if (!find_value(pdo, position, entry)) return false;
  if (is_receive()) found = {&pdo, position, entry};
  return true;
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
  go_through(pdo, image.data(), asks ? Step::refresh : Step::read);
}

std::uint32_t PdoService::go_through(const Pdo& pdo, std::uint8_t* image, Step step) {
  Entry entry;
  unsigned bits = 0;
  // A hook may change the mapping under our feet: bits_ is looked at anew.
  for (unsigned i = 0, start = 0; start < pdo.bits_; ++i, start += bits) {
    const std::uint32_t written = Pdo::has_plans ? nothing : mapped(pdo, i + 1);
    bits = Pdo::has_plans ? values_of(pdo)[i].bits() : written % 256;
    // The application may have written another record, past all hooks.
    if (bits == 0 || start + bits > pdo.bits_) break;
    if (!is_special(pdo, i)) {
      if (step <= Step::refresh) insert(image, start, bits, place_of(pdo, i));
      if (step == Step::write) extract(image, start, bits, place_of(pdo, i));
      continue;
    }
    if (!(Pdo::has_plans ? find_once(pdo, i, entry) : is_there(written, entry))) continue;
    if (!access(image, {start, bits}, step, entry)) {
      return static_cast<std::uint32_t>(entry.index) << 16 | unsigned{entry.sub} << 8;
    }
  }
  return 0;
}

/// One step with one value.
inline bool PdoService::access(std::uint8_t* image, BitField field, Step step, Entry& entry) {
  Dictionary& dictionary = node_.dictionary();
  if (step <= Step::refresh) {
    // A hook that refuses leaves the value as it is.
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
