// The floating-point half of analogue inputs and outputs of CiA 401 (6403h, 6413h and what belongs
// to them): a table, so that nothing of it is linked where a device has none of these objects.
//
//     AnalogueReals reals = AnalogueReals::calls;
//     AnalogueOutputs outputs(node, true, drive, &reals);
#pragma once

#include <bitset>

#include "canvoy/devices/cia401/analogue_inputs.hpp"
#include "canvoy/devices/cia401/analogue_outputs.hpp"

namespace canvoy::cia401 {

struct AnalogueReals {
  /// True where it was an event.
  bool (*read)(AnalogueInputs& inputs, AnalogueInputState& state, bool may_tell);
  void (*drive)(AnalogueOutputs& outputs, unsigned channel);

  /// Outputs that were written last by 6413h.
  std::bitset<256> written_last = {};

  static const AnalogueReals calls;

 private:
  static bool read_real(AnalogueInputs& inputs, AnalogueInputState& state, bool may_tell);
  static void drive_real(AnalogueOutputs& outputs, unsigned channel);
};

}  // namespace canvoy::cia401
