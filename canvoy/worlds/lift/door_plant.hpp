// A door of a car with the landing door that it moves, as a plant: panels with a mass, a drive with
// a limited force, people in the way, a lock, a safety contact, a light barrier, and possible
// defects.
//
//     DoorPlant plant({.width_m = 0.9, .open_time_s = 2.0});
//     cia417::CarDoorDevice<> door(port, 6, {plant.hardware()});
//     plant.on_change(...);           // has the device look: door.unit().hardware_changed()
//     plant.stand_in_way(now, true);  // somebody boards
//     plant.open_m(now);
//
// The plant is not stepped: the position of the panels is computed on request, and the device is
// notified when something will change (DoorHardware::next_change).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia417/door/car_door_hardware.hpp"
#include "canvoy/devices/cia417/kit/door_words.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/worlds/lift/door_motion.hpp"

namespace canvoy::lift {

/// Dimensions, forces and times of a door.
struct DoorPlantOptions {
  double width_m = 0.9;                             ///< of the open doorway
  double open_time_s = 2.0;                         ///< for the whole width, at standard speed
  double close_time_s = 2.6;                        ///< for the whole width, at standard speed
  double reduced_share = 0.5;                       ///< share of the speed
  double mass_kg = 180;                             ///< mass of all panels that move
  double limited_force_n = 150;                     ///< EN 81-20, 5.3.6.2.2.1.1
  double full_force_n = 300;                        ///< of the drive without the limit
  double contact_at_m = 0.005;                      ///< the safety contact closes at this width
  double friction_m_s2 = 0.5;                       ///< deceleration without torque
  Duration lock_time = 100ms;                       ///< of the lock, to open or to close
  static constexpr std::uint8_t profile_count = 2;  ///< profiles of 6304h:01h, and of 6304h:02h
  /// Share of the speed for each value of 6304h:01h, from 00h on: 01h is slow.
  std::array<double, profile_count> velocity_profiles = {1.0, 0.75};
  /// Share of the width for each value of 6304h:02h, from 00h on: 01h is narrow.
  std::array<double, profile_count> width_profiles = {1.0, 0.85};
  /// True: the light barrier is wired to the door; false: it is a device of its own.
  bool has_light_barrier = false;
};

/// A person or thing between the edges.
struct DoorObstacle {
  double width_m = 0.4;  ///< it stops the edge at this width
  double force_n = 200;  ///< force that pushes it out of the way
};

/// Defects of a door; none by default.
struct DoorFaults {
  bool is_stuck = false;            ///< the panels do not move
  bool belt_is_broken = false;      ///< the drive turns without moving the panels
  bool drive_fails = false;         ///< and reports the defect
  bool lock_is_stuck = false;       ///< keeps its state
  bool lock_is_open = false;        ///< it has sprung open, and does not hold
  bool contact_is_broken = false;   ///< the safety contact stays open, whatever the panels do
  bool barrier_is_broken = false;   ///< and reports the defect
  bool barrier_is_covered = false;  ///< by dirt: it is always interrupted
  bool finger_protector_is_broken = false;  ///< reports no finger
  bool motion_detector_is_broken = false;   ///< reports no person

  friend bool operator==(const DoorFaults&, const DoorFaults&) = default;
};

class DoorPlant {
 public:
  /// A closed and locked door.
  explicit DoorPlant(const DoorPlantOptions& options = {});
  DoorPlant(const DoorPlant&) = delete;
  DoorPlant& operator=(const DoorPlant&) = delete;

  /// Hardware for the devices; valid as long as the plant.
  cia417::DoorHardware hardware();
  /// Hardware for door 1 of a light barrier unit.
  cia417::LightBarrierHardware light_barrier_hardware();
  /// State of the light barrier; not available if it is broken.
  cia417::Detection beam() const;
  /// Sets the function that is called when people or faults have changed the inputs: then the
  /// devices must read them.
  void on_change(Callback<void()> changed) { changed_ = changed; }

  /// Follows a door unit elsewhere, by its report. Without a position, the door moves as its
  /// options say until an end is reported.
  void lead(Time now, const cia417::DoorReport& said, std::optional<std::uint16_t> position_mm);

  // Actions of people and faults.

  /// A person stands in the light barrier, and between the edges.
  void stand_in_way(Time now, bool is_in_way, const DoorObstacle& obstacle = {});
  /// A person is in front of the motion detector.
  void approach(bool is_near);
  /// A finger is where the panels slide in.
  void touch_edge(bool is_touched);
  /// Replaces all defects; they take effect at `now`.
  void set_faults(Time now, const DoorFaults& faults);
  /// Present defects.
  const DoorFaults& faults() const { return faults_; }

  // True state. Times must not be before that of the last call that changed something.

  /// Distance between the edges.
  double open_m(Time at) const;
  /// Opening is positive.
  double speed_m_s(Time at) const;
  /// True while the panels move.
  bool is_moving(Time at) const { return speed_m_s(at) != 0; }
  /// True if the lock holds.
  bool is_locked(Time at) const;
  /// True if the safety contact is closed: the chain lets the car go.
  bool contact_is_closed(Time at) const;
  /// True while the edge pushes against a person.
  bool is_pushing(Time at) const;
  /// The greatest energy of an edge that met a person: EN 81-20 allows 10 J.
  double impact_energy_max_j() const { return impact_energy_max_j_; }
  /// Time of the next change other than that of the position: never while nothing moves.
  Time next_change(Time after) const;

 private:
  cia417::DoorReadings sense(Time now);
  void drive(const cia417::DoorDrive& order, Time now);
  void lock(bool locks, Time now);
  void use_battery(bool uses) { uses_battery_ = uses; }
  Time next_change_for_device() { return next_change(asked_at_); }
  cia417::Detection beam_of(unsigned) { return beam(); }

  void settle(Time now);
  void move(Time now);
  void move_as_said(Time now, cia417::DoorState state, std::optional<double> position_m);
  void run_out(Time now, double deceleration_m_s2);
  void note_impact(double speed_m_s);
  DoorMotion::Way way() const;
  double width_m() const;
  double held_at_m() const;

  DoorPlantOptions options_;
  Callback<void()> changed_;
  DoorFaults faults_;
  cia417::DoorDrive order_;
  DoorMotion motion_;
  std::optional<DoorObstacle> obstacle_;
  bool is_near_ = false;
  bool edge_is_touched_ = false;
  bool uses_battery_ = false;
  bool lock_wanted_ = false;
  bool was_locked_ = false;  ///< before lock_at_
  Time lock_at_{};           ///< time at which the lock has its requested state
  Time met_at_ = never;      ///< time at which the edge meets the obstacle
  Time asked_at_{};
  bool is_led_ = false;
  double led_speed_m_s_ = 0;
  double impact_energy_max_j_ = 0;
};

}  // namespace canvoy::lift
