#include "canvoy/tools/play/lift_hands.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "canvoy/tools/device/wired_hands.hpp"
#include "canvoy/tools/device/wired_things.hpp"
#include "canvoy/worlds/lift/lift_panel.hpp"
#include "canvoy/worlds/lift/shaft_sensors.hpp"
#include "canvoy/worlds/lift/shaft_units.hpp"

namespace canvoy::tools {

namespace {

using lift::DeviceKind;
using lift::LiftNetworkDescription;
using lift::NodeDescription;

/// Null: none.
const NodeDescription* find_node(const LiftNetworkDescription& network, const HandOfFile& hand) {
  const auto is_it = [&](const NodeDescription& node) {
    return lift::device_kind_name(node.kind) == hand.device && node.lift == hand.lift &&
           (hand.node == 0 || node.id == hand.node) &&
           (hand.floor == 0 || std::ranges::find(node.floors, hand.floor) != node.floors.end());
  };
  const auto found = std::ranges::find_if(network.nodes, is_it);
  return found == network.nodes.end() ? nullptr : &*found;
}

/// Floor of the landing of the hand; floor_of_car: in the car, or at no floor.
lift::FloorNumber floor_of(const NodeDescription& node, const HandOfFile& hand) {
  if (node.floors.empty()) return cia417::floor_of_car;
  return hand.floor == 0 ? node.floors.front() : static_cast<lift::FloorNumber>(hand.floor);
}

std::vector<DeviceHand> hands_at(const LiftNetworkDescription& network, const NodeDescription& node,
                                 const HandOfFile& hand) {
  Environment environment;
  environment.floors = network.building.floor_count();
  if (!node.floors.empty()) environment.floor = floor_of(node, hand);
  return wired_hands(lift::device_kind_name(node.kind), environment);
}

void check_place(const TomlTable& table, const NodeDescription* node, const HandOfFile& hand) {
  if (node == nullptr) {
    const std::string id = hand.node == 0 ? "" : fmt::format(" with node-ID {}", hand.node);
    const std::string floor = hand.floor == 0 ? "" : fmt::format(" at floor {}", hand.floor);
    table.refuse("device", fmt::format("lift {} has no {}{}{}", hand.lift, hand.device, id, floor));
  }
  if (!node->played) table.refuse("device", "it is not played here: its hands are where it is");
}

SettingTable<HandOfFile> lift_hand_table() {
  SettingTable<HandOfFile> table = hand_table("a device of a lift, as `\"lift-door\"`");
  table.settings.push_back(place_setting(
      "lift", "1 without it", lift::lifts_max,
      [](const HandOfFile& hand) { return hand.lift == 1 ? 0U : hand.lift; },
      [](HandOfFile& hand, unsigned value) { hand.lift = value; }));
  table.settings.push_back(place_setting(
      "node", "its node-ID; without it, the first one of its kind", node_id_max,
      [](const HandOfFile& hand) { return hand.node; },
      [](HandOfFile& hand, unsigned value) { hand.node = static_cast<NodeId>(value); }));
  table.settings.push_back(place_setting(
      "floor", "where a landing panel or sensors hang; without it, the first one", lift::floors_max,
      [](const HandOfFile& hand) { return hand.floor; },
      [](HandOfFile& hand, unsigned value) { hand.floor = value; }));
  return table;
}

}  // namespace

FilePart<LiftRun> lift_hands_part() {
  return several<LiftRun, HandOfFile>(
      [](const LiftRun&) { return lift_hand_table(); },
      [](const LiftRun& run) { return run.hands; },
      [](const TomlTable& table, LiftRun& run, HandOfFile hand) {
        const NodeDescription* const node = find_node(run.network, hand);
        check_place(table, node, hand);
        const std::vector<DeviceHand> hands = hands_at(run.network, *node, hand);
        const HandTable of_device = {hand.device, hands};
        order_of(table, hand, {&of_device, 1});
        add_hand(table, run.hands, std::move(hand));
      });
}

/// A hand at a node, and the plant behind it.
struct LiftHands::Placed : WiredThings {
  Placed(lift::LiftNetwork& its_network, const HandOfFile& its_hand)
      : network(its_network),
        hand(its_hand),
        node(*find_node(its_network.description(), its_hand)),
        shaft(its_network.shaft(node.lift)),
        hands(hands_at(its_network.description(), node, its_hand)) {}

  void plan() {
    const HandTable table = {hand.device, hands};
    plan_hand(network.world(), hand, checked_order(hand, {&table, 1}),
              [this](Time now, const HandOrder& order, const std::string& text) {
                act(now, order, text);
              });
  }
  void act(Time now, const HandOrder& order, const std::string& text) {
    HandActed acted{.bus = node.bus, .node = node.id, .what = text};
    const HandTarget target{
        .unit = static_cast<WiredThings*>(this), .number = order.number, .now = now};
    if (!order.hand->act(target, order.value)) acted.refused = why_refused(*order.hand, target);
    network.note_hand(acted);
    shaft.look();
  }

