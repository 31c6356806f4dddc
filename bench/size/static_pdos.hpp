// The dictionary of a small node with static PDO mapping: the content and the transmission of its
// four RPDOs and four TPDOs are fixed at build time. Masters can read the PDO records, but not
// write them.
#pragma once

#include "bench/size/small_node.hpp"
#include "canvoy/profiles/cia301/predefined_pdo.hpp"

namespace canvoy {

namespace small_io {

inline constexpr EntryInfo input_entries[] = {cia301::highest_sub_index,
                                              {.sub_first = 1,
                                               .sub_last = 16,
                                               .name = "Input",
                                               .type = DataType::unsigned16,
                                               .access = Access::ro,
                                               .mapping = Mapping::optional}};
inline constexpr EntryInfo output_entries[] = {cia301::highest_sub_index,
                                               {.sub_first = 1,
                                                .sub_last = 16,
                                                .name = "Output",
                                                .type = DataType::unsigned16,
                                                .access = Access::rw,
                                                .mapping = Mapping::optional}};
inline constexpr ObjectInfo inputs = {
    .index = 0x2000, .code = ObjectCode::array, .name = "Inputs", .subs = input_entries};
inline constexpr ObjectInfo outputs = {
    .index = 0x2001, .code = ObjectCode::array, .name = "Outputs", .subs = output_entries};

constexpr std::array<std::uint32_t, 4> four_of(const ObjectInfo& object, unsigned first) {
  return {mapped_value(object, first), mapped_value(object, first + 1),
          mapped_value(object, first + 2), mapped_value(object, first + 3)};
}
template <const ObjectInfo& object, unsigned first>
inline constexpr auto mapping = four_of(object, first);

/// RPDOs of every kind: received at once with a deadline, and at SYNC.
template <unsigned number>
inline constexpr PdoInfo rpdo = {.direction = PdoInfo::Direction::receive,
                                 .number = number,
                                 .cob_id = 0x100 + 0x100 * number,
                                 .plus_node_id = true,
                                 .mapping = mapping<outputs, 4 * number - 3>,
                                 .transmission_type = number <= 2 ? 255 : 1,
                                 .event_timer = number == 1 ? 100 : 0};
/// TPDOs of every kind: at events with inhibit time and event timer, cyclic and acyclic at SYNC, on
/// request.
inline constexpr std::uint8_t tpdo_types[] = {255, 1, 0, 253};
template <unsigned number>
inline constexpr PdoInfo tpdo = {.direction = PdoInfo::Direction::transmit,
                                 .number = number,
                                 .cob_id = 0x80 + 0x100 * number,
                                 .plus_node_id = true,
                                 .mapping = mapping<inputs, 4 * number - 3>,
                                 .transmission_type = tpdo_types[number - 1],
                                 .inhibit_time = number == 1 ? 100 : 0,
                                 .event_timer = number == 1 ? 1000 : 0};

}  // namespace small_io

inline constexpr auto small_node =
    describe(cia301::device_type(0x0000'0191), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), Part(cia301::sync_cob_id_object).constant(),
             Part(cia301::sync_window_object).constant(),
             Part(cia301::sync_overflow_object).constant(), cia301::error_history(8),
             cia301::emergency().constant(), cia301::heartbeat_producer(1000), small_io::inputs,
             small_io::outputs, static_pdo<small_io::rpdo<1>>(), static_pdo<small_io::rpdo<2>>(),
             static_pdo<small_io::rpdo<3>>(), static_pdo<small_io::rpdo<4>>(),
             static_pdo<small_io::tpdo<1>>(), static_pdo<small_io::tpdo<2>>(),
             static_pdo<small_io::tpdo<3>>(), static_pdo<small_io::tpdo<4>>());
inline constexpr auto node_tables = lay_out_device<small_node>();
/// Not linked; the report reads its size.
extern const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes;
const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes{};

}  // namespace canvoy
