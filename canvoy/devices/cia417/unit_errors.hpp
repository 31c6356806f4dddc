// What the units of a lift tell of themselves by emergency messages, as its controller sees it: a
// unit that tells of an error is not relied on until the error is gone (CiA 301, 7.2.7 and 1028h;
// the codes are those of CiA 417-1).
//
//     UnitErrors errors(node, emergency_consumer, client, {.drive = 2, .position_unit = 4});
//     LiftController lift(node, calls, errors.guard({drive.interface(), doors.interface()}), ...);
//     errors.on_change(Callback<void()>::to<&LiftController::update>(lift));
//
// An error of drive or position unit makes the motion unavailable, so that a moving car stops fast
// and a standing one does not start; one of a door unit makes its door faulty, one of a light
// barrier unit its doors unprotected, and one of the load unit the load unknown. What concerns no
// trip is not held: concerns_trips().
//
// An error is gone when its unit says so with an empty error register, boots, or is lost: what is
// lost counts by that already. After a loss without a boot-up, a sign of lost frames (ask_anew()),
// and when this node itself starts, a unit may have an error that nobody heard of: its error
// register 1001h is read. That of a unit with an error is read again as long as the error lasts:
// its end may not have been heard.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/canopen/emergency/emergency_consumer.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/controller/lift_units.hpp"

namespace canvoy::cia417 {

/// Whether a lift must not travel while a unit has this error. Voltages of the mains and inside
/// (31xxh, 32xxh), the state of the bus (0010h, 81xxh, 82xxh) and detectors of doors (FF01h to
/// FF03h) let it: what they mean for a trip is known from heartbeats, PDOs and doors.
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
  /// All must outlive this. `client` reads error registers, where there is no error those of
  /// position and load unit alone: what drives and doors have is in their statuswords.
  UnitErrors(Node& node, EmergencyConsumer& emergencies, SdoClient& client, const LiftUnits& units);
  UnitErrors(const UnitErrors&) = delete;
  UnitErrors& operator=(const UnitErrors&) = delete;

  /// Called when a unit has an error, or has none any more.
  void on_change(Callback<void()> changed) { changed_ = changed; }
  /// Called for each emergency message, first.
  void on_emergency(Callback<void(NodeId, const Emergency&)> told) { told_ = told; }
  bool has_error(NodeId unit) const { return errors_[unit]; }
  /// Of those that 1028h names.
  bool has_any_error() const { return errors_.any(); }
  /// The boot-up message of a node was heard: it begins without errors.
  void booted(NodeId unit) { set(unit, false); }
  /// Emergency messages may have been lost (see GapWatch).
  void ask_anew();

  /// `parts` as they are while no unit has an error; valid as long as this. Called once.
  LiftParts guard(const LiftParts& parts);

 private:
  void reset(ResetScope scope);
  void state_entered(NmtState state);
  void error_changed(const Error& error, bool present);
  void heard(NodeId unit, const Emergency& emergency);
  void set(NodeId unit, bool has_error);
  /// For its error register.
  struct Question {
    NodeId unit = 0;
    std::uint8_t left = 0;  ///< so often it is still to be asked
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
  std::array<Question, 3> questions_;  ///< to position unit, load unit, and one with an error
  Question* asking_ = &questions_.back();
  std::array<std::uint8_t, 1> register_{};
  Callback<void()> changed_;
  Callback<void(NodeId, const Emergency&)> told_;
  static const ServiceCalls service_calls;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  Timer again_timer_;
};

}  // namespace canvoy::cia417
