// The panels of one lift at its landings and in its car: people press and turn their controls, and
// look at their lamps and lanterns.
//
//     ShaftPanels panels(world, plan, nodes, {.lamp = ...}, changed);
//     panels.add(node);
//     panels.press({.floor = 3, .direction = Direction::up}, true);
//     panels.lantern(3);
#pragma once

#include <bitset>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/can/callback.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/passenger.hpp"
#include "canvoy/worlds/lift/shaft_nodes.hpp"
#include "canvoy/worlds/lift/shaft_plan.hpp"

namespace canvoy::lift {

/// Functions that receive what panels show; an empty one does nothing.
struct PanelHooks {
  /// A lamp of a button changes; the key of a car call contains the lift.
  std::function<void(LiftNumber, const CallKey&, bool lit)> lamp{};
  /// A landing panel of this lift shows to which lift a destination call was given; 0: to none yet.
  std::function<void(LiftNumber, const DestinationButton&, LiftNumber assigned)> assigned{};
};

class ShaftPanels {
 public:
  /// `world`, `plan` and `nodes` must outlive this object. `changed` is called when people see
  /// another lantern() or shows_overload().
  ShaftPanels(World& world, const ShaftPlan& plan, ShaftNodes& nodes, PanelHooks hooks,
              Callback<void()> changed);
  ShaftPanels(const ShaftPanels&) = delete;
  ShaftPanels& operator=(const ShaftPanels&) = delete;

  /// Adds a panel with the controls that the plan gives it.
  void add(const NodeDescription& panel);

  /// Presses or releases a button of a landing, of the car, or of a destination. False: there is
  /// none, or no power.
  bool press(const CallKey& button, bool pressed);
  /// Presses a button or turns a key of the car, or of the fire floor. Where no panel has it, the
  /// hand is recorded all the same.
  void press(cia417::SpecialFunction function, bool on);
  /// Like press(), on a panel in the car (floor_of_car), or of that landing. False: none has it.
  bool press_at(FloorNumber floor, cia417::SpecialFunction function, bool on);
  /// True if it is held by press().
  bool is_held(cia417::SpecialFunction function) const {
    return held_[cia417::sub_function_of(function)];
  }
  /// Keeps the button in its state, whatever is pressed or released.
  void stick(const CallKey& button, bool stuck);
  /// Call it when the node with this node-ID has lost its power; does nothing if it is no panel.
  void go_dark(NodeId id);
  /// Node-ID of the panel with the button; 0: there is none here.
  NodeId with(const CallKey& button) const;

  /// Null where the node is no panel.
  LiftPanel* panel(NodeId id) const;

  /// Direction that the lantern of a floor shows; none: dark. `floor` from 1.
  Direction lantern(FloorNumber floor) const { return lanterns_[floor - std::size_t{1}]; }
  /// Time since when a display of position has named another floor; never: none does; empty: all
  /// are dark.
  std::optional<Time> misnamed_since(FloorNumber floor) const;
  /// True if a panel in the car shows an overload.
  bool shows_overload() const { return overload_is_shown_; }

 private:
  struct Panel {
    NodeId id = 0;
    std::unique_ptr<LiftPanel> panel{};
    FloorNumber shown_floor = no_floor;  ///< by its display of position; no_floor: dark
    Time shown_since{};                  ///< of shown_floor
  };

  const Panel* find(const CallKey& button) const;
  void shown(const NodeDescription& panel, const cia417::VirtualOutput& output,
             const cia417::OutputView& view);
  void shown_position(NodeId id, const cia417::OutputView& view);
  void shown_in_car(const cia417::VirtualOutput& output, const cia417::OutputView& view);
  void shown_at_landing(const cia417::VirtualOutput& output, const cia417::OutputView& view);

  World* world_;
  const ShaftPlan* plan_;
  ShaftNodes* nodes_;
  PanelHooks hooks_;
  Callback<void()> changed_;
  std::vector<Panel> panels_;
  std::bitset<256> held_;  ///< special functions
  bool overload_is_shown_ = false;
  std::vector<Direction> lanterns_;  ///< of each floor
};

}  // namespace canvoy::lift
