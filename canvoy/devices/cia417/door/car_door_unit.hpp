// A car door unit: one door of a car, which obeys its controlword (6300h), tells its statusword and
// position (6301h, 6302h), and does of its own accord what its configuration says (6304h to 6307h;
// CiA 417-4, 4.6.1 and 4.7).
//
//     CarDoorUnit door(node, hardware, {.door = 2});
//     node.start(now);
//
// A device that moves several doors has one for each. Where 6310h is in the dictionary too, the
// light barrier of the door is what stands there: an RPDO of the light barrier unit brings it.
//
// What the clause leaves open, and how it is taken here (docs/decisions.md, "Doors of lifts"):
// a command acts when it differs from the one before, or comes by SDO; an enabled lock locks when
// the door is closed and opens when the door is to; at reduced speed the light barrier turns
// nothing.
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/node.hpp"
#include "canvoy/devices/cia417/door/car_door_hardware.hpp"
#include "canvoy/devices/cia417/door/door_words.hpp"
#include "canvoy/profiles/cia417/handles.hpp"

namespace canvoy::cia417 {

struct CarDoorSettings {
  unsigned lift = 1;  ///< 1 to 8
  unsigned door = 1;  ///< 1 to 4
  /// The node-ID of the car door controller: 6304h:0Bh holds when its heartbeat is lost, which
  /// takes an entry in 1016h.
  NodeId controller = 1;
  /// Of the light barrier unit, where 6310h is consumed; 0: it is not watched. While its heartbeat
  /// is lost the light barrier is broken.
  NodeId light_barrier = 0;
  bool holds_closed = true;            ///< with torque, at that end
  bool holds_open = true;              ///< and at the other one
  std::uint8_t velocity_profiles = 1;  ///< 6304h:01h takes numbers below
  std::uint8_t width_profiles = 1;     ///< and 6304h:02h
  /// How often a hardware without next_change is looked at.
  Duration sensing_period = 50ms;
  /// How often a position that changes is told.
  Duration position_period = 100ms;
  /// A door that is driven for so long and stays where it is, without a limit of force, is stuck.
  Duration stall_time = 2s;
  /// A lock that takes longer to open is stuck.
  Duration lock_time = 1s;
};

class CarDoorUnit {
 public:
  /// What `hardware` refers to must outlive this.
  CarDoorUnit(Node& node, const DoorHardware& hardware, const CarDoorSettings& settings);
  CarDoorUnit(const CarDoorUnit&) = delete;
  CarDoorUnit& operator=(const CarDoorUnit&) = delete;

  /// The readings are others: has them looked at when the node is called next.
  void hardware_changed() { node_.timers().arm(timer_, node_.now()); }

  DoorState state() const { return report_.state; }
  const DoorReport& report() const { return report_; }
  const DoorDrive& driven() const { return driven_; }

 private:
  enum class Goal : std::uint8_t { stay, close, open };
  /// Why a door moves another way than it was told.
  enum class Cause : std::uint8_t { none, barrier, force, motion, finger };

  // The bus.
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

  // What is sensed, and what follows.
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
  void tell_defects();
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
  bool has_torque_ = false;     ///< while it stays
  bool limits_force_ = true;    ///< of the command
  bool is_reduced_ = false;     ///< the speed that was commanded
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
  bool reclose_began_ = false;                            ///< the time until it closes again
  Detection reclose_barrier_ = Detection::not_available;  ///< when that time began
  Time unlocking_since_ = never;
  Time moved_at_{};
  std::optional<std::uint16_t> moved_position_{};
  Time position_told_at_{};
  std::optional<std::uint16_t> seen_position_;
  Time position_changed_at_{};

  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;    ///< to look at the hardware
  Timer reclose_;  ///< until it closes again
};

}  // namespace canvoy::cia417
