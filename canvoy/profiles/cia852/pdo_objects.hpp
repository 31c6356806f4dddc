// CiA 852: the objects 1400h to 1BFFh, made from the parameter sets of clause 12.
//
//     cia852::tpdo_mapping(cia852::joystick_tpdo(2)).index  // 1A04h
#pragma once

#include "canvoy/profiles/cia852/pdos.hpp"

namespace canvoy::cia852 {

/// One PDO: its number, its mapping, and when it is mandatory.
struct PdoSet {
  unsigned number = 0;                ///< from 1
  Items<EntryInfo> mapping = {};      ///< entries of its mapping record
  std::string_view condition = {};    ///< when a device has it
  std::string_view clause = {};       ///< of both records
  std::string_view errata = {};       ///< findings that concern it
  std::string_view description = {};  ///< text for both records
};

inline constexpr std::size_t tpdo_count = 38;  ///< 1, and 5 to 41
inline constexpr std::size_t rpdo_count = 32;  ///< 1, 2, and 4 to 33

/// Sorted by their numbers: 1, 5 to 41.
inline constexpr auto tpdo_sets = [] {
  std::array<PdoSet, tpdo_count> sets{};
  std::size_t place = 0;
  const auto add = [&](const PdoSet& set) { sets[place++] = set; };
  for (unsigned n = 1; n <= joysticks_max; ++n) {
    add({joystick_tpdo(n), joystick_mappings[n - 1], "if the joystick is supported",
         n == 1 ? "12.2.1" : "12.2.2", "", "Position, memory function and buttons of a joystick."});
  }
  for (unsigned i = 0; i < foot_pedal_mappings.size(); ++i) {
    add({foot_pedal_tpdo(foot_pedals_of_tpdo * i + 1), foot_pedal_mappings[i],
         "if the first of the foot pedals is supported", i == 0 ? "12.2.3" : "12.2.4", "16, 21",
         "Memory functions and positions of two foot pedals."});
  }
  for (unsigned i = 0; i < encoder_mappings.size(); ++i) {
    add({encoder_tpdo(encoders_of_tpdo * i + 1), encoder_mappings[i],
         "if the first of the encoders is supported", i == 0 ? "12.2.5" : "12.2.6", "17",
         "Positions of two encoders."});
  }
  for (unsigned i = 0; i < wheel_mappings.size(); ++i) {
    add({wheel_tpdo(wheels_of_tpdo * i + 1), wheel_mappings[i],
         "if the first of the wheels is supported", i == 0 ? "12.2.7" : "12.2.8", "18, 32",
         "Positions of four wheels."});
  }
  for (unsigned n = 1; n <= push_button_clusters_max; ++n) {
    add({push_button_tpdo(n), push_button_mappings[n - 1],
         "if the push-button cluster is supported", n == 1 ? "12.2.9" : "12.2.10", "19, 33",
         "Push-buttons of a cluster."});
  }
  return sets;
}();

/// The RPDO of four parameters of display `n`; `part` counts from 1.
constexpr PdoSet display_set(unsigned n, unsigned part, Items<EntryInfo> mapping) {
  const unsigned number = display_rpdo(n, part);
  return {number,
          mapping,
          "if the first mapped parameter of the display is supported",
          number == 2 ? "12.2.13" : "12.2.14",
          number == 2 ? "28, 34" : "25, 28",
          "Four parameters of a display."};
}
/// Sorted by their numbers: 1, 2, 4, 5 to 33. `of_displays`: the mappings of the RPDOs of displays.
constexpr std::array<PdoSet, rpdo_count> rpdo_sets_with(
    const decltype(display_mappings)& of_displays) {
  std::array<PdoSet, rpdo_count> sets{};
  const auto add = [&](const PdoSet& set) {
    const unsigned place = set.number < 3 ? set.number - 1 : set.number - 2;
    sets[place] = set;
  };
  for (unsigned n = 1; n <= indicator_clusters_max; ++n) {
    add({indicator_rpdo(n), indicator_mappings[n - 1], "if the indicator cluster is supported",
         n == 1 ? "12.2.11" : "12.2.12", "28, 35", "Indicators of a cluster."});
  }
  for (unsigned n = 1; n <= displays_max; ++n) {
    for (unsigned part = 1; part <= rpdos_of_display; ++part) {
      add(display_set(n, part, of_displays[rpdos_of_display * (n - 1) + part - 1]));
    }
  }
  return sets;
}
/// In the usual reading of the displays' sub-indices.
inline constexpr auto rpdo_sets = rpdo_sets_with(display_mappings);
/// In the other reading: wide_display_pitch.
inline constexpr auto wide_rpdo_sets = rpdo_sets_with(wide_display_mappings);

/// Distance of the n-th PDO from the first: n - 1, or as printed in clause 12.
constexpr unsigned offset_of(unsigned number) {
  return number - 1;
}
inline constexpr unsigned first_shifted_tpdo = 20;  ///< errata 16
/// See offset_of(): TPDO 20 and those after it are one further.
constexpr unsigned printed_offset_of(unsigned number) {
  return number < first_shifted_tpdo ? number - 1 : number;
}

/// Communication record of a PDO.
constexpr ObjectInfo parameter_object(unsigned index, const PdoSet& set, std::string_view name,
                                      Items<EntryInfo> entries) {
  return record_object(static_cast<std::uint16_t>(index), name, set.clause, set.description,
                       entries,
                       {.first_number = static_cast<std::uint16_t>(set.number),
                        .condition = set.condition,
                        .errata = set.errata});
}
/// Mapping record of a PDO.
constexpr ObjectInfo mapping_object(unsigned index, const PdoSet& set, std::string_view name) {
  return record_object(static_cast<std::uint16_t>(index), name, set.clause, set.description,
                       set.mapping,
                       {.first_number = static_cast<std::uint16_t>(set.number),
                        .condition = "if the communication parameter of the PDO is implemented",
                        .errata = set.errata});
}

/// An object of each set.
template <std::size_t count, class Make>
constexpr std::array<ObjectInfo, count> objects_of(const std::array<PdoSet, count>& sets,
                                                   Make make) {
  std::array<ObjectInfo, count> made{};
  for (std::size_t i = 0; i < count; ++i) made[i] = make(sets[i]);
  return made;
}
/// Distance of a record from the first one, by the number of the PDO.
using OffsetOf = unsigned (*)(unsigned number);
/// All 1800h ff.
constexpr std::array<ObjectInfo, tpdo_count> tpdo_parameters_at(OffsetOf offset) {
  return objects_of(tpdo_sets, [=](const PdoSet& set) {
    const Items<EntryInfo> entries = set.number == 1 ? Items<EntryInfo>(tpdo1_parameter_entries)
                                                     : Items<EntryInfo>(tpdo_parameter_entries);
    return parameter_object(0x1800 + offset(set.number), set, "TPDO # communication parameter",
                            entries);
  });
}
/// All 1A00h ff.
constexpr std::array<ObjectInfo, tpdo_count> tpdo_mappings_at(OffsetOf offset) {
  return objects_of(tpdo_sets, [=](const PdoSet& set) {
    return mapping_object(0x1A00 + offset(set.number), set, "TPDO # mapping parameter");
  });
}
/// All 1600h ff., with these mappings.
constexpr std::array<ObjectInfo, rpdo_count> rpdo_mappings_of(
    const std::array<PdoSet, rpdo_count>& sets) {
  return objects_of(sets, [](const PdoSet& set) {
    return mapping_object(0x1600 + offset_of(set.number), set, "RPDO # mapping parameter");
  });
}

inline constexpr auto tpdo_parameter_objects = tpdo_parameters_at(offset_of);  ///< 1800h ff.
inline constexpr auto tpdo_mapping_objects = tpdo_mappings_at(offset_of);      ///< 1A00h ff.
/// 1400h ff.
inline constexpr auto rpdo_parameter_objects = objects_of(rpdo_sets, [](const PdoSet& set) {
  return parameter_object(0x1400 + offset_of(set.number), set, "RPDO # communication parameter",
                          rpdo_parameter_entries);
});
inline constexpr auto rpdo_mapping_objects = rpdo_mappings_of(rpdo_sets);  ///< 1600h ff.

// Objects of the other readings.
/// 1800h ff., as printed.
inline constexpr auto printed_tpdo_parameter_objects = tpdo_parameters_at(printed_offset_of);
/// 1A00h ff., as printed.
inline constexpr auto printed_tpdo_mapping_objects = tpdo_mappings_at(printed_offset_of);
/// 1600h ff., with wide displays.
inline constexpr auto wide_rpdo_mapping_objects = rpdo_mappings_of(wide_rpdo_sets);

/// The parameters of one PDO, by its number.
constexpr const ObjectInfo& tpdo_parameter(unsigned number) {
  return tpdo_parameter_objects[number == 1 ? 0 : number - 4];
}
/// The mapping of one TPDO, by its number.
constexpr const ObjectInfo& tpdo_mapping(unsigned number) {
  return tpdo_mapping_objects[number == 1 ? 0 : number - 4];
}
/// The parameters of one RPDO, by its number.
constexpr const ObjectInfo& rpdo_parameter(unsigned number) {
  return rpdo_parameter_objects[number < 3 ? number - 1 : number - 2];
}
/// The mapping of one RPDO, by its number.
constexpr const ObjectInfo& rpdo_mapping(unsigned number) {
  return rpdo_mapping_objects[number < 3 ? number - 1 : number - 2];
}

}  // namespace canvoy::cia852
