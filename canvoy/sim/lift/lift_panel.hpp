// A panel of a simulated building: buttons, keys and lamps of a landing or a car as one CANopen
// node, an input panel unit and an output panel unit.
//
//     LiftPanel panel(world, bus, 21, landing_controls({.lift = 1, .floors = {3}}), shown);
//     panel.press(*panel.find({BasicFunction::standard_hall_call, hall_up, 3}), true);
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/node.hpp"
#include "canvoy/devices/cia417/panel/output_view.hpp"
#include "canvoy/devices/cia417/panel/virtual_io.hpp"
#include "canvoy/sim/lift/building.hpp"
#include "canvoy/sim/lift/panel_words.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

/// What a panel has.
struct PanelControls {
  std::vector<cia417::VirtualInput> inputs{};
  std::vector<cia417::VirtualOutput> outputs{};
  bool parameters = false;  ///< four of each
};

/// Of a building, which doors there are where.
struct PanelPlace {
  const Building* building = nullptr;  ///< null: each floor has all doors
  LiftNumber number = 1;               ///< of the lift in it

  unsigned doors_at(FloorNumber floor, unsigned of_these) const {
    return building == nullptr ? of_these : of_these & building->doors_at(number, floor);
  }
  bool has_way(FloorNumber from, FloorNumber to) const {
    return building == nullptr || building->has_way(from, to);
  }
  bool serves(FloorNumber floor) const { return doors_at(floor, all_doors) != 0; }
  static constexpr unsigned all_doors = (1U << doors_max) - 1;
};

struct LandingPanelOptions {
  LiftNumber lift = 1;
  std::vector<FloorNumber> floors{};
  unsigned doors = 1;         ///< beside which it hangs
  FloorNumber highest = 2;    ///< floor of the building
  bool destinations = false;  ///< it has a button for each other floor, and none for directions
  FloorNumber fire_floor = no_floor;  ///< where it has a key; no_floor: nowhere
  PanelPlace place{};
  PanelDescription panel{};
};
PanelControls landing_controls(const LandingPanelOptions& options);

struct CarPanelOptions {
  LiftNumber lift = 1;
  std::vector<FloorNumber> floors{};  ///< that it has buttons for, as far as the lift serves them
  unsigned doors = 1;
  bool keys = true;  ///< and the door buttons
  PanelPlace place{};
  PanelDescription panel{};
};
PanelControls car_controls(const CarPanelOptions& options);

/// What tells an input from the others of its panel.
struct PanelInput {
  cia417::BasicFunction function = cia417::BasicFunction::none;
  std::uint8_t sub_function = 0;
  FloorNumber floor = cia417::floor_of_car;
};

/// A call button that is held for longer is stuck: the panel says that it is defective (6010h), and
/// tells an application error by emergency until it is let go. People hold door buttons and keys.
inline constexpr Duration stuck_after = 10s;

/// Of as many inputs and outputs as a node has room for, four groups of each (254 floors have more
/// buttons than one group): others are left out.
class LiftPanel {
 public:
  /// Told when an output shows something else.
  using Shown = std::function<void(const cia417::VirtualOutput&, const cia417::OutputView&)>;

  static constexpr std::size_t inputs_max = 4 * 254;
  static constexpr std::size_t outputs_max = 4 * 254;
  /// As many of each may have parameters.
  static constexpr std::size_t parameters_max = 254;

  LiftPanel(World& world, BusIndex bus, NodeId id, PanelControls controls, Shown shown);
  LiftPanel(const LiftPanel&) = delete;
  LiftPanel& operator=(const LiftPanel&) = delete;
  ~LiftPanel();

  std::optional<std::size_t> find(const PanelInput& input) const;
  /// At the world's present time.
  void press(std::size_t input, bool pressed);
  /// It stays as it is, whoever presses or lets go.
  void stick(std::size_t input, bool stuck);
  /// Without power no output shows anything.
  void go_dark();
  SlotIndex slot() const { return slot_; }
  Node& node();

 private:
  struct Body;
  template <std::size_t inputs, std::size_t outputs, bool parameters = false>
  struct Device;

  void show(std::uint32_t output, const cia417::OutputView& view);
  void set_level(std::size_t input, bool high);
  void watch(std::size_t input, bool high);
  void look_at_stuck(std::size_t input, Time since);
  void tell_defect(std::size_t input, bool is_defective);

  World* world_;
  SlotIndex slot_;
  PanelControls controls_;
  Shown shown_;
  std::vector<bool> fingers_;  ///< on which inputs there are any
  std::vector<bool> is_stuck_;
  std::vector<Time> high_since_;    ///< never: an input is low
  std::vector<bool> is_defective_;  ///< and the panel has told so
  std::unique_ptr<Body> body_;
};

}  // namespace canvoy::lift
