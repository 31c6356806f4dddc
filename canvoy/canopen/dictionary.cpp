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

template <class Number>
AbortCode check_range(Number number, Number low, Number high) {
  if (number < low) return AbortCode::value_too_low;
  if (number > high) return AbortCode::value_too_high;
  return AbortCode::none;
}

AbortCode check_integer(const EntryRow& row, std::span<const std::uint8_t> value) {
  const std::uint64_t number = load_unsigned(value);
  const unsigned bits = bit_length(row.type);
  // A Boolean arrives as a byte, in which any value but 0 is true.
  if (bits % 8 != 0 && bits > 1 && number >> bits != 0) return AbortCode::value_too_high;
  if (!has(row.traits, EntryTraits::limited)) return AbortCode::none;
  const std::int64_t with_sign = sign_extend(number, bits);
  const bool is_sentinel =
      has(row.traits, EntryTraits::has_sentinel) &&
      (is_signed(row.type) ? with_sign == row.sentinel
                           : number == static_cast<std::uint64_t>(row.sentinel));
  if (is_sentinel) return AbortCode::none;
  if (is_signed(row.type)) return check_range(with_sign, row.low, row.high);
  return check_range(number, static_cast<std::uint64_t>(row.low),
                     static_cast<std::uint64_t>(row.high));
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

/// A service's hook, called as an application's hook is.
struct BoundCalls {
  template <class Function>
  struct Bound {
    Function* function;
    void* service;

    explicit operator bool() const { return function != nullptr; }
    template <class... Arguments>
    auto operator()(const Arguments&... arguments) const {
      using Answer = decltype(function(service, arguments...));
      return function == nullptr ? Answer() : function(service, arguments...);
    }
  };

  BoundCalls(const HookCalls& calls, void* service)
      : before_read{calls.before_read, service},
        before_write{calls.before_write, service},
        after_write{calls.after_write, service} {}

  Bound<AbortCode(void*, const Entry&)> before_read;
  Bound<AbortCode(void*, const Entry&, std::span<const std::uint8_t>)> before_write;
  Bound<void(void*, const Entry&, Source)> after_write;
};

}  // namespace

Dictionary::Dictionary(const DictionaryTables& tables, std::span<std::uint8_t> values,
                       std::span<ObjectState> states)
    : tables_(tables), values_(values), states_(states) {
  std::ranges::fill(values_, std::uint8_t{0});
  remembered_.fill(&no_row);
}

inline Entry Dictionary::entry_at(const ObjectRow& object, const EntryRow& row, std::uint16_t index,
                                  std::uint8_t sub) const {
  // Most rows have one sub-index, and their pitch need not be found out.
  const auto place = static_cast<std::uint32_t>(sub - row.sub_first);
  const std::uint32_t offset = row.offset + (place == 0 ? 0 : place * row.pitch());
  return {.row = &row,
          .state = &states_[static_cast<std::size_t>(&object - tables_.objects.data())],
          .value = values_.data() + object.offset +
                   static_cast<std::uint32_t>(index - object.index) * object.pitch + offset,
          .index = index,
          .sub = sub};
}

/// The row that has the object, or null.
inline const ObjectRow* Dictionary::find_object(std::uint16_t index) const {
  const ObjectRow*& remembered = remembered_[place_of(index)];
  if (contains(*remembered, index)) return remembered;
  const ObjectRow* object =
      last_not_above(tables_.objects, index, [](const ObjectRow& row) { return row.index; });
  if (object == nullptr || !contains(*object, index)) return nullptr;
  return remembered = object;
}

Result<Entry> Dictionary::find(std::uint16_t index, std::uint8_t sub) const {
  const ObjectRow* object = find_object(index);
  if (object == nullptr) return AbortCode::no_object;
  const auto entries = tables_.entries.subspan(object->entry_first, object->entry_count);
  const EntryRow* row =
      last_not_above(entries, sub, [](const EntryRow& candidate) { return candidate.sub_first; });
  if (row == nullptr || sub > row->sub_last) return AbortCode::no_sub_index;
  return entry_at(*object, *row, index, sub);
}

/// Shows `visit` the hooks of an entry, the application's before the services', until one does not
/// answer "none".
template <class Visit>
AbortCode Dictionary::visit_hooks(const Entry& entry, Visit visit) const {
  for (const Hook* hook = hooks_; hook != nullptr; hook = hook->next) {
    if (!covers(*hook, entry.index)) continue;
    const AbortCode answer = visit(*hook);
    if (answer != AbortCode::none) return answer;
  }
  for (const HookLink* link = links_; link != nullptr; link = link->next) {
    for (const HookCalls& calls : link->hooks) {
      if (!covers(calls, entry.index)) continue;
      const AbortCode answer = visit(BoundCalls(calls, link->service));
      if (answer != AbortCode::none) return answer;
    }
  }
  return AbortCode::none;
}

