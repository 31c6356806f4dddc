// What a host does with the values of a received PDO, of which the mapping is resolved: all are
// checked, then all are written, then the services are notified (CiA 301, 7.2.2.5).
#include <span>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"

namespace canvoy {

namespace {

/// Mask of 1 to 64 bits.
constexpr std::uint64_t mask_of(unsigned bits) {
  return ~std::uint64_t{0} >> (64 - bits);
}
inline std::uint64_t number_in(const PdoImage& image, unsigned position, unsigned bits) {
  check_invariant(bits != 0 && position + bits <= 8 * image.size());
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
inline bool differs(const std::uint8_t* value, unsigned bits, std::uint64_t number) {
  if (bits == 32) return load<std::uint32_t>(value) != static_cast<std::uint32_t>(number);
  if (bits == 16) return load<std::uint16_t>(value) != static_cast<std::uint16_t>(number);
  if (bits == 8) return *value != static_cast<std::uint8_t>(number);
  return load_unsigned({value, (bits + 7) / 8}) != (number & mask_of(bits));
}

/// True outside of its limits: in the arithmetic of its bits, which is independent of the sign. The
/// lower bits of `number` count.
[[gnu::always_inline]] inline bool is_outside(const MappedValue& value, const std::int64_t* numbers,
                                              std::uint64_t number) {
  const std::int64_t* const limits = numbers + value.entry().row->limits;
  const auto low = static_cast<std::uint64_t>(limits[0]);
  const std::uint64_t range = static_cast<std::uint64_t>(limits[1]) - low;
  const unsigned unused = 64 - value.bits();
  return (number - low) << unused > range << unused;
}

/// Reason of a refusal; the sentinel is allowed beside the limits.
AbortCode check_number_of(const DictionaryTables& tables, const MappedValue& value,
                          std::uint64_t number) {
  if (!value.is(MappedValue::limit)) return AbortCode::none;
  const ValueBytes bytes(number, value.bits());
  return check_number(tables, *value.entry().row, bytes.bytes.data());
}

std::uint32_t refused_at(const Entry& entry) {
  return static_cast<std::uint32_t>(entry.index) << 16 | unsigned{entry.sub} << 8;
}

/// Without the bits of a value; zeros follow the last bit of 64.
[[gnu::always_inline]] inline std::uint64_t without(std::uint64_t image, unsigned bits) {
  return image >> (bits - 1) >> 1;
}

}  // namespace

/// A number outside may be a sentinel. Without any callback.
[[gnu::always_inline]] inline bool PdoService::are_within_limits(const Pdo& pdo,
                                                                 const std::int64_t* numbers,
                                                                 std::uint64_t image) {
  const MappedValue* value = values_of(pdo);
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    if (value->is(MappedValue::limit) && is_outside(*value, numbers, image)) [[unlikely]]
      return false;
    left -= bits;
    image = without(image, bits);
  }
  return true;
}

/// The first object that cannot take its value, or 0.
[[gnu::noinline]] std::uint32_t PdoService::ask_for_values(const Pdo& pdo,
                                                           const PdoImage& image) const {
  const DictionaryTables& tables = node_.dictionary().tables();
  std::uint32_t refused = 0;
  for_values(pdo, [&](const MappedValue& value, unsigned start) {
    const ValueBytes bytes(number_in(image, start, value.bits()), value.bits());
    const std::uint32_t object = refused_at(value.entry());
    AbortCode answer = check_number_of(tables, value, bytes.number());
    if (answer == AbortCode::none && value.asks()) answer = value.ask_for(bytes.span());
    if (answer != AbortCode::none) refused = object;
    return refused == 0;
  });
  return refused;
}

/// Before they are written, without any callback. A TPDO with an event that waits is sent with the
/// present values anyway.
[[gnu::always_inline]] inline void PdoService::note_changes(const Pdo& pdo, std::uint64_t image) {
  const MappedValue* value = values_of(pdo);
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    if (value->is(MappedValue::watch) && differs(value->value(), bits, image)) {
      const unsigned watcher = value->watcher();
      if (watcher == 0 || !places_.value.watching[watcher - 1].event_) {
        node_.dictionary().note_change(value->entry());
      }
    }
    left -= bits;
    image = without(image, bits);
  }
}

[[gnu::noinline]] void PdoService::write_one_by_one(const Pdo& pdo, const PdoImage& image) {
  const MappedValue* value = values_of(pdo);
  auto rest = canvoy::load<std::uint64_t>(image.data());
  for (unsigned left = pdo.bits_; left != 0; ++value) {
    const unsigned bits = value->bits();
    std::uint8_t* const place = value->value();
    // Special values first: they have 8, 16 and 32 bits as well.
    // NOLINTNEXTLINE(bugprone-branch-clone)
    if (value->is(MappedValue::set_text | MappedValue::skip)) [[unlikely]] {
      const ValueBytes bytes(rest, bits);
      if (value->is(MappedValue::set_text)) node_.dictionary().set(value->entry(), bytes.span());
    } else if (bits == 32) {
      store(place, static_cast<std::uint32_t>(rest));
    } else if (bits == 16) {
      store(place, static_cast<std::uint16_t>(rest));
    } else if (bits <= 8) {
      *place = static_cast<std::uint8_t>(rest & mask_of(bits));
    } else {
      const ValueBytes bytes(rest & mask_of(bits), bits);
      std::memcpy(place, bytes.bytes.data(), bytes.size);
    }
    left -= bits;
    rest = without(rest, bits);
  }
}

