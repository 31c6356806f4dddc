// Functions of virtual inputs and outputs: the codes of CiA 417-4 (4.3.1 and 4.4.1).
//
//     call.function = BasicFunction::standard_hall_call;
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

/// The first byte of virtual inputs and outputs. Inputs use the codes up to 11h: requests. Outputs
/// acknowledge them, and also use the codes from 40h on.
enum class BasicFunction : std::uint8_t {
  none = 0x00,  ///< reserved
  generic = 0x01,
  standard_hall_call = 0x02,
  low_priority_hall_call = 0x03,
  high_priority_hall_call = 0x04,
  standard_car_call = 0x05,
  low_priority_car_call = 0x06,
  high_priority_car_call = 0x07,
  standard_destination_call = 0x08,
  low_priority_destination_call = 0x09,
  high_priority_destination_call = 0x0A,
  standard_call_to_destination_floor = 0x0B,
  low_priority_call_to_destination_floor = 0x0C,
  high_priority_call_to_destination_floor = 0x0D,
  special_function = 0x0E,
  access_code_upload = 0x0F,
  speech_connection = 0x10,
  area_monitoring_connection = 0x11,
  position_indicator = 0x40,
  hall_lantern = 0x41,
  direction_indication = 0x42,
  special_indication = 0x43,
  arrival_indication = 0x44,
  operation_data = 0x45,
  publicity_indication = 0x46,
  manufacturer_first = 0x80,
  manufacturer_last = 0xFF,
};

inline constexpr NamedValue input_function_names[] = {
    {BasicFunction::none, "reserved", Meaning::reserved},
    {BasicFunction::generic, "Generic input"},
    {BasicFunction::standard_hall_call, "Standard hall call request"},
    {BasicFunction::low_priority_hall_call, "Low priority hall call request"},
    {BasicFunction::high_priority_hall_call, "High priority hall call request"},
    {BasicFunction::standard_car_call, "Standard car call request"},
    {BasicFunction::low_priority_car_call, "Low priority car call request"},
    {BasicFunction::high_priority_car_call, "High priority car call request"},
    {BasicFunction::standard_destination_call, "Standard destination call"},
    {BasicFunction::low_priority_destination_call, "Low priority destination call"},
    {BasicFunction::high_priority_destination_call, "High priority destination call"},
    {BasicFunction::standard_call_to_destination_floor, "Standard call to destination floor"},
    {BasicFunction::low_priority_call_to_destination_floor,
     "Low priority call to destination floor"},
    {BasicFunction::high_priority_call_to_destination_floor,
     "High priority call to destination floor"},
    {BasicFunction::special_function, "Special function"},
    {BasicFunction::access_code_upload, "Access code upload request"},
    {BasicFunction::speech_connection, "Speech connection request"},
    {BasicFunction::area_monitoring_connection, "Area monitoring connection request"},
    {0x12, 0x7F, "reserved", Meaning::reserved},
    {BasicFunction::manufacturer_first, BasicFunction::manufacturer_last, "manufacturer-specific",
     Meaning::manufacturer},
};
inline constexpr NamedValue output_function_names[] = {
    {BasicFunction::none, "reserved", Meaning::reserved},
    {BasicFunction::generic, "Generic output"},
    {BasicFunction::standard_hall_call, "Standard hall call acknowledgement"},
    {BasicFunction::low_priority_hall_call, "Low priority hall call acknowledgement"},
    {BasicFunction::high_priority_hall_call, "High priority hall call acknowledgement"},
    {BasicFunction::standard_car_call, "Standard car call acknowledgement"},
    {BasicFunction::low_priority_car_call, "Low priority car call acknowledgement"},
    {BasicFunction::high_priority_car_call, "High priority car call acknowledgement"},
    {BasicFunction::standard_destination_call, "Standard destination call acknowledgement"},
    {BasicFunction::low_priority_destination_call, "Low priority destination call acknowledgement"},
    {BasicFunction::high_priority_destination_call,
     "High priority destination call acknowledgement"},
    {BasicFunction::standard_call_to_destination_floor,
     "Standard call to destination floor acknowledgement"},
    {BasicFunction::low_priority_call_to_destination_floor,
     "Low priority call to destination floor acknowledgement"},
    {BasicFunction::high_priority_call_to_destination_floor,
     "High priority call to destination floor acknowledgement"},
    {BasicFunction::special_function, "Special function acknowledgement"},
    {BasicFunction::access_code_upload, "Access code upload acknowledgement"},
    {BasicFunction::speech_connection, "Speech connection acknowledgement"},
    {BasicFunction::area_monitoring_connection, "Area monitoring connection acknowledgement"},
    {0x12, 0x3F, "reserved", Meaning::reserved},
    {BasicFunction::position_indicator, "Position indicator"},
    {BasicFunction::hall_lantern, "Hall lantern"},
    {BasicFunction::direction_indication, "Direction indication"},
    {BasicFunction::special_indication, "Special indication"},
    {BasicFunction::arrival_indication, "Arrival indication"},
    {BasicFunction::operation_data, "Operation data"},
    {BasicFunction::publicity_indication, "Publicity indication"},
    {0x47, 0x7F, "reserved", Meaning::reserved},
    {BasicFunction::manufacturer_first, BasicFunction::manufacturer_last, "manufacturer-specific",
     Meaning::manufacturer},
};

