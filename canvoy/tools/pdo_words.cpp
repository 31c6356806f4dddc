#include "canvoy/tools/pdo_words.hpp"

#include "canvoy/canopen/little_endian.hpp"
#include "canvoy/tools/object_words.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

std::size_t hash_of(const EntryInfo* entry, std::uint64_t raw) {
  constexpr std::uint64_t golden_ratio = 0x9E37'79B9'7F4A'7C15;
  constexpr unsigned kept_bits = 32;
  const auto place = reinterpret_cast<std::uintptr_t>(entry) / alignof(EntryInfo);
  return static_cast<std::size_t>((raw ^ place * golden_ratio) * golden_ratio >> kept_bits);
}

}  // namespace

void ValueWords::append(std::string& text, const EntryInfo* entry,
                        std::span<const std::uint8_t> bytes) {
  const bool is_soon_said = entry == nullptr || entry->fields.empty();
  if (is_soon_said) return append_value_text(text, entry, bytes);
  const std::uint64_t raw = load_unsigned(bytes);
  Known& known = known_[hash_of(entry, raw) % count];
  if (known.entry != entry || known.raw != raw || known.size != bytes.size()) {
    known.entry = entry;
    known.raw = raw;
    known.size = bytes.size();
    known.text.clear();
    append_value_text(known.text, entry, bytes);
  }
  text += known.text;
}

PdoWords::Words PdoWords::words(std::uint32_t can_id, const decoder::Decoded& decoded,
                                std::uint32_t generation) {
  Pdo& pdo = pdos_[can_id];
  const bool is_new = pdo.generation != generation;
  if (is_new) {
    name(pdo, *decoded.pdo);
    pdo.generation = generation;
  }
  const bool has_changed = take_values(pdo, decoded.values);
  if (!is_new && !has_changed && pdo.count == decoded.values.size()) {
    return {pdo.service, pdo.text};
  }
  pdo.count = decoded.values.size();
  pdo.text = pdo.start;
  for (std::size_t i = 0; i < pdo.count; ++i) {
    if (i != 0) pdo.text += "; ";
    pdo.text += pdo.values[i].name;
    pdo.text += pdo.values[i].text;
  }
  return {pdo.service, pdo.text};
}

void PdoWords::name(Pdo& pdo, const decoder::PdoPlan& plan) {
  const char* direction = plan.direction == PdoInfo::Direction::transmit ? "TPDO" : "RPDO";
  pdo.service = plan.number == 0 ? "PDO" : direction + std::to_string(plan.number);
  pdo.start = plan.name.empty() ? "" : std::string(plan.name) + ": ";
  pdo.values.clear();
}

/// Whether one of them has changed.
bool PdoWords::take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values) {
  bool has_changed = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == pdo.values.size()) pdo.values.push_back({0, object_name_text(values[i]) + " = ", {}});
    Value& known = pdo.values[i];
    // A multiplexed PDO brings another object each time.
    const bool is_other = values[i].version == 0;
    if (is_other) known.name = object_name_text(values[i]) + " = ";
    if (known.version == values[i].version && !is_other) continue;
    known.version = values[i].version;
    known.text.clear();
    values_.append(known.text, values[i].entry, values[i].bytes());
    has_changed = true;
  }
  return has_changed;
}

}  // namespace canvoy::tools
