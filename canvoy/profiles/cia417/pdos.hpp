// The pre-defined PDOs of CiA 417-3, from public sources: its text is not at hand. `condition`
// states what is not certain. A PDO has the same number in sender and receiver.
//
//     cia417::lift_pdos<1>[0].cob_id  // 188h
#pragma once

#include "canvoy/profiles/cia417/devices.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::cia417 {

inline constexpr std::string_view pdo_clause = "CiA 417-3";
inline constexpr std::uint32_t invalid_pdo = 0x8000'0000;

/// The code as an object has it.
constexpr std::uint8_t code_of(VirtualDevice device) {
  return static_cast<std::uint8_t>(device);
}
inline constexpr std::uint8_t call_controller[] = {code_of(VirtualDevice::call_controller)};
inline constexpr std::uint8_t input_panels[] = {code_of(VirtualDevice::input_panel_unit)};
inline constexpr std::uint8_t output_panels[] = {code_of(VirtualDevice::output_panel_unit)};
inline constexpr std::uint8_t door_controller[] = {code_of(VirtualDevice::car_door_controller)};
inline constexpr std::uint8_t door_unit[] = {code_of(VirtualDevice::car_door_unit)};
inline constexpr std::uint8_t light_barrier_consumers[] = {
    code_of(VirtualDevice::car_door_controller), code_of(VirtualDevice::car_door_unit)};
inline constexpr std::uint8_t position_unit[] = {code_of(VirtualDevice::car_position_unit)};
inline constexpr std::uint8_t light_barrier[] = {code_of(VirtualDevice::light_barrier_unit)};
inline constexpr std::uint8_t drive_controller[] = {code_of(VirtualDevice::car_drive_controller)};
inline constexpr std::uint8_t drive_unit[] = {code_of(VirtualDevice::car_drive_unit)};
inline constexpr std::uint8_t load_unit[] = {code_of(VirtualDevice::load_measuring_unit)};
inline constexpr std::uint8_t load_consumers[] = {code_of(VirtualDevice::call_controller),
                                                  code_of(VirtualDevice::car_drive_controller)};
inline constexpr std::uint8_t position_consumers[] = {code_of(VirtualDevice::call_controller),
                                                      code_of(VirtualDevice::car_drive_controller)};
inline constexpr std::uint8_t sensor_units[] = {code_of(VirtualDevice::sensor_unit)};

/// The parameter of RPDO 1 is 1400h.
constexpr std::uint16_t number_of_rpdo(unsigned index) {
  return static_cast<std::uint16_t>(index - 0x1400 + 1);
}

// PDOs of many devices: one for each node-ID.

inline constexpr std::uint32_t virtual_input_pdo[] = {mapped_value(virtual_input_mapping_object)};
inline constexpr std::uint32_t virtual_output_pdo[] = {mapped_value(virtual_output_mapping_object)};
inline constexpr std::uint32_t virtual_sensor_pdo[] = {mapped_value(virtual_sensor_mapping_object)};

/// PDOs that a device with any node-ID sends, from node-ID 1 on.
constexpr PdoInfo sent_by_node(std::uint16_t first_rpdo, std::uint32_t cob_id) {
  return {.direction = PdoInfo::Direction::transmit,
          .number = number_of_rpdo(first_rpdo),
          .cob_id = invalid_pdo | cob_id,
          .plus_node_id = true,
          .clause = pdo_clause};
}
/// RPDOs for one message of each of 127 nodes, with consecutive numbers; `cob_id` without the node-
/// ID.
constexpr PdoInfo received_from_nodes(std::uint16_t first_rpdo, std::uint32_t cob_id) {
  return {.direction = PdoInfo::Direction::receive,
          .number = number_of_rpdo(first_rpdo),
          .last_number = static_cast<std::uint16_t>(number_of_rpdo(first_rpdo) + 126),
          .cob_id = cob_id + 1,
          .clause = pdo_clause};
}
/// The PDO with what it carries, and who sends or receives it.
constexpr PdoInfo carrying(PdoInfo pdo, std::string_view name, Items<std::uint32_t> mapping,
                           Items<std::uint8_t> devices, std::string_view condition = {}) {
  pdo.name = name;
  pdo.mapping = mapping;
  pdo.devices = devices;
  pdo.condition = condition;
  return pdo;
}
/// The PDO with the destination and the value in each frame, and so without a mapping.
constexpr PdoInfo multiplexed(PdoInfo pdo) {
  pdo.name = "Multiplexed PDO";
  pdo.multiplexed = MpdoKind::destination;
  return pdo;
}

inline constexpr std::string_view version_1 = "of version 1 of the profile";

