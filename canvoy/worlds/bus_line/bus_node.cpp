#include "canvoy/worlds/bus_line/bus_node.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/sim/device_name.hpp"

namespace canvoy::bus_line {

namespace {

constexpr std::uint16_t rpdo_mappings = object_index::rpdo_mapping;
constexpr std::uint16_t tpdo_mappings = object_index::tpdo_mapping;
constexpr std::uint16_t to_mapping = 0x200;
constexpr std::uint16_t pdos_looked_at = 64;

}  // namespace

BusNode::BusNode(World& world, BusIndex bus, std::span<const cia407::BusUnit* const> units,
                 const Place& place, const Environment& environment)
    : world_(world),
      bus_(bus),
      slot_(world.add_slot(bus)),
      units_(units),
      place_(place),
      environment_(environment) {
  make();
}

void BusNode::make() {
  identity_.reset();
  device_.reset();
  device_ =
      std::make_unique<cia407::BusDevice>(units_, world_.port(slot_), place_.id, environment_);
  identity_.emplace(node(), IdentityValues{.serial_number = place_.serial_number});
  next_restored_ = node().on_defaults_restored(callback<&BusNode::restore>(*this));
  world_.occupy(slot_, node());
}

void BusNode::restore(ResetScope scope) {
  if (next_restored_) next_restored_(scope);
  for (const Preset& preset : presets_) {
    node().dictionary().set_number(preset.index, preset.sub, preset.value);
  }
}

void BusNode::power(bool is_on) {
  world_.stop(slot_);
  if (!is_on || !place_.is_played) return;
  make();
  world_.start(slot_);
}

std::optional<std::uint16_t> BusNode::find_pdo(std::uint16_t first_mapping,
                                               std::span<const std::uint32_t> mapping,
                                               unsigned number) {
  const Dictionary& dictionary = node().dictionary();
  for (std::uint16_t i = 0; i < pdos_looked_at; ++i) {
    const auto index = static_cast<std::uint16_t>(first_mapping + i);
    if (!dictionary.find(index, 0) || dictionary.word(index, 0) != mapping.size()) continue;
    bool is_same = true;
    for (std::size_t sub = 1; sub <= mapping.size(); ++sub) {
      is_same =
          is_same && dictionary.word(index, static_cast<std::uint8_t>(sub)) == mapping[sub - 1];
    }
    if (is_same && number-- == 0) return static_cast<std::uint16_t>(index - to_mapping);
  }
  return std::nullopt;
}

bool BusNode::preset_rpdo(std::span<const std::uint32_t> mapping, std::uint32_t can_id,
                          unsigned number) {
  const auto parameter = find_pdo(rpdo_mappings, mapping, number);
  if (parameter) preset({*parameter, 1, can_id});
  return parameter.has_value();
}

bool BusNode::preset_tpdo(std::span<const std::uint32_t> mapping, std::uint32_t can_id) {
  const auto parameter = find_pdo(tpdo_mappings, mapping, 0);
  if (parameter) preset({*parameter, 1, can_id});
  return parameter.has_value();
}

std::string BusNode::device_name() const {
  return canvoy::device_name<cia407::BusUnit>(units_, cia407::application);
}

}  // namespace canvoy::bus_line
