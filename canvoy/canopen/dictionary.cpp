#include "canvoy/canopen/dictionary.hpp"

#include <algorithm>

namespace canvoy {

namespace {

/// The last row with first(row) <= key, or null. Branch-free in the loop: the walk takes the same
/// steps for every key.
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

AbortCode check_length(const EntryRow& row, std::size_t length) {
  if (row.type == DataType::domain) return AbortCode::none;
  if (length > row.capacity) return AbortCode::length_too_high;
  if (length < row.capacity && !is_string(row.type)) return AbortCode::length_too_low;
  return AbortCode::none;
}

/// Compares the lower bytes of two numbers; the upper one has its sign in its first bit, or none.
int compare(const std::uint8_t* a, const std::uint8_t* b, std::size_t size, bool with_sign) {
  int flip = with_sign ? 0x80 : 0;
  while (size-- != 0) {
    const int difference = (a[size] ^ flip) - (b[size] ^ flip);
    if (difference != 0) return difference;
    flip = 0;
  }
  return 0;
}

/// Odd sizes leave bits of their last byte unused.
bool overflows(const EntryRow& row, std::span<const std::uint8_t> value) {
  return row.type >= DataType::unsigned2 && row.type <= DataType::unsigned31 &&
         value.back() >> (bit_length(row.type) % 8) != 0;
}

AbortCode check_range(const EntryRow& row, std::span<const std::uint8_t> value) {
  const auto compare_with = [&](const std::int64_t& bound) {
    return compare(value.data(), reinterpret_cast<const std::uint8_t*>(&bound), value.size(),
                   is_signed(row.type));
  };
  if (has(row.traits, EntryTraits::has_sentinel) && compare_with(row.sentinel) == 0) {
    return AbortCode::none;
  }
  if (compare_with(row.low) < 0) return AbortCode::value_too_low;
  return compare_with(row.high) > 0 ? AbortCode::value_too_high : AbortCode::none;
}

bool contains(const ObjectRow& row, std::uint16_t index) {
  return static_cast<std::uint16_t>(index - row.index) < row.count;
}

/// Where the row of an object is remembered: spreads indices that differ in any digit (Fibonacci
/// hashing).
std::size_t place_of(std::uint16_t index) {
  return (index * 0x9E37'79B9U) >> 28;
}

constexpr ObjectRow no_row = {.index = 0, .count = 0};

template <class Range>
bool covers(const Range& range, std::uint16_t index) {
  return index >= range.first && index <= range.last;
}

}  // namespace

/// What hooks of an entry are asked, or told.
struct Dictionary::Question {
  enum class Moment : std::uint8_t { before_read, before_write, after_write, attention };

  Question(const Entry& asked_entry, Moment asked_moment)
      : entry(asked_entry), moment(asked_moment) {}

  const Entry& entry;
  Moment moment;
  Source source = Source::application;
  Watched watched;
  std::span<const std::uint8_t> value;

