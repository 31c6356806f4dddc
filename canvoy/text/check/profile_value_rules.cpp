// Values of an object of a profile: reserved ones, ranges, codes for "no value", and defaults.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/active_field.hpp"
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/profile_rule.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

/// A named value is an allowed one unless it is reserved.
bool is_known(const ValueInfo& value, std::int64_t number, unsigned bits, bool has_sign) {
  const NamedValue* const named = find_name(value, number, bits, has_sign);
  if (named != nullptr) return named->meaning != Meaning::reserved;
  if (value.limits.kind != Limits::Kind::absolute) return true;
  return number >= value.limits.low && number <= value.limits.high;
}

/// True if both numbers have the same bits in a type of this length.
bool is_same(std::int64_t one, std::int64_t other, unsigned bits) {
  return number_of(static_cast<std::uint64_t>(one), bits, false) ==
         number_of(static_cast<std::uint64_t>(other), bits, false);
}

/// What the clause prints as a default is allowed, even where its fields name it as reserved: a
/// mapping object of CiA 417 is 0 before there was anything to tell (4.2.3 to 4.2.5).
bool is_printed_default(const EntryInfo& entry, std::uint64_t raw) {
  const auto printed = printed_default(entry);
  return printed && is_same(*printed, static_cast<std::int64_t>(raw), bit_length(entry.type));
}

/// The first field with a reserved value; null: none.
const FieldInfo* find_reserved_field(const EntryInfo& entry, std::span<const std::uint8_t> bytes) {
  for (const FieldInfo& field : entry.fields) {
    if (!decoder::is_active(entry, field, bytes)) continue;
    const Reading reading = read_field(entry, field, bytes);
    const bool is_reserved =
        reading.named != nullptr && reading.named->meaning == Meaning::reserved;
    if (is_reserved || reading.out_of_range) return &field;
  }
  return nullptr;
}

/// True for a record of zeros in an entry that need not be there and has no printed default: the
/// device has nothing there, such as input 2 of a panel with inputs 1 and 3 (CiA 417-4, 4.3.1).
bool is_empty_place(const EntryInfo& entry, std::uint64_t raw) {
  return raw == 0 && entry.category == Category::optional && entry.sub_first > 1 &&
         !printed_default(entry);
}

/// A refusal because of the present state gives no information on the value.
bool is_refusal_of_state(const Reply& reply) {
  return reply.has_aborted(AbortCode::local_control) ||
         reply.has_aborted(AbortCode::device_state) || reply.has_aborted(AbortCode::read_only);
}
bool is_refusal_of_value(const Reply& reply) {
  return reply.has_aborted(AbortCode::value_range) ||
         reply.has_aborted(AbortCode::value_too_high) ||
         reply.has_aborted(AbortCode::value_too_low);
}

/// True if the entry is read in its length: another case judges what cannot be put back.
bool is_as_typed(Bench& bench, std::uint16_t index, const EntryInfo& entry) {
  const Reply reply = bench.read(index, entry.sub_first);
  return reply && reply.value.size() == byte_length(entry.type);
}

/// Reason why nothing of the object is written; application objects need permission.
std::optional<Verdict> cannot_write(Bench& bench, const Ruled& ruled) {
  // Those of CiA 302 start and stop nodes and programs.
  constexpr std::uint16_t first_of_302 = 0x1F00;
  const bool is_parameter = ruled.is_communication() && ruled.object->index < first_of_302;
  if (bench.options().moves || is_parameter) return std::nullopt;
  return not_applicable("objects are written with --moves only");
}

/// True for an entry with a plain number, which has its own names and limits.
bool is_plain_number(const EntryInfo& entry) {
  return is_integer(entry.type) && bit_length(entry.type) != 0 && entry.fields.empty();
}

/// The numbers beside the range of an entry that its type has, and that have no name.
std::vector<std::int64_t> numbers_beyond(const EntryInfo& entry) {
  std::vector<std::int64_t> numbers;
  const Limits& limits = entry.value.limits;
  if (limits.kind != Limits::Kind::absolute || !is_plain_number(entry)) return numbers;
  const unsigned bits = bit_length(entry.type);
  const NumberRange all = range_of_type(bits, is_signed(entry.type));
  for (const std::int64_t each : {limits.low - 1, limits.high + 1}) {
    const bool is_named = find_name(entry.value, each, bits, is_signed(entry.type)) != nullptr;
    if (all.contains(each) && !is_named) numbers.push_back(each);
  }
  return numbers;
}
/// True if a number beyond its range exists.
bool is_limited(const EntryInfo& entry) {
  return !numbers_beyond(entry).empty();
}

}  // namespace

std::optional<std::int64_t> printed_default(const EntryInfo& entry) {
  const bool is_number = entry.initial.kind == Default::Kind::number && is_integer(entry.type);
  return is_number ? std::optional(entry.initial.number) : std::nullopt;
}

bool has_reserved_values(const FieldInfo& field) {
  const NumberRange all = range_of_type(field.bits, field.is_signed);
  const auto is_unknown = [&](std::int64_t number) {
    return all.contains(number) && !is_known(field.value, number, field.bits, field.is_signed);
  };
  const auto number_at = [&](std::int64_t named) {
    return number_of(static_cast<std::uint64_t>(named), field.bits, field.is_signed);
  };
  const Limits& limits = field.value.limits;
  if (is_unknown(limits.low - 1) || is_unknown(limits.high + 1)) return true;
  return std::ranges::any_of(field.value.names, [&](const NamedValue& each) {
    return is_unknown(number_at(each.first)) || is_unknown(number_at(each.last) + 1);
  });
}

