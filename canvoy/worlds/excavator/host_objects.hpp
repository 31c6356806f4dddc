// The dictionary of the host of an excavator: what it receives from the seat and from the input and
// output module, and what it sends them. All of its own PDOs are set at each boot-up.
//
//     DeviceNode<host_layout, host_routes> host(port, host_id, true);
//     NodeConfiguration configuration(host.node(), host_configuration());
#pragma once

#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/sim/node_configuration.hpp"
#include "canvoy/worlds/excavator/machine_wiring.hpp"

namespace canvoy::excavator {

inline constexpr NodeId host_id = 1;     ///< node-ID of the host; NMT master
inline constexpr NodeId seat_id = 10;    ///< node-ID of the seat (CiA 852)
inline constexpr NodeId valves_id = 33;  ///< node-ID of the module on the valves (CiA 401)

// CAN-IDs of their messages: those of the pre-defined connection set as far as they suffice; for
// the wheels and the knob, those of an unused node-ID.
/// Left joystick: axes and contacts.
inline constexpr std::uint32_t left_stick_id = 0x180 + seat_id;
/// Right joystick: axes and contacts.
inline constexpr std::uint32_t right_stick_id = 0x280 + seat_id;
inline constexpr std::uint32_t pedals_id = 0x380 + seat_id;      ///< both pedals
inline constexpr std::uint32_t buttons_id = 0x480 + seat_id;     ///< push-buttons of the seat
inline constexpr std::uint32_t wheels_id = 0x180 + seat_id + 1;  ///< wheels: throttle and rotator
inline constexpr std::uint32_t knob_id = 0x280 + seat_id + 1;    ///< knob: its counter
inline constexpr std::uint32_t trainer_left_id = 0x380 + seat_id + 1;   ///< joystick 3
inline constexpr std::uint32_t trainer_right_id = 0x480 + seat_id + 1;  ///< joystick 4
inline constexpr std::uint32_t lamps_id = 0x200 + seat_id;              ///< indicators of the seat
inline constexpr std::uint32_t display_id = 0x300 + seat_id;       ///< display: parameters 1 to 4
inline constexpr std::uint32_t more_display_id = 0x400 + seat_id;  ///< display: parameters 5 to 8
inline constexpr std::uint32_t angles_id = 0x280 + valves_id;  ///< analogue inputs 1 to 4: angles
/// Analogue inputs 5 to 8: fuel, oil, engine, pressure.
inline constexpr std::uint32_t engine_id = 0x380 + valves_id;
inline constexpr std::uint32_t switches_id = 0x200 + valves_id;     ///< digital outputs
inline constexpr std::uint32_t valve_id = 0x300 + valves_id;        ///< analogue outputs 1 to 4
inline constexpr std::uint32_t more_valves_id = 0x400 + valves_id;  ///< analogue outputs 5 to 8

/// Time after which a silent node is lost: 1016h of host, seat and module.
inline constexpr Duration consumer_time = 500ms;
inline constexpr std::uint16_t heartbeat_ms = 200;  ///< period of all heartbeats
/// Longest interval between positions, which are otherwise stale.
inline constexpr std::uint16_t refresh_ms = 200;
/// Event timer of the RPDOs: older positions close the valves.
inline constexpr std::uint16_t stale_ms = 500;

// Indices of the values.
inline constexpr std::uint16_t axis_values = 0x2000;      ///< x, y and z of each joystick
inline constexpr std::uint16_t joystick_values = 0x2001;  ///< memory and buttons of each
inline constexpr std::uint16_t pedal_values = 0x2002;     ///< both pedals
inline constexpr std::uint16_t pedal_memories = 0x2003;   ///< memories of both pedals
inline constexpr std::uint16_t wheel_values = 0x2004;     ///< throttle and rotator
inline constexpr std::uint16_t knob_value = 0x2005;       ///< counter of the knob
inline constexpr std::uint16_t button_values = 0x2006;    ///< a bit for each push-button
inline constexpr std::uint16_t sensor_values = 0x2010;    ///< in the order of Sensor
inline constexpr std::uint16_t lamp_values = 0x2020;      ///< in the order of Lamp
inline constexpr std::uint16_t shown_values = 0x2021;     ///< in the order of Shown
/// In the order of Movement, and the throttle.
inline constexpr std::uint16_t valve_values = 0x2022;
inline constexpr std::uint16_t switch_values = 0x2023;  ///< digital outputs, as bits of Switched

/// RPDOs of the host, from 1 on.
enum class Input : std::uint8_t {
  left_stick = 1,
  right_stick,
  pedals,
  buttons,
  wheels,
  knob,
  angles,
  engine,
  trainer_left,  ///< joysticks 3 and 4, of a second seat
  trainer_right
};
/// Number of RPDOs.
inline constexpr unsigned host_inputs = static_cast<unsigned>(Input::trainer_right);
/// Seats with two joysticks each.
inline constexpr std::size_t seats_max = 2;
/// TPDOs.
enum class Output : std::uint8_t {
  lamps = 1,
  display,
  more_display,
  switches,
  valves,
  more_valves
};
/// Number of TPDOs.
inline constexpr unsigned host_outputs = static_cast<unsigned>(Output::more_valves);

namespace detail {

constexpr EntryInfo host_values(unsigned count, DataType type) {
  return {.sub_first = 1,
          .sub_last = static_cast<std::uint8_t>(count),
          .name = "Value",
          .type = type,
          .access = Access::rw,
          .mapping = Mapping::optional,
          .initial = 0};
}
template <std::uint16_t index, unsigned count, DataType type>
struct HostObject {
  static constexpr EntryInfo entries[] = {cia301::highest_sub_index, host_values(count, type)};
  static constexpr ObjectInfo object = {.index = index,
                                        .code = ObjectCode::array,
                                        .name = "Values of the machine",
                                        .category = Category::optional,
                                        .subs = entries};
};

inline constexpr auto host_description = describe(
    cia301::device_type(0), cia301::error_register_object,
    cia301::identity({.product_code = 852'401}),
    cia301::names({.device = "Canvoy excavator host",
                   .hardware_version = "simulated",
                   .software_version = "0.1.0"}),
    cia301::heartbeat_producer(heartbeat_ms), cia301::heartbeat_consumers(2), cia301::emergency(),
    cia301::error_history(8), Part(cia301::error_behavior_object).up_to(1).initial(1, 1),
    Part(cia301::rpdo_parameter_object).only(0, host_inputs),
    Part(cia301::rpdo_mapping_object).only(0, host_inputs).up_to(8),
    Part(cia301::tpdo_parameter_object).only(0, host_outputs),
    Part(cia301::tpdo_mapping_object).only(0, host_outputs).up_to(8),
    HostObject<axis_values, 6 * seats_max, DataType::integer16>::object,
    HostObject<joystick_values, 4 * seats_max, DataType::unsigned8>::object,
    HostObject<pedal_values, 2, DataType::integer16>::object,
    HostObject<pedal_memories, 2, DataType::unsigned8>::object,
    HostObject<wheel_values, 2, DataType::integer16>::object,
    HostObject<knob_value, 1, DataType::unsigned32>::object,
    HostObject<button_values, 1, DataType::unsigned8>::object,
    HostObject<sensor_values, sensors, DataType::integer16>::object,
    HostObject<lamp_values, 8, DataType::unsigned8>::object,
    HostObject<shown_values, 8, DataType::integer16>::object,
    HostObject<valve_values, 8, DataType::integer16>::object,
    HostObject<switch_values, 8, DataType::unsigned8>::object);
inline constexpr auto host_layout = lay_out_device<host_description>();

}  // namespace detail

/// Error control of all other nodes, the answers of two SDO servers, and those of the seat to
/// requests for the network behind it.
inline constexpr std::size_t host_routes = node_id_max + 6;
/// The node of the host.
using HostNode = DeviceNode<detail::host_layout, host_routes>;

/// `seat_time_out` is how long the seat may be silent, and its sticks unreported (zero: for ever).
std::vector<NodeValue> host_configuration(Duration seat_time_out, bool has_trainer = false);

}  // namespace canvoy::excavator
