// Inputs and outputs of the input and output module of an excavator: sensors, valves, the engine's
// throttle, and switched devices. Where a real module has its own valves, these follow the commands
// of the host.
//
//     ValvesHardware valves(machine, [&](Button button, bool is_on) { note(button, is_on); });
//     device(port, valves_id, valves.hardware());
//     valves.is_on(Switched::light);
#pragma once

#include <functional>

#include "canvoy/can/frame.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/sim/plants/excavator.hpp"
#include "canvoy/worlds/excavator/machine_wiring.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class ValvesHardware {
 public:
  /// Called when the device of a button was switched.
  using Switch = std::function<void(Button, bool is_on)>;

  /// `machine` must outlive this object. `switched` must not be empty.
  ValvesHardware(Excavator& machine, Switch switched)
      : machine_(machine), switched_(std::move(switched)) {}
  ValvesHardware(const ValvesHardware&) = delete;
  ValvesHardware& operator=(const ValvesHardware&) = delete;

  /// Hardware for the module; valid as long as this object.
  cia401::IoHardware hardware();
  /// Takes a frame on the bus of a real module.
  void follow(const Frame& frame);
  /// Closes the valves: call it when the module has no power.
  void release();

  unsigned outputs() const { return outputs_; }  ///< bits as in Switched
  /// True while the module drives this output.
  bool is_on(Switched output) const { return (outputs_ & bit_of(output)) != 0; }

 private:
  std::uint8_t sense_digital(unsigned) { return 0; }
  std::int32_t sense_analogue(unsigned channel);
  double value_of(Sensor sensor) const;
  void drive_digital(unsigned group, std::uint8_t outputs);
  void drive_analogue(unsigned channel, std::int32_t value);
  void switch_outputs(unsigned outputs);
  void set_valve(unsigned channel, double share);

  Excavator& machine_;
  Switch switched_;
  unsigned outputs_ = 0;
};

}  // namespace canvoy::excavator
