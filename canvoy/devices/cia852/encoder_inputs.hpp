// The encoders of an operator environment: 6120h:81h to 88h (CiA 852, 9.4), inputs of 32 bits that
// no narrower object has.
//
//     EncoderInputs encoders(node, memory, sense);
//     encoders.look();    // when one may have turned
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"

namespace canvoy::cia852 {

class EncoderInputs {
 public:
  using Sense = Callback<std::uint32_t(unsigned encoder)>;

  /// What is known of one beside the dictionary.
  struct State {
    std::uint32_t position = 0;  ///< at the last look
  };

  /// All must outlive this. `states`: one for each encoder, from 1 on.
  EncoderInputs(Node& node, std::span<State> states, Sense sense)
      : node_(node), states_(states), sense_(sense) {}
  EncoderInputs(const EncoderInputs&) = delete;
  EncoderInputs& operator=(const EncoderInputs&) = delete;

  /// Takes the positions as they are, without an event: after a reset.
  void begin();
  /// Each change is an event, but where those of digital inputs are switched off (6005h), and but
  /// for bits that the masks leave out (6126h to 6128h).
  void look();
  /// Without an event: when the polarity was written (6122h).
  void show();

 private:
  void store(std::size_t place, bool may_tell);

  Node& node_;
  std::span<State> states_;
  Sense sense_;
};

}  // namespace canvoy::cia852
