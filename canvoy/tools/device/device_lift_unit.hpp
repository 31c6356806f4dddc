// Sensor values of the door, the light barrier and the load cell of a lift car that `canvoy device`
// runs, from the command line: people in the door, and the load of the car.
//
//     LiftUnits units({.in_door = {"20s+5s"}, .loads = {"300@10s"}});
//     units.join(environment);
//     units.step(now);   // often
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/cli/verb.hpp"
#include "canvoy/worlds/lift/door_plant.hpp"
#include "canvoy/worlds/lift/load_cell.hpp"

namespace canvoy::tools {

struct LiftUnitOptions {
  std::vector<std::string> in_door{};  ///< `20s+5s`: start and duration of a person in the door
  std::vector<std::string> loads{};    ///< `300@10s`: kg and start time
};

inline constexpr double lift_load_kg_max = 50'000;

void add_lift_unit_options(Verb& command, LiftUnitOptions& options);

/// The units of one process belong to the same car.
class LiftUnits {
 public:
  /// Throws UsageError.
  explicit LiftUnits(const LiftUnitOptions& options);
  LiftUnits(const LiftUnits&) = delete;
  LiftUnits& operator=(const LiftUnits&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs what is due. Times count from the first call.
  void step(Time now);
  lift::DoorPlant& door() { return door_; }
  lift::LoadCell& cell() { return cell_; }
  /// Makes all units read their changed sensors.
  void look();

 private:
  struct Happening {
    Duration at{};
    std::function<void(Time)> happen{};
  };
  void plan_in_door(const std::string& text);
  void plan_load(const std::string& text);
  cia417::LoadSettings load_settings();
  template <class Unit>
  void is_there(Unit& unit, Node& node);

  lift::DoorPlant door_;
  lift::LoadCell cell_;
  std::vector<Happening> plan_;
  std::size_t done_ = 0;
  std::optional<Time> begin_{};
  std::vector<std::function<void()>> look_again_;  ///< one function for each device with sensors
};

}  // namespace canvoy::tools
