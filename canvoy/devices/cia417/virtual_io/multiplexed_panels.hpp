// The parts of a call controller that receive panels by multiplexed PDOs (CiA 301, 7.2.3), in
// either mode, beside panels with a separate PDO for 6010h: one RPDO for each node-ID, with COB-ID
// 500h + node-ID.
//
//     constexpr auto mine = describe(..., virtual_input_rpdos<127>(),
//                                    multiplexed_panels<MpdoMode::destination, 127>());
//     use_multiplexed_panels(node.dictionary(), 127, own);   // when defaults are restored
//
// The coding of a record of 48 bits in them is our choice (virtual_mpdo.hpp), and so are the
// numbers of these RPDOs: behind those known from part 3, from 1520h on. CallControllerDevice does
// the rest if its layout has 5F11h.
#pragma once

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_input_rpdos.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mpdo.hpp"

namespace canvoy::cia417 {

/// Number of the RPDO for node-ID 1.
inline constexpr std::uint16_t first_multiplexed_rpdo =
    number_of_rpdo(object_index::rpdo_parameter + 1);
inline constexpr std::uint32_t first_multiplexed_cob_id = 0x501;  ///< of node-ID 1

/// True if a dictionary has the objects of multiplexed_panels().
constexpr bool hears_multiplexed(const DictionaryTables& tables) {
  for (const ObjectRow& object : tables.objects) {
    if (object.index == received_parts_object.index) return true;
  }
  return false;
}

/// For node-IDs 1 to `count`, in one mode by default: a configuration tool can write FEh or FFh
/// into their mapping for the other mode. 5F11h takes 1 KiB, 1FD0h eight bytes for each. With
/// another `first`, they are at other numbers than in part 3.
template <MpdoMode mode, unsigned count, unsigned first = first_multiplexed_rpdo>
constexpr auto multiplexed_panels() {
  constexpr std::uint8_t event_driven = 254;
  DeviceDescription<8> parts;
  parts.add(Part(cia301::rpdo_parameter_object)
                .only(first - 1, count)
                .initial(1, invalid_pdo | first_multiplexed_cob_id)
                .initial(2, event_driven));
  parts.add(Part(cia301::rpdo_mapping_object)
                .only(first - 1, count)
                .up_to(1)
                .initial(static_cast<std::uint8_t>(mode)));
  parts.add(cia301::dispatching_lists(count));
  parts.add(received_parts_object);
  return parts;
}

/// Makes those of node-IDs 1 to `count` valid, except for `own`, and lists the parts that they send
/// in source address mode. Call it when power-on defaults have been restored.
inline void use_multiplexed_panels(Dictionary& dictionary, unsigned count, NodeId own,
                                   unsigned first = first_multiplexed_rpdo) {
  for (unsigned id = 1; id <= count; ++id) {
    if (id == own) continue;
    const auto parameter =
        static_cast<std::uint16_t>(object_index::rpdo_parameter + first + id - 2);
    dictionary.set_number(parameter, 1, first_multiplexed_cob_id + id - 1);
    // Two objects from 5F10h:01h of that node on, to its two in 5F11h.
    const std::uint64_t entry = std::uint64_t{2} << 56 |
                                std::uint64_t{received_parts_object.index} << 40 |
                                std::uint64_t{2 * id - 1} << 32 |
                                std::uint64_t{record_parts_object.index} << 16 | 1U << 8 | id;
    dictionary.set_number(object_index::dispatching_list, static_cast<std::uint8_t>(id), entry);
  }
}

}  // namespace canvoy::cia417
