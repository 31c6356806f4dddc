// Writes a frame with its meaning as a JSON object, at a rate of millions per second.
// docs/decode.md describes the members.
//
//     FrameJson json;
//     json.append(line, time, "can0", "18A#A00001", words, words.text);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/value_words.hpp"

namespace canvoy::text {

class FrameJson {
 public:
  /// Appends a frame. `time` counts from 1970; `text` replaces that of the words.
  void append(std::string& line, Duration time, std::string_view bus, std::string_view frame,
              const FrameWords& words, std::string_view text);
  /// Appends a list with one object for each value: object, sub, name, raw, value, unit, marks.
  void append_values(std::string& line, std::span<const decoder::DecodedValue> values);

 private:
  /// Size of the cache by hash: a lookup of a name takes longer than writing it.
  static constexpr std::size_t names_max = 1024;
  struct Name {
    const Profile* profile = nullptr;
    const ObjectInfo* object = nullptr;
    bool has_entry = false;
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::string text;  ///< `"object":"6010","sub":"00","name":"temperature"`; empty: unused
  };

  void append_said(std::string& line, const FrameWords& words, std::string_view text);
  void append_value(std::string& line, const decoder::DecodedValue& value);
  const std::string& name_of(const decoder::DecodedValue& value);
  const std::string& named_bus(std::string_view bus);

  std::vector<Name> names_{names_max};
  ValueWords values_{append_value_json};
  std::string bus_;
  std::string bus_text_;  ///< `,"bus":"can0","frame":"`
};

}  // namespace canvoy::text
