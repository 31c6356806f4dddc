// Text of PDOs. Most frames of a bus are PDOs, and most of their values repeat: texts of values are
// cached, for a rate of millions of frames per second.
//
//     PdoWords words(values);
//     words.text(frame.id, decoded, network.generation());  // "temperature = 20.000 °C; ..."
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/text/value_words.hpp"

namespace canvoy::text {

class PdoWords {
 public:
  /// `values` must outlive this; several buses may share it.
  explicit PdoWords(ValueWords& values) : values_(&values) {}

  /// Words for a PDO.
  struct Words {
    std::string_view service;  ///< `TPDO1`, or `PDO` if the number is unknown
    std::string_view text;     ///< its values, or why there are none
    /// Buffer for text that the caller makes of the text and the values; emptied when they change.
    std::string* kept = nullptr;
  };
  /// Returns the text, valid until the next PDO. `generation` is that of the network.
  Words words(std::uint32_t can_id, const decoder::Decoded& decoded, std::uint32_t generation);

 private:
  struct Value {
    std::uint64_t version = 0;  ///< DecodedValue::version of the text; 0: none
    std::string name;           ///< `temperature = `
    std::string text;           ///< `20.000 °C`
  };
  struct Pdo {
    std::uint32_t generation = 0;  ///< of the network, when the names were made; 0: never
    std::size_t count = 0;         ///< number of values in `text`
    std::string service;
    std::string start;  ///< `driver: ` if the message has a name
    std::string text;
    std::string kept;
    std::vector<Value> values;
  };

  static void name(Pdo& pdo, const decoder::PdoPlan& plan);
  bool take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values);

  decoder::ByCanId<Pdo> pdos_;
  ValueWords* values_;
};

}  // namespace canvoy::text
