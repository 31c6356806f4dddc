// What a lift controller knows of the load of its car, from the load measuring unit: 6482h, by PDO
// (CiA 417-4, 4.12.3).
//
//     LoadSignals load(node, heartbeats, {.load_unit = 13});
//     load.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     load.now().overload
#pragma once

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_bound.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"

namespace canvoy::cia417 {

struct LoadSignalsSettings {
  unsigned lift = 1;      ///< 1 to 8
  NodeId load_unit = 13;  ///< 0: there is none, and the car is neither empty nor full
};

/// The load is known from the first PDO on, which is asked for by remote frame. What the unit said
/// before it was lost (1016h), or began anew, counts no longer: it is asked again, each second
/// until it answers. An overload, for which a lift waits, is asked for again as long as it lasts.
class LoadSignals {
 public:
  /// All must outlive this.
  LoadSignals(Node& node, Rpdos& rpdos, HeartbeatConsumer& heartbeats,
              const LoadSignalsSettings& settings);
  LoadSignals(const LoadSignals&) = delete;
  LoadSignals& operator=(const LoadSignals&) = delete;

  void on_change(Callback<void()> changed) { changed_ = changed; }
  LiftLoad now();
  /// The device belongs to another lift now (6001h): what it heard was of another car.
  void begin_anew();
  /// PDOs may have been lost (see GapWatch): the unit is asked.
  void ask_anew() { ask(); }
  /// A boot-up message or heartbeat of a node.
  void heard(NodeId node, RemoteState state);
  /// For a LiftController; valid as long as this.
  Callback<LiftLoad()> interface() { return Callback<LiftLoad()>::to<&LoadSignals::now>(*this); }

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void forget();
  void ask();
  void expired(Time now);
  void received();
  void error_changed(const Error& error, bool present);

  Node& node_;
  Rpdos& rpdos_;
  HeartbeatConsumer& heartbeats_;
  LoadSignalsSettings settings_;
  bool is_heard_ = false;
  LiftBound<zero_load_reached> zero_;
  LiftBound<full_load_reached> full_;
  LiftBound<overload_reached> overload_;
  Callback<void()> changed_;
  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