  AbortCode put_to(const HookCalls& calls, void* service) {
    switch (moment) {
      case Moment::before_read:
        return calls.before_read == nullptr ? AbortCode::none : calls.before_read(service, entry);
      case Moment::before_write:
        return calls.before_write == nullptr ? AbortCode::none
                                             : calls.before_write(service, entry, value);
      case Moment::after_write:
        if (calls.after_write != nullptr) calls.after_write(service, entry, source);
        return AbortCode::none;
      case Moment::attention:
        pay(calls);
    }
    return AbortCode::none;
  }
  AbortCode put_to(const Hook& hook) {
    switch (moment) {
      case Moment::before_read:
        return hook.before_read(entry);
      case Moment::before_write:
        return hook.before_write(entry, value);
      case Moment::after_write:
        hook.after_write(entry, source);
        return AbortCode::none;
      case Moment::attention:
        pay(hook);
    }
    return AbortCode::none;
  }
  template <class Calls>
  void pay(const Calls& calls) {
    watched.reads = watched.reads || calls.before_read;
    watched.writes = watched.writes || calls.before_write || calls.after_write;
  }
  AbortCode put_to(std::span<const HookCalls> hooks, void* service) {
    for (const HookCalls& calls : hooks) {
      if (!covers(calls, entry.index)) continue;
      const AbortCode answer = put_to(calls, service);
      if (answer != AbortCode::none) return answer;
    }
    return AbortCode::none;
  }
};

Dictionary::Dictionary(const DictionaryTables& tables, std::span<std::uint8_t> values,
                       std::span<ObjectState> states)
    : tables_(tables),
      values_(values.data()),
      states_(states.data()),
      shared_state_(states.size() < tables.objects.size()) {
  std::ranges::fill(values, std::uint8_t{0});
  remembered_.fill(&no_row);
}

inline void Dictionary::fill(Entry& entry, const ObjectRow& object, const EntryRow& row) const {
  // Most rows have one sub-index, and their pitch need not be found out.
  const auto place = static_cast<std::uint32_t>(entry.sub - row.sub_first);
  std::uint8_t* value = values_ + object.offset + row.offset +
                        static_cast<std::uint32_t>(entry.index - object.index) * object.pitch;
  entry.row = &row;
  entry.state = &state_of(static_cast<std::size_t>(&object - tables_.objects.data()));
  entry.value = place == 0 ? value : value + place * row.pitch();
}

const ObjectRow* Dictionary::search_object(std::uint16_t index) const {
  const ObjectRow* object =
      last_not_above(tables_.objects, index, [](const ObjectRow& row) { return row.index; });
  return object != nullptr && contains(*object, index) ? object : nullptr;
}

/// The row that has the object, or null.
inline const ObjectRow* Dictionary::find_object(std::uint16_t index) const {
  if constexpr (remembered_max == 0) {
    return search_object(index);
  } else {
    const ObjectRow*& remembered = remembered_[place_of(index)];
    if (contains(*remembered, index)) return remembered;
    const ObjectRow* object = search_object(index);
    if (object != nullptr) remembered = object;
    return object;
  }
}

/// Finds the entry whose index and sub-index stand in `entry`, and fills in the rest.
AbortCode Dictionary::locate(Entry& entry) const {
  const ObjectRow* object = find_object(entry.index);
  if (object == nullptr) return AbortCode::no_object;
  const auto entries = tables_.entries.subspan(object->entry_first, object->entry_count);
  const EntryRow* row = last_not_above(
      entries, entry.sub, [](const EntryRow& candidate) { return candidate.sub_first; });
  if (row == nullptr || entry.sub > row->sub_last) return AbortCode::no_sub_index;
  fill(entry, *object, *row);
  return AbortCode::none;
}

Result<Entry> Dictionary::find(std::uint16_t index, std::uint8_t sub) const {
  Entry entry{.index = index, .sub = sub};
  const AbortCode answer = locate(entry);
  return {entry, answer};
}

/// Puts a question to the hooks of an entry, the application's before the services', until one does
/// not answer "none".
AbortCode Dictionary::ask(Question& question) const {
  AbortCode answer = ask_hooks_ == nullptr ? AbortCode::none : ask_hooks_(hooks_, question);
  for (const HookLink* link = links_; link != nullptr && answer == AbortCode::none;
       link = link->next) {
    answer = question.put_to(link->hooks, link->service);
  }
  for (const ServiceLink* link = services_; link != nullptr && answer == AbortCode::none;
       link = link->next) {
    answer = question.put_to(link->calls->hooks, link->service);
  }
  return answer;
}

AbortCode Dictionary::ask_hooks(const Hook* hook, Question& question) {
  for (; hook != nullptr; hook = hook->next) {
    if (!covers(*hook, question.entry.index)) continue;
    const AbortCode answer = question.put_to(*hook);
    if (answer != AbortCode::none) return answer;
  }
  return AbortCode::none;
}

AbortCode Dictionary::refresh(const Entry& entry) {
  Question question(entry, Question::Moment::before_read);
  return ask(question);
}

AbortCode Dictionary::write(const Entry& entry, std::span<const std::uint8_t> value,
                            Source source) {
  if (!allows(entry.row->access, Access::sdo_write)) return AbortCode::read_only;
  const AbortCode answer = check(entry, value);
  if (answer == AbortCode::none) commit(entry, value, source);
  return answer;
}

AbortCode Dictionary::write(std::uint16_t index, std::uint8_t sub,
                            std::span<const std::uint8_t> value, Source source) {
  Entry entry{.index = index, .sub = sub};
  const AbortCode answer = locate(entry);
  return answer == AbortCode::none ? write(entry, value, source) : answer;
}

AbortCode Dictionary::check_value(const EntryRow& row, std::span<const std::uint8_t> value) {
  const AbortCode answer = check_length(row, value.size());
  if (answer != AbortCode::none) return answer;
  if (overflows(row, value)) return AbortCode::value_too_high;
  const bool limited = has(row.traits, EntryTraits::limited) && is_integer(row.type);
  return limited ? check_range(row, value) : AbortCode::none;
}

AbortCode Dictionary::check(const Entry& entry, std::span<const std::uint8_t> value) const {
  const AbortCode answer = check_value(*entry.row, value);
  if (answer != AbortCode::none || !entry.state->hooked) return answer;
  Question question(entry, Question::Moment::before_write);
  question.value = value;
  return ask(question);
}

void Dictionary::commit(const Entry& entry, std::span<const std::uint8_t> value, Source source) {
  set(entry, value);
  announce(entry, source);
}

void Dictionary::announce(const Entry& entry, Source source) {
  if (!entry.state->hooked) return;
  Question question(entry, Question::Moment::after_write);
  question.source = source;
  ask(question);
}

void Dictionary::set(const Entry& entry, std::span<const std::uint8_t> value) {
  const std::size_t size = std::min<std::size_t>(value.size(), entry.row->capacity);
  std::uint8_t* place = entry.value;
  bool changed = false;
  if (is_string(entry.row->type)) {
    const auto length = static_cast<std::uint16_t>(size);
    changed = std::memcmp(place, &length, 2) != 0;
    std::memcpy(place, &length, 2);
    place += 2;
  }
  const std::uint32_t watchers = entry.state->watchers;
  if (watchers != 0 && (changed || !std::equal(place, place + size, value.data()))) {
    changes_ |= watchers;
  }
  if (size != 0) std::memcpy(place, value.data(), size);
}

/// Like locate(): the length of a number in bytes, 0 where there is none.
std::size_t Dictionary::locate_number(Entry& entry) const {
  return locate(entry) == AbortCode::none ? byte_length(entry.row->type) : 0;
}

bool Dictionary::set_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
  Entry entry{.index = index, .sub = sub};
  const std::size_t length = locate_number(entry);
  if (length != 0) set(entry, {reinterpret_cast<const std::uint8_t*>(&number), length});
  return length != 0;
}

std::uint64_t Dictionary::number(std::uint16_t index, std::uint8_t sub) const {
  Entry entry{.index = index, .sub = sub};
  const std::size_t length = locate_number(entry);
  std::uint64_t number = 0;
  if (length != 0) std::memcpy(&number, entry.value, length);
  return number;
}

const Domain* Dictionary::domain(const Entry& entry) const {
  if (!entry.state->hooked) return nullptr;
  for (const Hook* hook = hooks_; hook != nullptr; hook = hook->next) {
    if (covers(*hook, entry.index) && hook->domain != nullptr) return hook->domain;
  }
  return nullptr;
}

void Dictionary::watch(const Entry& entry, std::uint32_t watchers) {
  entry.state->watchers |= watchers;
  ++revision_;
}

void Dictionary::unwatch(std::uint32_t watchers) {
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    state_of(row).watchers &= ~watchers;
  }
  ++revision_;
}

