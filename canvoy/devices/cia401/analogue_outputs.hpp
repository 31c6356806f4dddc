// The analogue outputs of CiA 401: offset and scaling, and their reaction when the device fails
// (6410h to 6413h, 6441h to 6447h).
//
//     AnalogueOutputs outputs(node, 4, Callback<void(unsigned, std::int32_t)>::to<
//                                          &Board::output>(board));
//
// The text of CiA 401 is not at hand. Our reading: an output has the value last written, by any of
// its objects, and the others show it. Error values are in the units of that object, and the object
// shows them. Before the first write, it is the first existing object of 16 bits, 32 bits, 8 bits,
// floating-point.
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

struct AnalogueReals;

class AnalogueOutputs {
 public:
  /// Drives an output, by its sub-index, in the scale of its converter: full scale is that of 32
  /// bits; a narrower converter uses the upper bits.
  using Drive = Callback<void(unsigned channel, std::int32_t value)>;

  /// All arguments must outlive this. The outputs are the elements of 6411h, which may have gaps.
  /// `reals`: null without 6413h.
  AnalogueOutputs(Node& node, bool has_outputs, Drive drive, AnalogueReals* reals = nullptr)
      : node_(node), has_outputs_(has_outputs), drive_(drive), reals_(reals) {}
  AnalogueOutputs(const AnalogueOutputs&) = delete;
  AnalogueOutputs& operator=(const AnalogueOutputs&) = delete;

  /// Drives the values of the objects: after a reset. A reset of communication changes none of
  /// them.
  void begin(ResetScope scope);
  /// Drives an element of this object that the bus has written. Without effect for other objects.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Sets outputs with error mode 1 to their error value.
  void fail();

 private:
  friend struct AnalogueReals;

  template <class Each>
  void for_each_channel(Each each);
  void fail(std::uint8_t channel);
  void drive(std::uint16_t index, unsigned channel);
  void show(std::uint16_t but, unsigned channel, std::int32_t value);
  std::uint16_t index_of(unsigned channel) const;

  Node& node_;
  bool has_outputs_;
  Drive drive_;
  AnalogueReals* reals_;
};

}  // namespace canvoy::cia401
