// Who sits in the car of an IVN gateway that `canvoy device` runs: ignition, engine, lever, brakes
// and locks are as they must be where the car drives (CiA 447-3, 4.2.2 to 4.2.4).
//
//     driver.take(gateway);
//     driver.get_ready();              // it is to drive
//     if (driver.missing().empty()) ...
//     driver.follow(13.9, false);      // it drives, and does not brake
//
// What somebody has set by hand the driver leaves alone: then it may be that the car cannot drive.
#pragma once

#include <string>
#include <vector>

#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"

namespace canvoy::tools {

class CarDriver {
 public:
  /// Without a gateway nobody is asked, and nothing is missing. It must outlive the calls of this.
  void take(cia447::IvnGatewayUnit& gateway) { gateway_ = &gateway; }
  void set_by_hand(const cia447::FieldPlace& status);

  /// Key, engine, belt, locks, lever, parking brake; what is so already stays.
  void get_ready();
  /// Why the car cannot drive; empty: it can.
  std::string missing() const;
  /// The car drives so fast (m/s), and slows down or not: gear, brake light, engine.
  void follow(double speed, bool is_braking);

  double engine_revolutions() const { return revolutions_; }
  /// Litres a second.
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
