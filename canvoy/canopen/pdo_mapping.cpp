#include "canvoy/canopen/pdo_mapping.hpp"

#include <algorithm>
#include <bit>

namespace canvoy {

namespace {

constexpr unsigned pdo_bits_max = pdo_bytes_max * 8;

constexpr std::uint64_t mask_of(unsigned bits) {
  return ~std::uint64_t{0} >> (64 - bits);
}

/// A value on its way into the dictionary, as long as its entry.
struct Unpacked {
  Unpacked(const MappedValue& value, std::uint64_t image) {
    store(bytes.data(), (image >> value.position) & mask_of(value.bits));
    size = (value.bits + 7U) / 8;
  }
  operator std::span<const std::uint8_t>() const { return {bytes.data(), size}; }

  PdoImage bytes;
  std::size_t size;
};

std::uint64_t load_image(const std::uint8_t* data, unsigned bytes) {
  return load_unsigned({data, bytes});
}

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

void write_value(Dictionary& dictionary, const MappedValue& value, std::uint64_t image) {
  const Unpacked unpacked(value, image);
  const Entry& entry = value.entry;
  if (is_string(entry.row->type)) return dictionary.set(entry, unpacked);
  if (entry.state->watchers != 0 &&
      std::memcmp(entry.value, unpacked.bytes.data(), unpacked.size) != 0) {
    dictionary.mark_changed(entry.state->watchers);
  }
  copy_bytes(entry.value, unpacked.bytes.data(), static_cast<unsigned>(unpacked.size));
}

bool is_whole_bytes(const MappedValue& value) {
  return value.position % 8 == 0 && value.bits % 8 == 0;
}

/// Dummy entries are the data types 0001h to 0007h, as if they were objects.
Result<MappedValue> check_dummy(unsigned index, unsigned sub, unsigned bits,
                                PdoDirection direction) {
  if (sub != 0) return AbortCode::no_sub_index;
  const bool fits = bits == bit_length(static_cast<DataType>(index));
  if (direction == PdoDirection::transmit || !fits) return AbortCode::not_mappable;
  MappedValue dummy;
  dummy.bits = static_cast<std::uint8_t>(bits);
  return dummy;
}

bool is_hooked(const Dictionary& dictionary, const Entry& entry, PdoDirection direction) {
  const Dictionary::Watched watched = dictionary.watched(entry);
  return direction == PdoDirection::transmit ? watched.reads : watched.writes;
}

}  // namespace

Result<MappedValue> check_mapped_entry(const Dictionary& dictionary, std::uint32_t mapped,
                                       PdoDirection direction) {
  const auto index = static_cast<std::uint16_t>(mapped >> 16);
  const auto sub = static_cast<std::uint8_t>(mapped >> 8);
  const auto bits = static_cast<std::uint8_t>(mapped);
  constexpr unsigned dummy_first = 0x0001;
  constexpr unsigned dummy_last = 0x0007;
  if (index >= dummy_first && index <= dummy_last) {
    return check_dummy(index, sub, bits, direction);
  }
  const Result<Entry> entry = dictionary.find(index, sub);
  if (!entry) return entry.abort();
  const EntryRow& row = *entry->row;
  const Access needed = direction == PdoDirection::receive ? Access::rpdo : Access::tpdo;
  const unsigned length = is_string(row.type) ? row.capacity * 8U : bit_length(row.type);
  if (!allows(row.access, needed) || bits == 0 || bits != length) return AbortCode::not_mappable;
  return MappedValue{*entry, 0, bits, is_hooked(dictionary, *entry, direction)};
}

AbortCode check_mapping_write(const Dictionary& dictionary, const Entry& entry,
                              std::span<const std::uint8_t> value, const PdoWrite& pdo,
                              PdoMapping& scratch) {
  if (pdo.valid) return AbortCode::unsupported_access;
  const auto written = static_cast<std::uint32_t>(load_unsigned(value));
  if (entry.sub == 0) {
    const bool multiplexed = pdo.can_be_multiplexed && mpdo_mode(written) != MpdoMode::none;
    return multiplexed ? AbortCode::none
                       : scratch.resolve(dictionary, entry.index, written, pdo.direction);
  }
  if (dictionary.number(entry.index, 0) != 0) return AbortCode::unsupported_access;
  // Zero empties an entry, as masters do with those that they do not use.
  if (written == 0) return AbortCode::none;
  return check_mapped_entry(dictionary, written, pdo.direction).abort();
}

void PdoMapping::use(std::span<MappedValue> memory) {
  memory_ = memory.first(std::min<std::size_t>(memory.size(), pdo_values_max));
  clear();
}

void PdoMapping::clear() {
  value_count_ = copy_count_ = bits_ = unit_ = 0;
  watchers_ = 0;
  copied_ = unchecked_ = hooked_ = false;
}

AbortCode PdoMapping::resolve(const Dictionary& dictionary, std::uint16_t record, unsigned count,
                              PdoDirection direction) {
  clear();
  revision_ = dictionary.revision();
  const AbortCode answer = count > memory_.size()
                               ? AbortCode::value_range
                               : append_entries(dictionary, record, count, direction);
  if (answer != AbortCode::none) {
    clear();
    return answer;
  }
  hooked_ = std::ranges::any_of(values(), &MappedValue::hooked);
  unchecked_ = std::ranges::none_of(values(), [](const MappedValue& value) {
    return !value.is_dummy() &&
           (value.hooked || has(value.entry.row->traits, EntryTraits::limited));
  });
  copied_ = plan_copies(direction);
  unit_ = common_size();
  return AbortCode::none;
}

AbortCode PdoMapping::append_entries(const Dictionary& dictionary, std::uint16_t record,
                                     unsigned count, PdoDirection direction) {
  for (unsigned i = 0; i < count; ++i) {
    const Result<Entry> entry = dictionary.find(record, static_cast<std::uint8_t>(i + 1));
    if (!entry) return AbortCode::value_range;
    const auto mapped = static_cast<std::uint32_t>(load_unsigned(entry->bytes()));
    const Result<MappedValue> value = check_mapped_entry(dictionary, mapped, direction);
    if (!value) return value.abort();
    if (bits_ + unsigned{value->bits} > pdo_bits_max) return AbortCode::pdo_length;
    memory_[value_count_] = *value;
    memory_[value_count_].position = bits_;
    bits_ = static_cast<std::uint8_t>(bits_ + value->bits);
    ++value_count_;
  }
  return AbortCode::none;
}

bool PdoMapping::plan_copies(PdoDirection direction) {
  if (direction == PdoDirection::receive && hooked_) return false;
  for (const MappedValue& value : values()) {
    if (value.is_dummy()) continue;
    if (!is_whole_bytes(value) || is_string(value.entry.row->type)) return false;
  }
  for (const MappedValue& value : values()) {
    if (value.is_dummy()) continue;
    append_copy(value);
    watchers_ |= value.entry.state->watchers;
  }
  return true;
}

std::uint8_t PdoMapping::common_size() const {
  const auto copies = std::span(copies_).first(copy_count_);
  if (copies.empty() || (copies[0].size & (copies[0].size - 1)) != 0) return 0;
  const auto as_long = [&](const Copy& copy) { return copy.size == copies[0].size; };
  return std::ranges::all_of(copies, as_long) ? copies[0].size : std::uint8_t{0};
}

void PdoMapping::append_copy(const MappedValue& value) {
  const Copy next{value.entry.value, value.entry.state->watchers,
                  static_cast<std::uint8_t>(value.position / 8),
                  static_cast<std::uint8_t>(value.bits / 8)};
  if (copy_count_ != 0) {
    Copy& last = copies_[copy_count_ - 1U];
    if (last.position + last.size == next.position && last.value + last.size == next.value) {
      last.size = static_cast<std::uint8_t>(last.size + next.size);
      last.watchers |= next.watchers;
      return;
    }
  }
  copies_[copy_count_++] = next;
}

PdoImage PdoMapping::pack() const {
  PdoImage image{};
  if (copied_) {
    for (const Copy& copy : std::span(copies_).first(copy_count_)) {
      copy_bytes(image.data() + copy.position, copy.value, copy.size);
    }
    return image;
  }
  std::uint64_t bits = 0;
  for (const MappedValue& value : values()) {
    std::uint64_t number = load_unsigned(value.entry.bytes());
    if (value.entry.row->type == DataType::boolean) number = number != 0 ? 1 : 0;
    bits |= (number & mask_of(value.bits)) << value.position;
  }
  store(image.data(), bits);
  return image;
}

void PdoMapping::refresh(Dictionary& dictionary) const {
  if (!hooked_) return;
  for (const MappedValue& value : values()) {
    // A hook that refuses leaves the value as it is.
    if (value.hooked) static_cast<void>(dictionary.read(value.entry));
  }
}

const MappedValue* PdoMapping::find_refused(const Dictionary& dictionary,
                                            const std::uint8_t* data) const {
  const std::uint64_t image = load_image(data, bytes());
  for (const MappedValue& value : values()) {
    if (value.is_dummy()) continue;
    const Unpacked unpacked(value, image);
    const AbortCode answer = value.hooked ? dictionary.check(value.entry, unpacked)
                                          : Dictionary::check_value(*value.entry.row, unpacked);
    if (answer != AbortCode::none) return &value;
  }
  return nullptr;
}

void PdoMapping::write(Dictionary& dictionary, const std::uint8_t* data) const {
  if (!copied_) return write_values(dictionary, data);
  for (const Copy& copy : std::span(copies_).first(copy_count_)) {
    const std::uint8_t* from = data + copy.position;
    if (copy.watchers != 0 && std::memcmp(copy.value, from, copy.size) != 0) {
      dictionary.mark_changed(copy.watchers);
    }
    copy_bytes(copy.value, from, copy.size);
  }
}

void PdoMapping::write_values(Dictionary& dictionary, const std::uint8_t* data) const {
  const std::uint64_t image = load_image(data, bytes());
  for (const MappedValue& value : values()) {
    if (!value.is_dummy()) write_value(dictionary, value, image);
  }
  if (!hooked_) return;
  // A hook may change the mapping under our feet: value_count_ is looked at anew.
  for (std::size_t i = 0; i < value_count_; ++i) {
    if (memory_[i].hooked) dictionary.announce(memory_[i].entry, Source::pdo);
  }
}

}  // namespace canvoy
