// The driver of the car of an IVN gateway that `canvoy device` runs: sets ignition, engine, lever,
// brakes and locks as needed when the car drives (CiA 447-3, 4.2.2 to 4.2.4).
//
//     driver.take(gateway);
//     driver.get_ready();              // it is to drive
//     if (driver.missing().empty()) ...
//     driver.follow(13.9, false);      // it drives, and does not brake
//
// The driver does not change what was set by hand; the car may then be unable to drive.
#pragma once

#include <string>
#include <vector>

#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"

namespace canvoy::tools {

class CarDriver {
 public:
  /// Sets the gateway, which must outlive the calls of this. Without a gateway, nothing is needed.
  void take(cia447::IvnGatewayUnit& gateway) { gateway_ = &gateway; }
  void set_by_hand(const cia447::FieldPlace& status);

  /// Sets key, engine, belt, locks, lever and parking brake, as far as needed.
  void get_ready();
  /// Reason why the car cannot drive; empty: it can.
  std::string missing() const;
  /// Sets gear, brake light and engine for this speed (m/s), and for braking or not.
  void follow(double speed, bool is_braking);

  double engine_revolutions() const { return revolutions_; }
  /// In litres per second.
  double fuel_consumption() const;

 private:
  template <class Handle, class State>
  void say(const Handle& status, State state);
  bool is_by_hand(const cia447::FieldPlace& status) const;
  bool runs() const;

  cia447::IvnGatewayUnit* gateway_ = nullptr;
  std::vector<cia447::FieldPlace> by_hand_;
  bool is_ready_ = false;
  double speed_ = 0;
  double revolutions_ = 0;
};

}  // namespace canvoy::tools
