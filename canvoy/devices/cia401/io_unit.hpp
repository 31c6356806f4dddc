// An input and output module of CiA 401: digital and analogue inputs and outputs, for the objects
// in the dictionary.
//
//     IoUnit io(node, memory, {.digital_inputs = ..., .drive_digital = ...}, {});
//     io.hardware_changed();    // an input has changed, which is then told at once
//
// In NMT state stopped, at bus-off, on the loss of a monitored heartbeat (the communication errors
// of 1029h), and on a failure of the device itself, outputs take their error values. While analogue
// inputs cause no events (6423h), emergency 0080h reports this, from NMT state operational on.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/devices/cia401/analogue_inputs.hpp"
#include "canvoy/devices/cia401/analogue_outputs.hpp"
#include "canvoy/devices/cia401/digital_inputs.hpp"
#include "canvoy/devices/cia401/digital_outputs.hpp"

namespace canvoy::cia401 {

/// A callback may be omitted if the dictionary has no objects for it.
struct IoHardware {
  DigitalInputs::Sense digital_inputs = {};    ///< of 6000h
  DigitalOutputs::Drive drive_digital = {};    ///< of 6200h
  AnalogueInputs::Sense analogue_input = {};   ///< of 6401h
  AnalogueOutputs::Drive drive_analogue = {};  ///< of 6411h
};

/// Settings of a module that no object of its dictionary has.
struct IoSettings {
  /// Period of checks of the inputs; zero: checked when the hardware reports a change.
  Duration sensing_period = std::chrono::milliseconds(10);
  DigitalInputSettings digital = {};    ///< filter
  AnalogueInputSettings analogue = {};  ///< unit of limits
  /// Sends emergency 0080h. It is uncertain for modules that follow CiA 401 alone.
  bool warns_of_disabled_inputs = true;
};

/// Memory of a unit, as much as its dictionary needs.
struct IoMemory {
  std::span<DigitalInputGroup> digital_inputs;    ///< one for each element of 6000h
  std::span<std::uint8_t> digital_outputs;        ///< of 6200h
  std::span<AnalogueInputState> analogue_inputs;  ///< of 6401h
  bool has_analogue_outputs = false;              ///< 6411h
  AnalogueReals* reals = nullptr;  ///< with 6403h or 6413h: a copy of AnalogueReals::calls
};

class IoUnit {
 public:
  /// Everything to which `hardware` and `memory` refer must outlive this.
  IoUnit(Node& node, const IoMemory& memory, const IoHardware& hardware,
         const IoSettings& settings);
  IoUnit(const IoUnit&) = delete;
  IoUnit& operator=(const IoUnit&) = delete;

  /// Checks the inputs at the next call of the node.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }
  /// Sets outputs to their error values: the device has failed.
  void fail();

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void bus_state_changed(BusState state);
  void error_changed(const Error& error, bool present);
  void source_is_read(const Entry& entry);
  AbortCode check_error_mode(const Entry& entry, std::span<const std::uint8_t> value);
  void analogue_parameter_written(const Entry& entry);
  void written(const Entry& entry, Source source);
  void expired(Time now);
  void warn(bool is_operational);

  Node& node_;
  IoSettings settings_;
  bool has_analogue_inputs_;
  DigitalInputs digital_inputs_;
  DigitalOutputs digital_outputs_;
  AnalogueInputs analogue_inputs_;
  AnalogueOutputs analogue_outputs_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia401
