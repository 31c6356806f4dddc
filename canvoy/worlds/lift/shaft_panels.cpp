#include "canvoy/worlds/lift/shaft_panels.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace canvoy::lift {

namespace {

using cia417::BasicFunction;
using cia417::SpecialFunction;

Direction direction_of(const cia417::OutputView& view) {
  const unsigned both = cia417::arrow_up | cia417::arrow_down;
  const unsigned arrows = view.sub_function & both;
  if (!view.on || arrows == both || arrows == 0) return Direction::none;
  return arrows == cia417::arrow_up ? Direction::up : Direction::down;
}

PanelInput input_of(const CallKey& button) {
  if (button.lift != 0) return {BasicFunction::standard_car_call, button.floor};
  if (button.to != no_floor) {
    return {BasicFunction::standard_destination_call, button.to, button.floor};
  }
  const bool is_up = button.direction == Direction::up;
  return {BasicFunction::standard_hall_call, is_up ? cia417::hall_up : cia417::hall_down,
          button.floor};
}

}  // namespace

ShaftPanels::ShaftPanels(World& world, const ShaftPlan& plan, ShaftNodes& nodes, PanelHooks hooks,
                         Callback<void()> changed)
    : world_(&world),
      plan_(&plan),
      nodes_(&nodes),
      hooks_(std::move(hooks)),
      changed_(changed),
      lanterns_(plan.building().floors.size()) {}

void ShaftPanels::add(const NodeDescription& node) {
  auto shown_by = [this, node](const cia417::VirtualOutput& output,
                               const cia417::OutputView& view) { shown(node, output, view); };
  panels_.push_back(
      {node.id, std::make_unique<LiftPanel>(*world_, plan_->bus(), node.id,
                                            plan_->controls_of(node), std::move(shown_by))});
  LiftPanel& panel = *panels_.back().panel;
  nodes_->add(node.id, node.kind, panel.slot(), panel.node());
}

const ShaftPanels::Panel* ShaftPanels::find(const CallKey& button) const {
  const auto found = std::ranges::find_if(
      panels_, [&](const Panel& panel) { return panel.panel->find(input_of(button)).has_value(); });
  return found == panels_.end() ? nullptr : &*found;
}

NodeId ShaftPanels::with(const CallKey& button) const {
  const Panel* const panel = find(button);
  return panel == nullptr ? NodeId{0} : panel->id;
}

bool ShaftPanels::press(const CallKey& button, bool pressed) {
  const Panel* const found = find(button);
  if (found == nullptr) return false;
  // People who may go there have the key, and hold it turned meanwhile.
  const std::optional<std::size_t> key = plan_->key_for(button);
  if (key) press(key_lock(*key), pressed);
  // A finger is on the contact or not, with or without power.
  LiftPanel& panel = *found->panel;
  panel.press(panel.find(input_of(button)).value_or(0), pressed);
  return world_->is_running(panel.slot());
}

void ShaftPanels::press(SpecialFunction function, bool on) {
  const std::uint8_t number = cia417::sub_function_of(function);
  const FloorNumber fire_floor = plan_->service().fire_floor;
  held_[number] = on;
  for (const Panel& panel : panels_) {
    auto input = panel.panel->find({BasicFunction::special_function, number});
    if (!input) input = panel.panel->find({BasicFunction::special_function, number, fire_floor});
    if (input) return panel.panel->press(*input, on);
  }
}

bool ShaftPanels::press_at(FloorNumber floor, SpecialFunction function, bool on) {
  const PanelInput wanted{BasicFunction::special_function, cia417::sub_function_of(function),
                          floor};
  for (const Panel& panel : panels_) {
    const auto input = panel.panel->find(wanted);
    if (!input) continue;
    panel.panel->press(*input, on);
    return true;
  }
  return false;
}

void ShaftPanels::stick(const CallKey& button, bool stuck) {
  const Panel* const panel = find(button);
  if (panel == nullptr) return;
  const std::optional<std::size_t> input = panel->panel->find(input_of(button));
  if (input) panel->panel->stick(*input, stuck);
}

LiftPanel* ShaftPanels::panel(NodeId id) const {
  const auto found = std::ranges::find(panels_, id, &Panel::id);
  return found == panels_.end() ? nullptr : found->panel.get();
}

void ShaftPanels::go_dark(NodeId id) {
  if (LiftPanel* const dark = panel(id)) dark->go_dark();
}

/// A lamp or display has changed.
void ShaftPanels::shown(const NodeDescription& panel, const cia417::VirtualOutput& output,
                        const cia417::OutputView& view) {
  const bool is_position = output.function == BasicFunction::position_indicator;
  if (is_position && output.sub_function == 0) return shown_position(panel.id, view);
  if (panel.kind == DeviceKind::landing_panel) return shown_at_landing(output, view);
  shown_in_car(output, view);
}

/// One display for all floors; a lamp for each of them is another output.
void ShaftPanels::shown_position(NodeId id, const cia417::OutputView& view) {
  const auto panel = std::ranges::find(panels_, id, &Panel::id);
  if (panel == panels_.end()) return;
  const FloorNumber shown = view.on ? view.sub_function : no_floor;
  if (shown == panel->shown_floor) return;
  panel->shown_floor = shown;
  panel->shown_since = world_->now();
}

std::optional<Time> ShaftPanels::misnamed_since(FloorNumber floor) const {
  std::optional<Time> since;
  for (const Panel& panel : panels_) {
    if (panel.shown_floor == no_floor) continue;
    const Time misnamed = panel.shown_floor == floor ? never : panel.shown_since;
    since = std::min(since.value_or(never), misnamed);
  }
  return since;
}

void ShaftPanels::shown_in_car(const cia417::VirtualOutput& output,
                               const cia417::OutputView& view) {
  if (output.function == BasicFunction::standard_car_call && hooks_.lamp) {
    const LiftNumber lift = plan_->lift();
    hooks_.lamp(lift, {.lift = lift, .floor = view.sub_function}, view.on);
  }
  if (output.function != BasicFunction::special_indication) return;
  constexpr std::uint8_t overload = cia417::sub_function_of(cia417::SpecialIndication::overload);
  // One display for all indications shows the last one.
  if (output.sub_function != overload && output.sub_function != 0) return;
  overload_is_shown_ = view.on && view.sub_function == overload;
  changed_();
}

void ShaftPanels::shown_at_landing(const cia417::VirtualOutput& output,
                                   const cia417::OutputView& view) {
  const LiftNumber lift = plan_->lift();
  const std::size_t floor = output.floor;
  if (floor < 1 || floor > lanterns_.size()) return;
  if (output.function == BasicFunction::hall_lantern) {
    lanterns_[floor - 1] = direction_of(view);
    return changed_();
  }
  if (output.function == BasicFunction::standard_destination_call && view.on && hooks_.assigned) {
    // Several lifts: it will be one of them.
    const bool is_known = std::popcount(output.lifts) == 1;
    const int told = is_known ? std::countr_zero(output.lifts) + 1 : 0;
    return hooks_.assigned(lift, {output.floor, output.sub_function},
                           static_cast<LiftNumber>(told));
  }
  if (output.function == BasicFunction::standard_hall_call && hooks_.lamp) {
    const Direction direction =
        output.sub_function == cia417::hall_up ? Direction::up : Direction::down;
    hooks_.lamp(lift, {.floor = output.floor, .direction = direction}, view.on);
  }
}

}  // namespace canvoy::lift
