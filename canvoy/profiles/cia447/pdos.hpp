// The pre-defined PDOs of CiA 447-4: the same mapping is the TPDO of the virtual device that
// provides the objects and the RPDO of the devices that consume them.
//
// Part 4 is not at hand: numbers and mappings are from a public database. CAN-IDs within the node's
// range (pdo_base in network.hpp) are not known: the PDOs are invalid until they are set.
#pragma once

#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::cia447 {

/// An entry as a mapping parameter holds it.
constexpr std::uint32_t mapped(const ObjectInfo& object, unsigned sub = 0) {
  return static_cast<std::uint32_t>(mapping_entry(1, object, sub).initial.number);
}
/// Entries of a mapping record.
template <class... Mapped>
constexpr std::array<std::uint32_t, sizeof...(Mapped)> mapping_of(Mapped... entries) {
  return {entries...};
}

inline constexpr auto pdo_1_mapping = mapping_of(mapped(ignition_switch_status_object));
inline constexpr auto pdo_2_mapping =
    mapping_of(mapped(car_flap_status_object), mapped(switch_illumination_level_status_object),
               mapped(wiper_system_status_object));
inline constexpr auto pdo_3_mapping = mapping_of(mapped(tester_present_object));
inline constexpr auto pdo_4_mapping =
    mapping_of(mapped(occupant_classification_status_object), mapped(buckle_switch_status_object),
               mapped(central_locking_system_status_object));
inline constexpr auto pdo_5_mapping =
    mapping_of(mapped(window_status_object), mapped(door_status_object),
               mapped(turn_indicator_reset_status_object), mapped(day_night_detection_object));
inline constexpr auto pdo_6_mapping =
    mapping_of(mapped(seat_adjustment_status_object, 1), mapped(seat_adjustment_status_object, 2));
inline constexpr auto pdo_7_mapping = mapping_of(mapped(accident_detection_object));
inline constexpr auto pdo_17_mapping =
    mapping_of(mapped(actual_engine_revolutions_object), mapped(wheel_rpm_object),
               mapped(wheel_pulse_counter_object));
inline constexpr auto pdo_18_mapping = mapping_of(mapped(engine_status_object));
inline constexpr auto pdo_19_mapping =
    mapping_of(mapped(car_light_status_object), mapped(anti_theft_warning_system_status_object),
               mapped(horn_status_object));
inline constexpr auto pdo_65_mapping = mapping_of(mapped(radio_hand_free_status_object));
inline constexpr auto pdo_66_mapping = mapping_of(mapped(blue_light_flasher_status_object));
inline constexpr auto pdo_67_mapping = mapping_of(mapped(driver_id_status_object));
inline constexpr auto pdo_68_mapping = mapping_of(mapped(emergency_fresh_air_system_status_object));
inline constexpr auto pdo_69_mapping = mapping_of(mapped(fire_extinguishing_system_status_object));
inline constexpr auto pdo_70_mapping =
    mapping_of(mapped(gps_current_position_object, 1), mapped(gps_current_position_object, 2));
inline constexpr auto pdo_71_mapping = mapping_of(mapped(taxi_alarm_system_status_object));
inline constexpr auto pdo_72_mapping =
    mapping_of(mapped(printer_status_object), mapped(printer_errors_object));
inline constexpr auto pdo_73_mapping =
    mapping_of(mapped(light_status_roof_bar_object, 1), mapped(light_status_roof_bar_object, 2));
inline constexpr auto pdo_74_mapping =
    mapping_of(mapped(light_status_roof_bar_object, 3), mapped(light_status_roof_bar_object, 4));
inline constexpr auto pdo_75_mapping = mapping_of(mapped(light_status_roof_bar_object, 5));
inline constexpr auto pdo_76_mapping =
    mapping_of(mapped(sound_status_roof_bar_object, 1), mapped(sound_status_roof_bar_object, 2));
// Part 3 does not let a PDO map 6102h (errata Z40); the database has it here.
inline constexpr auto pdo_77_mapping = mapping_of(mapped(tariff_display_lamp_failures_1_object),
                                                  mapped(tariff_display_lamp_failures_2_object));
