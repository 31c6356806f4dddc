// A car in its shaft as a plant: car, counterweight, load and ropes on a motor with a brake, and
// the encoders that measure them.
//
// The plant is not stepped: between two events (a new profile, the brake, power, a fault) the
// motion is a closed form, computed on request. While the motor has power and the brake is open,
// the car follows the profile of the drive; else brake, safety gear and gravity move it or stop it.
//
//     CarPlant plant({.load_capacity_kg = 1000}, Callback<Time()>::to<&World::now>(world));
//     CarDriveDevice<> drive(world.port(slot), 2, plant.drive_hardware());
//     CarPositionDevice<> position(world.port(other), 4, plant.position_hardware());
//     plant.set_load(300);
//     plant.truth().position_m;
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/drive/car_drive_hardware.hpp"
#include "canvoy/devices/cia417/drive/motion_profile.hpp"
#include "canvoy/devices/cia417/position/car_position_hardware.hpp"
#include "canvoy/sim/duration_text.hpp"

namespace canvoy::lift {

/// Masses, forces and losses of a car in its shaft.
struct CarPlantDesign {
  double car_kg = 1100;            ///< mass of the empty car
  double counterweight_kg = 1600;  ///< balances a car with half of its rated load
  double rotating_kg = 600;        ///< inertia of motor and sheaves, as if they moved with the car
  double rope_kg_per_m = 0;        ///< of all ropes; 0: something compensates for them
  double travel_m = 30;            ///< between the lowest and the highest floor
  double overtravel_m = 0.3;       ///< beyond the travel, up to the buffers
  double friction_n = 400;         ///< force against the motion, of guides and sheaves
  /// Sag of the car under a load, through its ropes; the motor's encoder does not measure it.
  double stretch_um_per_kg = 2;
  double brake_force_n = 25'000;  ///< at the ropes, closed and whole
  /// Load on the brake at its self-test: the car with 125 % of its rated load (EN
  /// 81-20, 5.9.2.2.2).
  double brake_test_n = 7'358;
  bool has_brake_test = true;         ///< false: its drive tests nothing
  double gear_deceleration_m_s2 = 6;  ///< of the safety gear
  /// Share of the electric energy that the motor turns into motion, and of the motion that it turns
  /// back: without regeneration into the mains, that becomes heat.
  double motor_efficiency = 0.85;
  double regeneration_efficiency = 0.7;  ///< share of the motion that reaches the mains
  double standby_w = 100;                ///< taken from the mains all the time
  double increments_per_m = 10'000;      ///< of the motor's encoder
  double home_switch_m = -0.1;           ///< switched at this height and below
};

/// Defects. Each may come and go at any time.
struct CarPlantFaults {
  bool drive_encoder_is_dead = false;     ///< reports the last position; the motor runs away
  bool position_encoder_is_dead = false;  ///< reports the last position
  bool position_encoder_alarms = false;   ///< and reports the defect
  double slip = 0;                        ///< share of the way that is lost as ropes slip, below 1
  bool motor_runs_away = false;           ///< whatever its command, as long as it has power
  double brake_share = 1;                 ///< share of its force that the brake has
  bool brake_is_stuck = false;            ///< closed
  std::uint16_t drive_fault = 0;          ///< emergency error code of the drive's hardware
};

class CarPlant {
 public:
  /// True state of the car, whatever encoders report.
  struct Truth {
    double position_m = 0;         ///< of the car's floor, above floor 1
    double velocity_m_s = 0;       ///< upward is positive
    double acceleration_m_s2 = 0;  ///< upward is positive
    bool brake_is_closed = true;   ///< it holds, as far as it is whole
    bool is_cut = false;           ///< by the safety chain
    bool is_cranked = false;       ///< by hand
    bool gear_is_caught = false;   ///< it holds the car until release_gear()
    bool brake_slips = false;      ///< under the load of its self-test
    unsigned buffer_strikes = 0;   ///< times that the car ran into a buffer
    double energy_in_joule = 0;    ///< taken from the mains
    double energy_out_joule = 0;   ///< returned to the mains
    double way_m = 0;              ///< sum of the ways up and down
  };

  /// `clock` returns the time; the object to which it refers must outlive this one.
  CarPlant(const CarPlantDesign& design, Callback<Time()> clock, double position_m = 0);
  CarPlant(const CarPlant&) = delete;
  CarPlant& operator=(const CarPlant&) = delete;

