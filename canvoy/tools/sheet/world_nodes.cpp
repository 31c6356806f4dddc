#include "canvoy/tools/sheet/world_nodes.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::tools {

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

namespace {

constexpr std::uint8_t cob_id_sub = 1;

// Cars: CiA 447

/// Position of the predefined PDO with this number in the CAN-IDs of its sender.
std::uint32_t car_can_id(const cia447::PdoOffsets& offsets, NodeId sender, unsigned number) {
  const auto* found = std::ranges::find(cia447::predefined, number, &PdoInfo::number);
  const auto place = static_cast<std::size_t>(found - cia447::predefined.begin());
  return found == cia447::predefined.end() ? 0 : cia447::pdo_base(sender) + offsets.at(place);
}

/// The first node that sends the PDO with this number; null: none.
const DescribedNode* sender_of(const std::vector<DescribedNode>& nodes, unsigned number) {
  const auto parameter = static_cast<std::uint16_t>(object_index::tpdo_parameter + number - 1);
  const auto found = std::ranges::find_if(
      nodes, [&](const DescribedNode& node) { return node.sheet.objects.contains(parameter); });
  return found == nodes.end() ? nullptr : &*found;
}

}  // namespace

/// Sets the PDOs for each node found by the gateway (canvoy/devices/cia447/kit/car_network.hpp).
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

}  // namespace canvoy::tools
