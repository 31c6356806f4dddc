// The words of PDOs. Most frames of a bus are PDOs, and most of what is in them was there before:
// what was said of a value once is kept, so that millions of frames a second can be told.
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
#include "canvoy/words/value_words.hpp"

namespace canvoy::words {

class PdoWords {
 public:
  /// `values` has to outlive it, and may be that of several buses.
  explicit PdoWords(ValueWords& values) : values_(&values) {}

  struct Words {
    std::string_view service;  ///< `TPDO1`, or `PDO` where the number is not known
    std::string_view text;
    /// What a caller makes of it and its values; emptied when they change.
    std::string* kept = nullptr;
  };
  /// Until the next PDO. `generation` is that of the network.
  Words words(std::uint32_t can_id, const decoder::Decoded& decoded, std::uint32_t generation);

 private:
  struct Value {
    std::uint64_t version = 0;  ///< DecodedValue::version of what was said; 0: nothing yet
    std::string name;           ///< `temperature = `
    std::string text;           ///< `20.000 °C`
  };
  struct Pdo {
    std::uint32_t generation = 0;  ///< of the network, when the names were made; 0: never
    std::size_t count = 0;         ///< of the values in `text`
    std::string service;
    std::string start;  ///< `driver: ` where the message has a name
    std::string text;
    std::string kept;
    std::vector<Value> values;
  };

  static void name(Pdo& pdo, const decoder::PdoPlan& plan);
  bool take_values(Pdo& pdo, std::span<const decoder::DecodedValue> values);

  decoder::ByCanId<Pdo> pdos_;
  ValueWords* values_;
};

}  // namespace canvoy::words
