// CiA 447-3: handles for application code, of the IVN gateway: the car itself (4.2.2 to 4.2.4).
//
//     Values car(node.dictionary());
//     if (car[cia447::door_status_driver].is(cia447::Opening::open)) ...
//     car[cia447::car_light_command_high_beam] = cia447::Order::on;
//     std::optional<double> speed = car[cia447::displayed_vehicle_speed].value();
//     car[cia447::seat_adjustment_command_up_down[2]] = cia447::SeatHeight::up;  // of the
//     passenger
#pragma once

#include "canvoy/profiles/cia447/car_body.hpp"
#include "canvoy/profiles/cia447/light.hpp"
#include "canvoy/profiles/cia447/power_train.hpp"
#include "canvoy/profiles/cia447/states.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.2.

inline constexpr Quantity<switch_illumination_level_status_object> switch_illumination_level_status;
inline constexpr Quantity<switch_illumination_level_command_object>
    switch_illumination_level_command;

inline constexpr State<Signal, ignition_switch_status_object, "", "ignition lock">
    ignition_switch_status_lock;
inline constexpr State<Signal, ignition_switch_status_object, "", "accessory">
    ignition_switch_status_accessory;
inline constexpr State<Signal, ignition_switch_status_object, "", "ignition on">
    ignition_switch_status_on;
inline constexpr State<Signal, ignition_switch_status_object, "", "ignition start">
    ignition_switch_status_start;
inline constexpr State<Locking, central_locking_system_status_object, "",
                       "central locking system status">
    central_locking_system_status;
inline constexpr State<Locking, central_locking_system_command_object, "",
                       "central locking system command">
    central_locking_system_command;

inline constexpr State<Opening, window_status_object, "", "wd"> window_status_driver;
inline constexpr State<Opening, window_status_object, "", "wfp"> window_status_front_passenger;
inline constexpr State<Opening, window_status_object, "", "wrr"> window_status_rear_right;
inline constexpr State<Opening, window_status_object, "", "wrl"> window_status_rear_left;
inline constexpr State<Opening, window_status_object, "", "w3rr"> window_status_3rd_row_right;
inline constexpr State<Opening, window_status_object, "", "w3rl"> window_status_3rd_row_left;

inline constexpr State<OpeningCommand, window_command_object, "", "wd"> window_command_driver;
inline constexpr State<OpeningCommand, window_command_object, "", "wfp">
    window_command_front_passenger;
inline constexpr State<OpeningCommand, window_command_object, "", "wrr"> window_command_rear_right;
inline constexpr State<OpeningCommand, window_command_object, "", "wrl"> window_command_rear_left;
inline constexpr State<OpeningCommand, window_command_object, "", "w3rr">
    window_command_3rd_row_right;
inline constexpr State<OpeningCommand, window_command_object, "", "w3rl">
    window_command_3rd_row_left;

inline constexpr State<Opening, door_status_object, "", "dd"> door_status_driver;
inline constexpr State<Opening, door_status_object, "", "dfp"> door_status_front_passenger;
inline constexpr State<Opening, door_status_object, "", "drr"> door_status_rear_right;
inline constexpr State<Opening, door_status_object, "", "drl"> door_status_rear_left;

inline constexpr State<OpeningCommand, door_command_object, "", "dd"> door_command_driver;
inline constexpr State<OpeningCommand, door_command_object, "", "dfp"> door_command_front_passenger;
inline constexpr State<OpeningCommand, door_command_object, "", "drr"> door_command_rear_right;
inline constexpr State<OpeningCommand, door_command_object, "", "drl"> door_command_rear_left;

inline constexpr State<Flap, car_flap_status_object, "", "eh"> car_flap_status_engine_hood;
inline constexpr State<Flap, car_flap_status_object, "", "fd"> car_flap_status_fuel_door;
inline constexpr State<Flap, car_flap_status_object, "", "bl"> car_flap_status_boot_lid;
inline constexpr State<Flap, car_flap_status_object, "", "ct"> car_flap_status_convertible_top;
inline constexpr State<Flap, car_flap_status_object, "", "bd"> car_flap_status_back_door;
inline constexpr State<Flap, car_flap_status_object, "", "blw"> car_flap_status_boot_lid_window;
inline constexpr State<SlidingRoof, car_flap_status_object, "", "sr"> car_flap_status_sliding_roof;

