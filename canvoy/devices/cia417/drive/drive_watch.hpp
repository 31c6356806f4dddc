// Monitors the car of a drive: its speed, its standstill with the closed brake, and its following
// of the control loop (CiA 417-4, 4.11; CiA 402, following error).
//
//     DriveWatch watch({.overspeed_percent = 115});
//     if (watch.is_too_fast(car, parameters)) ...
#pragma once

#include <bitset>
#include <span>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/drive/driven_car.hpp"

namespace canvoy::cia417 {

/// The nodes that hold a drive: they report overspeed (FF05h) or unintended car movement (FF06h;
/// CiA 417-4, 4.11). Each holds it until it has no error any more, or boots.
///
///     DriveHold hold(node, emergency_consumer, held);
///     if (hold.is_held()) ...
class DriveHold {
 public:
  /// `emergencies` may be null: then none are received. Beside the nodes of 1028h, those of `more`
  /// are received. `held` is called each time that a node reports one of the two.
  DriveHold(Node& node, EmergencyConsumer* emergencies, std::span<const NodeId> more,
            Callback<void()> held);
  DriveHold(const DriveHold&) = delete;
  DriveHold& operator=(const DriveHold&) = delete;

  /// True while a node holds the drive.
  bool is_held() const { return holders_.any(); }
  /// Releases all nodes: those that have reported an error may have restarted without reporting its
  /// end.
  void release_all();

 private:
  void emergency_heard(NodeId node_id, const Emergency& emergency);
  void error_control_heard(const Frame& frame, Time now);
  void hold_for(NodeId node_id);
  void release(NodeId node_id);

  Node& node_;
  Callback<void()> held_;
  std::bitset<node_id_max + 1> holders_;
};

/// Widths are units of position.
struct DriveWatchLimits {
  double overspeed_percent = 115;   ///< of 6408h:01h
  double unintended_distance = 50;  ///< while it has to stand
  double following_window = 200;    ///< from the demanded position
  Duration following_time = 200ms;  ///< beyond the window: a fault
};

class DriveWatch {
 public:
  /// Makes a watch; nothing has lagged so far.
  explicit DriveWatch(const DriveWatchLimits& limits) : limits_(limits) {}

  /// Starts again, after a reset.
  void begin_anew() { behind_.begin_anew(); }
  /// True above the limit of overspeed.
  bool is_too_fast(const DrivenCar& car, const DriveParameters& parameters) const;
  /// True if it stood with the closed brake, and moves.
  bool strays(const DrivenCar& car, const DriveParameters& parameters) const;
  /// True if it lags for longer than allowed. Call it every period.
  bool lags_behind(const DrivenCar& car, const DriveParameters& parameters, Time now);

 private:
  DriveWatchLimits limits_;
  Lasting behind_;
};

}  // namespace canvoy::cia417
