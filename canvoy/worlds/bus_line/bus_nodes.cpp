#include "canvoy/worlds/bus_line/bus_nodes.hpp"

#include <algorithm>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/worlds/bus_line/line_control.hpp"

namespace canvoy::bus_line {

namespace {

/// Disturbances in the two cars differ.
constexpr std::uint64_t second_cable_seed = 0x407;
constexpr std::uint32_t first_serial_number = 4000;
/// Time until it is missed: a real device starts when a person switches it on.
constexpr Duration real_start_time = 1min;

}  // namespace

BusNodes::BusNodes(World& world, const BusNetworkOptions& options, EventLog<NetworkEvent>& events)
    : world_(world),
      options_(options),
      indices_{world.add_bus({.bit_rate = options.bit_rate, .seed = options.faults.seed}),
               world.add_bus({.bit_rate = options.bit_rate,
                              .seed = options.faults.seed + second_cable_seed})},
      watches_{
          BusWatch(indices_[0],
                   [&events](Time now, const canvoy::BusEvent& heard) { events.hear(now, heard); }),
          BusWatch(indices_[1], [&events](Time now, const canvoy::BusEvent& heard) {
            events.hear(now, heard);
          })} {}

void BusNodes::add(NodeId id, const Environment& environment) {
  const auto place = std::ranges::find(device_places, id, &DevicePlace::id);
  add({.name = place->name,
       .id = id,
       .serial_number = first_serial_number + id,
       .is_played = is_played(id)},
      units_at(id), environment);
}

void BusNodes::add(const AddedDevice& device, const Environment& environment) {
  add({.name = device.kind, .id = device.id, .serial_number = first_serial_number + device.id},
      std::span(&find_device_kind(device.kind)->bus_unit, 1), environment);
}

void BusNodes::add(const BusNode::Place& place, std::span<const cia407::BusUnit* const> units,
                   const Environment& environment) {
  auto& all = is_there(place.id) ? nodes_ : absent_;
  all.push_back(std::make_unique<BusNode>(world_, index_of(place.id), units, place, environment));
  by_id_.at(place.id) = all.back().get();
  watches_.at(car_of(place.id) - 1).name(all.back()->controller(), place.id);
}

unsigned BusNodes::car_of(NodeId id) const {
  const auto added = std::ranges::find(design().added, id, &AddedDevice::id);
  return added == design().added.end() ? bus_line::car_of(id) : added->car;
}

void BusNodes::complete() {
  std::ranges::sort(nodes_, {}, [](const auto& node) { return node->place().id; });
}

bool BusNodes::is_played(NodeId id) const {
  return is_there(id) && std::ranges::find(options_.real, id) == options_.real.end();
}

bool BusNodes::is_at_work(NodeId id) {
  return canvoy::is_at_work(world_, node(id), watches_.at(car_of(id) - 1),
                            LineControl::node_time_out);
}

bool BusNodes::is_awaited(NodeId id) const {
  const NodeId master = master_of(id);
  if (id != master && !is_played(master)) return true;
  return !is_played(id) && world_.now() < Time(real_start_time);
}

Duration BusNodes::heartbeat_time_out(NodeId id) const {
  return is_played(id) ? LineControl::short_time_out : LineControl::node_time_out;
}

std::array<BusSnapshot, 2> BusNodes::cable_snapshots() {
  const auto look = [this](unsigned car, NodeId id) -> BusSnapshot {
    const SimulatedBus& bus = cable(car);
    return {bus.load(node(id).controller()), bus.statistics().frames,
            bus.statistics().error_frames};
  };
  return {look(1, computer_id), look(2, second_gateway_id)};
}

std::vector<NodeSnapshot> BusNodes::node_snapshots() {
  std::vector<NodeSnapshot> all;
  for (const auto& node : nodes_) {
    const BusWatch& watch = watches_.at(car_of(node->place().id) - 1);
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
