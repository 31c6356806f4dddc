// What the input and output module of an excavator senses and drives: sensors, valves and the
// engine's throttle, and what is switched. Where a real module has its own valves, these follow
// what the host tells it.
//
//     ValvesHardware valves(machine, [&](Button button, bool is_on) { note(button, is_on); });
//     device(port, valves_id, valves.hardware());
//     valves.is_on(Switched::light);
#pragma once

#include <functional>

#include "canvoy/can/frame.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/sim/excavator/machine_wiring.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"
#include "canvoy/sim/plants/excavator.hpp"

namespace canvoy::excavator {

class ValvesHardware {
 public:
  /// What a button is for was switched.
  using Switch = std::function<void(Button, bool is_on)>;

  /// `machine` must outlive this. `switched` has to be there.
  ValvesHardware(Excavator& machine, Switch switched)
      : machine_(machine), switched_(std::move(switched)) {}
  ValvesHardware(const ValvesHardware&) = delete;
  ValvesHardware& operator=(const ValvesHardware&) = delete;

  /// For the module; valid as long as this.
  cia401::IoHardware hardware();
  /// A frame on the bus of a real module.
  void follow(const Frame& frame);
  /// The module has no power: its valves close.
  void release();

  unsigned outputs() const { return outputs_; }  ///< as Switched has them
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
