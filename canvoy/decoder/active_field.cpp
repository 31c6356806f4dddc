#include "canvoy/decoder/active_field.hpp"

#include <algorithm>

#include "canvoy/profiles/model/physical.hpp"

namespace canvoy::decoder {

namespace {

bool holds(const EntryInfo& entry, const FieldCondition& condition,
           std::span<const std::uint8_t> bytes) {
  return std::ranges::any_of(entry.fields, [&](const FieldInfo& field) {
    if (field.name != condition.field) return false;
    const Reading reading = read_field(entry, field, bytes);
    return reading.kind != Reading::Kind::none && reading.raw >= condition.first &&
           reading.raw <= condition.last;
  });
}

}  // namespace

bool is_active(const EntryInfo& entry, const FieldInfo& field,
               std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(field.when, [&](const FieldCondition& asked) {
    return std::ranges::any_of(field.when, [&](const FieldCondition& alternative) {
      return alternative.field == asked.field && holds(entry, alternative, bytes);
    });
  });
}

}  // namespace canvoy::decoder
