// The car drive controller of a lift: commands the drive of the car (6400h, 6420h, 6430h), and
// evaluates its statusword and velocity, and the position unit (6401h, 6433h, 6383h; CiA 417-4,
// 4.11).
//
//     CarDriveController drive(node, {.client = &client}, {.lift = 1});
//     drive.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     drive.travel_to(12'500'000);  // micrometres
//     LiftController lift(node, calls, {.motion = drive.interface(), ...}, settings);
//
// It controls the state machine of the drive: power on for a trip, off after it, and on again after
// the end of a fault. The car is stopped fast if its position unit is lost, or reports no movement
// while the drive reports one. If the drive stands at its target and the car does not (ropes have
// slipped, or stretch under the load), the next target is corrected by the difference. A car that
// the drive would move past its target is stopped fast, earlier near the last floors because of the
// limit switches behind them. A trip that comes to a standstill before its target ends
// there, without an arrival.
//
// Its information comes from event-driven PDOs: call ask_anew() after a sign of lost frames
// (GapWatch). It repeats requests by itself when a command has no effect, and when a car stands
// while its velocity or its position shows movement.
//
// Commands set a target, and each PDO of the drive leads to the next step: in the state machine of
// the drive, the handshake of set-points, the approach in profile velocity mode, or homing (CiA
// 417-4, 4.11.1 to 4.11.3). SeenCar has the known state of the car.
//
// If the drive needs another mode of operation (run(), home(), or trips in profile velocity mode),
// the mode is written by SDO while the car stands.
#pragma once

#include <cstdint>
#include <limits>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/drive/drive_mode_client.hpp"
#include "canvoy/devices/cia417/drive/drive_state.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/devices/cia417/drive/seen_car.hpp"
#include "canvoy/devices/cia417/lift/lift_bound.hpp"
#include "canvoy/devices/cia417/lift/lift_interfaces.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"

namespace canvoy::cia417 {

/// Settings of a car drive controller that no object of its dictionary has.
struct CarDriveControllerSettings {
  unsigned lift = 1;         ///< 1 to 8
  NodeId drive = 2;          ///< of the car drive unit
  NodeId position_unit = 4;  ///< of the car position unit
  /// Mode of trips: profile position mode, or profile velocity mode if the drive has no absolute
  /// encoder (4.11).
  cia402::DriveMode trip_mode = cia402::DriveMode::profile_position;
  std::int32_t drive_unit_micrometre = 1000;    ///< unit of 6420h, 6430h and 6433h
  std::int32_t position_step_micrometre = 100;  ///< one count of 6383h
  /// Positions of the last floors, as in LiftMotion: no trip goes beyond.
  std::int32_t lowest_micrometre = INT32_MIN;
  std::int32_t highest_micrometre = INT32_MAX;  ///< of the last floor above
  /// The ramps of the drive, in its units.
  MotionLimits ramps = {.velocity = 1600,
                        .acceleration = 1000,
                        .deceleration = 1000,
                        .jerk = {1200, 1200, 1200, 1200}};
  double creep_velocity = 100;  ///< in profile velocity mode, at the floor switch (6424h)
  /// Time between a measurement of the position unit and the reaction of the drive.
  Duration latency = 40ms;
  Duration answer_time = 500ms;  ///< without a reaction, the command is repeated then
  /// Period of attempts to reset a fault; 0: only by reset_fault().
  Duration fault_reset_period = 2s;
  /// Maximum time for which the drive may report a movement while the position does not change.
  Duration position_time = 500ms;
  /// If the car stands for this time on a trip or during homing, and the drive does not report its
  /// arrival, the trip has ended short of its target.
  Duration standstill_time = 4s;
};

/// Services of a node that it uses; all may be null.
struct CarDriveControllerServices {
  Rpdos* rpdos = nullptr;       ///< to request unknown states by remote frame
  Tpdos* tpdos = nullptr;       ///< to send a command to the drive again
  SdoClient* client = nullptr;  ///< to change the mode of operation
};

class CarDriveController {
 public:
  /// What the car is commanded to do.
  enum class Aim : std::uint8_t { none, trip, run, home };

  /// Makes the controller; `node` must outlive it, and so must the services.
  CarDriveController(Node& node, const CarDriveControllerServices& services,
                     const CarDriveControllerSettings& settings);

  // Commands. From outside of a callback of the node, call Node::advance() before and after.
  /// Moves the car to a position, in micrometres as in LiftMotion; within the last floors.
  void travel_to(std::int32_t position_micrometre);
  /// 0 stops.
  void run(std::int32_t velocity_micrometre_per_second);
  /// Moves to the home switch, from which the drive counts.
  void home();
  /// Stops the car within the ramps of the drive.
  void stop();
  /// Stops the car by the quick stop of the drive.
  void fast_stop();
  /// Resets a fault of the drive; the car stays where it is.
  void reset_fault();
  /// While it is held, the car stops fast and does not move: a node reports an error that makes a
  /// trip unsafe (1028h; see UnitErrors). The caller that releases it commands again.
  void hold(bool is_held);

