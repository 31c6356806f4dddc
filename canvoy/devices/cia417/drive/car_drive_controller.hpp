// The car drive controller of a lift: commands the drive of the car (6400h, 6420h, 6430h), and
// knows what it does by its statusword and velocity, and by the position unit (6401h, 6433h, 6383h;
// CiA 417-4, 4.11).
//
//     CarDriveController drive(node, {.client = &client}, {.lift = 1});
//     drive.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     drive.travel_to(12'500'000);  // micrometres
//     LiftController lift(node, calls, {.motion = drive.interface(), ...}, settings);
//
// It leads the state machine of the drive: power on for a trip, off behind it, and again after a
// fault that has gone. A car whose position unit is lost, or stands still while the drive says that
// it moves, is stopped fast. Where the drive stands at its target and the car does not (ropes have
// slipped, or stretch by the load), the next target is as much farther. A car that the drive would
// lead past its target is stopped fast, near the last floors sooner than elsewhere: behind them are
// limit switches. A trip that comes to a standstill before its target ends
// there, without an arrival.
//
// What it knows comes by event-driven PDOs: ask_anew() is for whoever sees a sign that some were
// lost (GapWatch). A command without its effect is asked for by itself, and a car that stands
// while its velocity or its position says otherwise.
//
// Commands give it an aim, and each PDO of the drive brings it a step further: by the state machine
// of the drive, the handshake of set-points, the approach in profile velocity mode, or homing (CiA
// 417-4, 4.11.1 to 4.11.3). What it sees of the car is a SeenCar.
//
// Where the drive is to have another mode of operation (run(), home(), or trips in profile velocity
// mode), the mode is written by SDO while the car stands.
#pragma once

#include <cstdint>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/controller/lift_bound.hpp"
#include "canvoy/devices/cia417/controller/lift_interfaces.hpp"
#include "canvoy/devices/cia417/drive/drive_mode_client.hpp"
#include "canvoy/devices/cia417/drive/drive_state.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/devices/cia417/drive/seen_car.hpp"
#include "canvoy/profiles/cia417/drive_handles.hpp"

namespace canvoy::cia417 {

struct CarDriveControllerSettings {
  unsigned lift = 1;         ///< 1 to 8
  NodeId drive = 2;          ///< of the car drive unit
  NodeId position_unit = 4;  ///< of the car position unit
  /// How trips are made: in profile position mode, or in profile velocity mode where the drive has
  /// no absolute encoder (4.11).
  cia402::DriveMode trip_mode = cia402::DriveMode::profile_position;
  std::int32_t drive_unit_micrometre = 1000;    ///< of 6420h, 6430h and 6433h
  std::int32_t position_step_micrometre = 100;  ///< one count of 6383h
  /// Of the last floors, as LiftMotion counts them: no trip goes beyond.
  std::int32_t lowest_micrometre = INT32_MIN;
  std::int32_t highest_micrometre = INT32_MAX;
  /// The ramps of the drive, in its units.
  MotionLimits ramps = {.velocity = 1600,
                        .acceleration = 1000,
                        .deceleration = 1000,
                        .jerk = {1200, 1200, 1200, 1200}};
  double creep_velocity = 100;  ///< in profile velocity mode, at the floor switch (6424h)
  /// Between what the position unit measures and what the drive does about it.
  Duration latency = 40ms;
  Duration answer_time = 500ms;  ///< a drive that does nothing until then is told again
  /// A fault is reset so often; 0: by reset_fault() only.
  Duration fault_reset_period = 2s;
  /// The drive says that it moves, and the position does not change: for as long.
  Duration position_time = 500ms;
  /// On a trip, or on its way home, the car stands still for as long, and the drive does not say
  /// that it has arrived: then the trip has ended short of its target.
  Duration standstill_time = 4s;
};

/// What of a node it works with; all may be null.
struct CarDriveControllerServices {
  Rpdos* rpdos = nullptr;       ///< to ask by remote frame for what is not known
  Tpdos* tpdos = nullptr;       ///< to tell a drive again what it did not do
  SdoClient* client = nullptr;  ///< to change the mode of operation
};

class CarDriveController {
 public:
  enum class Aim : std::uint8_t { none, trip, run, home };

  CarDriveController(Node& node, const CarDriveControllerServices& services,
                     const CarDriveControllerSettings& settings);
  CarDriveController(const CarDriveController&) = delete;
  CarDriveController& operator=(const CarDriveController&) = delete;

  // Commands. From outside of a callback of the node, call Node::advance() before and after.
  void travel_to(std::int32_t position_micrometre);
  /// 0 stops.
  void run(std::int32_t velocity_micrometre_per_second);
  /// To the home switch: the drive counts from there.
  void home();
  void stop();
  void fast_stop();
  void reset_fault();
  /// While it is held, the car stops fast and goes nowhere: somebody tells of an error that makes
  /// a trip unsafe (1028h; see UnitErrors). Who releases it commands anew.
  void hold(bool is_held);

  /// The device belongs to another lift now (6001h): what it heard was of another drive.
  void begin_anew();
  /// A boot-up message or heartbeat of a node: of a unit that has begun anew nothing is known, and
  /// one that becomes operational is asked. Losses and returns of those in 1016h are known here.
  void heard(NodeId node, RemoteState state);
  /// PDOs may have been lost: drive and position unit are asked for their state, and the drive is
  /// told its command again when it has answered.
  void ask_anew();
  /// Not while a car is under way.
  AbortCode refuses_lift_number();

  Aim aim() const { return aim_; }
  DriveState drive_state() const { return cia402::drive_state(statusword_.raw()); }
  /// The drive is in fault: what it told is in its emergency.
  bool has_fault() const;
  bool has_homed() const { return has_homed_; }
  MotionStatus status() const;
  /// Called when the status has changed.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// For a LiftController; valid as long as this.
  LiftMotion interface();

 private:
  /// Of a trip and of homing: by the handshake of the set-point in profile position mode; in
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
  void recover();
  bool has_mode();
  void tell_again(Time now);
  bool is_obeyed() const;
  void tell_command();
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

  /// Of 6420h.
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
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;

  Aim aim_ = Aim::none;
  Step step_ = Step::wanted;
  bool is_stopping_fast_ = false;
  bool is_reached_ = false;  ///< the last trip ended where it should
  bool has_homed_ = false;
  bool drive_is_known_ = false;
  bool position_is_known_ = false;
  bool drive_is_lost_ = false;
  bool position_is_lost_ = false;
  bool position_stands_ = false;      ///< while the drive moves
  bool is_told_by_answer_ = false;    ///< the command, once more
  bool velocity_may_be_old_ = false;  ///< it was not told since the position stands
  bool is_held_ = false;
  double wanted_position_ = 0;  ///< in units of the drive
  /// Where the drive counts a position, above where the position unit does. No reset of a node
  /// moves ropes: it is kept until the drive homes.
  double drift_ = 0;
  bool is_at_target_ = false;  ///< the drive, since a trip
  bool goes_up_ = false;       ///< to the target of a trip from where it was given
  double wanted_velocity_ = 0;
  Time stands_since_{};  ///< on a trip
  Time reset_at_{};
  Time told_at_{};
  MotionStatus told_;
};

}  // namespace canvoy::cia417