inline constexpr std::array node_pdos = {
    multiplexed(received_from_nodes(0x1401, 0x500)),
    multiplexed(sent_by_node(0x1401, 0x500)),
    carrying(received_from_nodes(0x1481, 0x480), "Virtual input", virtual_input_pdo,
             call_controller),
    carrying(sent_by_node(0x1481, 0x480), "Virtual input", virtual_input_pdo, input_panels),
    carrying(received_from_nodes(0x1581, 0x380), "Virtual sensor", virtual_sensor_pdo,
             call_controller, version_1),
    carrying(sent_by_node(0x1581, 0x380), "Virtual sensor", virtual_sensor_pdo, sensor_units,
             version_1),
    carrying({.direction = PdoInfo::Direction::transmit,
              .number = number_of_rpdo(0x1500),
              .cob_id = 0x400,
              .clause = pdo_clause},
             "Virtual output", virtual_output_pdo, call_controller),
    carrying({.direction = PdoInfo::Direction::receive,
              .number = number_of_rpdo(0x1500),
              .cob_id = 0x400,
              .clause = pdo_clause},
             "Virtual output", virtual_output_pdo, output_panels)};

// PDOs of one lift. Numbers and CAN-IDs of the next lift are 10h above. 1510h and 1511h, which door
// 4 uses here, are free between lifts 1 and 2 (1502h to 150Fh, 1512h to 151Fh). For light barrier 4
// of lift 8, 1581h is already used: it has no number.

inline constexpr unsigned lift_pdo_pitch = 0x10;

/// Mapping values of objects of lift `lift`, counted from 1.
constexpr std::uint32_t mapped_in(unsigned lift, const ObjectInfo& object, unsigned sub = 0) {
  return mapped_value(object, sub) + ((lift - 1U) * block_pitch << 16);
}
template <unsigned lift>
inline constexpr std::uint32_t load_pdo[] = {mapped_in(lift, load_signaling_object, 1)};
template <unsigned lift>
inline constexpr std::uint32_t velocity_control_pdo[] = {mapped_in(lift, controlword_object),
                                                         mapped_in(lift, target_velocity_object)};
template <unsigned lift>
inline constexpr std::uint32_t position_control_pdo[] = {mapped_in(lift, controlword_object),
                                                         mapped_in(lift, target_position_object)};
template <unsigned lift>
inline constexpr std::uint32_t position_status_pdo[] = {mapped_in(lift, statusword_object),
                                                        mapped_in(lift, control_effort_object)};
template <unsigned lift>
inline constexpr std::uint32_t car_position_pdo[] = {mapped_in(lift, position_value_object, 1)};
template <unsigned lift>
inline constexpr std::uint32_t velocity_status_pdo[] = {
    mapped_in(lift, statusword_object), mapped_in(lift, velocity_actual_value_object)};
template <unsigned lift>
inline constexpr std::uint32_t door_control_pdo[] = {
    mapped_in(lift, door_controlword_object, 1), mapped_in(lift, door_controlword_object, 2),
    mapped_in(lift, door_controlword_object, 3), mapped_in(lift, door_controlword_object, 4)};
template <unsigned lift, unsigned door>
inline constexpr std::uint32_t door_status_pdo[] = {mapped_in(lift, door_statusword_object, door),
                                                    mapped_in(lift, door_position_object, door)};
template <unsigned lift, unsigned door>
inline constexpr std::uint32_t light_barrier_pdo[] = {
    mapped_in(lift, light_barrier_status_object, door)};

/// One PDO of lift 1, with its sender and receivers.
struct LiftPdo {
  std::uint16_t rpdo = 0;              ///< the parameter object of the receivers; 0: not known
  std::uint32_t cob_id = 0;            ///< of lift 1
  std::string_view name = {};          ///< what it carries
  Items<std::uint32_t> mapping = {};   ///< objects of lift 1
  Items<std::uint8_t> producers = {};  ///< codes of virtual devices
  Items<std::uint8_t> consumers = {};  ///< codes of virtual devices
  std::string_view condition = {};     ///< remark on what is inferred
};
inline constexpr std::string_view lift_conditions[lift_count] = {
    "",
    "of lift 2: the CAN-ID is inferred from lift 1",
    "of lift 3: the CAN-ID is inferred from lift 1",
    "of lift 4: the CAN-ID is inferred from lift 1",
    "of lift 5: the CAN-ID is inferred from lift 1",
    "of lift 6: the CAN-ID is inferred from lift 1",
    "of lift 7: the CAN-ID is inferred from lift 1",
    "of lift 8: the CAN-ID is inferred from lift 1"};

