// The light of a roof bar: beacons, flashers, working lights, a search lamp that swings and moves
// to three positions, additional functions (6130h, 6131h; CiA 447-3, 4.2.20).
//
//     RoofBarLightUnit bar(network, {}, {});
//     bar.switching().report(light_status_roof_bar_local_voltage, LocalVoltage::under_voltage);
//
// The search lamp swings until it is stopped or at its end. Its position is then not known until it
// moves to one.
#pragma once

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/switching.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"

namespace canvoy::cia447 {

inline constexpr const ObjectInfo* roof_bar_light_commands[] = {&light_commands_roof_bar_object};
inline constexpr Mirror roof_bar_light_mirrors[] = {
    {&light_commands_roof_bar_object, &light_status_roof_bar_object, 50ms}};

namespace search_lamp {

/// Right, left or stop; field of 6130h.
inline constexpr auto swing_command = light_commands_roof_bar_swing_search_lamp_right_left;
/// Of 6131h.
inline constexpr auto swing_status = light_status_roof_bar_swing_search_lamp_right_left;
/// Up, down or stop; field of 6130h.
inline constexpr auto tilt_command = light_commands_roof_bar_swing_search_lamp_up_down;
/// Of 6131h.
inline constexpr auto tilt_status = light_status_roof_bar_swing_search_lamp_up_down;
/// Stored position 1 to 3 in which it is; field of 6131h.
inline constexpr auto lamp_position = light_status_roof_bar_search_lamp_position;
/// From one end to the other.
inline constexpr Duration swing_time = 6s;
inline constexpr Duration tilt_time = 3s;      ///< from one end to the other
inline constexpr Duration position_time = 4s;  ///< to a stored position

/// With a command to move, it is in no stored position any more.
template <class Command, class Code>
constexpr Effect leaves_position(const Command& command, Code code) {
  return effect(command, code, lamp_position, SearchLampPosition::not_available, 0ms);
}
/// Effects of a command to swing to this side: it stops at the end.
constexpr std::array<Effect, 2> swings(SearchLampTurn to) {
  return {pulse(swing_command, to, swing_status, to, SearchLampTurn::stop, swing_time),
          leaves_position(swing_command, to)};
}
/// Effects of a command to tilt: it stops at the end.
constexpr std::array<Effect, 2> tilts(SearchLampTilt to) {
  return {pulse(tilt_command, to, tilt_status, to, SearchLampTilt::stop, tilt_time),
          leaves_position(tilt_command, to)};
}
/// During the movement, there is no position, and no requested swing.
constexpr std::array<Effect, 3> goes_to(SearchLampPosition to) {
  constexpr auto command = light_commands_roof_bar_search_lamp_position;
  return {effect(command, to, lamp_position, SearchLampPosition::not_available, to, position_time),
          effect(command, to, swing_status, SearchLampTurn::stop, 0ms),
          effect(command, to, tilt_status, SearchLampTilt::stop, 0ms)};
}

}  // namespace search_lamp

/// Both movements, the three stored positions, and stop.
inline constexpr auto search_lamp_effects =
    join(search_lamp::swings(SearchLampTurn::right), search_lamp::swings(SearchLampTurn::left),
         search_lamp::tilts(SearchLampTilt::up), search_lamp::tilts(SearchLampTilt::down),
         search_lamp::goes_to(SearchLampPosition::position_1),
         search_lamp::goes_to(SearchLampPosition::position_2),
         search_lamp::goes_to(SearchLampPosition::position_3),
         std::array{effect(search_lamp::swing_command, SearchLampTurn::stop,
                           search_lamp::swing_status, SearchLampTurn::stop, 0ms),
                    effect(search_lamp::tilt_command, SearchLampTilt::stop,
                           search_lamp::tilt_status, SearchLampTilt::stop, 0ms)});
inline constexpr Rest roof_bar_light_rests[] = {
    rest(light_status_roof_bar_local_voltage, LocalVoltage::ok)};
inline constexpr SwitchedTable roof_bar_light_table = {.commands = roof_bar_light_commands,
                                                       .mirrors = roof_bar_light_mirrors,
                                                       .effects = search_lamp_effects,
                                                       .rests = roof_bar_light_rests};

/// The unit is its table.
using RoofBarLightUnit = SwitchedUnit<roof_bar_light_table>;

/// Catalogue row of the light of a roof bar (4.2.20); car_unit makes it a part of a device.
struct RoofBarLightKind : CarKind<RoofBarLightUnit, SwitchedHardware, SwitchedSettings> {
  static constexpr DeviceInfo info = {.name = "roof-bar-light",
                                      .title = "light of a roof bar",
                                      .product = "Canvoy CiA 447 roof bar light",
                                      .product_code = 44717,
                                      .node_id = 13,
                                      .hardware = "beacons, flashers, search lamp, voltage"};
  static constexpr const VirtualDeviceInfo& provides = roof_bar_light_device;
};

}  // namespace canvoy::cia447