/// What is notified may set another mapping; the rest is then that of the new values.
[[gnu::always_inline]] inline void PdoService::announce_values(const Pdo& pdo) const {
  const std::uint32_t reads = node_.mapping_reads();
  const MappedValue* value = values_of(pdo);
  for (unsigned left = pdo.bits_; left != 0; left -= value++->bits()) {
    if (!value->is(MappedValue::notify)) continue;
    const unsigned end = pdo.bits_ - left + value->bits();
    value->notify_of_write();
    if (node_.mapping_reads() != reads) [[unlikely]]
      return announce_rest(pdo, value + 1, end);
  }
}

[[gnu::noinline]] void PdoService::announce_rest(const Pdo& pdo, const MappedValue* first,
                                                 unsigned start) const {
  for_values_from(first, start, pdo, [&](const MappedValue& value, unsigned) {
    if (value.is(MappedValue::notify)) value.notify_of_write();
    return true;
  });
}

[[gnu::always_inline]] inline bool PdoService::are_doubtful(const Pdo& pdo,
                                                            std::uint64_t image) const {
  const unsigned deeds = pdo.deeds_.value;
  if ((deeds & MappedValue::ask) != 0) return true;
  const std::int64_t* const numbers = node_.dictionary().tables().numbers.data();
  return (deeds & MappedValue::limit) != 0 && !are_within_limits(pdo, numbers, image);
}

/// Without any callback.
[[gnu::always_inline]] inline void PdoService::write_values(const Pdo& pdo, const PdoImage& image) {
  const unsigned deeds = pdo.deeds_.value;
  if ((deeds & MappedValue::watch) != 0) {
    note_changes(pdo, canvoy::load<std::uint64_t>(image.data()));
  }
  (deeds & MappedValue::apart) != 0 ? write_one_by_one(pdo, image) : copy(pdo, image);
}

std::uint32_t PdoService::carry_out(const Pdo& pdo, const PdoImage& image, Step step) {
  if (step == Step::check) {
    const bool are_asked = are_doubtful(pdo, canvoy::load<std::uint64_t>(image.data()));
    return are_asked ? ask_for_values(pdo, image) : 0;
  }
  if (step == Step::write) {
    write_values(pdo, image);
  } else if ((pdo.deeds_.value & MappedValue::notify) != 0) {
    announce_values(pdo);
  }
  return 0;
}

// In functions that need no place on the stack, and end with a call of the next one.

void Rpdos::take_at_once(Rpdo& pdo, const PdoImage& image) {
  if ((pdo.deeds_.value & (MappedValue::ask | MappedValue::limit)) != 0) {
    return check_and_take(pdo, image);
  }
  take_checked(pdo, image);
}

[[gnu::noinline]] void Rpdos::check_and_take(Rpdo& pdo, const PdoImage& image) {
  if (are_doubtful(pdo, canvoy::load<std::uint64_t>(image.data()))) return ask_and_take(pdo, image);
  take_checked(pdo, image);
}

[[gnu::noinline]] void Rpdos::ask_and_take(Rpdo& pdo, const PdoImage& image) {
  if (const std::uint32_t object = ask_for_values(pdo, image); object != 0) {
    return refuse(pdo, object);
  }
  take_checked(pdo, image);
}

[[gnu::always_inline]] inline void Rpdos::take_checked(const Rpdo& pdo, const PdoImage& image) {
  const unsigned deeds = pdo.deeds_.value;
  if ((deeds & (MappedValue::watch | MappedValue::apart)) != 0) return take_apart(pdo, image);
  copy(pdo, image);
  finish_taken(pdo, deeds);
}

[[gnu::noinline]] void Rpdos::take_apart(const Rpdo& pdo, const PdoImage& image) {
  write_values(pdo, image);
  finish_taken(pdo, pdo.deeds_.value);
}

[[gnu::always_inline]] inline void Rpdos::finish_taken(const Rpdo& pdo, unsigned deeds) {
  if ((deeds & MappedValue::notify) != 0) return announce_taken(pdo);
  if (received) received(number_of(pdo));
}

[[gnu::noinline]] void Rpdos::announce_taken(const Rpdo& pdo) {
  announce_values(pdo);
  if (received) received(number_of(pdo));
}

}  // namespace canvoy