inline constexpr State<FlapCommand, car_flap_command_object, "", "eh"> car_flap_command_engine_hood;
inline constexpr State<FlapCommand, car_flap_command_object, "", "fd"> car_flap_command_fuel_door;
inline constexpr State<FlapCommand, car_flap_command_object, "", "bl"> car_flap_command_boot_lid;
inline constexpr State<FlapCommand, car_flap_command_object, "", "ct">
    car_flap_command_convertible_top;
inline constexpr State<FlapCommand, car_flap_command_object, "", "bd"> car_flap_command_back_door;
inline constexpr State<FlapCommand, car_flap_command_object, "", "blw">
    car_flap_command_boot_lid_window;
inline constexpr State<SlidingRoofCommand, car_flap_command_object, "", "sr">
    car_flap_command_sliding_roof;

/// Handles of the fields of the seat adjustment command.
template <class Enumeration, Name field>
using SeatAdjustmentCommandField =
    State<Enumeration, seat_adjustment_command_object, "Seat adjustment command driver", field>;
inline constexpr SeatAdjustmentCommandField<SeatMotion, "sfb">
    seat_adjustment_command_forward_backward;
inline constexpr SeatAdjustmentCommandField<SeatHeight, "sud"> seat_adjustment_command_up_down;
inline constexpr SeatAdjustmentCommandField<SeatAngle, "sals">
    seat_adjustment_command_angle_lift_sink;
inline constexpr SeatAdjustmentCommandField<SeatMotion, "stsfb">
    seat_adjustment_command_tight_support_forward_backward;
inline constexpr SeatAdjustmentCommandField<SeatMotion, "sbfb">
    seat_adjustment_command_back_forward_backward;
inline constexpr SeatAdjustmentCommandField<SeatHeight, "hud">
    seat_adjustment_command_headrest_up_down;
inline constexpr SeatAdjustmentCommandField<SeatMemory, "rm"> seat_adjustment_command_recall_memory;
inline constexpr SeatAdjustmentCommandField<SeatMemory, "sm"> seat_adjustment_command_store_memory;

/// Handles of the fields of the seat adjustment status.
template <class Enumeration, Name field>
using SeatAdjustmentStatusField =
    State<Enumeration, seat_adjustment_status_object, "Seat adjustment status driver", field>;
inline constexpr SeatAdjustmentStatusField<SeatMotion, "sfb">
    seat_adjustment_status_forward_backward;
inline constexpr SeatAdjustmentStatusField<SeatHeight, "sud"> seat_adjustment_status_up_down;
inline constexpr SeatAdjustmentStatusField<SeatAngle, "sals">
    seat_adjustment_status_angle_lift_sink;
inline constexpr SeatAdjustmentStatusField<SeatMotion, "stsfb">
    seat_adjustment_status_tight_support_forward_backward;
inline constexpr SeatAdjustmentStatusField<SeatMotion, "sbfb">
    seat_adjustment_status_back_forward_backward;
inline constexpr SeatAdjustmentStatusField<SeatHeight, "hud">
    seat_adjustment_status_headrest_up_down;
inline constexpr SeatAdjustmentStatusField<SeatMemory, "rm"> seat_adjustment_status_recall_memory;
inline constexpr SeatAdjustmentStatusField<SeatMemory, "sm"> seat_adjustment_status_store_memory;

inline constexpr State<Wiper, wiper_system_status_object, "", "wsf"> wiper_system_status_front;
inline constexpr State<Wiper, wiper_system_status_object, "", "wwf">
    wiper_system_status_washer_front;
inline constexpr State<WiperSwitch, wiper_system_status_object, "", "wspf">
    wiper_system_status_switch_position_front;
inline constexpr State<Wiper, wiper_system_status_object, "", "wsr"> wiper_system_status_rear;
inline constexpr State<Wiper, wiper_system_status_object, "", "wwr">
    wiper_system_status_washer_rear;

