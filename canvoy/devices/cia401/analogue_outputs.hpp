// The analogue outputs of CiA 401: offset and scaling, and what they do when the device fails
// (6410h to 6413h, 6441h to 6447h).
//
//     AnalogueOutputs outputs(node, 4, Callback<void(unsigned, std::int32_t)>::to<
//                                          &Board::output>(board));
//
// The text of CiA 401 is not at hand. Our reading: an output is what was written last, by whichever
// of its objects; error values are in the units of that object, and the object says them. Where
// nothing was written yet it is that of 16 bits, 32, 8, floating-point: the first that is there.
#pragma once

#include <cstdint>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

struct AnalogueReals;

class AnalogueOutputs {
 public:
  /// An output, by its sub-index, for its converter: full scale is that of 32 bits, for a narrower
  /// one the upper bits.
  using Drive = Callback<void(unsigned channel, std::int32_t value)>;

  /// All must outlive this. The outputs are the elements of 6411h, which may have gaps. `reals`:
  /// null where there is no 6413h.
  AnalogueOutputs(Node& node, bool has_outputs, Drive drive, AnalogueReals* reals = nullptr)
      : node_(node), has_outputs_(has_outputs), drive_(drive), reals_(reals) {}
  AnalogueOutputs(const AnalogueOutputs&) = delete;
  AnalogueOutputs& operator=(const AnalogueOutputs&) = delete;

  /// Drives what the objects say: after a reset. One of communication changes none of them.
  void begin(ResetScope scope);
  /// An element of this object was written by the bus; of one that is no output's, nothing happens.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Outputs with error mode 1 take their error value.
  void fail();

 private:
  friend struct AnalogueReals;

  template <class Each>
  void for_each_channel(Each each);
  void fail(std::uint8_t channel);
  void drive(std::uint16_t index, unsigned channel);
  std::uint16_t index_of(unsigned channel) const;

  Node& node_;
  bool has_outputs_;
  Drive drive_;
  AnalogueReals* reals_;
};

}  // namespace canvoy::cia401
