// The load of a car for its lift controller, from the load measuring unit: 6482h, by PDO (CiA
// 417-4, 4.12.3).
//
//     LoadSignals load(node, heartbeats, {.load_unit = 13});
//     load.on_change(Callback<void()>::to<&LiftController::update>(lift));
//     load.now().overload
#pragma once

#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/pdo/rpdo.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/lift/lift_bound.hpp"
#include "canvoy/profiles/cia417/car_handles.hpp"

namespace canvoy::cia417 {

/// The lift, and its load measuring unit.
struct LoadSignalsSettings {
  unsigned lift = 1;      ///< 1 to 8
  NodeId load_unit = 13;  ///< 0: none; the car is neither empty nor full
};

/// The load is known from the first PDO on, which is requested by remote frame. The last value is
/// discarded when the unit is lost (1016h) or restarts: the load is then requested every second
/// until the unit answers. An overload, for which a lift waits, is requested as long as it lasts.
class LoadSignals {
 public:
  /// All arguments must outlive this.
  LoadSignals(Node& node, Rpdos& rpdos, HeartbeatConsumer& heartbeats,
              const LoadSignalsSettings& settings);

  /// Sets the callback for each change of now().
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Load as it is known at present.
  LiftLoad now();
  /// Discards the load: the device belongs to another lift (6001h).
  void begin_anew();
  /// Requests the load: PDOs may have been lost (see GapWatch).
  void ask_anew() { ask(); }
  /// Takes a boot-up message or heartbeat of a node.
  void heard(NodeId node, RemoteState state);
  /// For a LiftController; valid as long as this.
  Callback<LiftLoad()> interface() { return callback<&LoadSignals::now>(*this); }

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
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this, block_shift(settings_.lift)};
  Timer timer_;
};

}  // namespace canvoy::cia417
