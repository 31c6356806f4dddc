// An operator environment interface module (CiA 852): joysticks, foot pedals, encoders, wheels,
// push-buttons, indicators and displays as inputs and outputs of CiA 401, for the objects in the
// dictionary.
//
//     OperatorUnit seat(node, memory, {.joystick_axis = ..., .show_indicators = ...}, {});
//     seat.hardware_changed();    // something was moved or pressed, which is then told at once
//
// All PDOs are sent when the node becomes operational (12.1), and emergency 0080h then reports that
// analogue inputs cause no events, until 6423h allows it (8.6). Indicators and displays take their
// error values like outputs of CiA 401 (cia401/io_unit.hpp).
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/cia852/operator_hardware.hpp"

namespace canvoy::cia852 {

/// The encoders of an operator environment: 6120h:81h to 88h (CiA 852, 9.4), inputs of 32 bits
/// without a narrower object.
///
///     EncoderInputs encoders(node, memory, sense);
///     encoders.look();    // when one may have turned
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

/// Settings of a module that no object of its dictionary has.
struct OperatorSettings {
  /// Period of readings; zero: read when the hardware reports a change. A shorter press may be
  /// missed.
  Duration sensing_period = std::chrono::milliseconds(2);
  cia401::DigitalInputSettings digital = {};    ///< filter
  cia401::AnalogueInputSettings analogue = {};  ///< unit of limits
};

/// Memory of a unit, as much as its dictionary needs.
struct OperatorMemory {
  cia401::IoMemory io;                       ///< inputs and outputs of CiA 401
  std::span<EncoderInputs::State> encoders;  ///< one for each encoder
};

class OperatorUnit {
 public:
  /// Everything to which `hardware` and `memory` refer must outlive this.
  OperatorUnit(Node& node, const OperatorMemory& memory, const OperatorHardware& hardware,
               const OperatorSettings& settings);

  /// Reads all inputs at the next call of the node.
  void hardware_changed();
  /// Sets indicators and displays to their error values: the module has failed.
  void fail() { io_.fail(); }

 private:
  cia401::IoHardware io_hardware();
  std::uint8_t digital_input(unsigned sub);
  std::int32_t analogue_input(unsigned sub);
  void show_indicators(unsigned sub, std::uint8_t lit);
  void show_parameter(unsigned sub, std::int32_t value);
  void polarity_written() { encoders_.show(); }
  void reset(ResetScope scope);
  void expired(Time now);
  void arm_from(Time now);

  Node& node_;
  OperatorHardware hardware_;
  Duration sensing_period_;
  cia401::IoUnit io_;
  EncoderInputs encoders_;
  bool has_encoders_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};  ///< of encoders
  Timer timer_;
};

}  // namespace canvoy::cia852
