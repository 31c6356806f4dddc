// The bus of a group of lifts: the controllers of lifts 1 to 8 as nodes 1 to 8, and a group
// controller. The profile leaves this bus to the maker; it uses the records of the profile (see
// docs/decisions.md).
//
// | from   | CAN-ID   | object | meaning                                                          |
// | ------ | -------- | ------ | ---------------------------------------------------------------- |
// | lift n | 480h + n | 6010h  | a hall or destination call from a panel of lift n                |
// | lift n | 400h + n | 6011h  | where lift n is, goes and stops, and whether it serves           |
// | lift n | 500h + n | 5F11h  | the same calls by multiplexed PDOs, where it is asked to         |
// | group  | 480h + g | 6010h  | a call, and in its lift mask the lift that has to answer it      |
// | group  | 400h     | 6011h  | a call is known, or done: for the panels                         |
//
// A node has its received records in 2010h and 2011h, as its sent ones are in 6010h and 6011h.
#pragma once

#include "canvoy/devices/cia417/virtual_io/multiplexed_panels.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"
#include "canvoy/profiles/cia417/watched_nodes.hpp"

namespace canvoy::cia417 {

/// The node-ID of the group controller: 9 to 16 are gateways on a shaft bus.
inline constexpr NodeId group_controller_id = 17;
inline constexpr std::uint32_t group_input_cob_id = 0x480;   ///< + node-ID
inline constexpr std::uint32_t group_output_cob_id = 0x400;  ///< + lift; of the group controller

/// An object of 48 bits for a record that was received.
constexpr ObjectInfo received_record(std::uint16_t index, std::string_view name) {
  return {.index = index,
          .name = name,
          .category = Category::optional,
          .clause = "docs/decisions.md",
          .entry = {.type = DataType::unsigned48,
                    .access = Access::rw,
                    .mapping = Mapping::optional,
                    .initial = 0,
                    .value = hexadecimal}};
}
/// 6010h of another node.
inline constexpr ObjectInfo group_input_object = received_record(0x2010, "Group input");
/// 6011h of another node.
inline constexpr ObjectInfo group_output_object = received_record(0x2011, "Group output");

/// Of a TPDO's 6010h at the receiver.
inline constexpr std::uint32_t group_input_pdo[] = {mapped_value(group_input_object)};
/// Of a TPDO's 6011h at the receiver.
inline constexpr std::uint32_t group_output_pdo[] = {mapped_value(group_output_object)};

namespace detail {

constexpr PdoInfo group_pdo(PdoInfo::Direction direction, std::uint16_t number,
                            std::uint32_t cob_id, Items<std::uint32_t> mapping,
                            std::uint8_t device) {
  return {.direction = direction,
          .number = number,
          .cob_id = cob_id,
          .plus_node_id = device == 1 && direction == PdoInfo::Direction::transmit,
          .mapping = mapping,
          .clause = "docs/decisions.md"};
}

inline constexpr auto transmit = PdoInfo::Direction::transmit;
inline constexpr auto receive = PdoInfo::Direction::receive;

inline constexpr PdoInfo group_member_pdos[] = {
    group_pdo(transmit, 1, group_input_cob_id, virtual_input_pdo, 1),
    group_pdo(transmit, 2, group_output_cob_id, virtual_output_pdo, 1),
    group_pdo(receive, 1, group_input_cob_id + group_controller_id, group_input_pdo, 1),
    group_pdo(receive, 2, group_output_cob_id, group_output_pdo, 1)};

/// For lift n, the RPDOs n and 8 + n.
inline constexpr auto group_controller_pdos = [] {
  std::array<PdoInfo, 2 * lift_count + 2> pdos{};
  std::size_t next = 0;
  pdos[next++] =
      group_pdo(transmit, 1, group_input_cob_id + group_controller_id, virtual_input_pdo, 0);
  pdos[next++] = group_pdo(transmit, 2, group_output_cob_id, virtual_output_pdo, 0);
  for (std::uint16_t lift = 1; lift <= lift_count; ++lift) {
    pdos[next++] = group_pdo(receive, lift, group_input_cob_id + lift, group_input_pdo, 0);
  }
  for (std::uint16_t lift = 1; lift <= lift_count; ++lift) {
    const auto number = static_cast<std::uint16_t>(lift_count + lift);
    pdos[next++] = group_pdo(receive, number, group_output_cob_id + lift, group_output_pdo, 0);
  }
  return pdos;
}();

inline constexpr Profile group_member_profile = {.number = profile_number,
                                                 .pdos = group_member_pdos};
inline constexpr Profile group_controller_profile = {.number = profile_number,
                                                     .pdos = group_controller_pdos};

template <const Profile& pdos>
constexpr auto group_node() {
  DeviceDescription<48> parts;
  parts.add(cia301::profile);
  parts.add(cia301::device_type(device_type(VirtualDevice::call_controller)));
  parts.add(cia301::error_register_object);
  parts.add(group_input_object);
  parts.add(group_output_object);
  parts.add(virtual_input_mapping_object);
  parts.add(virtual_output_mapping_object);
  constexpr auto is_mine = [](const PdoInfo&) { return true; };
  parts.add(predefined_pdos<pdos, is_mine>());
  return parts;
}

}  // namespace detail

/// A lift detects each loss that its group controller detects, which receives the lift one
/// heartbeat later at most. Therefore the lift sends its whole state again when it receives the
/// group controller again.
inline constexpr std::uint16_t group_heartbeat_ms = 300;
inline constexpr std::uint16_t group_lost_ms = 1000;  ///< silence of the group controller
/// Silence of a lift.
inline constexpr std::uint16_t member_lost_ms = group_lost_ms + group_heartbeat_ms + 100;

/// Of the catalogue; the node-ID is the number of the lift in the group.
inline constexpr DeviceInfo group_member_info = {.name = "lift-group-member",
                                                 .title = "lift controller on the group's bus",
                                                 .product = "Canvoy CiA 417 group member",
                                                 .product_code = 41700,
                                                 .node_id = 1};
/// The parts of a lift controller on the bus of its group: it monitors the group controller.
inline constexpr auto full_group_member =
    describe(detail::group_node<detail::group_member_profile>(),
             cia301::identity({.product_code = group_member_info.product_code}),
             cia301::names({.device = group_member_info.product,
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(group_heartbeat_ms),
             watched_nodes<group_lost_ms, group_controller_id>, cia301::emergency(),
             cia301::error_history(8), cia301::error_behavior().initial(1, keeps_state));
/// Of the catalogue.
inline constexpr DeviceInfo group_controller_info = {.name = "lift-group-controller",
                                                     .title = "group controller of up to 8 lifts",
                                                     .product = "Canvoy CiA 417 group controller",
                                                     .product_code = 41717,
                                                     .node_id = group_controller_id};
/// The parts of a group controller: it monitors the lifts.
inline constexpr auto full_group_controller =
    describe(detail::group_node<detail::group_controller_profile>(),
             cia301::identity({.product_code = group_controller_info.product_code}),
             cia301::names({.device = group_controller_info.product,
                            .hardware_version = "simulated",
                            .software_version = "0.1.0"}),
             cia301::sync_consumer(), cia301::heartbeat_producer(group_heartbeat_ms),
             watched_nodes<member_lost_ms, 1, 2, 3, 4, 5, 6, 7, 8>, cia301::emergency(),
             cia301::error_history(8), cia301::error_behavior().initial(1, keeps_state));

/// Number of the RPDO by which a group controller receives multiplexed PDOs of lift 1.
inline constexpr std::uint16_t first_multiplexed_group_rpdo = 2 * lift_count + 1;
/// Like full_group_controller, but it also takes calls by multiplexed PDOs: the two parts of a
/// record for lift n are 5F11h:2n - 1 and 2n (virtual_mpdo.hpp).
template <MpdoMode mode>
inline constexpr auto multiplexed_group_controller = describe(
    full_group_controller, multiplexed_panels<mode, lift_count, first_multiplexed_group_rpdo>());

}  // namespace canvoy::cia417
