// A car drive unit: the drive of CiA 402 that moves the car of a lift (CiA 417-4, 4.11), in profile
// position, profile velocity and homing mode.
//
//     CarDriveUnit drive(node, {.emergencies = &emergency_consumer}, hardware, {.lift = 1});
//     node.start(now);
//
// It stops fast, and waits for another command, when the heartbeat of its controller is lost, a
// control PDO is refused or late, or the node leaves NMT state operational or goes bus-off. It also
// stops fast when a node in 1028h reports overspeed (FF05h) or unintended car movement (FF06h),
// until that node has no error any more or boots; no option code of 6402h makes that stop slower
// than the quick stop deceleration (640Ah). Conditions that it detects itself (these two, a
// following error, a fault of the hardware) are a fault of CiA 402, which a fault reset ends.
// Without voltage (the safety chain is open), operation ends, the brake closes, and overspeed and
// unintended movement stay faults: they end only when a person closes the chain (EN 81-20, 5.6).
//
// This class is the state machine of CiA 402. DrivenCar is the car that it moves, the classes of
// the three modes are its movements, and DriveHold has the nodes that hold it from outside.
//
// Decisions where CiA 402 and CiA 417-4 are open: docs/decisions.md, "The drive of lifts".
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/drive/drive_faults.hpp"
#include "canvoy/devices/cia417/drive/drive_parameters.hpp"
#include "canvoy/devices/cia417/drive/drive_watch.hpp"
#include "canvoy/devices/cia417/drive/driven_car.hpp"
#include "canvoy/devices/cia417/drive/homing_mode.hpp"
#include "canvoy/devices/cia417/drive/profile_modes.hpp"
#include "canvoy/devices/cia417/lift/lift_bound.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"
#include "canvoy/profiles/model/written_value.hpp"

namespace canvoy::cia417 {

using cia402::StopReaction;

/// Settings of a drive for its building, in the units of its objects: power-on values of 6408h:01h
/// and 6423h, of 640Bh, and of all of 640Dh. 0: as in its description.
struct DriveTuning {
  std::uint32_t velocity = 0;      ///< 6408h:01h and 6423h
  std::uint32_t acceleration = 0;  ///< 640Bh
  std::uint32_t jerk = 0;          ///< all of 640Dh
};

/// Widths and speeds of the drive itself, in the units of its objects.
struct CarDriveSettings {
  unsigned lift = 1;        ///< 1 to 8
  DriveTuning tuning = {};  ///< for its building
  /// Further nodes that stop it fast, beside those of 1028h; 0: none.
  std::array<NodeId, 4> stops_for = {};
  NodeId controller = 1;             ///< its heartbeat is monitored, by an entry in 1016h
  Duration control_period = 20ms;    ///< of supervision and status, while the car moves
  Duration standing_period = 100ms;  ///< while the car stands
  /// Opening time of the brake: the car starts after it.
  Duration brake_time = 200ms;
  double position_window = 2;     ///< distance from the target at which it has arrived
  double following_window = 200;  ///< farther from its demanded position, for following_time: fault
  Duration following_time = 200ms;  ///< then it is a fault
  /// Overspeed, in per cent of 6408h:01h. A governor of EN 81-20 trips at 115 % or more.
  double overspeed_percent = 115;
  double unintended_distance = 50;  ///< maximum movement while it has to stand
  HomingMethod homing = HomingMethod::home_switch_below;  ///< see drive_homing.hpp
  double homing_velocity = 100;                           ///< in units of 6430h
  /// Distance between the ends of the shaft: a search that moves a tenth farther in one direction
  /// has missed its switch. 0: not known; then the width of the software limits (6422h) applies,
  /// and homing_time_max limits the search as well.
  double travel = 0;
  Duration homing_time_max = 5min;  ///< of a search, then it fails
  /// Deceleration of the motor on the current and on the voltage limit, in units of 640Ah.
  double current_limit_deceleration = 2500;
  double voltage_limit_deceleration = 2000;  ///< on its voltage limit
};

/// Services of a node that a drive uses.
struct CarDriveServices {
  EmergencyConsumer* emergencies = nullptr;  ///< needed to react to the emergencies of other nodes
};

class CarDriveUnit {
 public:
  /// Everything to which `hardware` and `services` refer must outlive this.
  CarDriveUnit(Node& node, const CarDriveServices& services, const CarDriveHardware& hardware,
               const CarDriveSettings& settings);

