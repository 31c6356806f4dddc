// Texts of values that come again and again: most of what is on a bus was there before.
//
//     ValueWords values;
//     values.append(line, entry, bytes);  // "20.000 °C"
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/words/value_text.hpp"

namespace canvoy::words {

/// As append_value_text(), or another, writes them. Those of entries with fields take their time:
/// the latest of each hash is kept, but where the entry lives no longer than what a decoder knows
/// of its bus.
class ValueWords {
 public:
  using Append = void (*)(std::string& text, const EntryInfo* entry,
                          std::span<const std::uint8_t> bytes);
  ValueWords() : ValueWords(append_value_text) {}
  explicit ValueWords(Append how) : append_(how) {}

  void append(std::string& text, const EntryInfo* entry, std::span<const std::uint8_t> bytes);
  void append(std::string& text, const decoder::DecodedValue& value);

 private:
  static constexpr std::size_t count = 4096;
  struct Known {
    const EntryInfo* entry = nullptr;
    std::uint64_t raw = 0;
    std::size_t size = 0;
    std::string text;
  };
  Append append_;
  std::vector<Known> known_{count};
};

}  // namespace canvoy::words