inline constexpr State<Order, wiper_system_command_object, "", "wsf"> wiper_system_command_front;
inline constexpr State<Order, wiper_system_command_object, "", "wwf">
    wiper_system_command_washer_front;
inline constexpr State<WiperSwitch, wiper_system_command_object, "", "wspf">
    wiper_system_command_switch_position_front;
inline constexpr State<Order, wiper_system_command_object, "", "wsr"> wiper_system_command_rear;
inline constexpr State<Order, wiper_system_command_object, "", "wwr">
    wiper_system_command_washer_rear;

inline constexpr Quantity<steering_wheel_angle_object, "", "steering wheel angle">
    steering_wheel_angle;
inline constexpr State<SteeringWheelSide, steering_wheel_angle_object, "", "swas">
    steering_wheel_angle_side;

inline constexpr State<Signal, turn_indicator_reset_status_object, "", "right turn indicator reset">
    turn_indicator_reset_status_right;
inline constexpr State<Signal, turn_indicator_reset_status_object, "", "left turn indicator reset">
    turn_indicator_reset_status_left;
inline constexpr Quantity<displayed_outside_air_temperature_object>
    displayed_outside_air_temperature;
inline constexpr Quantity<displayed_inside_air_temperature_object> displayed_inside_air_temperature;

inline constexpr State<Order, heating_and_air_conditioner_command_object, "", "hfw">
    heating_and_air_conditioner_command_heat_front_window;
inline constexpr State<Order, heating_and_air_conditioner_command_object, "", "hrw">
    heating_and_air_conditioner_command_heat_rear_window;
inline constexpr State<Order, heating_and_air_conditioner_command_object, "", "acc">
    heating_and_air_conditioner_command_automatic_control;
inline constexpr State<Order, heating_and_air_conditioner_command_object, "", "dfw">
    heating_and_air_conditioner_command_defrost_front_window;
inline constexpr State<TemperatureStep, heating_and_air_conditioner_command_object, "", "temp">
    heating_and_air_conditioner_command_temperature;
inline constexpr State<Order, heating_and_air_conditioner_command_object, "", "recair">
    heating_and_air_conditioner_command_recirculation;

inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "hfw">
    heating_and_air_conditioner_status_heat_front_window;
inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "hrw">
    heating_and_air_conditioner_status_heat_rear_window;
inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "acc">
    heating_and_air_conditioner_status_automatic_control;
inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "dfw">
    heating_and_air_conditioner_status_defrost_front_window;
inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "temp">
    heating_and_air_conditioner_status_temperature;
inline constexpr State<Signal, heating_and_air_conditioner_status_object, "", "recair">
    heating_and_air_conditioner_status_recirculation;

inline constexpr State<Signal, occupant_classification_status_object, "", "docs">
    occupant_classification_status_driver;
inline constexpr State<Signal, occupant_classification_status_object, "", "fpocs">
    occupant_classification_status_front_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "rrpocs">
    occupant_classification_status_rear_right_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "rlpocs">
    occupant_classification_status_rear_left_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "rmpocs">
    occupant_classification_status_rear_middle_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "3rrocs">
    occupant_classification_status_3rd_row_right_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "3rlocs">
    occupant_classification_status_3rd_row_left_passenger;
inline constexpr State<Signal, occupant_classification_status_object, "", "3rmocs">
    occupant_classification_status_3rd_row_middle_passenger;

/// Handles of the fields of the buckle switch status.
template <Name field>
using BuckleSwitchStatusField = State<Signal, buckle_switch_status_object, "", field>;
inline constexpr BuckleSwitchStatusField<"bsd"> buckle_switch_status_driver;
inline constexpr BuckleSwitchStatusField<"bsfp"> buckle_switch_status_front_passenger;
inline constexpr BuckleSwitchStatusField<"bsrr"> buckle_switch_status_rear_right;
inline constexpr BuckleSwitchStatusField<"bsrl"> buckle_switch_status_rear_left;
inline constexpr BuckleSwitchStatusField<"bsrm"> buckle_switch_status_rear_middle;
inline constexpr BuckleSwitchStatusField<"3rr"> buckle_switch_status_3rd_row_right;
inline constexpr BuckleSwitchStatusField<"3rl"> buckle_switch_status_3rd_row_left;
inline constexpr BuckleSwitchStatusField<"3rm"> buckle_switch_status_3rd_row_middle;
inline constexpr Text<vin_data_object> vin_data;
inline constexpr State<Language, user_selected_language_command_object, "", "language">
    user_selected_language_command;