  /// State of CiA 402, as the statusword has it.
  DriveState state() const { return state_; }
  /// Mode of operation (6404h).
  cia402::DriveMode mode() const { return mode_; }
  /// Demanded state of the car at present, in increments from the encoder's zero.
  MotionState demand(Time now) const { return car_.demand(now); }
  /// What the hardware reported last.
  const DriveReadings& readings() const { return car_.readings(); }
  /// True if the car is slower than the velocity threshold, and no profile moves it.
  bool is_standing() const { return car_.is_standing(); }
  /// True while a node reports overspeed or unintended movement.
  bool is_held() const { return hold_.is_held(); }

  /// Refuses configuration while the drive has power (4.11).
  AbortCode refuses_lift_number() {
    return is_powered(state_) ? AbortCode::device_state : AbortCode::none;
  }
  /// Reads the hardware at the next call of the node, after a change.
  void hardware_changed() { look_again(); }

 private:
  // Events of the bus.
  void reset(ResetScope scope);
  void tune();
  void read_parameters();
  void state_entered(NmtState state);
  void bus_state_changed(BusState state);
  void error_changed(const Error& error, bool present);
  void held();
  AbortCode note_order(Raw<std::uint16_t> controlword);
  AbortCode check(const Entry& entry, std::span<const std::uint8_t> value);
  void order_written();
  void mode_written();
  void target_velocity_written();
  void parameter_written(const Entry& entry);

  // The state machine.
  void obey(std::uint16_t word);
  void obey_level();
  void change_state(DriveState next);
  void stop(StopReaction reaction, std::optional<DriveState> then);
  void slow_down(StopReaction reaction);
  void enter(DriveState state);
  void stop_fast();
  bool must_be_fast() const { return is_held() || faults_.has_dangerous_motion(); }
  void hasten();
  void fail(DriveFault fault, std::uint16_t hardware_code = 0);
  void reset_fault();
  bool is_gone(DriveFault fault) const;

  // The mode of operation.
  void take_mode();
  void obey_mode(std::uint16_t word, std::uint16_t changed);
  void obey_halt(bool is_halted);
  void obey_velocity();

  // Called every period.
  void tick(Time now);
  void measure(Time now);
  void report_velocities(Time now);
  void supervise(Time now);
  void watch_voltage();
  void finish_stop(Time now);
  void advance_mode(Time now);
  std::optional<bool> look_at_mode(Time now);
  void refresh_status();
  std::uint16_t mode_bits() const;
  void look_again() { node_.timers().arm(timer_, node_.now()); }
  void arm(Time now);

  /// A value of this lift; looked up each time, for rare accesses.
  auto value(const auto& handle) const {
    return Values(node_.dictionary())[in_lift(lift_, handle)];
  }

  Node& node_;
  unsigned lift_;
  DriveTuning tuning_;
  Duration control_period_;
  Duration standing_period_;
  DriveParameters parameters_;
  DrivenCar car_;
  ProfilePositionMode position_mode_;
  ProfileVelocityMode velocity_mode_;
  HomingMode homing_mode_;
  DriveWatch watch_;
  Lasting weak_brake_;
  DriveFaults faults_;
  DriveHold hold_;
  LiftBound<controlword> controlword_;
  LiftBound<statusword> statusword_;
  LiftBound<modes_of_operation> mode_wanted_;
  LiftBound<velocity_demand_value> velocity_demand_;
  LiftBound<velocity_actual_value> velocity_actual_;
  LiftBound<velocity_sensor_actual_value> velocity_sensor_;
  LiftBound<sensor_selection_code> sensor_selection_;
  LiftBound<control_effort> control_effort_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(lift_)};
  Timer timer_;

  NodeId controller_;
  DriveState state_ = DriveState::not_ready_to_switch_on;
  cia402::DriveMode mode_ = cia402::DriveMode::profile_position;
  std::uint16_t asked_ = 0;   ///< the next allowed controlword
  std::uint16_t obeyed_ = 0;  ///< the last executed controlword
  /// The state after the present stop; nothing: it stays in this one.
  std::optional<DriveState> after_stop_;
  StopReaction reaction_ = StopReaction::disable;  ///< of that stop
  bool is_stopping_ = false;
  bool is_halted_ = false;
  bool has_arrived_ = false;  ///< bit 10
};

}  // namespace canvoy::cia417
