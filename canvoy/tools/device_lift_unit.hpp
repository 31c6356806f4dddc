// What `canvoy device lift-door`, `lift-light-barrier`, `lift-load` and `lift-controller` run:
// units of a lift (CiA 417-4) that are at its car, and its controller. What they sense, the command
// line says: who stands in the door, and what the people in the car weigh.
//
//     LiftUnits units({.in_door = {"20s+5s"}, .loads = {"300@10s"}});
//     LiftDevice door = units.make("lift-door", 6, port);
//     door.node->start(now);
//     units.step(now);   // often
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/sim/lift/door_plant.hpp"
#include "canvoy/sim/lift/load_cell.hpp"
#include "canvoy/tools/device_lift_car.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

struct LiftUnitOptions {
  unsigned door = 1;                   ///< 1 to 4: that a unit moves, or a light barrier watches
  unsigned floors = 10;                ///< of a controller, 3.5 m each
  std::vector<std::string> in_door{};  ///< `20s+5s`: somebody stands in it, and for how long
  std::vector<std::string> loads{};    ///< `300@10s`: kg, and from when on
};

/// The recommended node-ID of a kind; 0 where it is none of these. Of a door and its light barrier
/// it goes by the number of the door.
NodeId lift_unit_node_id(std::string_view kind, unsigned door);
inline constexpr std::string_view lift_controller_kind = "lift-controller";

void add_lift_unit_options(CLI::App& command, LiftUnitOptions& options);

/// The units of one process are at the same car.
class LiftUnits {
 public:
  /// Throws UsageError.
  explicit LiftUnits(const LiftUnitOptions& options);
  LiftUnits(const LiftUnits&) = delete;
  LiftUnits& operator=(const LiftUnits&) = delete;

  /// `kind` is one of these. This must outlive the device.
  LiftDevice make(std::string_view kind, NodeId id, const Port& port);
  /// Does what is due. Times count from the first call.
  void step(Time now);

 private:
  struct Happening {
    Duration at{};
    std::function<void(Time)> happen{};
  };
  void plan_in_door(const std::string& text);
  void plan_load(const std::string& text);

  LiftUnitOptions options_;
  lift::DoorPlant door_;
  lift::LoadCell cell_;
  std::vector<Happening> plan_;
  std::size_t done_ = 0;
  std::optional<Time> begin_{};
  std::vector<std::function<void()>> look_again_;  ///< of each device that senses
};

}  // namespace canvoy::tools
