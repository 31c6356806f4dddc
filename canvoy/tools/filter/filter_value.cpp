#include "canvoy/tools/filter/filter_value.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::tools {

namespace {

using decoder::DecodedValue;

/// Tolerance of a number for its digits: as many as are printed.
double tolerance_of(const Reading& reading, DataType type) {
  constexpr double digits_of_float = 1e-6;
  constexpr double digits_of_double = 1e-9;
  const double size = std::abs(reading.number);
  if (is_real(type)) return size * digits_of_float;
  const Scale& scale = scale_of(*reading.value, reading.raw);
  const unsigned digits = scale.denominator == 1 ? 0 : decimals(scale);
  std::int64_t power = 1;
  for (unsigned i = 0; i < digits; ++i) power *= 10;
  std::int64_t step = 0;
  const bool is_exact =
      !__builtin_mul_overflow(power, scale.numerator, &step) && step % scale.denominator == 0;
  return is_exact ? size * digits_of_double : 0.5 / static_cast<double>(power);
}

bool is_between(double number, double tolerance, const FilterLiteral& literal, double factor) {
  const double low = literal.low.number * factor;
  const double high = literal.high.number * factor;
  return (literal.low.is_open ? number > low + tolerance : number >= low - tolerance) &&
         (literal.high.is_open ? number < high - tolerance : number <= high + tolerance);
}

bool is_number(const Reading& reading, DataType type, const FilterLiteral& literal) {
  const bool is_state = reading.kind == Reading::Kind::name &&
                        reading.named->meaning == Meaning::state &&
                        reading.value->unit == Unit::none;
  if (reading.kind != Reading::Kind::number && !is_state) return false;
  double factor = 1;
  if (literal.unit) {
    const auto units = conversion(literal.unit->unit, reading.value->unit);
    if (!units) return false;
    factor = *units * literal.unit->count;
  }
  return is_between(reading.number, tolerance_of(reading, type), literal, factor);
}

bool is_raw(std::uint64_t raw, const FilterLiteral& literal) {
  // Patterns have no sign.
  const auto low = static_cast<std::uint64_t>(std::max<std::int64_t>(literal.raw.low, 0));
  return literal.raw.high >= 0 && raw >= low && raw <= static_cast<std::uint64_t>(literal.raw.high);
}

}  // namespace

bool FilterValue::holds(std::span<const DecodedValue> values) {
  return std::ranges::any_of(values, [this](const DecodedValue& value) { return holds(value); });
}

bool FilterValue::names(const DecodedValue& entry) {
  if (compares_ || !has_number(entry)) return false;
  const Known& parts = known(entry);
  return parts.has_whole || std::ranges::find(parts.has_field, true) != parts.has_field.end();
}

bool FilterValue::has_number(const DecodedValue& value) const {
  if (object_.indices &&
      (value.index < object_.indices->low || value.index > object_.indices->high)) {
    return false;
  }
  return !object_.sub || *object_.sub == value.sub;
}

const FilterValue::Known& FilterValue::known(const DecodedValue& value) {
  constexpr unsigned subs = 8;  // neighbours get slots of their own
  const auto place = reinterpret_cast<std::uintptr_t>(value.profile) / alignof(Profile);
  Known& known = known_[(value.index * subs + value.sub + place) % known_max];
  const bool has_entry = value.entry != nullptr;
  if (known.is_looked_at && known.profile == value.profile && known.object == value.object &&
      known.has_entry == has_entry && known.index == value.index && known.sub == value.sub) {
    return known;
  }
  known = {value.profile, value.object, has_entry, value.index, value.sub, true, false, {}};
  look(known, value);
  return known;
}

void FilterValue::look(Known& known, const DecodedValue& value) const {
  const std::string name = plain_name(text::object_name_text(value));
  known.has_whole = has_name(name, object_.name);
  if (value.entry == nullptr) return;
  for (const FieldInfo& field : value.entry->fields) {
    const std::string whole = name + ", " + plain_name(formats::field_name(field));
    known.has_field.push_back(known.has_whole || has_name(whole, object_.name));
  }
}

bool FilterValue::holds(const DecodedValue& value) {
  if (!has_number(value)) return false;
  const Known& parts = known(value);
  const EntryInfo* const entry = value.entry;
  if (!compares_ && parts.has_whole) return true;
  if (entry == nullptr) return parts.has_whole && holds_unknown(value);
  if (entry->fields.empty()) {
    return parts.has_whole && holds(value, read_value(*entry, value.bytes()));
  }
  for (std::size_t i = 0; i < parts.has_field.size(); ++i) {
    const FieldInfo& field = entry->fields[i];
    if (!parts.has_field[i] || is_reserved(field)) continue;
    if (!decoder::is_active(*entry, field, value.bytes())) continue;
    if (!compares_ || holds(value, read_field(*entry, field, value.bytes()))) return true;
  }
  return false;
}

bool FilterValue::holds(const DecodedValue& value, const Reading& reading) const {
  if (reading.kind == Reading::Kind::none) return false;
  if (leaves_out_codes_ && reading.value->notation == Notation::hexadecimal) return false;
  const bool is_one = std::ranges::any_of(literals_, [&](const FilterLiteral& literal) {
    switch (literal.kind) {
      case FilterLiteral::Kind::number:
        return is_number(reading, value.entry->type, literal);
      case FilterLiteral::Kind::raw:
        return value.bytes().size() <= sizeof(std::uint64_t) &&
               (is_raw(load_unsigned(value.bytes()), literal) ||
                is_raw(static_cast<std::uint64_t>(reading.raw), literal));
      case FilterLiteral::Kind::word:
        break;
    }
    return is_word(value, &reading, literal);
  });
  return is_one != negated_;
}

/// An undescribed value: bytes, or the little-endian number in them.
bool FilterValue::holds_unknown(const DecodedValue& value) const {
  const bool is_short = value.bytes().size() <= sizeof(std::uint64_t);
  const std::uint64_t raw = is_short ? load_unsigned(value.bytes()) : 0;
  const bool is_one = std::ranges::any_of(literals_, [&](const FilterLiteral& literal) {
    if (literal.kind == FilterLiteral::Kind::word) return is_word(value, nullptr, literal);
    if (!is_short) return false;
    if (literal.kind == FilterLiteral::Kind::raw) return is_raw(raw, literal);
    return !literal.unit && is_between(static_cast<double>(raw), 0, literal, 1);
  });
  return is_one != negated_;
}

bool FilterValue::is_word(const DecodedValue& value, const Reading* reading,
                          const FilterLiteral& literal) const {
  if (reading != nullptr && reading->kind == Reading::Kind::name) {
    return same_name(reading->named->name, literal.word);
  }
  if (reading != nullptr && reading->kind == Reading::Kind::text) {
    return reading->text == literal.word;
  }
  if (reading != nullptr && reading->kind == Reading::Kind::number) return false;
  return plain_name(text::value_text(value.entry, value.bytes())) == plain_name(literal.word);
}

}  // namespace canvoy::tools