std::optional<std::int64_t> sentinel_of(const EntryInfo& entry) {
  if (!is_plain_number(entry) || !allows(entry.access, Access::rw)) return std::nullopt;
  for (const NamedValue& each : entry.value.names) {
    if (each.meaning == Meaning::invalid || each.meaning == Meaning::do_not_care) return each.first;
  }
  return std::nullopt;
}

bool has_default_after_reset(const EntryInfo& entry) {
  return printed_default(entry) && entry.mapping == Mapping::by_default &&
         allows(entry.access, Access::rw) && !entry.consumer_initial &&
         entry.consumer_access == Access::none && !entry.access_by_device;
}

bool has_range(const EntryInfo& entry) {
  return is_limited(entry) && allows(entry.access, Access::rw);
}

bool has_unknown_values(const EntryInfo& entry) {
  if (!is_plain_number(entry)) return false;
  return is_limited(entry) || std::ranges::any_of(entry.value.names, [](const NamedValue& each) {
           return each.meaning == Meaning::reserved;
         });
}

Verdict judge_value(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    if (!is_plain_number(entry)) continue;
    const Reply reply = bench.read(index, entry.sub_first);
    if (!reply || reply.value.size() != byte_length(entry.type)) continue;
    ++tried;
    const unsigned bits = bit_length(entry.type);
    const std::int64_t number = number_of(reply.number(), bits, is_signed(entry.type));
    if (is_known(entry.value, number, bits, is_signed(entry.type))) continue;
    if (is_printed_default(entry, reply.number())) continue;
    return failed(fmt::format("{} is {}, which is reserved or out of its range",
                              text::object_text(index, entry.sub_first), number));
  }
  return tried == 0 ? not_applicable("it has no number that can be read") : passed();
}

Verdict judge_fields(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    if (entry.fields.empty()) continue;
    const Reply reply = bench.read(index, entry.sub_first);
    if (!reply || reply.value.size() != byte_length(entry.type)) continue;
    if (is_empty_place(entry, reply.number())) continue;
    ++tried;
    if (is_printed_default(entry, reply.number())) continue;
    const FieldInfo* const field = find_reserved_field(entry, reply.value);
    if (field == nullptr) continue;
    const std::int64_t number = read_field(entry, *field, reply.value).raw;
    return failed(fmt::format("{}: {} (bit {} on, {}) is {:X}h, which is reserved or out of range",
                              text::object_text(index, entry.sub_first), field->name,
                              field->first_bit, field->bits, number));
  }
  return tried == 0 ? not_applicable("it has no fields that can be read") : passed();
}

Verdict judge_range(Bench& bench, const Ruled& ruled) {
  if (const auto cannot = cannot_write(bench, ruled)) return *cannot;
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    if (!has_range(entry) || !is_as_typed(bench, index, entry)) continue;
    if (!allows(access_of_claim(claim, *ruled.object, entry), Access::rw)) continue;
    for (const std::int64_t beyond : numbers_beyond(entry)) {
      const Reply done = bench.set(index, entry.sub_first, static_cast<std::uint64_t>(beyond),
                                   byte_length(entry.type));
      if (is_refusal_of_state(done)) continue;
      ++tried;
      if (is_refusal_of_value(done)) continue;
      return failed(fmt::format("{} = {}: {}", text::object_text(index, entry.sub_first), beyond,
                                done.text()));
    }
  }
  return tried == 0 ? not_applicable("it has no range that can be tried") : passed();
}

Verdict judge_sentinel(Bench& bench, const Ruled& ruled) {
  if (const auto cannot = cannot_write(bench, ruled)) return *cannot;
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo& entry : ruled.object->entries()) {
    const auto code = sentinel_of(entry);
    if (!code || !is_as_typed(bench, index, entry)) continue;
    if (!allows(access_of_claim(claim, *ruled.object, entry), Access::rw)) continue;
    const Reply done = bench.set(index, entry.sub_first, static_cast<std::uint64_t>(*code),
                                 byte_length(entry.type));
    if (is_refusal_of_state(done)) continue;
    ++tried;
    if (done) continue;
    const std::int64_t number =
        number_of(static_cast<std::uint64_t>(*code), bit_length(entry.type), false);
    return failed(fmt::format("{} = {:X}h: {}", text::object_text(index, entry.sub_first), number,
                              done.text()));
  }
  return tried == 0 ? not_applicable("it has no code for \"no value\" that can be written")
                    : passed();
}

Verdict judge_default(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  const auto entries = ruled.object->entries();
  const bool is_there = std::ranges::any_of(entries, [&](const EntryInfo& each) {
    return has_default_after_reset(each) && bench.has(index, each.sub_first);
  });
  if (!is_there) return not_applicable("it is not there");
  if (reset_node(bench)) return not_applicable(no_boot_up);
  std::size_t tried = 0;
  for (const EntryInfo& entry : entries) {
    if (!has_default_after_reset(entry)) continue;
    const Reply reply = bench.read(index, entry.sub_first);
    if (!reply || reply.value.size() != byte_length(entry.type)) continue;
    ++tried;
    if (is_printed_default(entry, reply.number())) continue;
    const auto printed = number_of(static_cast<std::uint64_t>(entry.initial.number),
                                   bit_length(entry.type), is_signed(entry.type));
    return failed(fmt::format("{} is {} after a reset, in place of {}",
                              text::object_text(index, entry.sub_first), reply.text(), printed));
  }
  return tried == 0 ? not_applicable("it cannot be read") : passed();
}

}  // namespace canvoy::conformance
