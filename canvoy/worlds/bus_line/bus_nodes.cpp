#include "canvoy/worlds/bus_line/bus_nodes.hpp"

#include <algorithm>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/worlds/bus_line/line_control.hpp"

namespace canvoy::bus_line {

namespace {

/// Disturbances in the cars differ.
constexpr std::uint64_t next_cable_seed = 0x407;
constexpr std::uint32_t first_serial_number = 4000;
/// Time until it is missed: a real device starts when a person switches it on.
constexpr Duration real_start_time = 1min;

}  // namespace

BusNodes::BusNodes(World& world, const BusNetworkOptions& options, EventLog<NetworkEvent>& events)
    : world_(world), options_(options) {
  for (unsigned car = 1; car <= cars(); ++car) {
    indices_.push_back(world.add_bus(
        {.bit_rate = options.bit_rate, .seed = options.faults.seed + (car - 1) * next_cable_seed}));
    watches_.emplace_back(indices_.back(), [&events](Time now, const canvoy::BusEvent& heard) {
      events.hear(now, heard);
    });
  }
}

void BusNodes::add(DeviceKey key, const Environment& environment) {
  const auto place = std::ranges::find(device_places, key, &DevicePlace::id);
  add({.name = place->name,
       .key = key,
       .id = id(key),
       .serial_number = first_serial_number + key,
       .is_played = is_played(key)},
      units_at(key), environment);
}

void BusNodes::add(const AddedDevice& device, const Environment& environment) {
  add({.name = device.kind,
       .key = key_of(design(), device.id),
       .id = device.id,
       .serial_number = first_serial_number + device.id},
      std::span(&find_device_kind(device.kind)->bus_unit, 1), environment);
}

void BusNodes::add(const BusNode::Place& place, std::span<const cia407::BusUnit* const> units,
                   const Environment& environment) {
  auto& all = is_there(place.key) ? nodes_ : absent_;
  all.push_back(std::make_unique<BusNode>(world_, index_of(place.key), units, place, environment));
  by_key_.at(place.key) = all.back().get();
  watches_.at(car_of(place.key) - 1).name(all.back()->controller(), place.id);
}

unsigned BusNodes::car_of(DeviceKey key) const {
  return key <= node_id_max ? bus_line::car_of(key) : design().added.at(key - added_key(0)).car;
}

bool BusNodes::is_there(DeviceKey key) const {
  return key > node_id_max || bus_line::is_there(design(), key);
}

void BusNodes::complete() {
  std::ranges::sort(nodes_, {}, [](const auto& node) { return node->place().id; });
}

bool BusNodes::is_played(DeviceKey key) const {
  return is_there(key) && std::ranges::find(options_.real, key) == options_.real.end();
}

bool BusNodes::is_at_work(DeviceKey key) {
  return canvoy::is_at_work(world_, node(key), watches_.at(car_of(key) - 1),
                            LineControl::node_time_out);
}

bool BusNodes::is_awaited(DeviceKey key) const {
  const DeviceKey master = master_of(key);
  if (key != master && !is_played(master)) return true;
  return !is_played(key) && world_.now() < Time(real_start_time);
}

Duration BusNodes::heartbeat_time_out(DeviceKey key) const {
  return is_played(key) ? LineControl::short_time_out : LineControl::node_time_out;
}

std::vector<BusSnapshot> BusNodes::cable_snapshots() {
  std::vector<BusSnapshot> all;
  for (unsigned car = 1; car <= cars(); ++car) {
    const SimulatedBus& bus = cable(car);
    all.push_back({bus.load(node(master_in(car)).controller()), bus.statistics().frames,
                   bus.statistics().error_frames});
  }
  return all;
}

std::vector<NodeSnapshot> BusNodes::node_snapshots() {
  std::vector<NodeSnapshot> all;
  for (const auto& node : nodes_) {
    const BusWatch& watch = watches_.at(car_of(node->place().key) - 1);
    all.push_back(snapshot_of(world_, *node, watch, LineControl::node_time_out));
  }
  return all;
}

std::vector<std::string_view> BusNodes::names() const {
  std::vector<std::string_view> all;
  all.reserve(nodes_.size());
  for (const auto& node : nodes_) all.push_back(node->place().name);
  return all;
}

}  // namespace canvoy::bus_line
