#include "canvoy/text/value_words.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::text {

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
  const bool is_kept =
      entry != nullptr && !entry->fields.empty() && bytes.size() <= sizeof(std::uint64_t);
  if (!is_kept) return append_(text, entry, bytes);
  const std::uint64_t raw = load_unsigned(bytes);
  Known& known = known_[hash_of(entry, raw) % count];
  if (known.entry != entry || known.raw != raw || known.size != bytes.size()) {
    known.entry = entry;
    known.raw = raw;
    known.size = bytes.size();
    known.text.clear();
    append_(known.text, entry, bytes);
  }
  text += known.text;
}

void ValueWords::append(std::string& text, const decoder::DecodedValue& value) {
  if (value.is_told) return append_(text, value.entry, value.bytes());
  append(text, value.entry, value.bytes());
}

}  // namespace canvoy::text
