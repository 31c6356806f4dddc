// Errors of the units of a lift, from their emergency messages: the controller does not rely on a
// unit that reports an error until the error is gone (CiA 301, 7.2.7 and 1028h; the codes are those
// of CiA 417-1).
//
//     UnitErrors errors(node, emergency_consumer, client, {.drive = 2, .position_unit = 4});
//     LiftController lift(node, calls, errors.guard({drive.interface(), doors.interface()}), ...);
//     errors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//
// An error of drive or position unit makes the motion unavailable, so that a moving car stops fast
// and a standing one does not start; one of a door unit makes its door faulty, one of a light
// barrier unit its doors unprotected, and one of the load unit the load unknown. Errors that do not
// affect trips are not kept: concerns_trips().
//
// An error is gone when its unit reports that with an empty error register, boots, or is lost: a
// loss already counts by itself. After a loss without a boot-up, after a sign of lost frames
// (ask_anew()), and when this node starts, a unit may have an error that was not received: its
// error register 1001h is read. While a unit has an error, its register is read repeatedly, as the
// end may not be received.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/controller/lift_units.hpp"

namespace canvoy::cia417 {

/// True if a lift must not travel while a unit has this error. Voltages of the mains and inside
/// (31xxh, 32xxh), the state of the bus (0010h, 81xxh, 82xxh) and detectors of doors (FF01h to
/// FF03h) do not prevent it: their effect on a trip is known from heartbeats, PDOs and doors.
constexpr bool concerns_trips(std::uint16_t code) {
  switch (code >> 8) {
    case 0x00:
    case 0x31:
    case 0x32:
    case 0x81:
    case 0x82:
      return false;
    default:
      return code < 0xFF01 || code > 0xFF03;
  }
}

class UnitErrors {
 public:
  /// All arguments must outlive this. `client` reads error registers: without an error, those of
  /// position and load unit only, as statuswords have the state of drives and doors.
  UnitErrors(Node& node, EmergencyConsumer& emergencies, SdoClient& client, const LiftUnits& units);

  /// Calls `changed` when a unit gets an error, or has none any more.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Called for each emergency message, before anything else.
  void on_emergency(Callback<void(NodeId, const Emergency&)> told) { told_ = told; }
  /// True if this unit has an error that concerns trips; `unit` is 0 to 127.
  bool has_error(NodeId unit) const { return errors_[unit]; }
  /// True for any unit that 1028h names.
  bool has_any_error() const { return errors_.any(); }
  /// Takes the boot-up message of a node, which starts without errors.
  void booted(NodeId unit) { set(unit, false); }
  /// Call it when emergency messages may have been lost (see GapWatch).
  void ask_anew();

  /// Makes `parts` that are unavailable while their unit has an error; valid as long as this. Call
  /// it once.
  LiftParts guard(const LiftParts& parts);

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void heard(NodeId unit, const Emergency& emergency);
  void set(NodeId unit, bool has_error);
  /// Request of its error register.
  struct Question {
    NodeId unit = 0;
    std::uint8_t left = 0;  ///< remaining number of requests
  };
  void look_again(Time now);
  void ask(NodeId unit);
  void ask_next(Time now);
  void answered(SdoClient::Outcome outcome);

  MotionStatus motion();
  DoorsStatus doors();
  LiftLoad load();

  Node& node_;
  SdoClient& client_;
  LiftUnits units_;
  LiftParts behind_;
  std::bitset<node_id_max + 1> errors_;
  std::array<Question, 3> questions_;  ///< of position unit, load unit, and a unit with an error
  Question* asking_ = &questions_.back();
  std::array<std::uint8_t, 1> register_{};
  Callback<void()> changed_;
  Callback<void(NodeId, const Emergency&)> told_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Timer again_timer_;
};

}  // namespace canvoy::cia417