inline constexpr std::size_t lift_pdo_count = 15;
template <unsigned lift>
inline constexpr std::array<LiftPdo, lift_pdo_count> lift_pdo_table = {{
    {0x1502, 0x188, "Load signaling", load_pdo<lift>, load_unit, load_consumers},
    {0x1503, 0x184, "Control, profile velocity", velocity_control_pdo<lift>, drive_controller,
     drive_unit, "the CAN-ID is from one source, number and mapping are inferred"},
    {0x1504, 0x180, "Control, profile position", position_control_pdo<lift>, drive_controller,
     drive_unit},
    {0x1505, 0x181, "Status, profile position", position_status_pdo<lift>, drive_unit,
     drive_controller},
    {0x1506, 0x18C, "Car position", car_position_pdo<lift>, position_unit, position_consumers,
     "the number is from one source; who receives it is not said"},
    {0x1507, 0x185, "Status, profile velocity", velocity_status_pdo<lift>, drive_unit,
     drive_controller},
    {0x1508, 0x200, "Door control", door_control_pdo<lift>, door_controller, door_unit},
    {0x150A, 0x201, "Door 1", door_status_pdo<lift, 1>, door_unit, door_controller},
    {0x150B, 0x205, "Light barrier 1", light_barrier_pdo<lift, 1>, light_barrier,
     light_barrier_consumers},
    {0x150C, 0x202, "Door 2", door_status_pdo<lift, 2>, door_unit, door_controller},
    {0x150D, 0x206, "Light barrier 2", light_barrier_pdo<lift, 2>, light_barrier,
     light_barrier_consumers},
    {0x150E, 0x203, "Door 3", door_status_pdo<lift, 3>, door_unit, door_controller},
    {0x150F, 0x207, "Light barrier 3", light_barrier_pdo<lift, 3>, light_barrier,
     light_barrier_consumers},
    {0x1510, 0x204, "Door 4", door_status_pdo<lift, 4>, door_unit, door_controller,
     "CAN-ID and number are inferred from doors 1 to 3"},
    {0x1511, 0x208, "Light barrier 4", light_barrier_pdo<lift, 4>, light_barrier,
     light_barrier_consumers, "CAN-ID and number are inferred from doors 1 to 3"},
}};

/// Number of a PDO in lift `lift`; 0: not known. Inferred numbers end where the numbers of virtual
/// sensors begin.
constexpr std::uint16_t number_in_lift(const LiftPdo& row, unsigned lift) {
  const unsigned rpdo = row.rpdo + (lift - 1) * lift_pdo_pitch;
  return row.rpdo == 0 || rpdo >= 0x1581 ? std::uint16_t{0} : number_of_rpdo(rpdo);
}

/// A PDO of the table in the CAN-IDs and numbers of a lift.
constexpr PdoInfo lift_pdo(const LiftPdo& row, unsigned lift, PdoInfo::Direction direction) {
  const unsigned step = (lift - 1) * lift_pdo_pitch;
  const bool sends = direction == PdoInfo::Direction::transmit;
  PdoInfo pdo{.direction = direction, .number = 0, .cob_id = row.cob_id + step};
  pdo.number = number_in_lift(row, lift);
  pdo = carrying(pdo, row.name, row.mapping, sends ? row.producers : row.consumers,
                 lift == 1 ? row.condition : lift_conditions[lift - 1]);
  pdo.clause = pdo_clause;
  return pdo;
}
/// Each row of the table, sent and received.
template <unsigned lift>
constexpr std::array<PdoInfo, 2 * lift_pdo_count> pdos_of_lift() {
  std::array<PdoInfo, 2 * lift_pdo_count> pdos{};
  for (std::size_t i = 0; i < lift_pdo_count; ++i) {
    const LiftPdo& row = lift_pdo_table<lift>[i];
    pdos[2 * i] = lift_pdo(row, lift, PdoInfo::Direction::transmit);
    pdos[2 * i + 1] = lift_pdo(row, lift, PdoInfo::Direction::receive);
  }
  return pdos;
}
/// PDOs that belong to lift `lift` alone.
template <unsigned lift>
inline constexpr auto lift_pdos = pdos_of_lift<lift>();

/// The lists one after another.
template <class... Lists>
constexpr auto join_pdos(const Lists&... lists) {
  std::array<PdoInfo, (std::tuple_size_v<Lists> + ...)> all{};
  std::size_t next = 0;
  const auto add = [&](const auto& list) {
    for (const PdoInfo& pdo : list) all[next++] = pdo;
  };
  (add(lists), ...);
  return all;
}
inline constexpr auto pdos =
    join_pdos(node_pdos, lift_pdos<1>, lift_pdos<2>, lift_pdos<3>, lift_pdos<4>, lift_pdos<5>,
              lift_pdos<6>, lift_pdos<7>, lift_pdos<8>);

}  // namespace canvoy::cia417
