// A car door unit: one door of a car, which follows its controlword (6300h), sends its statusword
// and position (6301h, 6302h), and acts by itself according to its configuration (6304h to 6307h;
// CiA 417-4, 4.6.1 and 4.7).
//
//     CarDoorUnit door(node, hardware, {.door = 2});
//     node.start(now);
//
// A device that moves several doors has one unit for each. If the dictionary also has 6310h, its
// value is the light barrier of the door: an RPDO receives it from the light barrier unit.
//
// Decisions where the clause is open (docs/decisions.md, "Doors of lifts"): a command takes effect
// when it differs from the one before, or comes by SDO; an enabled lock locks when the door is
// closed, and unlocks when the door has to open; at reduced speed, the light barrier does not
// reverse the door.
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/door/car_door_hardware.hpp"
#include "canvoy/devices/cia417/kit/door_words.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

/// Settings of a door that no object of its dictionary has.
struct CarDoorSettings {
  unsigned lift = 1;  ///< 1 to 8
  unsigned door = 1;  ///< 1 to 4
  /// The node-ID of the car door controller: 6304h:0Bh applies when its heartbeat is lost. This
  /// takes an entry in 1016h.
  NodeId controller = 1;
  /// The node-ID of the light barrier unit, if 6310h is consumed; 0: not monitored. While its
  /// heartbeat is lost, the light barrier counts as broken.
  NodeId light_barrier = 0;
  bool holds_closed = true;            ///< with torque, at the closed end
  bool holds_open = true;              ///< with torque, at the open end
  std::uint8_t velocity_profiles = 1;  ///< 6304h:01h accepts lower numbers
  std::uint8_t width_profiles = 1;     ///< 6304h:02h accepts lower numbers
  /// Period of readings of a hardware without next_change.
  Duration sensing_period = 50ms;
  /// Period of messages while the position changes.
  Duration position_period = 100ms;
  /// A door that is driven for this time without moving, with unlimited force, is stuck.
  Duration stall_time = 2s;
  /// A lock that takes longer to open is stuck.
  Duration lock_time = 1s;
};

class CarDoorUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  CarDoorUnit(Node& node, const DoorHardware& hardware, const CarDoorSettings& settings);

  /// Reads the hardware at the next call of the node, after a change.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }

  /// State of the door, as the statusword has it.
  DoorState state() const { return report_.state; }
  /// Contents of the statusword.
  const DoorReport& report() const { return report_; }
  /// Command to the drive at present.
  const DoorDrive& driven() const { return driven_; }

 private:
  enum class Goal : std::uint8_t { stay, close, open };
  /// Reason for a movement other than the commanded one.
  enum class Cause : std::uint8_t { none, barrier, force, motion, finger };

  // Events of the bus.
  void reset(ResetScope scope);
  void error_changed(const Error& error, bool present);
  void order_received(const Entry& entry, Source source);
  AbortCode check_setting(const Entry& entry, std::span<const std::uint8_t> value);
  void barrier_received(const Entry& entry);

  // Commands.
  void obey(const DoorOrder& order, bool always);
  void obey_command(DoorCommand command);
  void go(Goal goal, bool limits_force);
  void stop(bool has_torque);
  void stop_by_itself();
  void clear_error();
  void lose_controller();

  // Readings, and reactions to them.
  void act(Time now);
  void look(Time now);
  void react(Time now);
  void react_while_closing();
  void react_while_opening();
  void turn(DoorReaction reaction, Cause cause, Goal goal);
  void await_return(Time now);
  void await_reclose(Time now, double seconds);
  void reclose();
  void reclose_expired(Time now);
  void check_progress(Time now);
  bool is_unlocking(Time now);
  void fail();
  DoorState next_state(Time now);
  bool drive(Time now);
  void tell(Time now);
  void report_defects();
  void plan(Time now);

  template <class Handle>
  auto setting(const Handle& handle) const {
    return Values(node_.dictionary())[in_lift(settings_.lift, handle(settings_.door))];
  }

  Node& node_;
  DoorHardware hardware_;
  CarDoorSettings settings_;
  DoorReadings readings_;
  DoorReport report_;
  DoorDrive driven_;

  Goal goal_ = Goal::stay;
  Cause cause_ = Cause::none;
  DoorCommand last_command_ = DoorCommand::no_action;
  bool has_torque_ = false;     ///< at rest
  bool limits_force_ = true;    ///< from the command
  bool is_reduced_ = false;     ///< the commanded speed
  bool closes_gently_ = false;  ///< reduced without a command
  bool closes_broken_ = false;  ///< with a light barrier that is known to be broken
  bool detects_motion_ = true;
  bool protects_fingers_ = true;
  bool locks_ = true;
  bool lock_told_ = false;
  bool has_failed_ = false;
  bool barrier_is_lost_ = false;
  std::array<bool, 3> defects_told_{};
  Detection barrier_ = Detection::not_available;          ///< by 6310h or wire
  bool reclose_began_ = false;                            ///< the time to closing has started
  Detection reclose_barrier_ = Detection::not_available;  ///< at the start of that time
  Time unlocking_since_ = never;
  Time moved_at_{};
  std::optional<std::uint16_t> moved_position_{};
  Time position_told_at_{};
  std::optional<std::uint16_t> seen_position_;
  Time position_changed_at_{};

  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;    ///< to read the hardware
  Timer reclose_;  ///< until it closes again
};

}  // namespace canvoy::cia417
