// The host of an excavator: it sets up and starts the seat and the input and output module, watches
// their heartbeats, turns sticks into valve commands and presses into switching, and has lamps and
// display show what the machine does. Without a valid and fresh command, a valve is closed.
//
//     MachineHost host(world.port(slot), {});
//     world.occupy(slot, host.node());
//
// A command is valid where the seat is operational, its sticks are received in time, the wire is
// whole, the contact of the direction agrees with the sensor, and the stick was released once after
// the last error; and where the armrest behind the seat answers, with all contacts closed. Of two
// seats, one has the command: the other one gets it by a button on its left joystick, while all
// sticks and pedals are at rest.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/kit/gap_watch.hpp"
#include "canvoy/worlds/excavator/armrest_watch.hpp"
#include "canvoy/worlds/excavator/host_objects.hpp"
#include "canvoy/worlds/excavator/machine_setup.hpp"
#include "canvoy/worlds/excavator/node_setup.hpp"
#include "canvoy/worlds/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class MachineControl {
 public:
  /// Both must outlive this object; it acts once the node runs.
  MachineControl(HostNode& device, const HostSettings& settings);
  MachineControl(const MachineControl&) = delete;
  MachineControl& operator=(const MachineControl&) = delete;

  /// Received value of an axis, for referees.
  std::int16_t axis_value(Stick stick) const { return axis_value(0, stick); }

 private:
  /// One of the seat and the module.
  struct Partner {
    NodeSetup setup;
    NodeId id = 0;
    bool is_ready = false;
    bool was_ready = false;
    Timer start_timer;

    Partner(Node& node, NodeId of, std::vector<SetupWrite> writes, Callback<void(Time)> start)
        : setup(node, of, std::move(writes)), id(of), start_timer(start) {}
    bool is_in_setup() const { return setup.busy() || start_timer.armed(); }
  };
  /// Number of commands that move the machine: sticks, pedals, and the wheel of the rotator.
  static constexpr std::size_t commands = movements;

  Node& node() { return device_.node(); }
  Dictionary& dictionary() { return device_.dictionary(); }
  std::int16_t integer(std::uint16_t index, unsigned sub) const;
  double sensor(Sensor which) const;
  void reset(ResetScope scope);
  void look(Time now);
  void end_horn(Time now);
  Partner& partner(NodeId id) { return id == seat_id ? seat_ : valves_; }
  void changed(NodeId id, RemoteState state);
  void set_up(NodeId id, bool is_done);
  void start_seat(Time now);
  void start_valves(Time now);
  void start(Partner& partner);
  void forget(Partner& partner);
  void begin(Partner& partner);
  void received(std::uint16_t number);
  void timed_out(std::uint16_t number);
  void ask_anew(NodeId partner);
  void report_anew(const Partner& partner);
  void armrest_changed();
  /// True if safety lever, seat switch and emergency stop let the machine move.
  bool is_released() const {
    if (!settings_.has_armrest) return true;
    return settings_.checks_armrest ? armrest_.is_released() : armrest_.was_released();
  }

  void drive();
  double command_of(Movement movement);
  double command_of_stick(Stick stick, bool& is_armed);
  double command_of_seat(std::size_t seat, Stick stick, bool& is_armed);
  std::int16_t axis_value(std::size_t seat, Stick stick) const;
  bool has_good_axis(std::size_t seat, Stick stick) const;
  bool is_fresh_stick(std::size_t seat, Stick stick) const;
  bool all_are_at_rest() const;
  void look_for_command();
  std::size_t seats() const { return settings_.has_trainer ? seats_max : 1; }
  double command_of_value(std::int16_t value, bool is_fresh, bool& is_armed) const;
  bool is_plausible(std::size_t seat, Stick stick, std::int16_t value) const;
  bool is_fresh(Input input) const { return is_fresh_[static_cast<std::size_t>(input)]; }
  /// Pedals and wheels are at the operator's seat alone.
  bool has_own(Input input) const { return is_fresh(input) && command_ == 0; }
  void press();
  void pressed(Button button);
  void tell();
  void show();

  HostNode& device_;
  HostSettings settings_;
  std::unique_ptr<std::array<NmtMaster::RemoteNode, node_id_max>> remotes_;
  NmtMaster master_;
  Partner seat_;
  Partner valves_;
  ArmrestWatch armrest_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer look_timer_;
  Timer horn_timer_;
  GapWatch gaps_;

  std::array<bool, host_inputs + 1> is_fresh_{};
  std::array<bool, commands> is_armed_{};              ///< released since the last error
  std::size_t command_ = 0;                            ///< seat that has it; 0: the operator's
  std::array<std::optional<bool>, seats_max> asks_{};  ///< its button is held
  std::uint32_t pressed_ = 0;
  bool knows_buttons_ = false;
  bool has_horn_ = false;
  bool has_light_ = false;
  bool has_beacon_ = false;
  bool is_fast_ = false;
  bool is_unlocked_ = false;
};

/// The whole device.
class MachineHost {
 public:
  /// Makes the node at the port.
  MachineHost(const Port& port, const HostSettings& settings)
      : values_(host_configuration(settings.seat_time_out, settings.has_trainer)),
        device_(port, host_id, true),
        configuration_(device_.node(), values_),
        control_(device_, settings) {}

  /// The node of the host.
  Node& node() { return device_.node(); }
  /// What it does with the machine.
  const MachineControl& control() const { return control_; }

 private:
  std::vector<NodeValue> values_;
  HostNode device_;
  NodeConfiguration configuration_;
  MachineControl control_;
};

}  // namespace canvoy::excavator
