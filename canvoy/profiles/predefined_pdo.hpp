// The PDOs that a profile defines in a table (Profile::pdos) as parts of a device, with their
// CAN-ID, type and mapping as defaults.
//
//     add_predefined_pdo<cia417::node_pdos, 3>(parts);
//
// All of it happens at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy {

namespace detail {

/// The mapping parameter of one PDO of a table.
template <const auto& pdos, std::size_t position>
struct PredefinedMapping {
  static constexpr const PdoInfo& pdo = pdos[position];
  static constexpr bool is_tpdo = pdo.direction == PdoInfo::Direction::transmit;
  static constexpr const ObjectInfo& shape =
      is_tpdo ? cia301::tpdo_mapping_object : cia301::rpdo_mapping_object;

  static constexpr auto entries = [] {
    std::array<EntryInfo, pdo.mapping.size() + 1> made{};
    made[0] = shape.subs[0];
    made[0].initial = Default(pdo.mapping.size());
    for (std::size_t i = 1; i < made.size(); ++i) {
      made[i] = shape.subs[1];
      made[i].sub_first = static_cast<std::uint8_t>(i);
      made[i].sub_last = made[i].sub_first;
      made[i].initial = Default(pdo.mapping[i - 1]);
    }
    return made;
  }();
  static constexpr ObjectInfo object = {
      .index = static_cast<std::uint16_t>(shape.index + pdo.number - 1),
      .code = ObjectCode::record,
      .name = shape.name,
      .category = Category::optional,
      .clause = pdo.clause,
      .errata = pdo.errata,
      .description = pdo.name,
      .subs = entries};
};

constexpr Part predefined_parameter(const PdoInfo& pdo) {
  const ObjectInfo& object = pdo.direction == PdoInfo::Direction::transmit
                                 ? cia301::tpdo_parameter_object
                                 : cia301::rpdo_parameter_object;
  return Part(object)
      .only(pdo.number - 1U)
      .initial(1, pdo.plus_node_id ? plus_node_id(pdo.cob_id) : Default(pdo.cob_id))
      .initial(2, pdo.transmission_type)
      .initial(3, pdo.inhibit_time)
      .initial(5, pdo.event_timer);
}

}  // namespace detail

/// Whether `parts` has all that a PDO maps.
template <std::size_t capacity>
constexpr bool has_mapped(const DeviceDescription<capacity>& parts, const PdoInfo& pdo) {
  for (const std::uint32_t raw : pdo.mapping) {
    const MappingValue mapped(raw);
    const Part* part = parts.find(mapped.index);
    if (part == nullptr || mapped.sub > part->highest_sub()) return false;
  }
  return true;
}

/// Adds one PDO of a table: of several of one shape the first.
template <const auto& pdos, std::size_t position, std::size_t capacity>
constexpr void add_predefined_pdo(DeviceDescription<capacity>& parts) {
  static_assert(pdos[position].number != 0, "the number of this PDO is not known");
  parts.add_pdo(detail::predefined_parameter(pdos[position]),
                detail::PredefinedMapping<pdos, position>::object);
}

/// Adds those that `wanted` says of a PDO, where all that they map is there.
template <const auto& pdos, std::size_t capacity, class Wanted>
constexpr void add_predefined_pdos(DeviceDescription<capacity>& parts, Wanted wanted) {
  const auto add = [&]<std::size_t position>() {
    constexpr const PdoInfo& pdo = pdos[position];
    if constexpr (pdo.number != 0 && pdo.multiplexed == MpdoKind::no) {
      if (wanted(pdo) && has_mapped(parts, pdo)) add_predefined_pdo<pdos, position>(parts);
    }
  };
  [&]<std::size_t... position>(std::index_sequence<position...>) {
    (add.template operator()<position>(), ...);
  }(std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(pdos)>>>{});
}

}  // namespace canvoy
