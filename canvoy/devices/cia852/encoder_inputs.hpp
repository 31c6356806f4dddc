// The encoders of an operator environment: 6120h:81h to 88h (CiA 852, 9.4), inputs of 32 bits
// without a narrower object.
//
//     EncoderInputs encoders(node, memory, sense);
//     encoders.look();    // when one may have turned
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy::cia852 {

class EncoderInputs {
 public:
  /// Returns the position of an encoder, counted from 1; it wraps at 2^32.
  using Sense = Callback<std::uint32_t(unsigned encoder)>;

  /// State of one encoder beside the dictionary.
  struct State {
    std::uint32_t position = 0;  ///< at the last check
  };

  /// All arguments must outlive this. `states`: one for each encoder, from 1 on.
  EncoderInputs(Node& node, std::span<State> states, Sense sense)
      : node_(node), states_(states), sense_(sense) {}
  EncoderInputs(const EncoderInputs&) = delete;
  EncoderInputs& operator=(const EncoderInputs&) = delete;

  /// Reads the positions without an event: after a reset.
  void begin();
  /// Reads the positions. Each change is an event, unless events of digital inputs are switched off
  /// (6005h), or the masks exclude the bits (6126h to 6128h).
  void look();
  /// Shows the positions without an event, after a write of the polarity (6122h).
  void show();

 private:
  void store(std::size_t place, bool may_tell);

  Node& node_;
  std::span<State> states_;
  Sense sense_;
};

}  // namespace canvoy::cia852