inline constexpr State<Language, user_selected_language_status_object, "", "language">
    user_selected_language_status;
inline constexpr State<DayNight, day_night_detection_object, "", "day/night detection">
    day_night_detection;
inline constexpr Quantity<environment_light_intensity_object> environment_light_intensity;

inline constexpr State<Signal, accident_detection_object, "", "airrel">
    accident_detection_airbag_released;
inline constexpr State<Signal, accident_detection_object, "", "pate">
    accident_detection_presafe_acceleration_threshold_exceeded;
inline constexpr State<Signal, accident_detection_object, "", "ams"> accident_detection_motor_stop;
inline constexpr State<Signal, accident_detection_object, "", "accident"> accident_detection;
inline constexpr State<Signal, tester_present_object, "", "UDS diagnose session">
    tester_present_uds_diagnose_session;

// 4.2.3.

/// Handles of the fields of the car light status.
template <Name field>
using CarLightStatusField = State<Signal, car_light_status_object, "", field>;
inline constexpr CarLightStatusField<"dtrl"> car_light_status_day_time_running;
inline constexpr CarLightStatusField<"bl"> car_light_status_brake;
inline constexpr CarLightStatusField<"rdl"> car_light_status_reverse_driving;
inline constexpr CarLightStatusField<"hb"> car_light_status_high_beam;
inline constexpr CarLightStatusField<"lb"> car_light_status_low_beam;
inline constexpr CarLightStatusField<"flf"> car_light_status_fog_lamps_front;
inline constexpr CarLightStatusField<"flr"> car_light_status_fog_lamps_rear;
inline constexpr CarLightStatusField<"tir"> car_light_status_turn_indication_right;
inline constexpr CarLightStatusField<"til"> car_light_status_turn_indication_left;
inline constexpr CarLightStatusField<"ttir"> car_light_status_tip_turn_indication_right;
inline constexpr CarLightStatusField<"ttil"> car_light_status_tip_turn_indication_left;
inline constexpr CarLightStatusField<"ef"> car_light_status_emergency_flasher;
inline constexpr CarLightStatusField<"fl"> car_light_status_flashing_light;
inline constexpr CarLightStatusField<"pl"> car_light_status_position_lamps;
inline constexpr CarLightStatusField<"plr"> car_light_status_parking_lamps_right;
inline constexpr CarLightStatusField<"pll"> car_light_status_parking_lamps_left;

/// Handles of the fields of the car light command.
template <Name field>
using CarLightCommandField = State<Order, car_light_command_object, "", field>;
inline constexpr CarLightCommandField<"dtrl"> car_light_command_day_time_running;
inline constexpr CarLightCommandField<"bl"> car_light_command_brake;
inline constexpr CarLightCommandField<"rdl"> car_light_command_reverse_driving;
inline constexpr CarLightCommandField<"hb"> car_light_command_high_beam;
inline constexpr CarLightCommandField<"lb"> car_light_command_low_beam;
inline constexpr CarLightCommandField<"flf"> car_light_command_fog_lamps_front;
inline constexpr CarLightCommandField<"flr"> car_light_command_fog_lamps_rear;
inline constexpr CarLightCommandField<"tir"> car_light_command_turn_indication_right;
inline constexpr CarLightCommandField<"til"> car_light_command_turn_indication_left;
inline constexpr CarLightCommandField<"ttir"> car_light_command_tip_turn_indication_right;
inline constexpr CarLightCommandField<"ttil"> car_light_command_tip_turn_indication_left;
inline constexpr CarLightCommandField<"ef"> car_light_command_emergency_flasher;
inline constexpr CarLightCommandField<"fl"> car_light_command_flashing_light;
inline constexpr CarLightCommandField<"pl"> car_light_command_position_lamps;
inline constexpr CarLightCommandField<"plr"> car_light_command_parking_lamps_right;
inline constexpr CarLightCommandField<"pll"> car_light_command_parking_lamps_left;

