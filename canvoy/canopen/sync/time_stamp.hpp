// TIME: the time of day that one node tells the others; consumer and producer (CiA 301, 7.2.6 and
// object 1012h).
//
//     TimeStamp time_stamp(node);
//     time_stamp.on_time(Callback<void(const TimeOfDay&, Duration)>::to<&App::corrected>(app));
//     time_stamp.set_clock({.milliseconds = 43'200'000, .days = 15'665});
//     time_stamp.produce_each(60s);
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy {

/// It keeps a clock: set by the application, and by each TIME where 1012h makes the node a
/// consumer (bit 31). Where 1012h makes it a producer (bit 30) it tells that clock, in the rhythm
/// that the application wants and whenever the application says so; CiA 301 has no object for it.
///
/// It works in NMT states pre-operational and operational. A TIME of another length than 6 bytes or
/// beyond midnight is ignored and counted. The clock goes on through NMT resets.
class TimeStamp {
 public:
  explicit TimeStamp(Node& node);
  TimeStamp(const TimeStamp&) = delete;
  TimeStamp& operator=(const TimeStamp&) = delete;

  /// Called for each TIME that was consumed, with how far it moved the clock ahead (back where
  /// negative): zero at the first.
  void on_time(Callback<void(const TimeOfDay&, Duration)> heard) { heard_ = heard; }

  /// It is `time` now, at Node::now(). False where that is no time of day.
  bool set_clock(const TimeOfDay& time);
  /// What the clock shows at `at`; nothing while nobody has set it, and after the last day that 16
  /// bits can count.
  std::optional<TimeOfDay> clock(Time at) const;

  /// Tells the time now, or as soon as the controller takes it. False where the node is no
  /// producer, may not send in its NMT state, or has no clock.
  bool send();
  /// Tells it each `period`, the first time after one, without drift; zero ends it. It holds
  /// through NMT resets.
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
  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  Callback<void(const TimeOfDay&, Duration)> heard_;
  Time due_{};           ///< of the next TIME that is produced
  Duration period_{};    ///< zero: on demand only
  Duration midnight_{};  ///< of day 0, in the time of the node; holds where has_clock_
  CobId cob_id_{can_id::time};
  std::uint16_t can_id_ = 0;  ///< that is listened to; 0: none
  bool running_ = false;      ///< in NMT state pre-operational or operational
  bool has_clock_ = false;
  bool waits_ = false;  ///< to be sent when the controller has room
};

}  // namespace canvoy
