// A referee between a charger and a battery: it listens to the bus, has the true current, and
// measures for how long current flowed without an agreement of both (CiA 419, 4.1, 5.2, 6.2 and
// 7.2).
//
//     HandshakeMonitor monitor(rules);
//     monitor.on_frame(now, frame);                 // for each frame on the bus
//     monitor.on_set_point(ampere);                 // whenever the power stage is told something
//     monitor.on_step(now, pilot_signal, ampere);   // for each step of the plant
//     if (monitor.outside_max() > bound) ...
//
// It is no part of the charger: what was not on the bus does not count.
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"

namespace canvoy::charger {

/// Terms between the two nodes.
struct HandshakeRules {
  NodeId charger = 0;  ///< node-ID of the charger
  NodeId battery = 0;  ///< node-ID of the battery
  /// CAN-IDs of the battery's TPDOs 1 to 3 (6010h and 6000h; the same and 6060h; 6070h and 6081h).
  std::array<std::uint32_t, 3> battery_tpdos{};
  /// CAN-IDs of the charger's TPDOs 1 to 3: all begin with 6001h.
  std::array<std::uint32_t, 3> charger_tpdos{};
  Duration heartbeat_time{};  ///< a battery that is silent for longer is lost
  Duration data_time{};       ///< its process data are invalid after this time
  bool has_request = true;    ///< the battery sends TPDO 3, without which nothing may flow
};

class HandshakeMonitor {
 public:
  /// Both are unknown until they are heard.
  explicit HandshakeMonitor(const HandshakeRules& rules) : rules_(rules) {}

  /// Takes each frame of the bus.
  void on_frame(Time now, const Frame& frame);
  /// Call it when the power stage receives a set-point.
  void on_set_point(double ampere);
  /// `ampere` is the true current during the last step.
  void on_step(Time now, bool pilot_signal, double ampere);

  /// Longest time without interruption in which current flowed without a handshake; 0 where it
  /// never did.
  Duration outside_max() const { return outside_max_; }
  /// Number of times that current began before the charger had reported on the bus that it was
  /// ready (CiA 419, 7.2.2).
  unsigned begun_before_ready() const { return begun_before_ready_; }
  /// Number of times that a current began.
  std::uint64_t begun() const { return begun_; }
  /// Number of steps with current.
  std::uint64_t steps_with_current() const { return steps_with_current_; }
  /// True if both are ready and operational, and were heard in time.
  bool is_valid(Time now) const { return flags_valid() && now < deadline(); }

 private:
  bool flags_valid() const;
  Time deadline() const;
  void note_validity(Time now);
  void hear_nmt_command(const Frame& frame);
  void hear_error_control(Time now, NodeId node, const Frame& frame);
  void hear_battery_pdo(Time now, const Frame& frame, bool carries_status);
  void hear_charger_pdo(const Frame& frame);

  HandshakeRules rules_;
  NmtState battery_state_ = NmtState::initialisation;
  NmtState charger_state_ = NmtState::initialisation;
  bool battery_ready_ = false;
  bool charger_ready_ = false;
  bool pilot_signal_ = false;
  Time heard_battery_at_ = Time::min();
  Time status_at_ = Time::min();
  Time request_at_ = Time::min();
  Time valid_until_{};
  Time no_current_until_{};
  Duration outside_max_{0};
  double set_point_ampere_ = 0;
  unsigned begun_before_ready_ = 0;
  std::uint64_t begun_ = 0;
  std::uint64_t steps_with_current_ = 0;
};

}  // namespace canvoy::charger
