// Caches texts of values: most values on a bus repeat.
//
//     ValueWords values;
//     values.append(line, entry, bytes);  // "20.000 °C"
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::text {

/// Texts as written by append_value_text() or another function. Those of entries with fields are
/// expensive: the last one of each hash is cached, unless the entry lives only as long as the
/// knowledge of a decoder about its bus.
class ValueWords {
 public:
  /// Function that writes a value at the end of a text.
  using Append = void (*)(std::string& text, const EntryInfo* entry,
                          std::span<const std::uint8_t> bytes);
  ValueWords() : ValueWords(append_value_text) {}
  /// Caches the texts of another function.
  explicit ValueWords(Append how) : append_(how) {}

  /// Appends a value of an entry; null: unknown.
  void append(std::string& text, const EntryInfo* entry, std::span<const std::uint8_t> bytes);
  /// Appends the value of a decoded frame.
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

}  // namespace canvoy::text
