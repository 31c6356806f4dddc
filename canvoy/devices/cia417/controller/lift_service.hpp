// The service that a lift is in: the one that its keys request, the calls that it answers, and its
// handling of doors. The profile names the services and leaves the rest to the maker:
// docs/decisions/lift.md describes them.
//
//     LiftServiceState service;
//     service.change(service.wanted(calls, is_at_fire_floor));
//     calls.accept(service.accepted());
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/call/call_controller.hpp"

namespace canvoy::cia417 {

/// In ascending order of priority.
enum class LiftService : std::uint8_t {
  normal,
  attendant,  ///< doors close on the attendant's command
  vip,        ///< car calls only, as for the next two
  bed_passenger,
  special,
  fire_brigade,  ///< car calls only, doors only by their buttons
  fire_recall,   ///< to the fire floor, and out
  out_of_order,
  dogging,      ///< by two buttons, slowly
  service_run,  ///< by two buttons, slowly, for maintenance
};

/// Service of a lift, and what follows from it.
class LiftServiceState {
 public:
  /// Returns to the normal service, after a reset.
  void begin_anew() { *this = {}; }

  /// Service at present.
  LiftService now() const { return now_; }
  /// True in this service.
  bool is(LiftService service) const { return now_ == service; }
  /// True in both phases of fire service.
  bool is_in_fire() const { return is(LiftService::fire_recall) || is(LiftService::fire_brigade); }
  /// True if buttons drive the car.
  bool is_manual() const { return is(LiftService::service_run) || is(LiftService::dogging); }
  /// True if one passenger has exclusive use of the car.
  bool is_occupied() const { return is(LiftService::vip) || is(LiftService::bed_passenger); }

  /// The service that the keys of `calls` request. Fire service ends only at the fire floor.
  LiftService wanted(const CallController& calls, bool is_at_fire_floor) const;
  /// False if the lift is already in that service.
  bool change(LiftService service);

  /// Kinds of calls that are accepted; others are refused.
  CallKinds accepted() const;

  /// True in recall or out of order when all passengers could get out.
  bool is_cleared() const { return is_cleared_; }
  /// Reports open doors, at a floor at which the service lets all passengers out. True on a change.
  bool clear(bool is_at_fire_floor);

  /// True if the service has the doors open at rest.
  bool keeps_doors_open(const CallController& calls, bool is_at_fire_floor) const;
  /// True if the doors ignore light barriers and motion detectors, which detect smoke as well as
  /// people (EN 81-73, 5.3; EN 81-72).
  bool distrusts_barriers() const { return is_in_fire(); }
  /// True if the button for door open takes effect.
  bool has_door_button() const {
    return !is(LiftService::fire_recall) && !is(LiftService::out_of_order);
  }

 private:
  LiftService now_ = LiftService::normal;
  bool is_cleared_ = false;
};

}  // namespace canvoy::cia417