  bool set_door_fault(bool lift::DoorFaults::*fault, bool is_there, Time now) override;
  bool put_in_door(bool is_there, Time now) override;
  bool approach_door(bool is_near) override;
  bool touch_door(bool is_touched) override;
  bool set_load(double kilograms) override;
  bool break_rope_sensor(bool is_broken) override;
  lift::CarPlant* car() override { return &shaft.plants().car.plant(); }
  bool open_safety_chain(bool is_open) override;
  bool catch_safety_gear(bool is_caught) override;
  bool press(cia417::BasicFunction function, std::uint8_t sub_function, const HandValue& value,
             Time now) override;
  bool set_sensor(cia417::SensorFunction sensor, const HandValue& value, Time now) override;

  /// The first door that the node moves or monitors, or that is beside it.
  lift::ShaftDoor& door() {
    return *shaft.plants().doors.at(static_cast<std::size_t>(std::countr_zero(node.doors)));
  }

  lift::LiftNetwork& network;
  const HandOfFile hand;
  const NodeDescription& node;
  lift::LiftShaft& shaft;
  std::vector<DeviceHand> hands;
};

bool LiftHands::Placed::set_door_fault(bool lift::DoorFaults::*fault, bool is_there, Time now) {
  if (node.kind == DeviceKind::door) {
    door().set_fault(now, fault, is_there);
  } else if (fault == &lift::DoorFaults::barrier_is_broken) {
    shaft.plants().barrier.break_down(is_there);
  } else {
    shaft.plants().barrier.cover(is_there);
  }
  return true;
}

bool LiftHands::Placed::put_in_door(bool is_there, Time now) {
  door().put_in_way(now, is_there);
  shaft.plants().barrier.look_again();
  return true;
}

bool LiftHands::Placed::approach_door(bool is_near) {
  door().approach(is_near);
  return true;
}

bool LiftHands::Placed::touch_door(bool is_touched) {
  door().touch_edge(is_touched);
  return true;
}

bool LiftHands::Placed::set_load(double kilograms) {
  shaft.plants().load.set_goods(kilograms);
  return true;
}

bool LiftHands::Placed::break_rope_sensor(bool is_broken) {
  shaft.plants().load.break_sensor(is_broken);
  return true;
}

bool LiftHands::Placed::open_safety_chain(bool is_open) {
  shaft.plants().car.press_stop(is_open);
  return true;
}

bool LiftHands::Placed::catch_safety_gear(bool is_caught) {
  lift::ShaftCar& car = shaft.plants().car;
  is_caught ? car.plant().arrest() : car.reset_by_hand();
  return true;
}

bool LiftHands::Placed::press(cia417::BasicFunction function, std::uint8_t sub_function,
                              const HandValue& value, Time /*now*/) {
  lift::LiftPanel* const panel = shaft.panel(node.id);
  if (panel == nullptr) return false;
  const auto input = panel->find({function, sub_function, floor_of(node, hand)});
  if (!input) return false;
  const bool is_pressed = value.code != 0;
  const bool is_special = function == cia417::BasicFunction::special_function;
  if (const auto condition = wired_condition<cia417::CallRequest>(value)) {
    panel->report(*input, *condition);
  } else if (!is_special) {
    panel->press(*input, is_pressed);
  } else if (sub_function == sub_function_of(cia417::SpecialFunction::door_open)) {
    shaft.press_door_open(is_pressed);
  } else {
    shaft.press_door_close(is_pressed);
  }
  return true;
}

bool LiftHands::Placed::set_sensor(cia417::SensorFunction sensor, const HandValue& value,
                                   Time /*now*/) {
  lift::ShaftSensors* const sensors = shaft.sensors(node.id);
  if (sensors == nullptr) return false;
  if (const auto condition = wired_condition<cia417::SensorSignal>(value)) {
    sensors->report(sensor, *condition);
  } else if (cia417::is_measured(sensor)) {
    sensors->set_value(sensor, static_cast<std::int16_t>(std::lround(value.number)));
  } else {
    sensors->set_level(sensor, value.code != 0);
  }
  return true;
}

LiftHands::LiftHands(lift::LiftNetwork& network, const std::vector<HandOfFile>& hands) {
  for (const HandOfFile& hand : hands) {
    placed_.push_back(std::make_unique<Placed>(network, hand));
    placed_.back()->plan();
  }
}

LiftHands::~LiftHands() = default;

}  // namespace canvoy::tools
