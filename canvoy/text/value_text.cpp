#include "canvoy/text/value_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include "canvoy/decoder/active_field.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"

namespace canvoy::text {

namespace {

constexpr std::array<std::int64_t, 10> powers_of_ten = {
    1, 10, 100, 1000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};

std::string unknown_text(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? "(empty)" : bytes_text(bytes);
}

void append_digits(std::string& text, std::uint64_t number) {
  std::array<char, 20> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end);
}

/// `number` divided, rounded to nearest, ties to even.
std::int64_t divide(std::int64_t number, std::int64_t denominator) {
  const std::int64_t quotient = number / denominator;
  const std::int64_t rest = std::abs(number % denominator);
  const bool is_beyond = rest > denominator - rest;
  const bool is_half = rest == denominator - rest;
  if (!is_beyond && !(is_half && quotient % 2 != 0)) return quotient;
  return number < 0 ? quotient - 1 : quotient + 1;
}

/// Writes the scaled number with integers, if possible, in a fraction of the time that a double
/// takes; false: not possible.
bool append_scaled(std::string& text, std::int64_t raw, const Scale& scale, unsigned digits) {
  std::int64_t number = 0;
  if (digits >= powers_of_ten.size() || scale.denominator <= 0 ||
      __builtin_mul_overflow(raw, scale.numerator, &number) ||
      __builtin_add_overflow(number, scale.offset, &number) ||
      __builtin_mul_overflow(number, powers_of_ten.at(digits), &number) ||
      number == std::numeric_limits<std::int64_t>::min()) {
    return false;
  }
  if (scale.denominator != 1) number = divide(number, scale.denominator);
  if (number < 0) text += '-';
  const auto size = static_cast<std::uint64_t>(std::abs(number));
  const auto power = static_cast<std::uint64_t>(powers_of_ten.at(digits));
  append_digits(text, size / power);
  if (digits == 0) return true;
  text += '.';
  for (std::uint64_t place = power / 10; place > 0; place /= 10) {
    text += static_cast<char>('0' + size / place % 10);
  }
  return true;
}

/// With as many digits as distinguish it from its neighbours.
std::string real_text(double number, DataType type) {
  return type == DataType::real32 ? fmt::format("{}", static_cast<float>(number))
                                  : fmt::format("{}", number);
}

void append_number(std::string& text, const Reading& reading, const EntryInfo& entry,
                   unsigned bits) {
  const ValueInfo& value = *reading.value;
  if (value.notation == Notation::hexadecimal || value.notation == Notation::bit_mask) {
    const auto raw = static_cast<std::uint64_t>(reading.raw);
    const std::uint64_t mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    fmt::format_to(std::back_inserter(text), "{:0{}X}h", raw & mask, (bits + 3) / 4);
    return;
  }
  const Scale& scale = scale_of(value, reading.raw);
  if (is_real(entry.type) && scale == Scale{}) {
    text += real_text(reading.number, entry.type);
    if (value.unit != Unit::none) text.append(" ").append(symbol(value.unit));
    return;
  }
  const unsigned digits = scale.denominator == 1 ? 0 : decimals(scale);
  const bool is_done = !is_real(entry.type) && append_scaled(text, reading.raw, scale, digits);
  if (!is_done) fmt::format_to(std::back_inserter(text), "{:.{}f}", reading.number, digits);
  if (value.unit != Unit::none) text.append(" ").append(symbol(value.unit));
}

/// The prescribed value of reserved bits: not shown.
bool is_padding(const Reading& reading) {
  return reading.kind == Reading::Kind::name && reading.named->meaning == Meaning::padding;
}

void append_reading(std::string& text, const Reading& reading, const EntryInfo& entry,
                    unsigned bits, std::span<const std::uint8_t> bytes) {
  switch (reading.kind) {
    case Reading::Kind::number:
      append_number(text, reading, entry, bits);
      if (reading.out_of_range) text += " (out of range)";
      return;
    case Reading::Kind::name:
      text += reading.named->name;
      return;
    case Reading::Kind::text:
      text.append("\"").append(formats::plain_text(reading.text)).append("\"");
      return;
    case Reading::Kind::bytes:
    case Reading::Kind::none:
      break;
  }
  text += unknown_text(bytes);
}

/// Writes the number in its unit, as a decimal fraction if possible; false: not a number, or too
/// many digits.
bool append_decimal_json(JsonLine& json, const Reading& reading) {
  constexpr std::int64_t exact_max = std::int64_t{1} << 53;
  const Scale& scale = scale_of(*reading.value, reading.raw);
  const unsigned places = scale.denominator == 1 ? 0 : decimals(scale);
  std::int64_t number = 0;
  if (places >= powers_of_ten.size() || scale.denominator <= 0 ||
      __builtin_mul_overflow(reading.raw, scale.numerator, &number) ||
      __builtin_add_overflow(number, scale.offset, &number) ||
      __builtin_mul_overflow(number, powers_of_ten.at(places), &number) || number == 0 ||
      number % scale.denominator != 0 || std::abs(number) >= exact_max) {
    return false;
  }
  json.decimal(number / scale.denominator, places);
  return true;
}

void append_reading_json(JsonLine& json, const Reading& reading, DataType type,
                         std::span<const std::uint8_t> bytes) {
  switch (reading.kind) {
    case Reading::Kind::number:
      if (!is_real(type) && scale_of(*reading.value, reading.raw) == Scale{}) {
        return json.number(reading.raw);
      }
      if (!is_real(type) && append_decimal_json(json, reading)) return;
      return json.number(reading.number);
    case Reading::Kind::name:
      if (reading.named->meaning == Meaning::invalid) return json.null();
      return json.text(reading.named->name);
    case Reading::Kind::text:
      return json.text(formats::plain_text(reading.text));
    case Reading::Kind::bytes:
    case Reading::Kind::none:
      break;
  }
  json.text(unknown_text(bytes));
}

struct FieldReading {
  std::string_view plain_name = {};
  std::string numbered = {};  ///< empty: it has no number
  Reading reading = {};

