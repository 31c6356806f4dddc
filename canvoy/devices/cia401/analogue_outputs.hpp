// The analogue outputs of CiA 401: offset and scaling, and what they do when the device fails
// (6410h to 6413h, 6441h to 6447h).
//
//     AnalogueOutputs outputs(node, 4, Callback<void(unsigned, std::int32_t)>::to<
//                                          &Board::output>(board));
//
// The text of CiA 401 is not at hand. Our reading: an output is what was written last, by whichever
// of its objects; error values are in the units of that object, and the object says them.
#pragma once

#include <cstdint>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia401_handles.hpp"

namespace canvoy::cia401 {

class AnalogueOutputs {
 public:
  /// An output from 1 on, for its converter: full scale is that of 32 bits, for a narrower one the
  /// upper bits.
  using Drive = Callback<void(unsigned channel, std::int32_t value)>;

  /// All must outlive this.
  AnalogueOutputs(Node& node, unsigned count, Drive drive)
      : node_(node), count_(count), drive_(drive) {}
  AnalogueOutputs(const AnalogueOutputs&) = delete;
  AnalogueOutputs& operator=(const AnalogueOutputs&) = delete;

  /// Drives what the objects say: after a reset.
  void begin();
  /// An element of this object was written by the bus; of one that is no output's, nothing happens.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Outputs with error mode 1 take their error value.
  void fail();

 private:
  void drive(std::uint16_t index, unsigned channel);
  std::uint16_t first_index(unsigned channel) const;

  Node& node_;
  unsigned count_;
  Drive drive_;
};

}  // namespace canvoy::cia401
