// PDOs that a profile lists (Profile::pdos), as parts of a device: their communication and mapping
// parameters, with the defaults from the list.
//
//     constexpr auto is_mine = [](const PdoInfo& pdo) { return pdo.cob_id == 0x181; };
//     constexpr auto pdos = predefined_pdos<cia407::profile, is_mine>();
//
// And PDOs that a device maker defines, with static mapping:
//
//     constexpr PdoInfo status = {.number = 1, .cob_id = 0x180, .plus_node_id = true,
//                                 .mapping = status_objects};
//     describe(..., static_pdo<status>())
#pragma once

#include <utility>

#include "canvoy/profiles/cia301/channels.hpp"
#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy {

namespace detail {

template <const Profile& profile, std::size_t position>
struct ListedPdo {
  static constexpr const PdoInfo& pdo = profile.pdos[position];
};
template <const PdoInfo& own>
struct OwnPdo {
  static constexpr const PdoInfo& pdo = own;
};

/// Descriptions of one PDO. They live as long as the program.
template <class Source>
class PredefinedPdo {
  static constexpr const PdoInfo& pdo = Source::pdo;
  static constexpr bool is_tpdo = pdo.direction == PdoInfo::Direction::transmit;
  static constexpr const ObjectInfo& parameter_shape =
      is_tpdo ? cia301::tpdo_parameter_object : cia301::rpdo_parameter_object;
  static constexpr const ObjectInfo& mapping_shape =
      is_tpdo ? cia301::tpdo_mapping_object : cia301::rpdo_mapping_object;

  static constexpr EntryInfo with_default(EntryInfo entry, const Default& initial) {
    entry.initial = initial;
    return entry;
  }
  static constexpr EntryInfo parameters[] = {
      cia301::highest_sub_index,
      with_default(cia301::pdo_cob_id_entry,
                   pdo.plus_node_id ? plus_node_id(pdo.cob_id) : Default(pdo.cob_id)),
      with_default(cia301::transmission_type_entry, pdo.transmission_type),
      with_default(cia301::inhibit_time_entry, pdo.inhibit_time),
      with_default(cia301::event_timer_entry, pdo.event_timer)};

  static constexpr auto mapped = [] {
    std::array<EntryInfo, pdo.mapping.size() + 1> entries{};
    entries[0] = with_default(cia301::mapping_number_entry, pdo.mapping.size());
    for (std::size_t i = 1; i < entries.size(); ++i) {
      entries[i] = with_default(cia301::pdo_mapping_entries[1], pdo.mapping[i - 1]);
      entries[i].sub_first = static_cast<std::uint8_t>(i);
      entries[i].sub_last = entries[i].sub_first;
    }
    return entries;
  }();

  static constexpr ObjectInfo object(const ObjectInfo& shape, const Items<EntryInfo>& entries) {
    if (pdo.number == 0) description_is_wrong("the number of the PDO is not known");
    if (pdo.last_number > pdo.number) description_is_wrong("several PDOs in one description");
    if (pdo.multiplexed != MpdoKind::no) description_is_wrong("multiplexed PDOs map nothing");
    ObjectInfo made = shape;
    made.index = static_cast<std::uint16_t>(shape.index + pdo.number - 1);
    made.count = 1;
    made.clause = pdo.clause;
    made.errata = pdo.errata;
    made.subs = entries;
    return made;
  }

 public:
  static constexpr ObjectInfo parameter = object(parameter_shape, parameters);
  static constexpr ObjectInfo mapping = object(mapping_shape, mapped);
};

template <const Profile& profile, std::size_t position, std::size_t capacity>
constexpr void add_predefined_pdo(DeviceDescription<capacity>& parts) {
  using Objects = PredefinedPdo<ListedPdo<profile, position>>;
  parts.add_pdo(Objects::parameter, Objects::mapping);
}

template <const Profile& profile, auto is_wanted>
constexpr std::size_t count_wanted_pdos() {
  std::size_t count = 0;
  for (const PdoInfo& pdo : profile.pdos) count += is_wanted(pdo) ? 1U : 0U;
  return count;
}
/// Positions of the wanted PDOs in the profile's list. A compiler looks at no others.
template <const Profile& profile, auto is_wanted>
inline constexpr auto wanted_pdos = [] {
  std::array<std::size_t, count_wanted_pdos<profile, is_wanted>()> positions{};
  std::size_t found = 0;
  for (std::size_t position = 0; position < profile.pdos.size(); ++position) {
    if (is_wanted(profile.pdos[position])) positions[found++] = position;
  }
  return positions;
}();

}  // namespace detail

/// PDOs of a profile for which `is_wanted(const PdoInfo&)` holds.
template <const Profile& profile, auto is_wanted>
constexpr auto predefined_pdos() {
  constexpr const auto& wanted = detail::wanted_pdos<profile, is_wanted>;
  DeviceDescription<2 * wanted.size()> parts;
  [&]<std::size_t... which>(std::index_sequence<which...>) {
    (detail::add_predefined_pdo<profile, wanted[which]>(parts), ...);
  }(std::make_index_sequence<wanted.size()>());
  return parts;
}

/// A PDO that the device maker fixes: its records can be read but not written, as CiA 301 allows. A
/// device that has only such PDOs carries no code to change them.
template <const PdoInfo& pdo>
constexpr auto static_pdo() {
  using Objects = detail::PredefinedPdo<detail::OwnPdo<pdo>>;
  DeviceDescription<2> parts;
  parts.add_pdo(Part(Objects::parameter).constant(), Part(Objects::mapping).constant());
  return parts;
}

}  // namespace canvoy
