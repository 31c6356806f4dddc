// The passenger counter of a door of a bus and the counting manager (CiA 407) that `canvoy device`
// runs: people who get in and out, and the capacity.
//
//     BusCounting counting({.door = 2, .capacity = 80, .kept = kept.counts});
//     counting.join(environment);
//     counting.act(parse_bus_press(units, "in:3@2s"));
#pragma once

#include <optional>

#include "canvoy/devices/cia407/counting/counting_manager_unit.hpp"
#include "canvoy/devices/cia407/counting/passenger_counter_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class BusCounting {
 public:
  using Counts = cia407::CountingManagerUnit::Counts;
  struct Settings {
    unsigned door = 1;       ///< of the counter, 1 to 12
    unsigned capacity = 80;  ///< of the vehicle, in passengers
    Counts kept{};           ///< before the last power-down
  };

  explicit BusCounting(const Settings& settings) : settings_(settings) {}
  BusCounting(const BusCounting&) = delete;
  BusCounting& operator=(const BusCounting&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `in`, `out`, `open-door`, `close-door` and `clear`, which need the device; ignores
  /// others.
  void act(const BusPress& press);

  /// The counts; nothing without a counting manager.
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