/// The sub-function of BasicFunction::special_function.
enum class SpecialFunction : std::uint8_t {
  none = 0x00,  ///< reserved
  fan_1 = 0x01,
  fan_2 = 0x02,
  load_time_1 = 0x03,
  load_time_2 = 0x04,
  key_lock_1 = 0x05,
  key_lock_2 = 0x06,
  key_lock_3 = 0x07,
  key_lock_4 = 0x08,
  door_open = 0x09,
  door_close = 0x0A,
  fire_service_enable = 0x0B,
  fire_service = 0x0C,
  hall_call_disable = 0x0D,
  attendant_service = 0x0E,
  vip_service = 0x0F,
  out_of_order = 0x10,
  bed_passenger_service = 0x11,
  special_service = 0x12,
  service_run = 0x13,
  dogging_service_enable = 0x14,
  dogging_service_up = 0x15,
  dogging_service_down = 0x16,
};

inline constexpr NamedValue special_function_names[] = {
    {SpecialFunction::none, "reserved", Meaning::reserved},
    {SpecialFunction::fan_1, "Request fan 1"},
    {SpecialFunction::fan_2, "Request fan 2"},
    {SpecialFunction::load_time_1, "Request load time 1"},
    {SpecialFunction::load_time_2, "Request load time 2"},
    {SpecialFunction::key_lock_1, "Key lock 1"},
    {SpecialFunction::key_lock_2, "Key lock 2"},
    {SpecialFunction::key_lock_3, "Key lock 3"},
    {SpecialFunction::key_lock_4, "Key lock 4"},
    {SpecialFunction::door_open, "Request door open"},
    {SpecialFunction::door_close, "Request door close"},
    {SpecialFunction::fire_service_enable, "Fire service enable"},
    {SpecialFunction::fire_service, "Fire service"},
    {SpecialFunction::hall_call_disable, "Hall call disable"},
    {SpecialFunction::attendant_service, "Attendant service"},
    {SpecialFunction::vip_service, "VIP service"},
    {SpecialFunction::out_of_order, "Out of order"},
    {SpecialFunction::bed_passenger_service, "Bed passenger service"},
    {SpecialFunction::special_service, "Special service"},
    {SpecialFunction::service_run, "Service run"},
    {SpecialFunction::dogging_service_enable, "Dogging service enable"},
    {SpecialFunction::dogging_service_up, "Dogging service up"},
    {SpecialFunction::dogging_service_down, "Dogging service down"},
    {0x17, 0xFF, "reserved", Meaning::reserved},
};
inline constexpr NamedValue special_acknowledgement_names[] = {
    {SpecialFunction::none, "reserved", Meaning::reserved},
    {SpecialFunction::fan_1, "Request fan 1 acknowledgement"},
    {SpecialFunction::fan_2, "Request fan 2 acknowledgement"},
    {SpecialFunction::load_time_1, "Request load time 1 acknowledgement"},
    {SpecialFunction::load_time_2, "Request load time 2 acknowledgement"},
    {SpecialFunction::key_lock_1, "Request key lock 1 acknowledgement"},
    {SpecialFunction::key_lock_2, "Request key lock 2 acknowledgement"},
    {SpecialFunction::key_lock_3, "Request key lock 3 acknowledgement"},
    {SpecialFunction::key_lock_4, "Request key lock 4 acknowledgement"},
    {SpecialFunction::door_open, "Request door open acknowledgement"},
    {SpecialFunction::door_close, "Request door close acknowledgement"},
    {SpecialFunction::fire_service_enable, "Fire service enable acknowledgement"},
    {SpecialFunction::fire_service, "Fire service acknowledgement"},
    {SpecialFunction::hall_call_disable, "Hall call disable acknowledgement"},
    {SpecialFunction::attendant_service, "Attendant service acknowledgement"},
    {SpecialFunction::vip_service, "VIP service acknowledgement"},
    {SpecialFunction::out_of_order, "Out of order acknowledgement"},
    {SpecialFunction::bed_passenger_service, "Bed passenger service acknowledgement"},
    {SpecialFunction::special_service, "Special service acknowledgement"},
    {SpecialFunction::service_run, "Service run acknowledgement"},
    {SpecialFunction::dogging_service_enable, "Dogging service enable acknowledgement"},
    {SpecialFunction::dogging_service_up, "Dogging service up acknowledgement"},
    {SpecialFunction::dogging_service_down, "Dogging service down acknowledgement"},
    {0x17, 0xFF, "reserved", Meaning::reserved},
};

/// The field that decides the meaning of the others.
inline constexpr std::string_view basic_function_name = "Basic function";

/// Condition that the basic function is one of these.
constexpr FieldCondition function_is(BasicFunction first, BasicFunction last) {
  return {basic_function_name, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}
/// Condition that the basic function is this one.
constexpr FieldCondition function_is(BasicFunction only) {
  return function_is(only, only);
}

inline constexpr FieldCondition on_hall_call[] = {
    function_is(BasicFunction::standard_hall_call, BasicFunction::high_priority_hall_call)};
inline constexpr FieldCondition on_target_stop[] = {function_is(
    BasicFunction::standard_car_call, BasicFunction::high_priority_call_to_destination_floor)};
inline constexpr FieldCondition on_special_function[] = {
    function_is(BasicFunction::special_function)};
inline constexpr FieldCondition on_manufacturer_function[] = {
    function_is(BasicFunction::manufacturer_first, BasicFunction::manufacturer_last)};
inline constexpr NamedValue manufacturer_8[] = {
    {0x00, 0xFF, "manufacturer-specific", Meaning::manufacturer}};

/// First bit of the sub-function in inputs and outputs.
inline constexpr unsigned sub_function_bit = 8;

/// Fields common to inputs and outputs: two buttons or lamps of a landing.
inline constexpr std::array hall_call_fields = {
    field_when(on_hall_call, sub_function_bit, 1, "Hall call up"),
    field_when(on_hall_call, sub_function_bit + 1, 1, "Hall call down"),
    reserved_zeros<6>(sub_function_bit + 2, 1, on_hall_call),
};

}  // namespace canvoy::cia417
