#include "canvoy/tools/sheet/world_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/sim/excavator/excavator_network.hpp"
#include "canvoy/sim/excavator/machine_control.hpp"
#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/tools/run/bus_file.hpp"
#include "canvoy/tools/run/excavator_file.hpp"
#include "canvoy/tools/run/police_file.hpp"
#include "canvoy/tools/run/taxi_file.hpp"
#include "canvoy/tools/toml_file.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint8_t cob_id_sub = 1;

/// What the network writes there. A mapping that has become longer has entries as its first.
void set_entry(formats::DataSheet& sheet, std::uint16_t index, std::uint8_t sub,
               std::uint32_t value) {
  const auto object = sheet.objects.find(index);
  if (object == sheet.objects.end()) return;
  formats::SheetEntry& own = object->second.own;
  auto& subs = object->second.subs;
  const bool is_longer = !subs.empty() && !subs.contains(sub);
  if (is_longer) subs.emplace(sub, subs.contains(1) ? subs.at(1) : subs.begin()->second);
  (subs.empty() ? own : subs.at(sub)).value = fmt::format("0x{:X}", value);
}

// Cars: CiA 447

/// Where the pre-defined PDO of this number is among the CAN-IDs of the node that sends it.
std::uint32_t car_can_id(const cia447::PdoOffsets& offsets, NodeId sender, unsigned number) {
  const auto* found = std::ranges::find(cia447::predefined, number, &PdoInfo::number);
  const auto place = static_cast<std::size_t>(found - cia447::predefined.begin());
  return found == cia447::predefined.end() ? 0 : cia447::pdo_base(sender) + offsets.at(place);
}

/// The first node that sends the PDO of this number; null: there is none.
const DescribedNode* sender_of(const std::vector<DescribedNode>& nodes, unsigned number) {
  const auto parameter = static_cast<std::uint16_t>(object_index::tpdo_parameter + number - 1);
  const auto found = std::ranges::find_if(
      nodes, [&](const DescribedNode& node) { return node.sheet.objects.contains(parameter); });
  return found == nodes.end() ? nullptr : &*found;
}

/// As each node has them when the gateway has found it (canvoy/devices/cia447/car_network.hpp).
void place_car_pdos(std::vector<DescribedNode>& nodes, const cia447::PdoOffsets& offsets) {
  for (const PdoInfo& pdo : cia447::predefined) {
    const auto rpdo = static_cast<std::uint16_t>(object_index::rpdo_parameter + pdo.number - 1);
    const auto tpdo = static_cast<std::uint16_t>(object_index::tpdo_parameter + pdo.number - 1);
    const DescribedNode* sender = sender_of(nodes, pdo.number);
    for (DescribedNode& node : nodes) {
      set_entry(node.sheet, tpdo, cob_id_sub, car_can_id(offsets, node.id, pdo.number));
      if (sender == nullptr) continue;
      set_entry(node.sheet, rpdo, cob_id_sub, car_can_id(offsets, sender->id, pdo.number));
    }
  }
}

template <class Network>
std::vector<DescribedNode> of_network(const Network& network) {
  std::vector<DescribedNode> nodes;
  for (const auto& node : network.nodes()) {
    DescribedNode& made =
        nodes.emplace_back(describe_device(node->device_name(), node->place().id));
    made.name = node->place().name;
    // Of two cars each has a bus, as in the log of a run.
    if constexpr (requires { node->bus(); }) made.bus = fmt::format("sim{}", node->bus());
    if constexpr (requires { node->presets(); }) {
      for (const auto& preset : node->presets()) {
        set_entry(made.sheet, preset.index, preset.sub, preset.value);
      }
    }
  }
  return nodes;
}

template <class Network, class Options>
std::vector<DescribedNode> of_car(const Options& options, const cia447::PdoOffsets& offsets) {
  std::vector<DescribedNode> nodes = of_network(*std::make_unique<Network>(options));
  place_car_pdos(nodes, offsets);
  return nodes;
}

// Excavators: CiA 852 and CiA 401

/// The device of the catalogue that a node is; empty: it is none, as the host.
std::string excavator_device(NodeId id) {
  if (id == excavator::seat_id) return "operator";
  return id == excavator::host_id ? "" : "io-401";
}

std::vector<excavator::SetupWrite> excavator_setup(NodeId id, const excavator::HostSettings& host) {
  if (id == excavator::seat_id) return seat_setup(host);
  return id == excavator::valves_id ? valves_setup(host) : std::vector<excavator::SetupWrite>{};
}

/// As the host has set them up. That writes a COB-ID twice: the last counts.
std::vector<DescribedNode> of_excavator(const excavator::ExcavatorOptions& options) {
  std::vector<DescribedNode> nodes;
  const auto network = std::make_unique<excavator::ExcavatorNetwork>(options);
  for (const auto& node : network->nodes()) {
    const NodeId id = node->place().id;
    const std::string device = excavator_device(id);
    DescribedNode& made =
        nodes.emplace_back(device.empty() ? DescribedNode{.id = id} : describe_device(device, id));
    made.name = node->place().name;
    made.bus = fmt::format("sim{}", node->bus());
    for (const excavator::SetupWrite& write : excavator_setup(id, network->host_settings())) {
      set_entry(made.sheet, write.index, write.sub, write.value);
    }
  }
  return nodes;
}

}  // namespace

std::vector<DescribedNode> describe_world(const std::string& path) {
  TomlFile file(path);
  TomlTable& table = file.table();
  std::string network;
  table.take("network", network);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (network == "taxi") {
    const TaxiRun run = read_taxi_run(table, folder);
    return of_car<taxi::TaxiNetwork>(run.network, run.network.car_network.nodes.pdo_offsets);
  }
  if (network == "police") {
    return of_car<police::PoliceNetwork>(read_police_run(table).network, cia447::listed_offsets());
  }
  if (network == "bus") {
    return of_network(*std::make_unique<bus::BusNetwork>(read_bus_run(table, folder).network));
  }
  if (network == "excavator") return of_excavator(read_excavator_run(table, folder).network);
  return {};
}

}  // namespace canvoy::tools