inline constexpr State<InteriorLight, car_interior_light_status_object, "", "ii">
    car_interior_light_status_illumination;
inline constexpr State<Signal, car_interior_light_status_object, "", "lrid">
    car_interior_light_status_leg_room_illumination_driver;
inline constexpr State<Signal, car_interior_light_status_object, "", "lrifp">
    car_interior_light_status_leg_room_illumination_front_passenger;
inline constexpr State<Signal, car_interior_light_status_object, "", "lrirr">
    car_interior_light_status_leg_room_illumination_rear_right;
inline constexpr State<Signal, car_interior_light_status_object, "", "lrirl">
    car_interior_light_status_leg_room_illumination_rear_left;
inline constexpr State<Signal, car_interior_light_status_object, "", "bli">
    car_interior_light_status_boot_lid_illumination;

inline constexpr State<InteriorLight, car_interior_light_command_object, "", "ii">
    car_interior_light_command_illumination;
inline constexpr State<Order, car_interior_light_command_object, "", "lrid">
    car_interior_light_command_leg_room_illumination_driver;
inline constexpr State<Order, car_interior_light_command_object, "", "lrifp">
    car_interior_light_command_leg_room_illumination_front_passenger;
inline constexpr State<Order, car_interior_light_command_object, "", "lrirr">
    car_interior_light_command_leg_room_illumination_rear_right;
inline constexpr State<Order, car_interior_light_command_object, "", "lrirl">
    car_interior_light_command_leg_room_illumination_rear_left;
inline constexpr State<Order, car_interior_light_command_object, "", "bli">
    car_interior_light_command_boot_lid_illumination;
inline constexpr State<AntiTheft, anti_theft_warning_system_status_object, "",
                       "anti theft warning system">
    anti_theft_warning_system_status;
inline constexpr State<AntiTheftCommand, anti_theft_warning_system_command_object, "",
                       "anti theft warning system">
    anti_theft_warning_system_command;
inline constexpr Quantity<mirror_anti_dazzle_position_object> mirror_anti_dazzle_position;
inline constexpr State<Signal, horn_status_object, "", "horn status"> horn_status;
inline constexpr State<Order, horn_command_object, "", "horn command"> horn_command;

/// Handles of the fields of the flashing light command.
template <Name field>
using FlashingLightCommandField = State<Order, flashing_light_command_object, "", field>;
inline constexpr FlashingLightCommandField<"gclf"> flashing_light_command_gateway_coded_functions;
inline constexpr FlashingLightCommandField<"fld"> flashing_light_command_fog_lamps_day;
inline constexpr FlashingLightCommandField<"fln"> flashing_light_command_fog_lamps_night;
inline constexpr FlashingLightCommandField<"hbd"> flashing_light_command_high_beam_day;
inline constexpr FlashingLightCommandField<"hbn"> flashing_light_command_high_beam_night;
inline constexpr FlashingLightCommandField<"lbd"> flashing_light_command_low_beam_day;
inline constexpr FlashingLightCommandField<"lbn"> flashing_light_command_low_beam_night;
inline constexpr FlashingLightCommandField<"dtrld"> flashing_light_command_day_time_running_day;
inline constexpr FlashingLightCommandField<"dtrln"> flashing_light_command_day_time_running_night;

/// Handles of the fields of the flashing light status.
template <Name field>
using FlashingLightStatusField = State<Signal, flashing_light_status_object, "", field>;
inline constexpr FlashingLightStatusField<"gclf"> flashing_light_status_gateway_coded_functions;
inline constexpr FlashingLightStatusField<"fld"> flashing_light_status_fog_lamps_day;
inline constexpr FlashingLightStatusField<"fln"> flashing_light_status_fog_lamps_night;
inline constexpr FlashingLightStatusField<"hbd"> flashing_light_status_high_beam_day;
inline constexpr FlashingLightStatusField<"hbn"> flashing_light_status_high_beam_night;
inline constexpr FlashingLightStatusField<"lbd"> flashing_light_status_low_beam_day;
inline constexpr FlashingLightStatusField<"lbn"> flashing_light_status_low_beam_night;
inline constexpr FlashingLightStatusField<"dtrld"> flashing_light_status_day_time_running_day;
inline constexpr FlashingLightStatusField<"dtrln"> flashing_light_status_day_time_running_night;

