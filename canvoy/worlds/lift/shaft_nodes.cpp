#include "canvoy/worlds/lift/shaft_nodes.hpp"

#include <algorithm>

namespace canvoy::lift {

namespace {

Frame babble_of(NodeId node) {
  return Frame::data_frame(0x480U + node, {0, 0, 0, 0, 0, 0});
}

}  // namespace

void ShaftNodes::add(NodeId id, DeviceKind kind, SlotIndex slot, Node& node) {
  nodes_.push_back({id, kind, slot, &node});
}

void ShaftNodes::link(NodeId controller, SlotIndex group_slot, Node& member) {
  const Entry& own = *find(controller);
  on_own_bus_ = std::make_unique<LinkedNode>(*world_, *own.node, group_slot);
  on_group_bus_ = std::make_unique<LinkedNode>(*world_, member, own.slot);
  world_->occupy(own.slot, *on_own_bus_);
  world_->occupy(group_slot, *on_group_bus_);
  group_slot_ = group_slot;
}

void ShaftNodes::start() {
  for (const bool panels : {false, true}) {
    for (const Entry& each : nodes_) {
      if (is_panel(each.kind) == panels) world_->start(each.slot);
    }
  }
  if (group_slot_) world_->start(*group_slot_);
}

void ShaftNodes::power(NodeId id, bool is_on) {
  const Entry* const entry = find(id);
  if (entry == nullptr) return;
  const auto set = [&](SlotIndex slot) { is_on ? world_->start(slot) : world_->stop(slot); };
  if (entry->kind == DeviceKind::lift_controller && group_slot_) set(*group_slot_);
  set(entry->slot);
}

void ShaftNodes::cut_cable(NodeId id) {
  const std::optional<SlotIndex> behind = slot(id);
  if (behind) world_->bus(bus_).cut_cable(world_->controller(*behind));
}

void ShaftNodes::babble(NodeId id, bool babbles) {
  const std::optional<SlotIndex> of = slot(id);
  if (!of) return;
  SimulatedBus& cable = world_->bus(bus_);
  const ControllerId controller = world_->controller(*of);
  babbles ? cable.babble(controller, babble_of(id)) : cable.stop_babbling(controller);
}

const ShaftNodes::Entry* ShaftNodes::find(NodeId id) const {
  const auto found = std::ranges::find(nodes_, id, &Entry::id);
  return found == nodes_.end() ? nullptr : &*found;
}

std::optional<SlotIndex> ShaftNodes::slot(NodeId id) const {
  const Entry* const entry = find(id);
  return entry == nullptr ? std::nullopt : std::optional(entry->slot);
}

Node* ShaftNodes::node(NodeId id) const {
  const Entry* const entry = find(id);
  return entry == nullptr ? nullptr : entry->node;
}

bool ShaftNodes::is_a(DeviceKind kind, NodeId id) const {
  const Entry* const entry = find(id);
  return entry != nullptr && entry->kind == kind;
}

}  // namespace canvoy::lift
