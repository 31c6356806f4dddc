// The dictionary of a small node that is completely configurable: masters write the communication
// and mapping records of four RPDOs and four TPDOs of eight mapped values each, and the parameters
// of SYNC and emergency.
#pragma once

#include "bench/size/small_node.hpp"

namespace canvoy {

inline constexpr auto small_node =
    describe(cia301::device_type(0x0000'0191), cia301::error_register_object,
             cia301::identity({.vendor_id = 1}), cia301::sync(), cia301::error_history(8),
             cia301::emergency(), cia301::heartbeat_producer(1000),
             cia301::rpdo({.number = 1, .entries = 8}), cia301::rpdo({.number = 2}),
             cia301::rpdo({.number = 3}), cia301::rpdo({.number = 4}), cia301::tpdo({.number = 1}),
             cia301::tpdo({.number = 2}), cia301::tpdo({.number = 3}), cia301::tpdo({.number = 4}));
inline constexpr auto node_tables = lay_out_device<small_node>();
/// Not linked; the report reads its size.
extern const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes;
const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes{};

}  // namespace canvoy
