#include "canvoy/devices/cia447/kit/commands.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia447.hpp"

namespace canvoy::cia447 {

namespace {

const EntryInfo* find_entry_info(std::uint16_t index, std::uint8_t sub) {
  const ObjectInfo* object = find_object(profile, index);
  return object == nullptr ? nullptr : find_entry(*object, sub);
}

/// Calls `each` with the place of every field and the description of its values; an entry without
/// fields is one field.
template <class Each>
void each_field(std::uint16_t index, std::uint8_t sub, Each each) {
  const EntryInfo* entry = find_entry_info(index, sub);
  if (entry == nullptr) return;
  if (entry->fields.empty()) {
    each(FieldPlace{index, sub, 0, static_cast<std::uint8_t>(bit_length(entry->type))},
         entry->value);
  }
  for (const FieldInfo& field : entry->fields) {
    each(FieldPlace{index, sub, field.first_bit, field.bits}, field.value);
  }
}

std::uint32_t code_in(std::uint64_t whole, const FieldPlace& place) {
  return static_cast<std::uint32_t>(whole >> place.first_bit &
                                    ((std::uint64_t{1} << place.bits) - 1));
}

const NamedValue* find_named(const ValueInfo& value, std::uint32_t code) {
  for (const NamedValue& named : value.names) {
    if (code >= named.first && code <= named.last) return &named;
  }
  return nullptr;
}

/// Reserved bits have no meaning, whatever their value.
bool is_padding(const ValueInfo& value) {
  return std::ranges::any_of(
      value.names, [](const NamedValue& named) { return named.meaning == Meaning::padding; });
}

/// True if a client may write it.
bool can_be_written(const ValueInfo& value, std::uint32_t code) {
  if (is_padding(value)) return true;
  if (const NamedValue* named = find_named(value, code)) {
    return named->meaning != Meaning::reserved && named->meaning != Meaning::not_implemented;
  }
  // A number beside named codes; texts and similar values have neither names nor limits.
  const Limits& limits = value.limits;
  const bool has_limits = limits.kind == Limits::Kind::absolute;
  return has_limits ? code >= limits.low && code <= limits.high : value.names.empty();
}

bool is_left_alone(const ValueInfo& value, std::uint32_t code) {
  const NamedValue* named = find_named(value, code);
  return is_padding(value) || (named != nullptr && named->meaning == Meaning::do_not_care);
}

}  // namespace

const ValueInfo* find_value_info(const FieldPlace& place) {
  const ValueInfo* found = nullptr;
  each_field(place.index, place.sub, [&](const FieldPlace& other, const ValueInfo& value) {
    if (other == place && !is_padding(value)) found = &value;
  });
  return found;
}

std::optional<std::uint32_t> code_meaning(const FieldPlace& place, Meaning meaning) {
  const ValueInfo* value = find_value_info(place);
  if (value == nullptr) return std::nullopt;
  for (const NamedValue& named : value->names) {
    // If several codes have the meaning, a producer sends the highest (errata A9, Z11).
    if (named.meaning == meaning) return static_cast<std::uint32_t>(named.last);
  }
  return std::nullopt;
}

AbortCode check_codes(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.row->is_text()) return AbortCode::none;
  const std::uint64_t whole = load_unsigned(value);
  AbortCode answer = AbortCode::none;
  each_field(entry.index, entry.sub, [&](const FieldPlace& place, const ValueInfo& info) {
    if (!can_be_written(info, code_in(whole, place))) answer = AbortCode::value_range;
  });
  return answer;
}

std::uint32_t read_field(const Dictionary& dictionary, const FieldPlace& place) {
  return code_in(dictionary.number(place.index, place.sub), place);
}

void write_field(Dictionary& dictionary, const FieldPlace& place, std::uint32_t code) {
  const std::uint64_t mask = ((std::uint64_t{1} << place.bits) - 1) << place.first_bit;
  const std::uint64_t before = dictionary.number(place.index, place.sub);
  const std::uint64_t whole = (before & ~mask) | (std::uint64_t{code} << place.first_bit & mask);
  if (whole != before) dictionary.set_number(place.index, place.sub, whole);
}

constexpr ServiceHandlers Commands::service_calls = {.reset = method<&Commands::reset>};

Commands::Commands(CarNetwork& network, std::span<const ObjectInfo* const> wanted,
                   const CommandSettings& settings)
    : network_(network), settings_(settings) {
  check_invariant(wanted.size() <= objects_max);
  network.node().attach(service_);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Hook& hook = hooks_[i];
    hook.first = hook.last = wanted[i]->index;
    hook.before_write = callback<&Commands::check>(*this);
    hook.after_write = callback<&Commands::written>(*this);
    network.node().dictionary().attach(hook);
  }
}

bool Commands::lacks(const FieldPlace& place) const {
  return std::ranges::find(settings_.lacking, place) != settings_.lacking.end();
}

void Commands::reset(ResetScope) {
  for (const FieldPlace& place : settings_.lacking) {
    const auto code = code_meaning(place, Meaning::not_implemented);
    if (code) write_field(network_.node().dictionary(), place, *code);
  }
}

AbortCode Commands::check(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.row->is_text()) return AbortCode::none;
  const std::uint64_t whole = load_unsigned(value);
  AbortCode answer = AbortCode::none;
  each_field(entry.index, entry.sub, [&](const FieldPlace& place, const ValueInfo& info) {
    const std::uint32_t code = code_in(whole, place);
    if (answer != AbortCode::none) return;
    // The value read of a missing function may be written back: backups do so.
    if (lacks(place) && code == code_meaning(place, Meaning::not_implemented)) return;
    if (!can_be_written(info, code)) {
      answer = AbortCode::value_range;
    } else if (settings_.refuses && !is_left_alone(info, code)) {
      answer = settings_.refuses(Commanded{place, code, network_.client()});
    }
  });
  return answer;
}

void Commands::written(const Entry& entry, Source) {
  const std::uint64_t whole = entry.row->is_text() ? 0 : load_unsigned(entry.bytes());
  each_field(entry.index, entry.sub, [&](const FieldPlace& place, const ValueInfo& info) {
    const std::uint32_t code = code_in(whole, place);
    if (lacks(place)) {
      if (const auto none = code_meaning(place, Meaning::not_implemented)) {
        write_field(network_.node().dictionary(), place, *none);
      }
    } else if (settings_.commanded && !is_left_alone(info, code)) {
      settings_.commanded(Commanded{place, code, network_.client()});
    }
  });
}

}  // namespace canvoy::cia447
