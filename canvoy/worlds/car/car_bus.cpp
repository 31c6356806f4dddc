#include "canvoy/worlds/car/car_bus.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/profiles/cia447/network.hpp"

namespace canvoy::car {

namespace {

/// Time within which a real device must come.
constexpr Duration real_start = 1min;
/// Like real_start, but for simulated devices beside real ones: LSS handles all devices one after
/// the other, and a real device answers when its computer lets it. Their service for people is
/// judged from then on as well, or as soon as all have come.
constexpr Duration start_beside_real = 3min;

}  // namespace

CarBus::CarBus(World& world, Settings settings, BusWatch::Note note)
    : world_(world),
      settings_(std::move(settings)),
      index_(world.add_bus({.bit_rate = settings_.bit_rate, .seed = settings_.seed})),
      watch_(index_, std::move(note)) {}

void CarBus::add(std::span<const cia447::CarUnit* const> units, const Environment& environment) {
  const auto id = static_cast<NodeId>(nodes_.size() + 1);
  const CarNode::Place place = {
      .name = settings_.names[nodes_.size()],
      .id = id,
      .serial_number = settings_.serial_numbers + id,
      // The node-IDs that a real gateway assigns are unknown.
      .is_named_by_lss = id != cia447::gateway_node_id && is_played(cia447::gateway_node_id),
      .is_played = is_played(id)};
  nodes_.push_back(std::make_unique<CarNode>(world_, index_, units, place, environment));
}

void CarBus::complete() {
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    known_.addresses.at(i - 1) = nodes_[i]->address();
    known_.is_known.at(i - 1) = true;
    if (!nodes_[i]->place().is_played) keep_place(*nodes_[i]);
  }
  for (const auto& node : nodes_) watch_.name(node->controller(), node->place().id);
}

/// Keeps the place of a real device. Where its identity is not given, a simulated device in this
/// place would be known as well.
void CarBus::keep_place(const CarNode& node) {
  cia447::CarPlace place{.id = node.place().id, .provides = &node.provides()};
  const auto told = std::ranges::find(settings_.identities, place.id, &RealIdentity::id);
  if (told != settings_.identities.end()) {
    place.identity = told->identity;
    known_.is_known.at(place.id - std::size_t{2}) = false;
  }
  places_.push_back(place);
}

cia447::CarMasterSettings CarBus::master_settings() const {
  cia447::CarMasterSettings made = settings_.master;
  made.places = places_;
  return made;
}

cia447::CarMemory CarBus::memory() {
  return {.load = callback<&CarBus::known>(*this), .store = callback<&CarBus::keep>(*this)};
}

bool CarBus::is_played(NodeId id) const {
  return std::ranges::find(settings_.real, id) == settings_.real.end();
}

bool CarBus::is_at_work(CarNode& node) const {
  return canvoy::is_at_work(world_, node, watch_, settings_.time_out);
}

bool CarBus::waits_for_real() const {
  const auto does_work = [this](const auto& node) { return is_at_work(*node); };
  return world_.now() - Time{} < start_beside_real && !std::ranges::all_of(nodes_, does_work);
}

bool CarBus::may_come_yet(NodeId id) const {
  const Duration time = is_played(id) ? start_beside_real : real_start;
  return !settings_.real.empty() && world_.now() - Time{} < time;
}

bool CarBus::all_sleep() const {
  return std::ranges::all_of(nodes_, [](const std::unique_ptr<CarNode>& node) {
    return !node->is_powered() || node->device().sleep().state() == cia447::SleepState::asleep;
  });
}

bool CarBus::any_sleeps() const {
  return std::ranges::any_of(nodes_, [](const std::unique_ptr<CarNode>& node) {
    return node->is_powered() && node->device().sleep().state() != cia447::SleepState::awake;
  });
}

cia447::CarMaster* CarBus::master() {
  return is_played(cia447::gateway_node_id) ? gateway().device().master() : nullptr;
}

BusSnapshot CarBus::snapshot() const {
  const SimulatedBus& bus = world_.bus(index_);
  return {bus.load(nodes_.front()->controller()), bus.statistics().frames,
          bus.statistics().error_frames};
}

std::vector<NodeSnapshot> CarBus::node_snapshots() const {
  std::vector<NodeSnapshot> all;
  all.reserve(nodes_.size());
  for (const auto& node : nodes_) {
    all.push_back(snapshot_of(world_, *node, watch_, settings_.time_out));
  }
  return all;
}

std::vector<std::string_view> CarBus::names() const {
  std::vector<std::string_view> all;
  all.reserve(nodes_.size());
  for (const auto& node : nodes_) all.push_back(node->place().name);
  return all;
}

}  // namespace canvoy::car
