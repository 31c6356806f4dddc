// An excavator as a plant: engine and pump, boom, stick, bucket and rotator, slew and tracks, and
// the earth that the bucket digs, carries, dumps and spills.
//
//     Excavator machine;
//     machine.command(Movement::boom, 0.5);
//     machine.set_pilot_pressure(true);     // without, no valve opens
//     machine.step(0.02);
//     machine.tip().z;                      // m above the ground on which it stands
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "canvoy/can/random.hpp"

namespace canvoy {

// A hydraulic cylinder between two pivots, and the valve that feeds it: dead band and lag of the
// spool, rate of the pump, ends of the stroke, and the angle of the joint by the law of cosines.
//
//     HydraulicCylinder boom({.near_metres = 1.8, .far_metres = 2.3, ...});
//     boom.step(command, flow, 0.02);     // command -1 to 1
//     boom.angle();                       // degrees

/// The spool of a proportional valve: it follows its command with a lag and passes no flow in its
/// dead band.
class ValveSpool {
 public:
  static constexpr double lag_seconds = 0.04;  ///< time constant
  static constexpr double dead_band = 0.05;    ///< share of the command without flow

  /// `command` is -1 to 1.
  void step(double command, double seconds);
  /// Share of the full flow, -1 to 1; 0 within the dead band.
  double opening() const;

 private:
  double place_ = 0;
};

/// Geometry and size of a cylinder.
struct CylinderShape {
  double near_metres = 1;  ///< from the joint to the pivots of the cylinder
  double far_metres = 1;   ///< from the joint to the far pivot
  double at_zero = 0;      ///< degrees of the joint where the angle between both would be 0
  double direction = 1;    ///< 1: the joint opens with the cylinder; -1: it closes
  double lowest = 0;       ///< degrees, at the ends of the stroke
  double highest = 90;     ///< degrees, at the other end
  double rate = 0.4;       ///< m/s at full flow
};

/// A hydraulic cylinder between two pivots, and the valve that feeds it.
class HydraulicCylinder {
 public:
  /// Starts in the middle of the stroke.
  explicit HydraulicCylinder(const CylinderShape& shape);

  /// A `command` above 0 opens the joint; `flow` is the share of the greatest flow of the pump.
  void step(double command, double flow, double seconds);
  double angle() const { return angle_; }  ///< degrees
  /// Length of the cylinder, in metres.
  double length() const { return length_; }
  /// Degrees per second in the last step.
  double speed() const { return speed_; }

 private:
  double length_of(double angle) const;
  double angle_of(double length) const;

  CylinderShape shape_;
  ValveSpool spool_;
  double shortest_ = 0;
  double longest_ = 0;
  double length_ = 0;
  double angle_ = 0;
  double speed_ = 0;
};

/// A movement that a valve drives.
enum class Movement : std::uint8_t { slew, stick, boom, bucket, left_track, right_track, rotator };
/// Number of movements.
inline constexpr std::size_t movements = static_cast<std::size_t>(Movement::rotator) + 1;

class Excavator {
 public:
  /// A point in the plane of boom and stick.
  struct Point {
    double x = 0;  ///< m in front of the axis of the slew
    double z = 0;  ///< m above the ground
  };
  /// Earth, in m3: in the bucket, on the heap, or spilled elsewhere.
  struct Earth {
    double dug = 0;        ///< taken up since the start
    double in_bucket = 0;  ///< at present
    double heaped = 0;     ///< dumped on the heap
    double spilled = 0;    ///< dumped or lost elsewhere
  };

  static constexpr double bucket_capacity = 1.2;  ///< m3, heaped
  /// Share of its capacity that a bucket takes of stony earth at least, and of loose earth at most.
  static constexpr double fill_least = 0.7;
  static constexpr double fill_most = 1;        ///< all of it
  static constexpr double earth_of_place = 40;  ///< m3 to dig before it has to drive on
  static constexpr double heap_at = 80;         ///< degrees of the slew
  static constexpr double heap_width = 20;      ///< degrees to either side
  static constexpr double tank_litres = 400;    ///< of fuel, when full
  static constexpr double hot = 80;             ///< degC of the oil

