// The passenger counter of a door of a bus and the counting manager (CiA 407) that `canvoy device`
// runs: who gets in and out, and how many have room.
//
//     BusCounting counting({.door = 2, .capacity = 80, .kept = kept.counts});
//     counting.join(site);
//     counting.act(parse_bus_press(units, "in:3@2s"));
#pragma once

#include <optional>

#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class BusCounting {
 public:
  using Counts = cia407::CountingManagerUnit::Counts;
  struct Settings {
    unsigned door = 1;       ///< of the counter, 1 to 12
    unsigned capacity = 80;  ///< passengers of the vehicle
    Counts kept{};           ///< before the power went
  };

  explicit BusCounting(const Settings& settings) : settings_(settings) {}
  BusCounting(const BusCounting&) = delete;
  BusCounting& operator=(const BusCounting&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// `in`, `out`, `open-door`, `close-door` and `clear`, which want the device there; others do
  /// nothing.
  void act(const BusPress& press);

  /// Nothing: there is no counting manager.
  std::optional<Counts> counts() const;

 private:
  cia407::PassengerCounterSettings counter_settings() { return {.door = settings_.door}; }
  void is_counter(cia407::PassengerCounterUnit& unit, Node& /*node*/) { counter_ = &unit; }
  cia407::CountingManagerSettings manager_settings() { return {.capacity = settings_.capacity}; }
  void is_manager(cia407::CountingManagerUnit& unit, Node& node);

  Settings settings_;
  cia407::PassengerCounterUnit* counter_ = nullptr;
  cia407::CountingManagerUnit* manager_ = nullptr;
};

}  // namespace canvoy::tools
