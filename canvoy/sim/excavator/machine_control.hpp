// The host of an excavator: it sets up and starts the seat and the input and output module, watches
// their heartbeats, turns sticks into valves, presses into switches, and tells lamps and display
// what the machine does. Without a valid and fresh command a valve is closed.
//
//     MachineHost host(world.port(slot), {});
//     world.occupy(slot, host.node());
//
// A command is valid where the seat is operational, its sticks are told again and again, the wire
// is whole, the contact of the direction agrees with the sensor, and the stick was let go once
// since something was wrong; and where the armrest behind the seat answers, with its lever down.
#pragma once

#include <array>
#include <memory>

#include "canvoy/canopen/nmt/nmt_master.hpp"
#include "canvoy/devices/gap_watch.hpp"
#include "canvoy/sim/excavator/armrest_watch.hpp"
#include "canvoy/sim/excavator/host_objects.hpp"
#include "canvoy/sim/excavator/machine_setup.hpp"
#include "canvoy/sim/excavator/node_setup.hpp"
#include "canvoy/sim/excavator/seat_panel.hpp"

namespace canvoy::excavator {

class MachineControl {
 public:
  MachineControl(HostNode& device, const HostSettings& settings);
  MachineControl(const MachineControl&) = delete;
  MachineControl& operator=(const MachineControl&) = delete;

  /// For referees: what has reached it.
  std::int16_t axis_value(Stick stick) const;

 private:
  /// The seat, or the module.
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
  /// What moves the machine: sticks, pedals, and the wheel of the rotator.
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
  void tell_anew(const Partner& partner);
  void armrest_changed();
  /// The safety lever is down.
  bool is_released() const {
    if (!settings_.has_armrest) return true;
    return settings_.checks_armrest ? armrest_.is_lowered() : armrest_.was_lowered();
  }

  void drive();
  double command_of(Movement movement);
  double command_of_stick(Stick stick, bool& is_armed);
  double command_of_value(std::int16_t value, bool is_fresh, bool& is_armed) const;
  bool is_plausible(Stick stick, std::int16_t value) const;
  bool is_fresh(Input input) const { return is_fresh_[static_cast<std::size_t>(input)]; }
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
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer look_timer_;
  Timer horn_timer_;
  GapWatch gaps_;

  std::array<bool, host_inputs + 1> is_fresh_{};
  std::array<bool, commands> is_armed_{};   ///< was let go since something was wrong
  std::array<bool, stick_count> is_odd_{};  ///< wire or contact of a stick
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
  MachineHost(const Port& port, const HostSettings& settings)
      : values_(host_configuration(settings.seat_time_out)),
        device_(port, host_id, true),
        configuration_(device_.node(), values_),
        control_(device_, settings) {}

  Node& node() { return device_.node(); }
  const MachineControl& control() const { return control_; }

 private:
  std::vector<NodeValue> values_;
  HostNode device_;
  NodeConfiguration configuration_;
  MachineControl control_;
};

}  // namespace canvoy::excavator