  /// The seed of the soil determines how full each bucket gets.
  explicit Excavator(std::uint64_t soil = 1) : soil_(soil) { draw_fill(); }

  // Inputs from its wiring.

  /// -1 to 1.
  void command(Movement movement, double value) { commands_[index(movement)] = value; }
  /// Engine speed, 0 to 1: from idle to full speed.
  void set_throttle(double share) { throttle_ = share; }
  /// As set last.
  double throttle() const { return throttle_; }
  /// Opens or closes the pilot valve: without pressure, no valve opens.
  void set_pilot_pressure(bool is_on) { has_pilot_pressure_ = is_on; }
  /// Selects the speed range of the tracks.
  void set_fast_travel(bool is_fast) { is_fast_ = is_fast; }
  /// Fills the tank.
  void refuel() { litres_ = tank_litres; }
  /// Makes a hole in the bucket: nothing stays in it.
  void pierce_bucket() { has_hole_ = true; }

  /// Advances the machine by this time, in which its commands stay as they are.
  void step(double seconds);

  // What can be seen of it.

  double angle(Movement movement) const;  ///< degrees; of a track, m
  /// Share of the greatest speed of the movement, -1 to 1, in the last step.
  double speed(Movement movement) const { return speeds_[index(movement)]; }
  /// Position of the tip of the bucket.
  Point tip() const;
  /// Position of the tip at these angles.
  static Point tip_at(double boom, double stick, double bucket);
  Point joint(Movement movement) const;  ///< position of the hinge of boom, stick or bucket
  /// Where the earth is.
  const Earth& earth() const { return earth_; }
  double earth_left() const { return left_here_; }  ///< m3 within reach
  /// True while the pilot valve is open.
  bool has_pilot_pressure() const { return has_pilot_pressure_; }
  /// True in the fast range of the tracks.
  bool is_fast() const { return is_fast_; }
  /// Speed of the engine, in revolutions per minute.
  double rpm() const { return rpm_; }
  /// Fuel left, in litres.
  double litres() const { return litres_; }
  /// Temperature of the hydraulic oil.
  double oil_celsius() const { return oil_; }
  /// Pressure of the pump.
  double pressure_bar() const { return pressure_; }

 private:
  static constexpr std::size_t index(Movement movement) {
    return static_cast<std::size_t>(movement);
  }
  double wanted(Movement movement) const {
    return has_pilot_pressure_ ? commands_[index(movement)] : 0;
  }
  void step_engine(double seconds);
  void step_cylinder(HydraulicCylinder& cylinder, Movement movement, double seconds);
  void step_turns(double seconds);
  void step_earth(const Point& before, double seconds);
  bool is_over_heap() const;
  void draw_fill();

  std::array<double, movements> commands_{};
  std::array<double, movements> speeds_{};
  HydraulicCylinder boom_{{.near_metres = 1.8,
                           .far_metres = 2.3,
                           .at_zero = -90,
                           .direction = 1,
                           .lowest = -45,
                           .highest = 60,
                           .rate = 0.35}};
  HydraulicCylinder stick_{{.near_metres = 0.9,
                            .far_metres = 2.6,
                            .at_zero = 5,
                            .direction = -1,
                            .lowest = -145,
                            .highest = -35,
                            .rate = 0.4}};
  HydraulicCylinder bucket_{{.near_metres = 0.7,
                             .far_metres = 0.75,
                             .at_zero = 40,
                             .direction = -1,
                             .lowest = -100,
                             .highest = 10,
                             .rate = 0.4}};
  std::array<ValveSpool, movements> spools_;  ///< of slew, tracks and rotator
  double slew_ = 0;
  double rotator_ = 0;
  std::array<double, 2> tracks_{};
  double driven_ = 0;  ///< m driven since the bucket had earth of another place
  double left_here_ = earth_of_place;
  Earth earth_;
  Random soil_;
  double room_ = 0;  ///< m3 that the bucket takes this time
  bool has_pilot_pressure_ = false;
  bool is_fast_ = false;
  bool has_hole_ = false;
  double throttle_ = 0;
  double rpm_ = 0;
  double litres_ = 0.2 * tank_litres;
  double oil_ = 20;
  double pressure_ = 0;
};

}  // namespace canvoy
