// A referee between a charger and a battery: hears the bus, knows the true current, and says for
// how long current flowed although the two had not agreed upon it (CiA 419, 4.1, 5.2, 6.2 and 7.2).
//
//     HandshakeMonitor monitor(rules);
//     monitor.on_frame(now, frame);                 // for each frame on the bus
//     monitor.on_set_point(ampere);                 // whenever the power stage is told something
//     monitor.on_step(now, pilot_signal, ampere);   // for each step of the plant
//     if (monitor.outside_max() > bound) ...
//
// It has no part in the charger: what was not on the bus does not count.
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/time.hpp"
#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/canopen/nmt/nmt.hpp"

namespace canvoy::charging {

/// What was agreed upon between the two nodes.
struct HandshakeRules {
  NodeId charger = 0;
  NodeId battery = 0;
  /// CAN-IDs of the battery's TPDOs 1 to 3 (6010h and 6000h; the same and 6060h; 6070h and 6081h).
  std::array<std::uint32_t, 3> battery_tpdos{};
  /// CAN-IDs of the charger's TPDOs 1 to 3: all begin with 6001h.
  std::array<std::uint32_t, 3> charger_tpdos{};
  Duration heartbeat_time{};  ///< a battery that was not heard for so long is lost
  Duration data_time{};       ///< its process data that was not renewed for so long is void
};

class HandshakeMonitor {
 public:
  explicit HandshakeMonitor(const HandshakeRules& rules) : rules_(rules) {}

  void on_frame(Time now, const Frame& frame);
  /// The power stage was told, just now, to deliver so much.
  void on_set_point(double ampere);
  /// `ampere` really flowed during the last step.
  void on_step(Time now, bool pilot_signal, double ampere);

  /// The longest time that current flowed without a handshake, at a stretch; 0 where it never did.
  Duration outside_max() const { return outside_max_; }
  /// How often current began although the charger had not said on the bus that it was ready (CiA
  /// 419, 7.2.2).
  unsigned begun_before_ready() const { return begun_before_ready_; }
  /// How often a current began at all.
  std::uint64_t begun() const { return begun_; }
  /// Steps in which one flowed.
  std::uint64_t steps_with_current() const { return steps_with_current_; }
  /// Both are ready and operational, and have been heard of in time.
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

}  // namespace canvoy::charging
