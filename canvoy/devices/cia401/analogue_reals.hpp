// The floating-point half of analogue inputs and outputs of CiA 401 (6403h, 6413h and related
// objects): a table, so that a device without these objects does not link it.
//
//     AnalogueReals reals = AnalogueReals::calls;
//     AnalogueOutputs outputs(node, true, drive, &reals);
#pragma once

#include <bitset>

#include "canvoy/devices/cia401/analogue_inputs.hpp"
#include "canvoy/devices/cia401/analogue_outputs.hpp"

namespace canvoy::cia401 {

struct AnalogueReals {
  /// Returns true for an event.
  bool (*read)(AnalogueInputs& inputs, AnalogueInputState& state, bool may_tell);
  /// Drives an output with the value that 6413h has.
  void (*drive)(AnalogueOutputs& outputs, unsigned channel);
  /// Shows the value of an output that was written as an integer.
  void (*show)(AnalogueOutputs& outputs, unsigned channel, std::int32_t value);

  /// Outputs that were last written by 6413h.
  std::bitset<256> written_last = {};

  static const AnalogueReals calls;  ///< the functions, for devices with reals

 private:
  static bool read_real(AnalogueInputs& inputs, AnalogueInputState& state, bool may_tell);
  static void drive_real(AnalogueOutputs& outputs, unsigned channel);
  static void show_real(AnalogueOutputs& outputs, unsigned channel, std::int32_t value);
};

}  // namespace canvoy::cia401
