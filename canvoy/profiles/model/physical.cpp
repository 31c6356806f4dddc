#include "canvoy/profiles/model/physical.hpp"

namespace canvoy {

namespace {

/// NumberRules gives the same result, but searches all names first: this runs for each value of
/// each decoded frame.
bool is_out_of_limits(const Limits& limits, std::int64_t number) {
  return limits.kind == Limits::Kind::absolute && (number < limits.low || number > limits.high);
}

Reading read_number(const ValueInfo& value, const BitRange& bits, std::uint64_t whole) {
  Reading reading;
  reading.value = &value;
  reading.raw = extract(whole, bits);
  reading.number = to_physical(static_cast<double>(reading.raw), scale_of(value, reading.raw));
  reading.named = find_name(value, reading.raw, bits.bits, bits.is_signed);
  reading.kind = reading.named != nullptr ? Reading::Kind::name : Reading::Kind::number;
  reading.out_of_range = reading.named == nullptr && is_out_of_limits(value.limits, reading.raw);
  return reading;
}

Reading read_real(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  Reading reading;
  reading.kind = Reading::Kind::number;
  reading.value = &entry.value;
  const double number = entry.type == DataType::real32
                            ? static_cast<double>(load<float>(bytes.data()))
                            : load<double>(bytes.data());
  reading.number = to_physical(number, entry.value.scale);
  reading.raw = static_cast<std::int64_t>(load_unsigned(bytes));
  return reading;
}

Reading read_bytes(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  Reading reading;
  reading.kind = Reading::Kind::bytes;
  reading.value = &entry.value;
  const bool is_text =
      entry.type == DataType::visible_string || entry.type == DataType::utf8_string;
  if (!is_text) return reading;
  reading.kind = Reading::Kind::text;
  reading.text = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  // Characters behind a zero belong to an older, longer text.
  reading.text = reading.text.substr(0, reading.text.find('\0'));
  return reading;
}

}  // namespace

Reading read_value(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  if (is_string(entry.type) || bit_length(entry.type) == 0) return read_bytes(entry, bytes);
  if (bytes.size() != byte_length(entry.type)) return {};
  if (is_real(entry.type)) return read_real(entry, bytes);
  if (!is_integer(entry.type)) return read_bytes(entry, bytes);
  return read_number(entry.value, bits_of(entry), normalized(entry.type, load_unsigned(bytes)));
}

Reading read_field(const EntryInfo& entry, const FieldInfo& field,
                   std::span<const std::uint8_t> bytes) {
  if (!is_integer(entry.type) || bytes.size() != byte_length(entry.type)) return {};
  return read_number(field.value, bits_of(field), load_unsigned(bytes));
}

Result<std::uint64_t> raw_from_physical(const ValueInfo& value, const BitRange& bits,
                                        double physical) {
  const NumberRules rules(value, bits);
  const double exact = rules.exact(physical);
  // A value of half a step beyond a limit is still rounded to it. NaN is refused.
  if (!(exact >= static_cast<double>(rules.range().low) - 0.5)) return AbortCode::value_too_low;
  if (!(exact <= static_cast<double>(rules.range().high) + 0.5)) return AbortCode::value_too_high;
  const std::int64_t number = rules.round(exact);
  if (!rules.is_value(number)) return AbortCode::value_range;
  return insert(0, {0, bits.bits, bits.is_signed}, number);
}

}  // namespace canvoy
