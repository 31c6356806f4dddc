// A hydraulic cylinder between two pivots, and the valve that feeds it: dead band and lag of the
// spool, rate of the pump, ends of the stroke, and the angle of the joint by the law of cosines.
//
//     HydraulicCylinder boom({.near_metres = 1.8, .far_metres = 2.3, ...});
//     boom.step(command, flow, 0.02);     // command -1 to 1
//     boom.angle();                       // degrees
#pragma once

namespace canvoy {

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

}  // namespace canvoy
