#include "canvoy/devices/cia447/kit/car_places.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia447/device.hpp"
#include "canvoy/profiles/cia447/pdos.hpp"

namespace canvoy::cia447 {

bool CarPlace::fits(const LssAddress& address) const {
  for (std::size_t part = 0; part < identity.known.size(); ++part) {
    if (identity.known[part] && identity.address.parts[part] != address.parts[part]) return false;
  }
  return !is_of_anyone();
}

DeviceMark mark_of(const VirtualDeviceInfo& device) {
  constexpr auto sent = pdos_of(PdoInfo::Direction::transmit);
  for (const PdoInfo& pdo : sent) {
    const bool is_of_it =
        can_be_mapped(pdo) && std::ranges::all_of(pdo.mapping, [&](std::uint32_t raw) {
          return std::ranges::find(device.objects, MappingValue(raw).index, &DeviceObject::index) !=
                 device.objects.end();
        });
    if (!is_of_it) continue;
    return {static_cast<std::uint16_t>(object_index::tpdo_parameter + pdo.number - 1U), 1};
  }
  return {device.objects[device.objects.size() - 1].index, 0};
}

std::optional<NodeId> place_for(std::span<const CarPlace> places, const LssAddress& address,
                                const NodeSet& present) {
  const auto found = std::ranges::find_if(
      places, [&](const CarPlace& place) { return place.fits(address) && !present[place.id]; });
  return found == places.end() ? std::nullopt : std::optional(found->id);
}

std::optional<NodeId> only_place(std::span<const CarPlace> places, const NodeSet& present) {
  std::optional<NodeId> only;
  for (const CarPlace& place : places) {
    if (!place.is_of_anyone()) continue;
    if (only) return std::nullopt;
    only = place.id;
  }
  return only && !present[*only] ? only : std::nullopt;
}

}  // namespace canvoy::cia447
