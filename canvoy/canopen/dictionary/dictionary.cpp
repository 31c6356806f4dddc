#include "canvoy/canopen/dictionary/dictionary.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/frame.hpp"

namespace canvoy {

namespace {

/// Last row with first(row) <= key, or null. Branch-free in the loop: the search takes the same
/// number of steps for every key.
template <class Row, class Key, class First>
const Row* last_not_above(std::span<const Row> rows, Key key, First first) {
  if (rows.empty()) return nullptr;
  const Row* base = rows.data();
  std::size_t length = rows.size();
  while (length > 1) {
    const std::size_t half = length / 2;
    base = first(base[half]) <= key ? base + half : base;
    length -= half;
  }
  return first(*base) <= key ? base : nullptr;
}

/// Compares a number with a bound of its type, byte by byte from the top, beginning with the sign,
/// if it has one. Small and slow.
[[maybe_unused]] int compare(const EntryShape& row, const std::uint8_t* value,
                             const std::int64_t& bound) {
  const auto* with = reinterpret_cast<const std::uint8_t*>(&bound);
  unsigned flip = has(row.traits, EntryTraits::has_sign) ? 0x80 : 0;
  for (std::size_t i = row.capacity; i-- != 0; flip = 0) {
    const int difference = static_cast<int>(value[i] ^ flip) - static_cast<int>(with[i] ^ flip);
    if (difference != 0) return difference;
  }
  return 0;
}

/// Loads a number of 1 to 8 bytes.
[[maybe_unused]] inline std::uint64_t load_number(const std::uint8_t* value, unsigned size) {
  switch (size) {
    case 1:
      return *value;
    case 2:
      return load<std::uint16_t>(value);
    case 4:
      return load<std::uint32_t>(value);
    case 8:
      return load<std::uint64_t>(value);
    default:
      return load_unsigned({value, size});
  }
}

/// Like check_limits(), but for hosts: numbers and limits as those of 64 bits.
[[maybe_unused]] inline AbortCode check_limits_at_once(const EntryShape& row,
                                                       const std::int64_t* limits,
                                                       const std::uint8_t* value) {
  const std::uint64_t number = load_number(value, row.capacity);
  const unsigned unused = 64 - 8U * row.capacity;
  if (has(row.traits, EntryTraits::has_sentinel) &&
      (number ^ static_cast<std::uint64_t>(limits[2])) << unused == 0) {
    return AbortCode::none;
  }
  if (has(row.traits, EntryTraits::has_sign)) {
    const auto with_sign = static_cast<std::int64_t>(number << unused) >> unused;
    if (with_sign < limits[0]) return AbortCode::value_too_low;
    return with_sign > limits[1] ? AbortCode::value_too_high : AbortCode::none;
  }
  if (number < static_cast<std::uint64_t>(limits[0])) return AbortCode::value_too_low;
  return number > static_cast<std::uint64_t>(limits[1]) ? AbortCode::value_too_high
                                                        : AbortCode::none;
}

/// Checks a value that has the length of its type.
AbortCode check_limits(const EntryShape& row, const std::int64_t* limits,
                       const std::uint8_t* value) {
  if constexpr (!is_small_machine) return check_limits_at_once(row, limits, value);
  const std::int64_t& low = limits[0];
  const std::int64_t& high = limits[1];
  if (has(row.traits, EntryTraits::has_sentinel) && compare(row, value, limits[2]) == 0) {
    return AbortCode::none;
  }
  if (compare(row, value, low) < 0) return AbortCode::value_too_low;
  return compare(row, value, high) > 0 ? AbortCode::value_too_high : AbortCode::none;
}

AbortCode check_length(const EntryShape& row, std::size_t size) {
  if (row.type == DataType::domain) return AbortCode::none;
  if (size > row.capacity) return AbortCode::length_too_high;
  return size < row.capacity && !row.is_text() ? AbortCode::length_too_low : AbortCode::none;
}

/// Copies bytes. Most values have one of these sizes, for which it takes a few instructions.
[[maybe_unused]] inline void copy(std::uint8_t* to, const std::uint8_t* from, std::size_t size) {
  if (size == 4) return store(to, load<std::uint32_t>(from));
  switch (size) {
    case 0:
      return;
    case 1:
      *to = *from;
      return;
    case 2:
      return store(to, load<std::uint16_t>(from));
    case 8:
      return store(to, load<std::uint64_t>(from));
    default:
      std::memcpy(to, from, size);
  }
}

bool contains(const ObjectRow& row, std::uint16_t index) {
  return static_cast<std::uint16_t>(index - row.index) < row.count;
}

/// Position of the remembered row of an object: spreads indices that differ in any digit (Fibonacci
/// hashing). A small machine remembers none.
[[maybe_unused]] std::size_t slot_of(std::uint16_t index) {
  return (index * 0x9E37'79B9U) >> 26;
}

[[maybe_unused, gnu::always_inline]] inline const ObjectRow* search(
    std::span<const ObjectRow> objects, std::uint16_t index) {
  const ObjectRow* object =
      last_not_above(objects, index, [](const ObjectRow& row) { return row.index; });
  return object != nullptr && contains(*object, index) ? object : nullptr;
}

}  // namespace

/// The part of the index in which an index stands: `away` from the lowest one.
[[maybe_unused]] constexpr std::size_t part_of(std::uint32_t away, std::uint64_t scale) {
  return static_cast<std::size_t>(away * scale >> 32);
}

void Dictionary::make_index() {
  const std::span<const ObjectRow> objects = tables_.objects;
  if (objects.empty()) return;
  Index& index = index_.value;
  index.first = objects.front().index;
  index.reach = objects.back().index + objects.back().count - 1U - index.first;
  index.scale = (std::uint64_t{objects.size()} << 32) / (index.reach + 1);
  // A part begins at the first row that ends in it or after it.
  std::size_t part = 0;
  for (std::size_t row = 0; row < objects.size(); ++row) {
    const std::uint32_t end = objects[row].index + objects[row].count - 1U - index.first;
    const std::size_t own = part_of(end, index.scale);
    for (; part <= own; ++part) states_.value[part].place = static_cast<std::uint16_t>(row);
  }
  for (; part < objects.size(); ++part) {
    states_.value[part].place = static_cast<std::uint16_t>(objects.size() - 1);
  }
}

/// Row of the object, or null: for who remembers what it found, and so seldom comes here.
[[gnu::noinline]] const ObjectRow* Dictionary::search_object(std::uint16_t index) const {
  if constexpr (is_small_machine) return search(tables_.objects, index);
  const std::uint32_t away = index - index_.value.first;
  if (away > index_.value.reach) return nullptr;
  return search_part(part_of(away, index_.value.scale), index);
}

/// Most parts have one row or two.
const ObjectRow* Dictionary::search_part(std::size_t part, std::uint16_t index) const {
  return search_here(part, index);
}

[[gnu::always_inline]] inline const ObjectRow* Dictionary::search_here(std::size_t part,
                                                                       std::uint16_t index) const {
  if constexpr (is_small_machine) return nullptr;
  const std::size_t first = states_.value[part].place;
  const std::size_t last = part + 1 < tables_.objects.size() ? states_.value[part + 1].place
                                                             : tables_.objects.size() - 1;
  return search(tables_.objects.subspan(first, last - first + 1), index);
}

/// An object has few rows, so a small machine searches them in sequence.
inline const EntryShape* Dictionary::find_row(const ObjectRow& object, std::uint8_t sub) const {
  const EntryShape* row = tables_.entries.data() + object.entry_first;
  if constexpr (is_small_machine) {
    const EntryShape* const end = row + object.entry_count;
    while (row != end && sub > row->sub_last) ++row;
    return row != end && sub >= row->sub_first ? row : nullptr;
  }
  // In most objects each sub-index has a row, or all from 1 on share one.
  if (sub < object.entry_count && row[sub].sub_first == sub) return row + sub;
  if (object.entry_count == 2) {
    row += sub >= row[1].sub_first ? 1 : 0;
    return sub >= row->sub_first && sub <= row->sub_last ? row : nullptr;
  }
  row = last_not_above(std::span(row, object.entry_count), sub,
                       [](const EntryShape& candidate) { return candidate.sub_first; });
  return row != nullptr && sub <= row->sub_last ? row : nullptr;
}

[[gnu::always_inline]] inline AbortCode Dictionary::look_up_in(const ObjectRow& object,
                                                               Entry& entry) const {
  const EntryShape* row = find_row(object, entry.sub);
  if (row == nullptr) return AbortCode::no_sub_index;
  // Most rows have one sub-index, and their pitch is not needed.
  const auto place = static_cast<std::uint32_t>(entry.sub - row->sub_first);
  std::uint8_t* value = values_ + object.offset + row->offset +
                        static_cast<std::uint32_t>(entry.index - object.index) * object.pitch;
  entry.row = row;
  if constexpr (!is_small_machine) {
    entry.state.value = states_.value + (&object - tables_.objects.data());
  }
  entry.value = place == 0 ? value : value + place * row->pitch();
  return AbortCode::none;
}

[[gnu::always_inline]] inline AbortCode Dictionary::look_up(Entry& entry) const {
  if constexpr (is_small_machine) {
    const ObjectRow* const object = search(tables_.objects, entry.index);
    return object == nullptr ? AbortCode::no_object : look_up_in(*object, entry);
  } else {
    const ObjectRow& remembered = *remembered_.value[slot_of(entry.index)];
    return contains(remembered, entry.index) ? look_up_in(remembered, entry) : look_up_anew(entry);
  }
}

[[gnu::always_inline]] inline AbortCode Dictionary::remember(const ObjectRow& object,
                                                             Entry& entry) const {
  if constexpr (!is_small_machine) remembered_.value[slot_of(entry.index)] = &object;
  return look_up_in(object, entry);
}

/// In functions without a call in between: most objects are the first ones of their parts.
[[gnu::noinline]] AbortCode Dictionary::look_up_anew(Entry& entry) const {
  if constexpr (is_small_machine) return AbortCode::no_object;
  const std::uint32_t away = entry.index - index_.value.first;
  if (away > index_.value.reach) return AbortCode::no_object;
  const std::size_t part = part_of(away, index_.value.scale);
  const ObjectRow& row = tables_.objects[states_.value[part].place];
  return contains(row, entry.index) ? remember(row, entry) : look_up_in_part(part, entry);
}

[[gnu::noinline]] AbortCode Dictionary::look_up_in_part(std::size_t part, Entry& entry) const {
  const ObjectRow* const object = search_here(part, entry.index);
  return object == nullptr ? AbortCode::no_object : remember(*object, entry);
}

AbortCode Dictionary::locate(Entry& entry) const {
  return look_up(entry);
}

/// For callers that need a number only: a host then determines nothing else.
[[gnu::always_inline]] inline bool Dictionary::has_value(Entry& entry) const {
  return (is_small_machine ? locate(entry) : look_up(entry)) == AbortCode::none;
}

Result<Entry> Dictionary::find(std::uint16_t index, std::uint8_t sub) const {
  Entry entry{.index = index, .sub = sub};
  const AbortCode answer = is_small_machine ? locate(entry) : look_up(entry);
  return {entry, answer};
}

Result<Entry> Dictionary::find_for_bus(std::uint16_t index, std::uint8_t sub) const {
  Entry entry{.index = index, .sub = sub};
  const AbortCode answer = locate_for_bus(entry);
  return {entry, answer};
}

[[gnu::always_inline]] inline bool NodeService::hears(ServiceEvent& event) const {
  if (can_id_ == every_id) return true;
  // 0 is for NMT, which is not passed to services.
  const bool is_mine = event.frame().id == can_id_ && !event.frame().is_remote();
  if (is_mine) event.want();
  return is_mine;
}

/// On a host: the row of the object knows who they are, as long as they are few. Mostly it is one.
inline void Dictionary::notify_access(ServiceEvent& event) const {
  if constexpr (is_small_machine) return;
  const ObjectState& state = *event.entry().state.value;
  if (state.service_count != 1) return tell_several_of_access(event);
  NodeService& service = *state.services[0];
  if (service.covers(event.entry().index)) service.notify(event);
}

std::uint32_t Dictionary::notify(ServiceEvent::Kind kind, std::uint32_t number,
                                 const void* subject) const {
  ServiceEvent event{.kind = kind, .number = number, .subject = subject};
  return notify(event);
}

std::uint32_t Dictionary::notify(ServiceEvent& event) const {
  if (!is_small_machine && event.is_access()) {
    notify_access(event);
    return event.answer;
  }
  for (NodeService* service = services_; service != nullptr; service = service->next_) {
    if (is_small_machine && event.is_access()) {
      if (event.answer != 0) break;
      if (!service->covers(event.entry().index)) continue;
    }
    const bool is_frame = is_small_machine && event.kind == ServiceEvent::frame_came;
    if (is_frame && !service->hears(event)) continue;
    service->notify(event);
  }
  return event.answer;
}

EntryWatchers Dictionary::find_watchers(const Entry& entry) const {
  EntryWatchers found;
  if (is_small_machine || entry.watchers() == 0) return found;
  bool is_only = true;
  NodeService* service = frequent_.value.first;
  for (; service != nullptr; service = service->frequent_.value.next) {
    const std::uint32_t events = service->frequent_.value.events;
    if ((events & NodeService::EventMask::watch) == 0) {
      is_only = is_only && (events & NodeService::EventMask::values) == 0;
      continue;
    }
    ServiceEvent event{.kind = ServiceEvent::watch_asked, .number = offset_of(entry)};
    service->notify(event);
    if (event.answer == 0) continue;
    is_only = is_only && !found.are_there;
    found = {.are_there = true, .only = event.subject};
  }
  if (!is_only) found.only = nullptr;
  return found;
}

/// Refreshes an entry; on a small machine with the checks before it, so that they exist once.
AbortCode Dictionary::refresh(const Entry& entry) {
  if constexpr (is_small_machine) {
    const AbortCode answer = check_read(entry);
    if (answer != AbortCode::none) return answer;
  }
  return static_cast<AbortCode>(notify(ServiceEvent::before_read, 0, &entry));
}

AbortCode check_number(const DictionaryTables& tables, const EntryShape& row,
                       const std::uint8_t* value) {
  // Odd sizes leave bits of their last byte unused; a Boolean uses one bit of its byte.
  const bool is_odd = row.bits % 8 != 0;
  if (is_odd && value[row.capacity - 1] >> (row.bits % 8) != 0) return AbortCode::value_too_high;
  if (!has(row.traits, EntryTraits::limited)) return AbortCode::none;
  return check_limits(row, tables.numbers.data() + row.limits, value);
}

// For hosts: without a call in between.
#ifndef CANVOY_SMALL_MACHINE
[[gnu::flatten]]
#endif
AbortCode
Dictionary::write(const Entry& entry, std::span<const std::uint8_t> value, Source source) {
  if (!allows(entry.row->access, Access::sdo_write)) return AbortCode::read_only;
  const AbortCode answer = check(entry, value);
  if (answer != AbortCode::none) return answer;
  set(entry, value);
  announce(entry, source);
  return answer;
}

AbortCode Dictionary::write(std::uint16_t index, std::uint8_t sub,
                            std::span<const std::uint8_t> value, Source source) {
  Entry entry{.index = index, .sub = sub};
  const AbortCode answer = locate(entry);
  return answer == AbortCode::none ? write(entry, value, source) : answer;
}

AbortCode Dictionary::check_value(const EntryShape& row,
                                  std::span<const std::uint8_t> value) const {
  const AbortCode answer = check_length(row, value.size());
  return answer == AbortCode::none ? check_number(tables_, row, value.data()) : answer;
}

AbortCode Dictionary::check(const Entry& entry, std::span<const std::uint8_t> value) const {
  AbortCode answer = check_length(*entry.row, value.size());
  if (answer == AbortCode::none && tables_.check_number != nullptr) {
    // Nearly always it is this one, which then needs no call on a host.
    const bool is_usual = !is_small_machine && tables_.check_number == &check_number;
    answer = is_usual ? check_number(tables_, *entry.row, value.data())
                      : tables_.check_number(tables_, *entry.row, value.data());
  }
  return answer == AbortCode::none ? ask(entry, value) : answer;
}

/// The first refusal of a hook.
inline AbortCode Dictionary::ask(const Entry& entry, std::span<const std::uint8_t> value) const {
  if (!entry.is_hooked(ServiceEvent::before_write)) return AbortCode::none;
  ServiceEvent event{.kind = ServiceEvent::before_write,
                     .number = static_cast<std::uint32_t>(value.size()),
                     .subject = &entry,
                     .data = value.data()};
  return static_cast<AbortCode>(notify(event));
}

void Dictionary::commit(const Entry& entry, std::span<const std::uint8_t> value, Source source) {
  set(entry, value);
  announce(entry, source);
}

void Dictionary::announce(const Entry& entry, Source source) {
  if (!entry.is_hooked(ServiceEvent::after_write)) return;
  notify(ServiceEvent::after_write, static_cast<std::uint32_t>(source), &entry);
}

// For find_hooks(): the dictionary asks and notifies all.

AbortCode Dictionary::ask_all(void* dictionary, const Entry& entry,
                              std::span<const std::uint8_t> value) {
  return static_cast<const Dictionary*>(dictionary)->ask(entry, value);
}

void Dictionary::notify_all(void* dictionary, const Entry& entry, Source source) {
  static_cast<Dictionary*>(dictionary)->announce(entry, source);
}

void Dictionary::set(const Entry& entry, std::span<const std::uint8_t> value) {
  const std::size_t size = std::min<std::size_t>(value.size(), entry.row->capacity);
  std::uint8_t* place = entry.value;
  unsigned difference = 0;
  if (entry.row->is_text()) {
    difference = load<std::uint16_t>(place) ^ static_cast<unsigned>(size);
    store(place, static_cast<std::uint16_t>(size));
    place += 2;
  }
  if constexpr (is_small_machine) {
    for (std::size_t i = 0; i < size; ++i) {
      difference |= unsigned{place[i]} ^ value[i];
      place[i] = value[i];
    }
    if (difference != 0) changes_ = entry.watchers();
    return;
  }
  const std::uint32_t watchers = entry.watchers();
  if (watchers != 0 && (difference != 0 || !are_equal(place, value.data(), size))) {
    changes_ |= watchers;
    changed_places_.value.add(offset_of(entry));
  }
  copy(place, value.data(), size);
}

namespace {

void copy_number(const Entry& entry, std::span<const std::uint8_t> value) {
  std::copy_n(value.begin(), std::min<std::size_t>(value.size(), entry.row->capacity), entry.value);
}

}  // namespace

void Dictionary::set_with_event(const Entry& entry, std::span<const std::uint8_t> value) {
  if constexpr (is_small_machine) {
    set(entry, value.first(std::min<std::size_t>(value.size(), entry.row->capacity)));
  } else {
    copy_number(entry, value);
    changes_ |= entry.watchers();
    if (entry.watchers() != 0) {
      changed_places_.value.add(offset_of(entry));
    }
    ServiceEvent event{.kind = ServiceEvent::value_set, .number = 1, .subject = &entry};
    notify_frequent(event);
  }
}

void Dictionary::set_without_event(const Entry& entry, std::span<const std::uint8_t> value) {
  copy_number(entry, value);
  if constexpr (is_small_machine) return;
  ServiceEvent event{.kind = ServiceEvent::value_set, .subject = &entry};
  notify_frequent(event);
}

bool Dictionary::set_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
  Entry entry{.index = index, .sub = sub};
  if (locate(entry) != AbortCode::none || entry.row->bits == 0) return false;
  set(entry, {reinterpret_cast<const std::uint8_t*>(&number), entry.row->capacity});
  return true;
}

void Dictionary::set_word(std::uint16_t index, std::uint32_t number) {
  Entry entry{.index = index};
  if (locate(entry) != AbortCode::none) return;
  set(entry, {reinterpret_cast<const std::uint8_t*>(&number),
              std::min<std::size_t>(entry.row->capacity, sizeof number)});
}

std::uint64_t Dictionary::number(std::uint16_t index, std::uint8_t sub) const {
  Entry entry{.index = index, .sub = sub};
  std::uint64_t number = 0;
  if (!has_value(entry) || entry.row->bits == 0) return number;
  std::memcpy(&number, entry.value, entry.row->capacity);
  return number;
}

std::uint32_t Dictionary::word(std::uint16_t index, std::uint8_t sub, std::uint32_t absent) const {
  Entry entry{.index = index, .sub = sub};
  return has_value(entry) ? entry.word() : absent;
}

std::uint32_t Dictionary::word(std::uint16_t index) const {
  return word(index, 0);
}

const Domain* Dictionary::domain(const Entry& entry) const {
  if (!entry.is_hooked(ServiceEvent::domain_wanted)) return nullptr;
  ServiceEvent event{.kind = ServiceEvent::domain_wanted, .subject = &entry};
  return notify(event) == 0 ? nullptr : static_cast<const Domain*>(event.subject);
}

void Dictionary::watch(const Entry& entry, std::uint32_t watchers) {
  if constexpr (is_small_machine) return;
  entry.state.value->watchers |= watchers;
  ++revision_.value;
}

void Dictionary::unwatch(std::uint32_t watchers) {
  if constexpr (is_small_machine) return;
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    states_.value[row].watchers &= ~watchers;
  }
  ++revision_.value;
}

}  // namespace canvoy
