#include "canvoy/text/doctor/value_watch.hpp"

#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/model/physical.hpp"

namespace canvoy::text {

namespace {

const NamedValue* failure_of(const Reading& reading) {
  const bool fails = reading.named != nullptr && reading.named->meaning == Meaning::failure;
  return fails ? reading.named : nullptr;
}

/// The sentinel with this meaning; null: none.
const NamedValue* failure_of(const decoder::DecodedValue& value) {
  if (value.entry == nullptr) return nullptr;
  if (const NamedValue* named = failure_of(read_value(*value.entry, value.bytes()))) return named;
  for (const FieldInfo& field : value.entry->fields) {
    if (!decoder::is_active(*value.entry, field, value.bytes())) continue;
    if (const NamedValue* named = failure_of(read_field(*value.entry, field, value.bytes())))
      return named;
  }
  return nullptr;
}

}  // namespace

void ValueWatch::hear(Time at, const decoder::Decoded& decoded) {
  using decoder::Mark;
  decoder::Marks of_values;
  const bool is_pdo = decoded.service == decoder::Decoded::Service::pdo;
  // A PDO of another length has an unknown mapping.
  if (is_pdo && decoded.marks.has(Mark::wrong_length)) return;
  for (const decoder::DecodedValue& value : decoded.values) {
    hear_value(at, decoded.node, value);
    of_values.add(value.marks);
  }
  if (decoded.marks.empty()) return;
  for (const Mark mark : decoder::all_marks) {
    if (!decoded.marks.has(mark) || of_values.has(mark)) continue;
    messages_[{decoded.node, mark}].add(at);
  }
}

void ValueWatch::hear_value(Time at, NodeId node, const decoder::DecodedValue& value) {
  using decoder::Mark;
  for (const Mark mark : {Mark::reserved, Mark::out_of_range}) {
    if (!value.marks.has(mark)) continue;
    HeardValue* heard = place(wrong_, node, value);
    if (heard == nullptr) continue;
    heard->mark = mark;
    heard->tally.add(at);
  }
  const NamedValue* failure = failure_of(value);
  if (failure == nullptr) return;
  if (HeardValue* heard = place(failed_, node, value)) {
    heard->meaning = failure->name;
    heard->tally.add(at);
  }
}

HeardValue* ValueWatch::place(ByEntry& entries, NodeId node, const decoder::DecodedValue& value) {
  constexpr std::size_t entries_max = 1024;
  const std::tuple key(node, value.index, value.sub);
  if (entries.size() == entries_max && !entries.contains(key)) return nullptr;
  HeardValue& heard = entries[key];
  if (value.object != nullptr) heard.name = value.object->name;
  return &heard;
}

}  // namespace canvoy::text
