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

/// Like check_limits(), but for hosts: signed numbers are compared as unsigned ones, with the sign
/// bit inverted.
[[maybe_unused]] inline AbortCode check_limits_at_once(const EntryShape& row,
                                                       const std::int64_t* limits,
                                                       const std::uint8_t* value) {
  const unsigned unused = 64 - 8U * row.capacity;
  const std::uint64_t sign = has(row.traits, EntryTraits::has_sign) ? std::uint64_t{1} << 63 : 0;
  const auto order = [&](std::uint64_t number) { return number << unused ^ sign; };
  const std::uint64_t number = order(load_number(value, row.capacity));
  const auto limit = [&](unsigned i) { return order(static_cast<std::uint64_t>(limits[i])); };
  if (has(row.traits, EntryTraits::has_sentinel) && number == limit(2)) return AbortCode::none;
  if (number < limit(0)) return AbortCode::value_too_low;
  return number > limit(1) ? AbortCode::value_too_high : AbortCode::none;
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
  switch (size) {
    case 0:
      return;
    case 1:
      *to = *from;
      return;
    case 2:
      return store(to, load<std::uint16_t>(from));
    case 4:
      return store(to, load<std::uint32_t>(from));
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
  return (index * 0x9E37'79B9U) >> 28;
}

AbortCode put_to(const AccessHandlers& calls, void* service, const ServiceEvent& access) {
  const Entry& entry = access.entry();
  switch (access.kind) {
    case ServiceEvent::before_read:
      return calls.before_read == nullptr ? AbortCode::none : calls.before_read(service, entry);
    case ServiceEvent::before_write:
      return calls.before_write == nullptr ? AbortCode::none
                                           : calls.before_write(service, entry, access.value());
    case ServiceEvent::after_write:
      if (calls.after_write != nullptr) calls.after_write(service, entry, access.source());
      return AbortCode::none;
    default:
      return AbortCode::none;
  }
}

/// Writes `count` numbers, and returns the end. Most often it is one.
template <class Number>
std::uint8_t* fill(std::uint8_t* values, Number number, unsigned count) {
  store(values, number);
  for (; count > 1; --count) store(values += sizeof number, number);
  return values + sizeof number;
}

[[gnu::always_inline]] inline const ObjectRow* search(std::span<const ObjectRow> objects,
                                                      std::uint16_t index) {
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
  index.last = objects.back().index + objects.back().count - 1U;
  index.scale = (std::uint64_t{objects.size()} << 32) / (index.last - index.first + 1);
  // A part begins at the last row that begins before it.
  std::size_t part = 0;
  for (std::size_t row = 1; row < objects.size(); ++row) {
    const std::size_t own = part_of(objects[row].index - index.first, index.scale);
    for (; part <= own; ++part) states_.value[part].place = static_cast<std::uint16_t>(row - 1);
  }
  for (; part < objects.size(); ++part) {
    states_.value[part].place = static_cast<std::uint16_t>(objects.size() - 1);
  }
}

/// For who remembers what it found, and so seldom comes here.
[[gnu::noinline]] const ObjectRow* Dictionary::search_object(std::uint16_t index) const {
  if constexpr (is_small_machine) return search(tables_.objects, index);
  const Index& all = index_.value;
  const std::uint32_t away = index - all.first;
  if (index > all.last || away > all.last) return nullptr;
  const std::size_t part = part_of(away, all.scale);
  const std::size_t first = states_.value[part].place;
  const std::size_t last = part + 1 < tables_.objects.size() ? states_.value[part + 1].place
                                                             : tables_.objects.size() - 1;
  // Most parts have one row or two.
  const ObjectRow* row = tables_.objects.data() + first;
  for (std::size_t length = last - first + 1; length > 1;) {
    const std::size_t half = length / 2;
    row = row[half].index <= index ? row + half : row;
    length -= half;
  }
  return contains(*row, index) ? row : nullptr;
}

void ObjectState::add(NodeService& service, bool in_front) {
  const auto end = services.begin() + std::min<std::size_t>(service_count, services_max);
  if (!has_all() || std::find(services.begin(), end, &service) != end) return;
  if (++service_count > services_max) return;
  if (in_front) {
    std::copy_backward(services.begin(), end, end + 1);
    services.front() = &service;
  } else {
    *end = &service;
  }
}

void ObjectState::remove(const NodeService& service) {
  if (!has_all()) return;
  const auto end = services.begin() + service_count;
  const auto found = std::find(services.begin(), end, &service);
  if (found == end) return;
  std::copy(found + 1, end, found);
  --service_count;
}

/// Row of the object, or null.
inline const ObjectRow* Dictionary::find_object(std::uint16_t index) const {
  if constexpr (is_small_machine) {
    return search(tables_.objects, index);
  } else {
    const ObjectRow*& remembered = remembered_.value[slot_of(index)];
    if (contains(*remembered, index)) return remembered;
    const ObjectRow* object = search_object(index);
    if (object != nullptr) remembered = object;
    return object;
  }
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

[[gnu::always_inline]] inline AbortCode Dictionary::look_up(Entry& entry) const {
  const ObjectRow* object = find_object(entry.index);
  if (object == nullptr) return AbortCode::no_object;
  const EntryShape* row = find_row(*object, entry.sub);
  if (row == nullptr) return AbortCode::no_sub_index;
  // Most rows have one sub-index, and their pitch is not needed.
  const auto place = static_cast<std::uint32_t>(entry.sub - row->sub_first);
  std::uint8_t* value = values_ + object->offset + row->offset +
                        static_cast<std::uint32_t>(entry.index - object->index) * object->pitch;
  entry.row = row;
  if constexpr (!is_small_machine) {
    entry.state.value = states_.value + (object - tables_.objects.data());
  }
  entry.value = place == 0 ? value : value + place * row->pitch();
  return AbortCode::none;
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

void Dictionary::tell_several_of_access(ServiceEvent& event) const {
  const std::uint16_t index = event.entry().index;
  const ObjectState& state = *event.entry().state.value;
  if (!state.has_all()) return tell_of_access_by_list(event);
  for (std::size_t i = 0; i < state.service_count && event.answer == 0; ++i) {
    NodeService* const service = state.services[i];
    if (service->covers(index)) service->notify(event);
    // What was called may have attached a hook before it.
    while (i < state.service_count && state.has_all() && state.services[i] != service) ++i;
  }
}

/// A link could be told of any object, and has hooks for a few: that is seen here, for a node has
/// many links.
void Dictionary::tell_of_access_by_list(ServiceEvent& event) const {
  const std::uint16_t index = event.entry().index;
  for (NodeService* service = services_; service != nullptr; service = service->next_) {
    if (event.answer != 0) return;
    if (!service->covers(index)) continue;
    const bool is_link = service->listener_.on_event == &HandlerBinding::on_event;
    if (is_link && !static_cast<const HandlerBinding*>(service)->covers_object(index)) continue;
    service->notify(event);
  }
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

/// The accesses of a binding are in its table; a service without a table may use all.
EntryHooks Dictionary::find_hooks(const Entry& entry) {
  EntryHooks found;
  if (is_small_machine || entry.state.value->hooks == 0) return found;
  for (NodeService* service = services_; service != nullptr; service = service->next_) {
    if (!service->covers(entry.index)) continue;
    if (service->listener_.on_event != &HandlerBinding::on_event) {
      const unsigned accesses = service->frequent_.value.accesses;
      const auto handles = [accesses](ServiceEvent::Kind access) {
        return (accesses & ServiceEvent::bit_of(access)) != 0;
      };
      add_hooks(found, {.context = this,
                        .ask = handles(ServiceEvent::before_write) ? ask_all : nullptr,
                        .notify = handles(ServiceEvent::after_write) ? notify_all : nullptr,
                        .reads = handles(ServiceEvent::before_read)});
      continue;
    }
    const HandlerBinding& link = static_cast<const HandlerBinding&>(*service);
    const auto in_table = static_cast<std::uint16_t>(entry.index - link.shift_);
    for (const AccessHandlers& calls : link.calls_->hooks) {
      if (!calls.covers(in_table, entry.sub)) continue;
      add_hooks(found, {.context = link.service_,
                        .ask = calls.before_write,
                        .notify = calls.after_write,
                        .reads = calls.before_read != nullptr});
    }
  }
  return found;
}

/// A second function of a kind, or one with another object, is called by the dictionary.
void Dictionary::add_hooks(EntryHooks& found, const EntryHooks& more) {
  found.reads |= more.reads;
  if (more.ask == nullptr && more.notify == nullptr) return;
  const bool is_first = found.ask == nullptr && found.notify == nullptr;
  const bool fits = found.context == more.context &&
                    (found.ask == nullptr || more.ask == nullptr) &&
                    (found.notify == nullptr || more.notify == nullptr);
  if (is_first || fits) {
    found.context = more.context;
    if (more.ask != nullptr) found.ask = more.ask;
    if (more.notify != nullptr) found.notify = more.notify;
    return;
  }
  found.context = this;
  if (found.ask != nullptr || more.ask != nullptr) found.ask = ask_all;
  if (found.notify != nullptr || more.notify != nullptr) found.notify = notify_all;
}

AbortCode Dictionary::ask_all(void* dictionary, const Entry& entry,
                              std::span<const std::uint8_t> value) {
  ServiceEvent event{.kind = ServiceEvent::before_write,
                     .number = static_cast<std::uint32_t>(value.size()),
                     .subject = &entry,
                     .data = value.data()};
  static_cast<const Dictionary*>(dictionary)->notify_access(event);
  return static_cast<AbortCode>(event.answer);
}

void Dictionary::notify_all(void* dictionary, const Entry& entry, Source source) {
  ServiceEvent event{.kind = ServiceEvent::after_write,
                     .number = static_cast<std::uint32_t>(source),
                     .subject = &entry};
  static_cast<const Dictionary*>(dictionary)->notify_access(event);
}

bool Dictionary::is_watched(const Entry& entry) const {
  if (is_small_machine || entry.watchers() == 0) return false;
  ServiceEvent event{.kind = ServiceEvent::watch_asked,
                     .number = static_cast<std::uint32_t>(entry.value - values_)};
  notify_frequent(event);
  return event.answer != 0;
}

bool HandlerBinding::covers_object(std::uint16_t index) const {
  const auto in_table = static_cast<std::uint16_t>(index - shift_);
  return std::ranges::any_of(calls_->hooks,
                             [&](const AccessHandlers& calls) { return calls.covers(in_table); });
}

/// First refusal among its hooks.
AbortCode HandlerBinding::answer(const ServiceEvent& access) const {
  const Entry& entry = access.entry();
  const auto in_table = static_cast<std::uint16_t>(entry.index - shift_);
  for (const AccessHandlers& calls : calls_->hooks) {
    if (!calls.covers(in_table, entry.sub)) continue;
    const AbortCode answer = put_to(calls, service_, access);
    if (answer != AbortCode::none) return answer;
  }
  return AbortCode::none;
}

/// Calls the handler of its table for the event.
void HandlerBinding::on_event(NodeService& link, ServiceEvent& event) {
  const HandlerBinding& self = static_cast<HandlerBinding&>(link);
  const ServiceHandlers& calls = *self.calls_;
  void* const service = self.service_;
  const auto call = [service](auto function, auto... arguments) {
    if (function != nullptr) function(service, arguments...);
  };
  switch (event.kind) {
    case ServiceEvent::reset:
      return call(calls.reset, event.scope());
    case ServiceEvent::state_entered:
      return call(calls.state_entered, event.state());
    case ServiceEvent::bus_state_changed:
    case ServiceEvent::bus_recovered:
      return call(calls.bus_state_changed, event.bus_state());
    case ServiceEvent::error_came:
    case ServiceEvent::error_went:
      if (calls.error_changed == nullptr) return;
      return calls.error_changed(service, event.error(), event.kind == ServiceEvent::error_came);
    case ServiceEvent::values_changed:
      return call(calls.values_changed, event.watchers());
    case ServiceEvent::tx_ready:
      return call(calls.tx_ready);
    case ServiceEvent::before_read:
    case ServiceEvent::before_write:
    case ServiceEvent::after_write:
      return event.refuse(self.answer(event));
    default:
      return;
  }
}

void Hook::Link::on_event(NodeService& link, ServiceEvent& event) {
  const Hook& hook = *static_cast<Link&>(link).hook_;
  switch (event.kind) {
    case ServiceEvent::before_read:
      return event.refuse(hook.before_read(event.entry()));
    case ServiceEvent::before_write:
      return event.refuse(hook.before_write(event.entry(), event.value()));
    case ServiceEvent::after_write:
      return hook.after_write(event.entry(), event.source());
    case ServiceEvent::domain_wanted:
      if (hook.domain != nullptr) event.serve(*hook.domain);
      return;
    default:
      return;
  }
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

inline AbortCode Dictionary::write_by_steps(const Entry& entry, std::span<const std::uint8_t> value,
                                            Source source) {
  if (!allows(entry.row->access, Access::sdo_write)) return AbortCode::read_only;
  const AbortCode answer = check(entry, value);
  if (answer != AbortCode::none) return answer;
  set(entry, value);
  announce(entry, source);
  return answer;
}

/// For hosts: without a call in between.
[[gnu::flatten]] AbortCode Dictionary::write_at_once(const Entry& entry,
                                                     std::span<const std::uint8_t> value,
                                                     Source source) {
  if constexpr (is_small_machine) return AbortCode::general;
  return write_by_steps(entry, value, source);
}

AbortCode Dictionary::write(const Entry& entry, std::span<const std::uint8_t> value,
                            Source source) {
  if constexpr (!is_small_machine) return write_at_once(entry, value, source);
  return write_by_steps(entry, value, source);
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
    answer = tables_.check_number(tables_, *entry.row, value.data());
  }
  if (answer != AbortCode::none || !entry.is_hooked(ServiceEvent::before_write)) return answer;
  ServiceEvent event{.kind = ServiceEvent::before_write,
                     .number = static_cast<std::uint32_t>(value.size()),
                     .subject = &entry,
                     .data = value.data()};
  if constexpr (is_small_machine) return static_cast<AbortCode>(notify(event));
  notify_access(event);
  return static_cast<AbortCode>(event.answer);
}

void Dictionary::commit(const Entry& entry, std::span<const std::uint8_t> value, Source source) {
  set(entry, value);
  announce(entry, source);
}

void Dictionary::announce(const Entry& entry, Source source) {
  if (!entry.is_hooked(ServiceEvent::after_write)) return;
  if constexpr (is_small_machine) {
    notify(ServiceEvent::after_write, static_cast<std::uint32_t>(source), &entry);
  } else {
    ServiceEvent event{.kind = ServiceEvent::after_write,
                       .number = static_cast<std::uint32_t>(source),
                       .subject = &entry};
    notify_access(event);
  }
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
    changed_places_.value.add(static_cast<std::uint32_t>(entry.value - values_));
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
      changed_places_.value.add(static_cast<std::uint32_t>(entry.value - values_));
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

void Dictionary::attach(Hook& hook) {
  NodeService& link = hook.link;
  link.listener_.first = hook.first;
  link.listener_.last = hook.last;
  link.next_ = services_;
  if (services_ == nullptr) last_ = &link.next_;
  services_ = &link;
  if constexpr (!is_small_machine) link.frequent_.value.accesses = hook.accesses();
  mark_hooked(link, hook.first, hook.last, hook.accesses(), true);
}

/// The rows keep their marks, which are only a hint that a hook may exist; the hook itself is no
/// longer called.
void Dictionary::detach(Hook& hook) {
  NodeService** link = &services_;
  while (*link != nullptr && *link != &hook.link) link = &(*link)->next_;
  if (*link == nullptr) return;
  *link = std::exchange(hook.link.next_, nullptr);
  if (*link == nullptr) last_ = link;
  if constexpr (!is_small_machine) {
    ++revision_.value;
    for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
      states_.value[row].remove(hook.link);
    }
  }
}

void Dictionary::mark_hooked(HandlerBinding& service) {
  for (const AccessHandlers& calls : service.calls_->hooks) {
    mark_hooked(service, static_cast<std::uint16_t>(calls.first + service.shift_),
                static_cast<std::uint16_t>(calls.last + service.shift_), calls.accesses());
  }
}

void Dictionary::mark_hooked(NodeService& service, std::uint16_t first, std::uint16_t last,
                             std::uint8_t accesses, bool in_front) {
  if constexpr (is_small_machine) return;
  ++revision_.value;
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    const ObjectRow& object = tables_.objects[row];
    if (object.index > last || object.index + object.count - 1 < first) continue;
    ObjectState& state = states_.value[row];
    state.hooks |= accesses;
    state.add(service, in_front);
  }
}

inline std::uint64_t Dictionary::default_of(const EntryShape& row, std::uint32_t place,
                                            std::uint8_t node_id) const {
  const std::uint64_t number = tables_.number_at(row, place);
  return has(row.traits, EntryTraits::plus_node_id) ? number + node_id : number;
}

std::uint64_t Dictionary::default_number(const Entry& entry) const {
  const ObjectRow& object = *search_object(entry.index);
  const auto row = entry.row - (tables_.entries.data() + object.entry_first);
  return tables_.number_at(*entry.row, tables_.defaults_of(object, entry.index)[row]);
}

/// Values are in the block in the order of the rows, without a gap.
void Dictionary::restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  Entry entry;
  entry.value = values_;
  for (const ObjectRow& object : tables_.objects) {
    if constexpr (!is_small_machine) {
      entry.state.value = states_.value + (&object - tables_.objects.data());
    }
    const std::span<const EntryShape> rows = tables_.entries_of(object);
    const std::uint32_t* places = tables_.defaults_of(object, object.index);
    for (unsigned index = object.index; index < unsigned{object.index} + object.count; ++index) {
      const bool is_wanted = index >= first && index <= last;
      const std::uint32_t* place = places;
      places += object.default_pitch;
      if constexpr (!is_small_machine) {
        if (!is_wanted || entry.watchers() == 0) {
          std::uint8_t* const next = entry.value + object.pitch;
          if (is_wanted) restore_unwatched(rows, entry, place, node_id);
          entry.value = next;
          continue;
        }
      }
      for (const EntryShape& row : rows) {
        entry.row = &row;
        for (unsigned sub = row.sub_first; sub <= row.sub_last; ++sub) {
          if (is_wanted) restore_default(entry, *place, node_id);
          entry.value += row.pitch();
        }
        ++place;
      }
    }
  }
}

/// Restores all entries of an object without a notification.
[[gnu::always_inline]] inline void Dictionary::restore_unwatched(std::span<const EntryShape> rows,
                                                                 Entry& entry,
                                                                 const std::uint32_t* place,
                                                                 std::uint8_t node_id) {
  std::uint8_t* value = entry.value;
  for (const EntryShape& row : rows) {
    const std::uint32_t number =
        *place + (has(row.traits, EntryTraits::plus_node_id) ? node_id : 0U);
    const unsigned count = row.sub_last - row.sub_first + 1U;
    switch (row.is_text() ? 0 : row.capacity) {
      case 1:
        value = fill(value, static_cast<std::uint8_t>(number), count);
        break;
      case 2:
        value = fill(value, static_cast<std::uint16_t>(number), count);
        break;
      case 4:
        value = fill(value, number, count);
        break;
      default:
        entry.row = &row;
        for (unsigned i = 0; i < count; ++i, value += row.pitch()) {
          entry.value = value;
          restore_default(entry, *place, node_id);
        }
    }
    ++place;
  }
}

inline void Dictionary::restore_default(const Entry& entry, std::uint32_t place,
                                        std::uint8_t node_id) {
  const EntryShape& row = *entry.row;
  std::size_t size = row.capacity;
  const void* bytes = &place;
  std::uint64_t wide = 0;
  if (row.is_text()) {
    bytes = tables_.texts[place].data();
    size = tables_.texts[place].size();
  } else if (size > sizeof place && !is_small_machine) {
    wide = default_of(row, place, node_id);
    bytes = &wide;
  } else if (size > sizeof place) {
    bytes = &tables_.numbers[place];
  } else if (has(row.traits, EntryTraits::plus_node_id)) {
    place += node_id;
  }
  set(entry, {static_cast<const std::uint8_t*>(bytes), size});
}

}  // namespace canvoy
