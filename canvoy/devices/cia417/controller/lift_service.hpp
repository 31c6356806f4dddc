// The service that a lift is in: which one its keys ask for, which calls that answers, and what it
// does with the doors. What a service does is in docs/decisions/lift.md: the profile names them and
// leaves the rest to the maker.
//
//     LiftServiceState service;
//     service.change(service.wanted(calls, is_at_fire_floor));
//     calls.accept(service.accepted());
#pragma once

#include <cstdint>

#include "canvoy/devices/cia417/call/call_controller.hpp"

namespace canvoy::cia417 {

/// In the order of what goes before what.
enum class LiftService : std::uint8_t {
  normal,
  attendant,  ///< doors close when the attendant says so
  vip,        ///< car calls only, and so for the next two
  bed_passenger,
  special,
  dogging,       ///< by two buttons, slowly
  service_run,   ///< the same for who maintains it
  fire_brigade,  ///< car calls only, doors by their buttons alone
  fire_recall,   ///< to the fire floor, and out
  out_of_order,
};

class LiftServiceState {
 public:
  void begin_anew() { *this = {}; }

  LiftService now() const { return now_; }
  bool is(LiftService service) const { return now_ == service; }
  bool is_in_fire() const { return is(LiftService::fire_recall) || is(LiftService::fire_brigade); }
  /// Driven by buttons.
  bool is_manual() const { return is(LiftService::service_run) || is(LiftService::dogging); }
  /// One passenger has the car for himself.
  bool is_occupied() const { return is(LiftService::vip) || is(LiftService::bed_passenger); }

  /// That which the keys of `calls` ask for. Fire service ends at the fire floor only.
  LiftService wanted(const CallController& calls, bool is_at_fire_floor) const;
  /// False: it is in that one already.
  bool change(LiftService service);

  /// Others are refused.
  CallKinds accepted() const;

  /// In recall or out of order: everybody could get out.
  bool is_cleared() const { return is_cleared_; }
  /// Its doors are open, at a floor at which the service lets everybody out. True: that is news.
  bool clear(bool is_at_fire_floor);

  bool keeps_doors_open(const CallController& calls, bool is_at_fire_floor) const;
  /// Light barriers and motion detectors see smoke as well as people (EN 81-73, 5.3; EN 81-72).
  bool distrusts_barriers() const { return is_in_fire(); }
  /// The button for door open is obeyed.
  bool has_door_button() const {
    return !is(LiftService::fire_recall) && !is(LiftService::out_of_order);
  }

 private:
  LiftService now_ = LiftService::normal;
  bool is_cleared_ = false;
};

}  // namespace canvoy::cia417
