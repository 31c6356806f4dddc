// TIME: the time of day that one node sends to the others; consumer and producer (CiA 301, 7.2.6
// and object 1012h).
//
//     TimeStamp time_stamp(node);
//     time_stamp.on_time(Callback<void(const TimeOfDay&, Duration)>::to<&App::corrected>(app));
//     time_stamp.set_clock({.milliseconds = 43'200'000, .days = 15'665});
//     time_stamp.produce_each(60s);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy {

/// Keeps a clock, which is set by the application, and by each TIME if 1012h makes the node a
/// consumer (bit 31). If 1012h makes it a producer (bit 30), it sends that clock periodically and
/// when the application requests it; CiA 301 has no object for the period.
///
/// It works in NMT states pre-operational and operational. A TIME with a length other than 6 bytes
/// or beyond midnight is ignored and counted. The clock continues through NMT resets.
class TimeStamp {
 public:
  /// Attaches to the node, which needs a route. Without 1012h it neither consumes nor produces.
  explicit TimeStamp(Node& node);
  TimeStamp(const TimeStamp&) = delete;
  TimeStamp& operator=(const TimeStamp&) = delete;

  /// Sets the callback for each TIME that was consumed, with the distance by which it moved the
  /// clock ahead (back if negative): zero at the first.
  void on_time(Callback<void(const TimeOfDay&, Duration)> heard) { heard_ = heard; }

  /// Sets the clock to `time` at Node::now(). False if that is not a time of day.
  bool set_clock(const TimeOfDay& time);
  /// Time of the clock at `at`; nothing before the clock is set, and after the last day that 16
  /// bits can count.
  std::optional<TimeOfDay> clock(Time at) const;

  /// Sends the present time at once, or as soon as the controller takes it. False if the node is
  /// not a producer, may not send in its NMT state, or has no clock.
  bool send();
  /// Sends the time every `period`, the first time after one period, without drift; zero ends it.
  /// The setting survives NMT resets.
  void produce_each(Duration period);

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void after_write(const Entry& entry, Source source);
  void read_parameter();
  void listen();
  void restart();
  void schedule(Time previous);
  void expired(Time now);
  void tx_ready();
  void receive(const Frame& frame, Time now);
  bool usable() const;
  bool is_producer() const { return (cob_id_.raw & CobId::bit30) != 0 && usable(); }

  Node& node_;
  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Callback<void(const TimeOfDay&, Duration)> heard_;
  Time due_{};           ///< time of the next TIME produced
  Duration period_{};    ///< zero: on demand only
  Duration midnight_{};  ///< midnight of day 0, in the time of the node; valid if has_clock_
  CobId cob_id_{can_id::time};
  std::uint16_t can_id_ = 0;  ///< that the node listens to; 0: none
  bool running_ = false;      ///< in NMT state pre-operational or operational
  bool has_clock_ = false;
  bool waits_ = false;  ///< for room in the controller
};

}  // namespace canvoy
