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
#include "canvoy/sim/plants/hydraulic_cylinder.hpp"

namespace canvoy {

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
