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

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/panel/output_view.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/sim/world.hpp"
#include "canvoy/worlds/lift/building.hpp"
#include "canvoy/worlds/lift/panel_words.hpp"

namespace canvoy::lift {

/// Controls of a panel.
struct PanelControls {
  /// Groups of up to 254, in the order of their sub-indices.
  std::vector<cia417::VirtualInput> inputs{};
  /// Groups of up to 254, in the order of their sub-indices.
  std::vector<cia417::VirtualOutput> outputs{};
  bool parameters = false;  ///< true: four parameters for each control
};

/// Place of a panel in a building, and which doors are where.
struct PanelPlace {
  const Building* building = nullptr;  ///< null: every floor has all doors
  LiftNumber number = 1;               ///< number of the lift in it

  /// Those among the doors `of_these` that the floor has: bit 0 is door 1.
  unsigned doors_at(FloorNumber floor, unsigned of_these) const {
    return building == nullptr ? of_these : of_these & building->doors_at(number, floor);
  }
  /// True if any lift connects the two floors.
  bool has_way(FloorNumber from, FloorNumber to) const {
    return building == nullptr || building->has_way(from, to);
  }
  /// True if the lift has a door at the floor.
  bool serves(FloorNumber floor) const { return doors_at(floor, all_doors) != 0; }
  static constexpr unsigned all_doors = (1U << doors_max) - 1;  ///< bit 0 is door 1
};

/// What the panel of a landing has.
struct LandingPanelOptions {
  LiftNumber lift = 1;                ///< lift beside which it hangs
  std::vector<FloorNumber> floors{};  ///< floors that it has buttons for
  unsigned doors = 1;                 ///< doors beside which it hangs
  FloorNumber highest = 2;            ///< highest floor of the building
  bool destinations = false;  ///< it has a button for each other floor, and none for directions
  FloorNumber fire_floor = no_floor;  ///< floor with its key; no_floor: none
  PanelPlace place{};                 ///< which doors and ways there are
  PanelDescription panel{};           ///< keys and displays
};
/// Buttons, keys, lamps and displays of a landing panel with these options.
PanelControls landing_controls(const LandingPanelOptions& options);

/// What the panel of a car has.
struct CarPanelOptions {
  LiftNumber lift = 1;                ///< lift of the car
  std::vector<FloorNumber> floors{};  ///< floors that it has buttons for, as far as the lift serves
                                      ///< them
  unsigned doors = 1;                 ///< doors that have buttons of their own: bit 0 is door 1
  bool keys = true;                   ///< true: keys and the door buttons
  PanelPlace place{};                 ///< which doors and floors there are
  PanelDescription panel{};           ///< keys and displays
};
/// Buttons, keys, lamps and displays of a car panel with these options.
PanelControls car_controls(const CarPanelOptions& options);

/// Identifies an input of a panel.
struct PanelInput {
  cia417::BasicFunction function =
      cia417::BasicFunction::none;           ///< first byte of the virtual input
  std::uint8_t sub_function = 0;             ///< for a special function which one
  FloorNumber floor = cia417::floor_of_car;  ///< 0: of the car
};

/// Time after which a pressed call button counts as stuck: the panel reports it as defective
/// (6010h), and an application error by emergency until it is released. Door buttons and keys may
/// be held for longer.
inline constexpr Duration stuck_after = 10s;

/// A panel with at most as many inputs and outputs as a node has room for, four groups of each (254
/// floors have more buttons than one group): others are left out.
class LiftPanel {
 public:
  /// Called when the state of an output changes.
  using Shown = std::function<void(const cia417::VirtualOutput&, const cia417::OutputView&)>;

  static constexpr std::size_t inputs_max = 4 * 254;   ///< four objects of 254 sub-indices
  static constexpr std::size_t outputs_max = 4 * 254;  ///< four objects of 254 sub-indices
  /// Greatest number of inputs, and of outputs, with parameters.
  static constexpr std::size_t parameters_max = 254;

  /// Adds the node to the bus, without power; `shown` is called at changes of outputs.
  LiftPanel(World& world, BusIndex bus, NodeId id, PanelControls controls, Shown shown);
  LiftPanel(const LiftPanel&) = delete;
  LiftPanel& operator=(const LiftPanel&) = delete;
  ~LiftPanel();

  /// Position of the input among PanelControls::inputs; empty: the panel has none.
  std::optional<std::size_t> find(const PanelInput& input) const;
  /// Presses or releases an input, at the world's present time.
  void press(std::size_t input, bool pressed);
  /// Sets its contact to defective, not installed, or working again (none). Nothing is sent without
  /// power.
  void report(std::size_t input, cia417::CallRequest condition);
  /// Keeps its state, whatever is pressed or released.
  void stick(std::size_t input, bool stuck);
  /// Switches all outputs off: call it when the panel has no power.
  void go_dark();
  /// Its slot on the bus.
  SlotIndex slot() const { return slot_; }
  /// The node of the panel.
  Node& node();

 private:
  struct Body;
  template <std::size_t inputs, std::size_t outputs, bool parameters = false>
  struct Device;

  void show(std::uint32_t output, const cia417::OutputView& view);
  void set_level(std::size_t input, bool high);
  void watch(std::size_t input, bool high);
  void look_at_stuck(std::size_t input, Time since);
  void report_defect(std::size_t input, bool is_defective);
  void tell(std::size_t input, cia417::CallRequest condition);

  World* world_;
  SlotIndex slot_;
  PanelControls controls_;
  Shown shown_;
  std::vector<bool> fingers_;  ///< true: an input that is held
  std::vector<bool> is_stuck_;
  std::vector<Time> high_since_;    ///< never: the input is low
  std::vector<bool> is_defective_;  ///< true: reported as defective
  std::unique_ptr<Body> body_;
};

}  // namespace canvoy::lift
