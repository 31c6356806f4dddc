// A frame with what it means as a JSON object, millions of them a second: docs/decode.md says what
// is in it.
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
#include "canvoy/words/frame_decoder.hpp"
#include "canvoy/words/value_words.hpp"

namespace canvoy::words {

class FrameJson {
 public:
  /// `time` counts from 1970; `text` stands for that of the words.
  void append(std::string& line, Duration time, std::string_view bus, std::string_view frame,
              const FrameWords& words, std::string_view text);
  /// A list with an object a value: object, sub, name, raw, value, unit, marks.
  void append_values(std::string& line, std::span<const decoder::DecodedValue> values);

 private:
  /// The latest of each hash: to look for a name takes longer than to write it.
  static constexpr std::size_t names_max = 1024;
  struct Name {
    const Profile* profile = nullptr;
    const ObjectInfo* object = nullptr;
    bool has_entry = false;
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::string text;  ///< `"object":"6010","sub":"00","name":"temperature"`; empty: nothing yet
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

}  // namespace canvoy::words