AbortCode Dictionary::refresh(const Entry& entry) {
  return visit_hooks(entry, [&](const auto& hook) { return hook.before_read(entry); });
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
  const Result<Entry> entry = find(index, sub);
  return entry ? write(*entry, value, source) : entry.abort();
}

AbortCode Dictionary::check_value(const EntryRow& row, std::span<const std::uint8_t> value) {
  const AbortCode answer = check_length(row, value.size());
  if (answer != AbortCode::none) return answer;
  return is_integer(row.type) ? check_integer(row, value) : AbortCode::none;
}

AbortCode Dictionary::check(const Entry& entry, std::span<const std::uint8_t> value) const {
  const AbortCode answer = check_value(*entry.row, value);
  if (answer != AbortCode::none || !entry.state->hooked) return answer;
  return visit_hooks(entry, [&](const auto& hook) { return hook.before_write(entry, value); });
}

void Dictionary::commit(const Entry& entry, std::span<const std::uint8_t> value, Source source) {
  set(entry, value);
  announce(entry, source);
}

void Dictionary::announce(const Entry& entry, Source source) {
  if (!entry.state->hooked) return;
  visit_hooks(entry, [&](const auto& hook) {
    hook.after_write(entry, source);
    return AbortCode::none;
  });
}

void Dictionary::set(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.row->type == DataType::domain) return;
  const std::span<const std::uint8_t> kept =
      value.first(std::min<std::size_t>(value.size(), entry.row->capacity));
  const std::span<std::uint8_t> present = entry.bytes();
  if (entry.state->watchers != 0 && !std::ranges::equal(present, kept))
    changes_ |= entry.state->watchers;
  if (!is_string(entry.row->type)) {
    std::memcpy(entry.value, kept.data(), kept.size());
    return;
  }
  store(entry.value, static_cast<std::uint16_t>(kept.size()));
  if (!kept.empty()) std::memcpy(entry.value + 2, kept.data(), kept.size());
}

bool Dictionary::set_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
  const Result<Entry> entry = find(index, sub);
  const std::size_t length = entry ? byte_length(entry->row->type) : 0;
  if (length == 0) return false;
  std::uint8_t bytes[8];
  store(bytes, number);
  set(*entry, {bytes, length});
  return true;
}

std::uint64_t Dictionary::number(std::uint16_t index, std::uint8_t sub) const {
  const Result<Entry> entry = find(index, sub);
  const std::size_t length = entry ? byte_length(entry->row->type) : 0;
  return length == 0 ? 0 : load_unsigned({entry->value, length});
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
  for (ObjectState& state : states_) state.watchers &= ~watchers;
  ++revision_;
}

Dictionary::Watched Dictionary::watched(const Entry& entry) const {
  Watched found;
  if (!entry.state->hooked) return found;
  visit_hooks(entry, [&](const auto& hook) {
    found.reads = found.reads || hook.before_read;
    found.writes = found.writes || hook.before_write || hook.after_write;
    return AbortCode::none;
  });
  return found;
}

void Dictionary::attach(Hook& hook) {
  hook.next = hooks_;
  hooks_ = &hook;
  mark_hooked(hook.first, hook.last);
}

void Dictionary::attach(HookLink& link) {
  link.next = links_;
  links_ = &link;
  for (const HookCalls& calls : link.hooks) mark_hooked(calls.first, calls.last);
}

void Dictionary::mark_hooked(std::uint16_t first, std::uint16_t last) {
  ++revision_;
  for (std::size_t row = 0; row < tables_.objects.size(); ++row) {
    const ObjectRow& object = tables_.objects[row];
    const bool apart = object.index > last || object.index + object.count - 1 < first;
    if (!apart) states_[row].hooked = true;
  }
}

void Dictionary::restore_defaults(std::uint16_t first, std::uint16_t last, std::uint8_t node_id) {
  for (const ObjectRow& object : tables_.objects) {
    for (unsigned index = std::max(object.index, first);
         index < object.index + unsigned{object.count} && index <= last; ++index) {
      for (const EntryRow& row : tables_.entries.subspan(object.entry_first, object.entry_count)) {
        for (unsigned sub = row.sub_first; sub <= row.sub_last; ++sub) {
          restore_default(entry_at(object, row, static_cast<std::uint16_t>(index),
                                   static_cast<std::uint8_t>(sub)),
                          node_id);
        }
      }
    }
  }
}

void Dictionary::restore_default(const Entry& entry, std::uint8_t node_id) {
  const EntryRow& row = *entry.row;
  if (is_string(row.type)) {
    const std::string_view text = row.initial_text;
    set(entry, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return;
  }
  const std::uint64_t offset = has(row.traits, EntryTraits::plus_node_id) ? node_id : 0U;
  std::uint8_t bytes[8];
  store(bytes, static_cast<std::uint64_t>(row.initial) + offset);
  set(entry, {bytes, row.capacity});
}

}  // namespace canvoy
