// What the door, the light barrier and the load cell of a lift car sense that `canvoy device` runs,
// as the command line says: who stands in the door, and what the people in the car weigh.
//
//     LiftUnits units({.in_door = {"20s+5s"}, .loads = {"300@10s"}});
//     units.join(site);
//     units.step(now);   // often
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/devices/site.hpp"
#include "canvoy/sim/lift/door_plant.hpp"
#include "canvoy/sim/lift/load_cell.hpp"
#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

struct LiftUnitOptions {
  std::vector<std::string> in_door{};  ///< `20s+5s`: somebody stands in it, and for how long
  std::vector<std::string> loads{};    ///< `300@10s`: kg, and from when on
};

void add_lift_unit_options(Verb& command, LiftUnitOptions& options);

/// The units of one process are at the same car.
class LiftUnits {
 public:
  /// Throws UsageError.
  explicit LiftUnits(const LiftUnitOptions& options);
  LiftUnits(const LiftUnits&) = delete;
  LiftUnits& operator=(const LiftUnits&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// Does what is due. Times count from the first call.
  void step(Time now);

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
  std::vector<std::function<void()>> look_again_;  ///< of each device that senses
};

}  // namespace canvoy::tools
