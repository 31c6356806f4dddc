#include "canvoy/devices/cia407/kit/bus_device.hpp"

#include <algorithm>

namespace canvoy::cia407 {

namespace {

bool starts_others(std::span<const BusUnit* const> units, const BusSegment& segment) {
  const DeviceCode first = segment.has_main_computer ? DeviceCode::main_on_board_computer
                                                     : DeviceCode::train_bus_gateway;
  return segment.is_started_by_first && std::ranges::any_of(units, [first](const BusUnit* unit) {
           return unit->provides->code == code_of(first);
         });
}

std::size_t routes_of(std::span<const BusUnit* const> units, const BusSegment& segment) {
  std::size_t routes = starts_others(units, segment) ? NetworkStart::routes : 0;
  for (const BusUnit* unit : units) routes += unit->routes;
  return routes;
}

}  // namespace

std::vector<Part> bus_parts(std::span<const BusUnit* const> units, const BusSegment& segment) {
  return BusParts<std::vector<Part>>(units, segment).make();
}

BusDevice::BusDevice(std::span<const BusUnit* const> units, const Port& port, NodeId node_id,
                     const Environment& environment)
    : tables_(bus_parts(units, environment.get<BusSegment>())),
      device_(tables_.tables(), port, node_id,
              catalogue_routes + routes_of(units, environment.get<BusSegment>())),
      all_(device_.node()) {
  environment.made<VirtualDevices>(all_, device_.node());
  for (const BusUnit* kind : units) {
    VirtualDevice& device = virtual_devices_.emplace_back(
        all_, *kind->provides, static_cast<unsigned>(virtual_devices_.size() + 1));
    units_.make(*kind, device, environment);
  }
  const BusSegment segment = environment.get<BusSegment>();
  take_files(bus_parts(units, segment));
  if (starts_others(units, segment)) start_ = std::make_unique<NetworkStart>(node());
}

/// A file that no unit uses is still accepted: the device offers it.
void BusDevice::take_files(std::span<const Part> parts) {
  const Dictionary& dictionary = node().dictionary();
  for (const Part& part : parts) {
    const Result<Entry> entry = dictionary.find(part.index(), 0);
    const bool is_file = entry && entry->row->type == DataType::domain;
    if (!is_file || dictionary.domain(*entry) != nullptr) continue;
    TakenFile& taken = taken_files_.emplace_back(virtual_devices_.front(), part.index());
    taken.file.shelf().on_stored = callback<&BusDevice::file_taken>(*this);
  }
}

std::span<const std::uint8_t> BusDevice::taken_file(std::uint16_t index) {
  const auto found = std::ranges::find(taken_files_, index, &TakenFile::index);
  return found == taken_files_.end() ? std::span<const std::uint8_t>()
                                     : found->file.shelf().file(0);
}

}  // namespace canvoy::cia407
