// Sensors of a lift beside load and position: virtual sensors and the parameters of each (CiA
// 417-4, 4.2.5 and 4.13).
//
//     cia417::sensor_group_object.count  // 32 groups of 254 sensors
#pragma once

#include "canvoy/profiles/cia417/inputs.hpp"

namespace canvoy::cia417 {

/// Kind of a virtual sensor (6012h).
enum class SensorFunction : std::uint8_t {
  none = 0x00,  ///< reserved
  generic = 0x01,
  glass = 0x02,
  smoke = 0x03,
  damage = 0x04,
  pressure = 0x05,
  temperature = 0x06,
  manufacturer_first = 0x80,
  manufacturer_last = 0xFF,
};
inline constexpr NamedValue sensor_function_names[] = {
    {SensorFunction::none, "reserved", Meaning::reserved},
    {SensorFunction::generic, "Generic sensor"},
    {SensorFunction::glass, "Glass sensor"},  // errata C7
    {SensorFunction::smoke, "Smoke sensor"},
    {SensorFunction::damage, "Damage sensor"},
    {SensorFunction::pressure, "Pressure sensor"},
    {SensorFunction::temperature, "Temperature sensor"},
    {0x07, 0x7F, "reserved", Meaning::reserved},
    {SensorFunction::manufacturer_first, SensorFunction::manufacturer_last, "manufacturer-specific",
     Meaning::manufacturer},
};

/// State of a virtual sensor (6012h).
enum class SensorSignal : std::uint8_t { not_set = 0, set = 1, defective = 2, not_installed = 3 };
inline constexpr NamedValue sensor_signal_names[] = {
    {SensorSignal::not_set, "no signal set"},
    {SensorSignal::set, "signal set"},
    {SensorSignal::defective, "sensor is defective", Meaning::failure},
    {SensorSignal::not_installed, "sensor is not installed", Meaning::not_implemented},
};

/// The first source position that a sensor may tell: a maker defines it and those above it.
inline constexpr std::uint8_t first_maker_position = 0x80;
inline constexpr NamedValue source_position_names[] = {
    {0x00, first_maker_position - 1, "reserved", Meaning::reserved},
    {first_maker_position, std::uint8_t{0xFF}, "manufacturer-specific", Meaning::manufacturer}};
inline constexpr NamedValue manufacturer_16[] = {
    {0x0000, 0xFFFF, "manufacturer-specific", Meaning::manufacturer}};

/// Condition that the basic function of the sensor is one of these.
constexpr FieldCondition sensor_is(SensorFunction first, SensorFunction last) {
  return {basic_function_name, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}
inline constexpr FieldCondition on_signal[] = {
    sensor_is(SensorFunction::glass, SensorFunction::temperature)};
inline constexpr FieldCondition on_signal_only[] = {
    sensor_is(SensorFunction::glass, SensorFunction::damage)};
inline constexpr FieldCondition on_measurement[] = {
    sensor_is(SensorFunction::pressure, SensorFunction::temperature)};
/// Errata A11.
inline constexpr FieldCondition on_reserved_sensor[] = {
    sensor_is(SensorFunction::none, SensorFunction::generic), {basic_function_name, 0x07, 0x7F}};
inline constexpr FieldCondition on_manufacturer_sensor[] = {
    sensor_is(SensorFunction::manufacturer_first, SensorFunction::manufacturer_last)};

/// First bit of the unit code in sensor parameter 3.
inline constexpr std::uint8_t sensor_unit_first_bit = 16;

/// Bits 15 to 2 of the function data: a signed number (errata A21).
constexpr FieldInfo sensor_value(UnitEntry unit) {
  return {.first_bit = 34,
          .bits = 14,
          .name = "Sensor value",
          .is_signed = true,
          .value = {.unit_entry = unit, .counting = Counting::counts},
          .description = "In multiples of the SI unit of sensor parameter 3.",
          .when = on_measurement};
}

/// A virtual sensor of 6 bytes, in 6012h and in 6500h to 651Fh. For the latter, sensor parameter 3
/// has the unit; 6012h does not identify its sensor.
constexpr auto sensor_fields(UnitEntry unit) {
  return join_fields(
      field(0, 8, basic_function_name, sensor_function_names),
      lift_bits(8, "Source lift #", request_bit),
      field(16, 8, "Source floor", source_floor, "The floor at which the sensor is."),
      field(24, 8, "Source position",
            {.names = source_position_names, .notation = Notation::hexadecimal}),
      field_when(on_signal, 32, 2, "Sensor signal", {.names = sensor_signal_names}),
      reserved_ones<14>(34, 1, on_signal_only), sensor_value(unit),
      field_when(on_reserved_sensor, 32, 16, "Function data",
                 {.names = any_bits<16>, .notation = Notation::hexadecimal}),
      field_when(on_manufacturer_sensor, 32, 16, "Function data",
                 {.names = manufacturer_16, .notation = Notation::hexadecimal}));
}
inline constexpr auto sensor_mapping_fields = sensor_fields({});
inline constexpr auto virtual_sensor_fields =
    sensor_fields({.index = 0x6560, .first_bit = sensor_unit_first_bit});

inline constexpr auto virtual_sensor_mapping_object =
    var_object(0x6012, "Virtual sensor mapping", "4.2.5",
               "The sensor that is sent next: a copy of the one that has changed.",
               provided({.type = DataType::unsigned48,
                         .mapping = Mapping::by_default,
                         .initial = 0,
                         .value = hexadecimal,
                         .fields = sensor_mapping_fields}),
               {.condition = "if sensor groups are implemented", .errata = "A6, A8, A9"});

inline constexpr EntryInfo supported_sensors =
    count_entry("Number of supported sensors", 0x01, last_of_many);
inline constexpr EntryInfo virtual_sensor_entry = provided(sub_index(
    0, "Virtual sensor #", entry(unsigned48, ro, no, {}, hexadecimal, virtual_sensor_fields)));
inline constexpr EntryInfo sensor_group_entries[] = {
    supported_sensors, at(1, virtual_sensor_entry),
    optional_at(2, last_of_many, virtual_sensor_entry)};
inline constexpr auto sensor_group_object = array_object(
    0x6500, "Sensor group #", "4.13.1", "State, function and place of up to 254 sensors.",
    sensor_group_entries,
    {.count = group_count, .condition = see_part_2, .errata = "A9, A11, A21, B31, C7, C8"});

// Parameters of sensors.

/// One of the parameters of a sensor.
constexpr EntryInfo sensor_parameter(std::string_view name, Items<FieldInfo> fields) {
  return input_parameter(name, fields);
}

inline constexpr EntryInfo sensor_parameter_1 =
    sensor_parameter("Parameter 1 sensor #", input_parameter_1_fields);
inline constexpr EntryInfo sensor_parameter_1_entries[] = {
    supported_sensors, at(1, sensor_parameter_1),
    conditional_at(2, last_of_many, sensor_parameter_1, "if the sensor is implemented")};
inline constexpr auto sensor_parameter_1_object =
    array_object(0x6520, "Sensor parameter 1 group #", "4.13.2",
                 "System behaviour: whether the sensors are enabled, and what is wrong with them.",
                 sensor_parameter_1_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "A24, B1, B19"});

inline constexpr EntryInfo sensor_parameter_2 =
    sensor_parameter("Parameter 2 sensor #", input_parameter_2_fields);
inline constexpr EntryInfo sensor_parameter_2_entries[] = {
    supported_sensors, optional_at(1, last_of_many, sensor_parameter_2)};
inline constexpr auto sensor_parameter_2_object =
    array_object(0x6540, "Sensor parameter 2 group #", "4.13.3",
                 "Logical behaviour: how often the sensors may change.", sensor_parameter_2_entries,
                 {.count = group_count, .condition = see_part_2, .errata = "B19"});

inline constexpr auto sensor_parameter_3_fields =
    join_fields(debounce_and_edge_fields,
                field(sensor_unit_first_bit, 8, "SI unit",
                      {.names = not_used_8, .notation = Notation::hexadecimal},
                      "Of pressure and temperature sensors, by CiA 303-2."),
                field(24, 8, "Prefix", {.names = not_used_8, .notation = Notation::hexadecimal}));
inline constexpr EntryInfo sensor_parameter_3 =
    sensor_parameter("Parameter 3 sensor #", sensor_parameter_3_fields);
inline constexpr EntryInfo sensor_parameter_3_entries[] = {
    supported_sensors, optional_at(1, last_of_many, sensor_parameter_3)};
inline constexpr auto sensor_parameter_3_object = array_object(
    0x6560, "Sensor parameter 3 group #", "4.13.4",
    "Physical behaviour: debouncing, edges that are sent, polarity, unit.",
    sensor_parameter_3_entries,
    {.count = group_count, .condition = see_part_2, .errata = "A10, A18, B19, B30, C6"});

}  // namespace canvoy::cia417