Dictionary::Watched Dictionary::watched(const Entry& entry) const {
  Question question(entry, Question::Moment::attention);
  if (entry.state->hooked) ask(question);
  return question.watched;
}

void Dictionary::attach(HookLink& link) {
  link.next = links_;
  links_ = &link;
  for (const HookCalls& calls : link.hooks) mark_hooked(calls.first, calls.last);
}

void Dictionary::attach(ServiceLink& service) {
  ServiceLink** tail = &services_;
  while (*tail != nullptr) tail = &(*tail)->next;
  *tail = &service;
  for (const HookCalls& calls : service.calls->hooks) mark_hooked(calls.first, calls.last);
}

void Dictionary::mark_hooked(std::uint16_t first, std::uint16_t last) {
  ++revision_;
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    const ObjectRow& object = tables_.objects[row];
    const bool apart = object.index > last || object.index + object.count - 1 < first;
    if (!apart) state_of(row).hooked = true;
  }
}

void Dictionary::restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  for (const ObjectRow& object : tables_.objects) {
    for (unsigned n = 0; n < object.count; ++n) {
      Entry entry;
      entry.index = static_cast<std::uint16_t>(object.index + n);
      if (entry.index < first || entry.index > last) continue;
      for (const EntryRow& row : tables_.entries.subspan(object.entry_first, object.entry_count)) {
        for (unsigned sub = row.sub_first; sub <= row.sub_last; ++sub) {
          entry.sub = static_cast<std::uint8_t>(sub);
          fill(entry, object, row);
          restore_default(entry, node_id);
        }
      }
    }
  }
}

void Dictionary::restore_default(const Entry& entry, std::uint8_t node_id) {
  const EntryRow& row = *entry.row;
  const std::uint64_t offset = has(row.traits, EntryTraits::plus_node_id) ? node_id : 0U;
  const std::uint64_t number = static_cast<std::uint64_t>(row.initial) + offset;
  std::span<const std::uint8_t> value(reinterpret_cast<const std::uint8_t*>(&number), row.capacity);
  if (is_string(row.type)) {
    const std::string_view text = row.initial_text;
    value = {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  }
  set(entry, value);
}

}  // namespace canvoy
