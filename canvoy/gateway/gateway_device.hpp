// The gateway as a CANopen device: its object dictionary, with room for 512 PDOs of either
// direction and for their values.
//
//     auto device = std::make_unique<GatewayDevice>(port, node_id, true);
#pragma once

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::gateway {

/// Where the values of PDOs are kept: one object for each PDO. As a PDO can have any sequence of
/// lengths, the object has as many entries of each length as fit into a PDO.
struct PdoStorage {
  static constexpr std::uint16_t rpdo_first = 0x2000;  ///< index of the object of RPDO 1
  static constexpr std::uint16_t tpdo_first = 0x2200;  ///< index of the object of TPDO 1
  /// Entries of one length in such an object.
  struct Room {
    std::uint8_t bits;       ///< length of each
    std::uint8_t sub_first;  ///< first of their sub-indices
    std::uint8_t count;      ///< number of them
  };
  /// All lengths, whole bytes first.
  static constexpr std::array<Room, 9> rooms = {{{8, 1, 8},
                                                 {16, 9, 4},
                                                 {24, 13, 2},
                                                 {32, 15, 2},
                                                 {40, 17, 1},
                                                 {48, 18, 1},
                                                 {56, 19, 1},
                                                 {64, 20, 1},
                                                 {1, 21, 64}}};
};

namespace detail {

constexpr EntryInfo pdo_value(std::uint8_t first, std::uint8_t last, DataType type) {
  return {.sub_first = first,
          .sub_last = last,
          .name = "Value",
          .type = type,
          .access = Access::rw,
          .mapping = Mapping::optional,
          .initial = 0};
}
inline constexpr EntryInfo pdo_value_entries[] = {
    cia301::highest_sub_index,
    pdo_value(1, 8, DataType::unsigned8),
    pdo_value(9, 12, DataType::unsigned16),
    pdo_value(13, 14, DataType::unsigned24),
    pdo_value(15, 16, DataType::unsigned32),
    pdo_value(17, 17, DataType::unsigned40),
    pdo_value(18, 18, DataType::unsigned48),
    pdo_value(19, 19, DataType::unsigned56),
    pdo_value(20, 20, DataType::unsigned64),
    pdo_value(21, 84, DataType::boolean),
};
inline constexpr ObjectInfo rpdo_values = {.index = PdoStorage::rpdo_first,
                                           .count = 512,
                                           .code = ObjectCode::record,
                                           .name = "Values received",
                                           .category = Category::optional,
                                           .subs = pdo_value_entries};
inline constexpr ObjectInfo tpdo_values = {.index = PdoStorage::tpdo_first,
                                           .count = 512,
                                           .code = ObjectCode::record,
                                           .name = "Values to send",
                                           .category = Category::optional,
                                           .subs = pdo_value_entries};

inline constexpr auto gateway_description = describe(
    cia301::device_type(0), cia301::error_register_object, cia301::identity({.product_code = 309}),
    cia301::names({.device = "Canvoy CiA 309 gateway",
                   .hardware_version = "host",
                   .software_version = "0.1.0"}),
    cia301::guard_time_object, cia301::life_time_factor_object, cia301::heartbeat_producer(0),
    cia301::heartbeat_consumers(node_id_max), cia301::emergency(), cia301::error_history(8),
    // The loss of a node does not stop the PDOs of the gateway.
    Part(cia301::error_behavior_object).up_to(1).initial(1, 1), cia301::sync(),
    cia301::rpdo_parameter_object, cia301::rpdo_mapping_object, cia301::tpdo_parameter_object,
    cia301::tpdo_mapping_object, rpdo_values, tpdo_values);
inline constexpr auto gateway_layout = lay_out_device<gateway_description>();

/// Number of CAN-IDs beside those of the device: answers of 127 SDO servers, of LSS slaves, and to
/// guarding.
inline constexpr std::size_t gateway_routes = 2 * node_id_max + 2;

}  // namespace detail

/// Node and services of a gateway.
using GatewayDevice = DeviceNode<detail::gateway_layout, detail::gateway_routes>;

}  // namespace canvoy::gateway
