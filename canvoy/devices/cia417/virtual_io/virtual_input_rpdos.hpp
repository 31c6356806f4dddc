// The RPDOs by which a call controller receives the panels: one for each node-ID (RPDO 1481h and up
// of CiA 417-3, COB-ID 480h + node-ID).
//
//     constexpr auto mine = describe(..., virtual_input_rpdos<127>());
//     use_panels(node.dictionary(), 127);   // when defaults are restored
//
// The facts are from public sources (grade A, see canvoy/profiles/cia417/pdos.hpp).
#pragma once

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"

namespace canvoy::cia417 {

/// Number of the RPDO for node-ID 1.
inline constexpr std::uint16_t first_input_rpdo = number_of_rpdo(0x1481);
inline constexpr std::uint32_t first_input_cob_id = 0x481;  ///< of node-ID 1

namespace detail {

constexpr EntryInfo with_initial(EntryInfo entry, std::uint32_t initial) {
  entry.initial = initial;
  return entry;
}
constexpr EntryInfo only_mapped(std::uint32_t mapped) {
  EntryInfo entry = with_initial(cia301::pdo_mapping_entries[1], mapped);
  entry.sub_last = entry.sub_first;
  return entry;
}

inline constexpr EntryInfo input_rpdo_parameters[] = {
    cia301::highest_sub_index,
    with_initial(cia301::pdo_cob_id_entry, invalid_pdo | (first_input_cob_id - 1)),
    cia301::transmission_type_entry};
inline constexpr EntryInfo input_rpdo_mapping[] = {
    with_initial(cia301::mapping_number_entry, 1),
    only_mapped(mapped_value(virtual_input_mapping_object))};

/// `count` objects of one shape, starting with those of PDO `first`.
constexpr ObjectInfo rpdo_objects(ObjectInfo shape, Items<EntryInfo> entries, unsigned first,
                                  unsigned count) {
  shape.index = static_cast<std::uint16_t>(shape.index + first - 1);
  shape.count = static_cast<std::uint16_t>(count);
  shape.clause = pdo_clause;
  shape.subs = entries;
  return shape;
}
template <unsigned first, unsigned count>
inline constexpr ObjectInfo input_rpdo_parameter_objects =
    rpdo_objects(cia301::rpdo_parameter_object, input_rpdo_parameters, first, count);
template <unsigned first, unsigned count>
inline constexpr ObjectInfo input_rpdo_mapping_objects =
    rpdo_objects(cia301::rpdo_mapping_object, input_rpdo_mapping, first, count);

}  // namespace detail

/// For node-IDs 1 to `count`. They are invalid until use_panels(): their COB-IDs differ, while one
/// description has the default of all. With another `first`, a device with little memory has them
/// at lower numbers than in part 3.
template <unsigned count, unsigned first = first_input_rpdo>
constexpr auto virtual_input_rpdos() {
  DeviceDescription<2> parts;
  parts.add(detail::input_rpdo_parameter_objects<first, count>);
  parts.add(detail::input_rpdo_mapping_objects<first, count>);
  return parts;
}

/// Makes those of node-IDs 1 to `count` valid, except for `own`. Call it when power-on defaults
/// have been restored (Node::on_defaults_restored).
inline void use_panels(Dictionary& dictionary, unsigned count, NodeId own,
                       unsigned first = first_input_rpdo) {
  for (unsigned i = 0; i < count; ++i) {
    const auto parameter = static_cast<std::uint16_t>(object_index::rpdo_parameter + first - 1 + i);
    if (i + 1 != own) dictionary.set_number(parameter, 1, first_input_cob_id + i);
  }
}

}  // namespace canvoy::cia417
