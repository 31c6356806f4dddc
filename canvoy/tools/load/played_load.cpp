#include "canvoy/tools/load/played_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "canvoy/tools/load/heard_load.hpp"
#include "canvoy/tools/play/world.hpp"

namespace canvoy::tools {

std::vector<LoadedBus> played_load(TomlTable& table, const std::string& path, Duration after,
                                   Duration length) {
  std::string name;
  table.take("network", name);
  const auto world = std::ranges::find(worlds(), name, &WorldEntry::name);
  if (world == worlds().end()) {
    table.refuse("network", fmt::format("'{}' is not known; there are {}", name, world_names()));
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const HeardWorld made = world->make(table, folder);
  PlayedNetwork& network = *made.network;
  const std::vector<std::string> names = network.bus_names();
  network.run_until(Time(after));
  struct Ear {
    HeardLoad* load;
    std::string name;
  };
  HeardLoad load;
  std::vector<Ear> ears;
  ears.reserve(names.size());
  for (const std::string& name : names) ears.push_back({&load, name});
  for (BusIndex bus = 0; bus < names.size(); ++bus) {
    network.world().bus(bus).observe(
        {.context = &ears[bus],
         .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
           const Ear& ear = *static_cast<Ear*>(context);
           ear.load->add(now.time_since_epoch(), ear.name, frame);
         }});
  }
  network.run_until(Time(after + length));
  std::vector<LoadedBus> buses = load.buses(length);
  for (LoadedBus& bus : buses) {
    const auto index = static_cast<BusIndex>(std::ranges::find(names, bus.name) - names.begin());
    bus.bit_rate = made.bit_rates.at(index);
  }
  return buses;
}

}  // namespace canvoy::tools