  /// Discards all states: the device belongs to another lift (6001h).
  void begin_anew();
  /// Takes a boot-up message or heartbeat of a node. The state of a unit that has restarted is
  /// discarded; the state of a unit that becomes operational is requested. Losses and returns of
  /// units in 1016h are detected automatically.
  void heard(NodeId node, RemoteState state);
  /// Requests the state of drive and position unit, as PDOs may have been lost. The drive gets its
  /// command again when it has answered.
  void ask_anew();
  /// Refuses while a car moves.
  AbortCode refuses_lift_number();

  /// Present command.
  Aim aim() const { return aim_; }
  /// State of the drive by its statusword.
  DriveState drive_state() const { return cia402::drive_state(statusword_.raw()); }
  /// True if the drive is in fault; its emergency has the reason.
  bool has_fault() const;
  /// True if the drive counts from its home switch.
  bool has_homed() const { return has_homed_; }
  /// State of the car and its drive, for a lift controller.
  MotionStatus status() const;
  /// Calls `changed` when the status has changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// For a LiftController; valid as long as this.
  LiftMotion interface();

 private:
  /// Step of a trip or of homing: by the handshake of the set-point in profile position mode; in
  /// profile velocity mode `sent` is slow and `taken` is stopping.
  enum class Step : std::uint8_t { wanted, placed, sent, taken };

  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void status_received();
  void velocity_received();
  void drive_told();
  void position_received();

  void take_aim(Aim aim);
  void pursue();
  void pursue_enabled(std::uint16_t status);
  void rest();
  void lead_trip(std::uint16_t status);
  void send_set_point();
  void repeat_set_point();
  void lead_approach();
  void lead_run();
  void lead_homing(std::uint16_t status);
  void reach(bool is_reached);
  void learn_drift();
  double drift_of_trip() const;
  void recover();
  bool has_mode();
  void report_again(Time now);
  bool is_obeyed() const;
  void report_command();
  void ask_what_is_odd();
  cia402::DriveMode wanted_mode() const;
  void command(unsigned word);
  void forget_drive();
  void ask();
  void request(std::uint16_t rpdo);
  void watch_position(Time now);
  void watch_standstill(Time now);
  void watch_overshoot();
  bool passes_last_floor() const;
  void expired(Time now);
  double position() const { return car_.position(); }
  double velocity() const { return car_.velocity(); }
  void tell();
  MotionStatus status_for_lift() { return status(); }

  /// 6420h.
  auto target() const {
    return Values(node_.dictionary())[in_lift(settings_.lift, target_position)];
  }

  Node& node_;
  Rpdos* rpdos_;
  Tpdos* tpdos_;
  CarDriveControllerSettings settings_;
  LiftBound<controlword> controlword_;
  LiftBound<statusword> statusword_;
  LiftBound<target_velocity> target_velocity_;
  SeenCar car_;
  DriveModeClient mode_;
  Callback<void()> changed_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;

  Aim aim_ = Aim::none;
  Step step_ = Step::wanted;
  bool is_stopping_fast_ = false;
  bool is_reached_ = false;  ///< the last trip ended at its target
  bool has_homed_ = false;
  bool drive_is_known_ = false;
  bool position_is_known_ = false;
  bool drive_is_lost_ = false;
  bool position_is_lost_ = false;
  bool position_stands_ = false;      ///< while the drive reports a movement
  bool is_told_by_answer_ = false;    ///< the command is repeated with the next answer
  bool velocity_may_be_old_ = false;  ///< it was not received since the position stands still
  bool is_held_ = false;
  double wanted_position_ = 0;  ///< in units of the drive
  /// Position of the drive minus that of the position unit. A reset of a node does not move ropes:
  /// it is kept until the drive homes.
  double drift_ = 0;
  /// Bounds of the drift, where the drive has led the car past a target since it was learnt.
  double drift_least_ = -std::numeric_limits<double>::infinity();
  double drift_most_ = std::numeric_limits<double>::infinity();
  bool is_at_target_ = false;  ///< the drive, during a trip
  bool goes_up_ = false;       ///< direction to the target of a trip from its start
  double wanted_velocity_ = 0;
  Time stands_since_{};  ///< on a trip
  Time reset_at_{};
  Time told_at_{};
  MotionStatus told_;
};

}  // namespace canvoy::cia417
