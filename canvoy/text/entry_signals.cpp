#include "canvoy/text/entry_signals.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/number_rules.hpp"

namespace canvoy::text {

namespace {

using formats::Signal;

constexpr unsigned signal_bits_max = 64;

std::uint64_t bits_in_use(const Signal& signal) {
  const std::uint64_t ones =
      signal.bits >= signal_bits_max ? ~std::uint64_t{0} : (std::uint64_t{1} << signal.bits) - 1;
  return ones << signal.first_bit;
}

/// A range of names is written only if it has few numbers.
void add_states(Signal& signal, const ValueInfo& value, const BitRange& bits) {
  constexpr std::int64_t numbers_max = 16;
  for (const NamedValue& named : value.names) {
    if (named.meaning == Meaning::reserved || named.meaning == Meaning::padding) continue;
    const NumberRange range = range_of(named, bits);
    if (range.high - range.low >= numbers_max) continue;
    for (std::int64_t number = range.low; number <= range.high; ++number) {
      signal.states.push_back({number, std::string(named.name)});
    }
  }
}

bool is_amount(const ValueInfo& value) {
  return value.notation == Notation::number && value.pieces.empty();
}

void add_scale(Signal& signal, const ValueInfo& value) {
  if (!value.pieces.empty()) signal.comment = "its scale depends on the number";
  if (value.notation == Notation::bcd) signal.comment = "binary coded decimal digits";
  if (value.notation == Notation::characters) signal.comment = "characters";
  if (value.notation == Notation::bit_mask) signal.comment = "each bit for itself";
  if (!is_amount(value)) return;
  const auto denominator = static_cast<double>(value.scale.denominator);
  signal.factor = static_cast<double>(value.scale.numerator) / denominator;
  signal.offset = static_cast<double>(value.scale.offset) / denominator;
  signal.unit = symbol(value.unit);
  if (value.limits.kind != Limits::Kind::absolute) return;
  const double low = to_physical(static_cast<double>(value.limits.low), value.scale);
  const double high = to_physical(static_cast<double>(value.limits.high), value.scale);
  signal.limits = std::minmax(low, high);
}

Signal signal_of(const std::string& name, const ValueInfo& value, const BitRange& bits) {
  Signal signal = {.name = name, .first_bit = bits.first, .bits = bits.bits};
  if (bits.is_signed) signal.type = Signal::Type::signed_number;
  add_scale(signal, value);
  add_states(signal, value, bits);
  return signal;
}

/// For bits with alternative meanings: the least number of numbers that do not overlap.
void add_conditional(std::vector<Signal>& signals, const std::string& name,
                     const EntryInfo& entry) {
  std::uint64_t bits = 0;
  for (const FieldInfo& field : entry.fields) {
    if (!field.when.empty())
      bits |= bits_in_use({.first_bit = field.first_bit, .bits = field.bits});
  }
  for (const Signal& signal : signals) bits &= ~bits_in_use(signal);
  for (unsigned first = 0; first < signal_bits_max; ++first) {
    if ((bits >> first & 1) == 0) continue;
    unsigned end = first;
    while (end < signal_bits_max && (bits >> end & 1) != 0) ++end;
    signals.push_back({.name = fmt::format("{}, bits {} to {}", name, first, end - 1),
                       .first_bit = first,
                       .bits = end - first,
                       .comment = "what it means depends on other bits"});
    first = end;
  }
}

}  // namespace

std::vector<Signal> entry_signals(const std::string& name, const EntryInfo& entry) {
  const unsigned length = bit_length(entry.type);
  if (length == 0 || length > signal_bits_max) return {};
  if (is_real(entry.type)) {
    Signal signal = signal_of(name, entry.value, bits_of(entry));
    signal.type = entry.type == DataType::real32 ? Signal::Type::real32 : Signal::Type::real64;
    return {signal};
  }
  if (!is_integer(entry.type))
    return {signal_of(name, {.notation = Notation::hexadecimal}, bits_of(entry))};
  if (entry.fields.empty()) return {signal_of(name, entry.value, bits_of(entry))};
  if (const FieldInfo* only = only_field(entry); only != nullptr && only->when.empty()) {
    return {signal_of(name, only->value, bits_of(*only))};
  }
  std::vector<Signal> signals;
  std::uint64_t used = 0;
  for (const FieldInfo& field : entry.fields) {
    if (is_reserved(field) || !field.when.empty()) continue;
    Signal signal = signal_of(fmt::format("{}, {}", name, formats::field_name(field)), field.value,
                              bits_of(field));
    if ((used & bits_in_use(signal)) != 0) continue;
    used |= bits_in_use(signal);
    signals.push_back(std::move(signal));
  }
  add_conditional(signals, name, entry);
  std::ranges::sort(signals, {}, &Signal::first_bit);
  return signals;
}

}  // namespace canvoy::text