  std::string_view name() const { return numbered.empty() ? plain_name : numbered; }
};

/// Puts the last reading of each field in order of name, each name once.
void put_reading(std::vector<FieldReading>& readings, const FieldInfo& field,
                 const Reading& reading) {
  constexpr std::size_t usual_count = 16;
  if (readings.empty()) readings.reserve(usual_count);
  FieldReading made{.plain_name = field.name, .reading = reading};
  if (field.name.find('#') != std::string_view::npos) made.numbered = formats::field_name(field);
  std::size_t place = readings.size();
  while (place > 0 && readings[place - 1].name() > made.name()) --place;
  if (place > 0 && readings[place - 1].name() == made.name()) {
    readings[place - 1].reading = reading;
    return;
  }
  readings.insert(readings.begin() + static_cast<std::ptrdiff_t>(place), std::move(made));
}

bool is_time(const EntryInfo& entry) {
  return entry.type == DataType::time_of_day || entry.type == DataType::time_difference;
}

std::string time_value_text(DataType type, std::span<const std::uint8_t, time_of_day_bytes> bytes) {
  return type == DataType::time_of_day ? time_text(decode_time<TimeOfDay>(bytes))
                                       : time_text(decode_time<TimeDifference>(bytes));
}

/// True if an unset bit has no information: it is a plain 0, or shares its names with other bits of
/// the entry, like one of eight buttons. "The car stands" is shown.
bool says_nothing(const EntryInfo& entry, const FieldInfo& bit, const Reading& reading) {
  if (bit.bits != 1 || reading.raw != 0) return false;
  if (reading.kind != Reading::Kind::name) return true;
  return std::ranges::any_of(entry.fields, [&](const FieldInfo& other) {
    return &other != &bit && other.bits == 1 &&
           other.value.names.begin() == bit.value.names.begin();
  });
}

/// True if there are too many bits to show all.
bool has_many_bits(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  constexpr std::ptrdiff_t few = 4;
  return std::ranges::count_if(entry.fields, [&](const FieldInfo& field) {
           return field.bits == 1 && !is_reserved(field) && decoder::is_active(entry, field, bytes);
         }) > few;
}

void append_fields(std::string& text, const EntryInfo& entry, std::span<const std::uint8_t> bytes,
                   bool is_brief) {
  const FieldInfo* only = only_field(entry);
  const bool are_set_ones_enough = is_brief && has_many_bits(entry, bytes);
  const std::size_t start = text.size();
  for (const FieldInfo& field : entry.fields) {
    if (!decoder::is_active(entry, field, bytes)) continue;
    const Reading reading = read_field(entry, field, bytes);
    if (is_padding(reading)) continue;
    if (are_set_ones_enough && says_nothing(entry, field, reading)) continue;
    if (text.size() != start) text += ", ";
    if (&field != only) text.append(formats::field_name(field)).append(": ");
    append_reading(text, reading, entry, field.bits, bytes);
  }
  if (are_set_ones_enough && text.size() == start) text += "no bit is set";
}

void append_value(std::string& text, const EntryInfo* entry, std::span<const std::uint8_t> bytes,
                  bool is_brief) {
  if (entry == nullptr) {
    text += unknown_text(bytes);
  } else if (is_time(*entry) && bytes.size() == time_of_day_bytes) {
    text += time_value_text(entry->type, bytes.first<time_of_day_bytes>());
  } else if (entry->fields.empty()) {
    append_reading(text, read_value(*entry, bytes), *entry, bit_length(entry->type), bytes);
  } else {
    append_fields(text, *entry, bytes, is_brief);
  }
}

}  // namespace

std::string value_text(const EntryInfo* entry, std::span<const std::uint8_t> bytes) {
  std::string text;
  append_value(text, entry, bytes, false);
  return text;
}

void append_value_text(std::string& text, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes) {
  append_value(text, entry, bytes, true);
}

void append_value_json(std::string& line, const EntryInfo* entry,
                       std::span<const std::uint8_t> bytes) {
  JsonLine json(line);
  if (entry == nullptr) return json.text(unknown_text(bytes));
  if (is_time(*entry)) return json.text(value_text(entry, bytes));
  if (entry->fields.empty()) {
    return append_reading_json(json, read_value(*entry, bytes), entry->type, bytes);
  }
  if (const FieldInfo* only = only_field(*entry)) {
    return append_reading_json(json, read_field(*entry, *only, bytes), entry->type, bytes);
  }
  std::vector<FieldReading> readings;
  for (const FieldInfo& field : entry->fields) {
    if (!decoder::is_active(*entry, field, bytes)) continue;
    const Reading reading = read_field(*entry, field, bytes);
    if (!is_padding(reading)) put_reading(readings, field, reading);
  }
  json.begin_object();
  for (const FieldReading& each : readings) {
    append_reading_json(json.key(each.name()), each.reading, entry->type, bytes);
  }
  json.end_object();
}

}  // namespace canvoy::text