// 4.2.4.

inline constexpr Quantity<actual_engine_revolutions_object, "", "actual engine revolutions">
    actual_engine_revolutions;
inline constexpr State<Signal, actual_engine_revolutions_object, "", "t61">
    actual_engine_revolutions_terminal_61;
inline constexpr State<Engine, engine_status_object> engine_status;

inline constexpr State<SelectorLever, transmission_selector_lever_position_object, "",
                       "selector lever position">
    transmission_selector_lever_position;
inline constexpr State<GearMode, transmission_selector_lever_position_object, "", "agm">
    automatic_gear_mode;
inline constexpr State<Signal, transmission_selector_lever_position_object, "", "pb"> parking_brake;
inline constexpr State<Signal, transmission_selector_lever_position_object, "", "cs">
    coupling_switch;
inline constexpr State<Gear, transmission_selector_lever_position_object, "", "engaged gear">
    engaged_gear;
inline constexpr Quantity<wheel_rpm_object> wheel_rpm;
inline constexpr State<WheelSource, wheel_signal_source_object> wheel_signal_source;

inline constexpr Number<wheel_pulse_counter_object, "", "wheel pulse counter"> wheel_pulse_counter;
inline constexpr State<Signal, wheel_pulse_counter_object, "", "pcvalid"> wheel_pulse_counter_valid;

inline constexpr Number<wheel_pulse_counter_overrun_value_object, "",
                        "wheel pulse counter overrun value">
    wheel_pulse_counter_overrun_value;
inline constexpr State<Signal, wheel_pulse_counter_overrun_value_object, "", "valid">
    wheel_pulse_counter_overrun_value_valid;
inline constexpr Number<pulses_per_wheel_rotation_object> pulses_per_wheel_rotation;
inline constexpr Quantity<displayed_vehicle_speed_object> displayed_vehicle_speed;
inline constexpr Quantity<odometer_object> odometer;

inline constexpr Quantity<tank_status_object, "", "tank level"> tank_level;
inline constexpr State<Signal, tank_status_object, "", "tlm"> tank_level_minimum;

inline constexpr Quantity<current_average_fuel_consumption_object, "",
                          "current average fuel consumption">
    current_average_fuel_consumption;
inline constexpr State<Signal, current_average_fuel_consumption_object, "", "fco">
    current_average_fuel_consumption_overflow;
inline constexpr State<FuelUnit, current_average_fuel_consumption_object, "", "fsu">
    current_average_fuel_consumption_unit;

inline constexpr State<Order, cruise_control_command_object, "", "acc">
    cruise_control_command_automatic;
inline constexpr State<Acceleration, cruise_control_command_object, "", "ad">
    cruise_control_command_accelerate_decelerate;
inline constexpr State<StoredSpeed, cruise_control_command_object, "", "store">
    cruise_control_command_store;
inline constexpr State<Order, cruise_control_command_object, "", "dcs">
    cruise_control_command_distance_system;

inline constexpr State<Signal, cruise_control_status_object, "", "acc">
    cruise_control_status_automatic;
inline constexpr State<Acceleration, cruise_control_status_object, "", "ad">
    cruise_control_status_accelerate_decelerate;
inline constexpr State<StoredSpeed, cruise_control_status_object, "", "store">
    cruise_control_status_store;
inline constexpr State<Signal, cruise_control_status_object, "", "dcs">
    cruise_control_status_distance_system;
inline constexpr State<Order, four_wheel_drive_command_object, "", "four-wheel drive">
    four_wheel_drive_command;
inline constexpr State<Signal, four_wheel_drive_status_object, "", "four-wheel drive">
    four_wheel_drive_status;

}  // namespace canvoy::cia447