inline constexpr auto pdo_78_mapping = mapping_of(mapped(tariff_display_inputs_status_object));
inline constexpr auto pdo_79_mapping = mapping_of(mapped(discrete_inputs_status_object));
inline constexpr auto pdo_80_mapping = mapping_of(mapped(taximeter_status_object));
// The database has 609Bh sub-index 00h in the last place, a constant that no PDO may map. This
// description has the status beside it, which part 3 maps by default.
inline constexpr auto pdo_81_mapping =
    mapping_of(mapped(number_pad_status_object), mapped(number_pad_user_interaction_object),
               mapped(function_keys_status_object), mapped(function_keys_user_interaction_object),
               mapped(control_keys_status_object), mapped(control_keys_user_interaction_object),
               mapped(display_1_status_object), mapped(display_2_status_object));
inline constexpr auto pdo_82_mapping =
    mapping_of(mapped(steering_wheel_switch_pad_status_object),
               mapped(steering_wheel_switch_pad_user_interaction_object),
               mapped(emergency_key_status_object), mapped(emergency_key_user_interaction_object));
inline constexpr auto pdo_83_mapping =
    mapping_of(mapped(radio_status_object), mapped(radio_device_status_object));
inline constexpr auto pdo_84_mapping = mapping_of(mapped(radio_power_supply_status_object),
                                                  mapped(periphery_power_supply_status_object));

/// Engine, wheel speed and wheel pulses are sent every 100 ms (4.2.4.1, 4.2.4.4, 4.2.4.6).
inline constexpr unsigned wheel_pdo_number = 17;
inline constexpr std::uint16_t wheel_pdo_period = 100;

/// One of the pre-defined PDOs of part 4, by its number.
constexpr PdoInfo pdo(PdoInfo::Direction direction, unsigned number, Items<std::uint32_t> mapping) {
  constexpr std::uint32_t not_valid = 0x8000'0000;
  const bool is_cyclic = number == wheel_pdo_number && direction == PdoInfo::Direction::transmit;
  return {.direction = direction,
          .number = static_cast<std::uint16_t>(number),
          .cob_id = not_valid,
          .mapping = mapping,
          .event_timer = is_cyclic ? wheel_pdo_period : std::uint16_t{0},
          .condition = "if the virtual device that provides or consumes the objects is there",
          .clause = "CiA 447-4"};
}
/// All of them, sent or received.
constexpr auto pdos_of(PdoInfo::Direction direction) {
  return std::array{pdo(direction, 1, pdo_1_mapping),   pdo(direction, 2, pdo_2_mapping),
                    pdo(direction, 3, pdo_3_mapping),   pdo(direction, 4, pdo_4_mapping),
                    pdo(direction, 5, pdo_5_mapping),   pdo(direction, 6, pdo_6_mapping),
                    pdo(direction, 7, pdo_7_mapping),   pdo(direction, 17, pdo_17_mapping),
                    pdo(direction, 18, pdo_18_mapping), pdo(direction, 19, pdo_19_mapping),
                    pdo(direction, 65, pdo_65_mapping), pdo(direction, 66, pdo_66_mapping),
                    pdo(direction, 67, pdo_67_mapping), pdo(direction, 68, pdo_68_mapping),
                    pdo(direction, 69, pdo_69_mapping), pdo(direction, 70, pdo_70_mapping),
                    pdo(direction, 71, pdo_71_mapping), pdo(direction, 72, pdo_72_mapping),
                    pdo(direction, 73, pdo_73_mapping), pdo(direction, 74, pdo_74_mapping),
                    pdo(direction, 75, pdo_75_mapping), pdo(direction, 76, pdo_76_mapping),
                    pdo(direction, 77, pdo_77_mapping), pdo(direction, 78, pdo_78_mapping),
                    pdo(direction, 79, pdo_79_mapping), pdo(direction, 80, pdo_80_mapping),
                    pdo(direction, 81, pdo_81_mapping), pdo(direction, 82, pdo_82_mapping),
                    pdo(direction, 83, pdo_83_mapping), pdo(direction, 84, pdo_84_mapping)};
}
/// All of them, sent, then received.
constexpr auto transmit_and_receive() {
  constexpr auto transmit = pdos_of(PdoInfo::Direction::transmit);
  constexpr auto receive = pdos_of(PdoInfo::Direction::receive);
  std::array<PdoInfo, transmit.size() + receive.size()> all{};
  for (std::size_t i = 0; i < transmit.size(); ++i) {
    all[i] = transmit[i];
    all[transmit.size() + i] = receive[i];
  }
  return all;
}
inline constexpr auto pdos = transmit_and_receive();

}  // namespace canvoy::cia447
