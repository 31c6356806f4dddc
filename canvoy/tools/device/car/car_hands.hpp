// Actions by hand on the devices of CiA 447 of one node, with their times: from the command line,
// or from lines read at run time.
//
//     CarHands hands(units, {.car = &car}, output);
//     hands.join(environment);
//     hands.take("hire@10s");
//     hands.step(node, now);   // often
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"
#include "canvoy/tools/device/hand/hand_order.hpp"

namespace canvoy::tools {

/// One table for each unit.
std::vector<HandTable> hand_tables(std::span<const cia447::CarUnit* const> units);

class CarHands {
 public:
  /// `around` is what hands act on beside the units. All arguments must outlive this.
  CarHands(std::span<const cia447::CarUnit* const> units, const HandTarget& around,
           const DeviceOutput& output);
  CarHands(const CarHands&) = delete;
  CarHands& operator=(const CarHands&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// True if one of the devices has a hand of this name.
  bool has(std::string_view order) const { return orders_.has(order); }
  /// Adds a hand with a time. Throws like HandOrders::take().
  void take(std::string_view order) { orders_.take(order); }
  /// Performs what is due. Times count from the first call.
  void step(Node& node, Time now);

  /// The unit of a kind; null: none.
  template <class Kind>
  typename Kind::Unit* unit() const {
    const auto found = made_.find(Kind::info.name);
    return found == made_.end() ? nullptr : static_cast<typename Kind::Unit*>(found->second);
  }

 private:
  template <class Kind>
  void watch(Environment& environment);
  template <class Kind>
  void has(typename Kind::Unit& unit, Node& node);
  void act(const HandOrder& order, Time now);

  std::vector<const cia447::CarUnit*> units_;
  HandTarget around_;
  const DeviceOutput& output_;
  std::map<std::string_view, void*> made_;  ///< units by name
  HandOrders orders_;
};

}  // namespace canvoy::tools