  /// Hardware for a drive that counts 10,000 increments per metre, or as the design states, and for
  /// a position unit of which all encoders have the same value.
  cia417::CarDriveHardware drive_hardware();
  /// Encoders of the position units; valid as long as the plant.
  cia417::CarPositionHardware position_hardware();

  /// Follows a drive elsewhere: the car has the position that `car` returns, in metres. Its defects
  /// are those of the drive elsewhere.
  void lead_by(Callback<cia417::MotionState()> car);

  /// Mass of all people in the car.
  void set_load(double kg);
  /// Mass of all people in the car.
  double load_kg() const { return load_kg_; }
  /// Replaces all defects; they take effect at once.
  void set_faults(const CarPlantFaults& faults);
  /// Present defects.
  const CarPlantFaults& faults() const { return faults_; }
  /// Opens the brake by hand and moves the car at this speed; 0: closes it.
  void crank(double metre_per_second);
  /// The safety gear catches the car.
  void arrest();
  /// Pulls the car off its safety gear.
  void release_gear();
  /// Opens or closes the safety chain: while it is open, motor and brake have no current, whatever
  /// the drive commands; the drive detects the lost voltage. A car that follows a drive elsewhere
  /// is cut off there.
  void cut(bool is_cut);
  /// True while the safety chain is open.
  bool is_cut() const { return is_cut_; }
  /// Share of its force at which a brake holds any load that is allowed, and slips at its
  /// self-test.
  double weak_brake_share() const { return 0.9 * design_.brake_test_n / design_.brake_force_n; }
  /// True if the brake has slipped at a self-test since the last forget_brake_test().
  bool brake_has_slipped() const { return brake_has_slipped_; }
  /// Call it when a technician has reset it.
  void forget_brake_test() { brake_has_slipped_ = false; }
  /// True if the brake alone must hold the car, and the loads on both sides of its ropes differ so
  /// much that it would move without a brake.
  bool would_drift() const;

  /// True state at present.
  Truth truth();
  /// The same, for those who only look: the motion is the same as without them, to the last bit.
  Truth look() const;
  /// Sets the function that is called when the motion of the car changes.
  void on_change(Callback<void()> changed) { changed_ = changed; }

 private:
  enum class Motion : std::uint8_t { standing, following, free };

  Time now() const { return clock_(); }

  cia417::DriveReadings sense_drive();
  cia417::PositionReadings sense_position(unsigned unit);
  void set_power(bool on);
  void set_brake(bool released);
  bool brake_slips() const;
  bool test_brake();
  void follow(const cia417::MotionProfile& profile, Duration delay);

  cia417::MotionState motion(Time time) const;
  double imbalance_n(double position) const;
  double potential_joule(double position) const;
  double mass_kg() const;
  double stretch_m() const { return load_kg_ * design_.stretch_um_per_kg * 1e-6; }
  /// What has come together since the start.
  struct Sums {
    double energy_in_joule = 0;
    double energy_out_joule = 0;
    double way_m = 0;
  };
  void settle();
  Sums sums_at(Time time, const cia417::MotionState& at) const;
  Truth truth_of(const cia417::MotionState& at, const Sums& sums) const;
  void strike_buffers();
  void choose_motion();
  bool is_led() const;
  void run_free();

  CarPlantDesign design_;
  Callback<Time()> clock_;
  Callback<cia417::MotionState()> elsewhere_;
  Callback<void()> changed_;
  CarPlantFaults faults_;
  double load_kg_ = 0;
  bool has_power_ = false;
  bool brake_released_ = false;
  bool gear_is_caught_ = false;
  bool is_cut_ = false;
  bool brake_has_slipped_ = false;
  double crank_m_s_ = 0;
  Motion kind_ = Motion::standing;
  cia417::MotionState state_;  ///< at settled_at_, in metres
  Time settled_at_{};
  double acceleration_ = 0;        ///< of a free motion
  bool stops_ = false;             ///< a free motion ends where it comes to rest
  cia417::MotionProfile profile_;  ///< in increments
  Time profile_start_{};
  double profile_origin_m_ = 0;  ///< position of increment 0: it moves while ropes slip
  double frozen_drive_m_ = 0;
  double frozen_position_m_ = 0;
  unsigned buffer_strikes_ = 0;
  Sums sums_;
};

}  // namespace canvoy::lift
