// The pre-defined PDOs of a profile, whether it describes them in a table (Profile::pdos) or as the
// PDO parameters of its devices (1400h to 1BFFh).
//
//     for_each_pdo(cia419::profile, [](const PdoInfo& pdo) { ... });  // RPDO 1 first
#pragma once

#include <array>

#include "canvoy/profiles/model/description.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy {

namespace detail {

/// The PDO that the objects at `parameter` and `mapping` describe, with the mapped entries in
/// `mapped`.
inline PdoInfo pdo_of(const ObjectInfo& parameter, const ObjectInfo* mapping,
                      std::array<std::uint32_t, pdo_bits_max>& mapped) {
  constexpr unsigned first_tpdo = 0x1800;
  const bool is_tpdo = parameter.index >= first_tpdo;
  PdoInfo pdo = {.direction = is_tpdo ? PdoInfo::Direction::transmit : PdoInfo::Direction::receive,
                 .number = static_cast<std::uint16_t>((parameter.index & 0x1FF) + 1),
                 .clause = parameter.clause,
                 .errata = parameter.errata};
  if (parameter.category == Category::conditional) pdo.condition = parameter.condition;
  const auto number = [&parameter](unsigned sub) {
    const EntryInfo* entry = find_entry(parameter, sub);
    return entry == nullptr ? std::int64_t{0} : entry->initial.number;
  };
  if (const EntryInfo* cob_id = find_entry(parameter, 1)) {
    pdo.cob_id = static_cast<std::uint32_t>(cob_id->initial.number);
    pdo.plus_node_id = cob_id->initial.kind == Default::Kind::plus_node_id;
  }
  pdo.transmission_type = static_cast<std::uint8_t>(number(2));
  pdo.inhibit_time = static_cast<std::uint16_t>(number(3));
  pdo.event_timer = static_cast<std::uint16_t>(number(5));
  std::size_t count = 0;
  if (mapping != nullptr) {
    for (const EntryInfo& entry : mapping->entries()) {
      if (entry.sub_first == 0 || !entry.initial || count == mapped.size()) continue;
      mapped[count++] = static_cast<std::uint32_t>(entry.initial.number);
    }
  }
  pdo.mapping = Items<std::uint32_t>(mapped.data(), count);
  return pdo;
}

}  // namespace detail

/// Calls `visit` with the PDOs, those of the objects first. Its argument lives until it returns.
template <class Visit>
void for_each_pdo(const Profile& profile, Visit visit) {
  constexpr unsigned to_mapping = 0x200;
  for (const ObjectInfo* object : profile.objects) {
    const bool is_parameter = is_pdo_mapping(object->index + to_mapping);
    // CiA 301 describes all PDOs in one object, without separate mappings.
    if (!is_parameter || object->count != 1) continue;
    std::array<std::uint32_t, pdo_bits_max> mapped;
    visit(detail::pdo_of(*object, find_object(profile, object->index + to_mapping), mapped));
  }
  for (const PdoInfo& pdo : profile.pdos) visit(pdo);
}

}  // namespace canvoy
