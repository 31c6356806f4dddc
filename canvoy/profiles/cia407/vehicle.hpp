// Objects of CiA 407 that the vehicle gateway provides, 6481h to 648Dh (9.2.15), and the
// tachograph, 6520h to 6525h (9.2.17).
//
//     cia407::state_of_doors_object.index  // 6488h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

// Speed, distance and direction.

inline constexpr auto wheel_based_vehicle_speed_object =
    variable(0x6481, "wheel_based_vehicle_speed", "9.2.15.1", "The speed, forward or backward.",
             entry(unsigned16, ro, optional, {}, speed));
inline constexpr auto vehicle_mileage_object = variable(
    0x6482, "vehicle_mileage", "9.2.15.2", "The distance that the vehicle has gone in all.",
    entry(unsigned32, ro, optional, 0, distance));
inline constexpr auto vehicle_mileage_precision_object =
    variable(0x6483, "vehicle_mileage_precision", "9.2.15.3", "How exact 6482h is.",
             entry(unsigned16, ro, optional, 0xFFFF, distance_precision),
             {.condition = "if object 6482h is implemented", .errata = "104"});

/// Direction of travel (6484h, 6521h).
enum class Direction : std::uint8_t { forward = 0, reverse = 1, error = 2, not_available = 3 };
/// Whether motion was recognized (6484h, 6521h).
enum class Motion : std::uint8_t { not_detected = 0, detected = 1, error = 2, not_available = 3 };
inline constexpr NamedValue directions[] = {
    {Direction::forward, "forward"},
    {Direction::reverse, "reverse"},
    {Direction::error, "error", Meaning::failure},
    {Direction::not_available, "not available", Meaning::invalid}};
inline constexpr NamedValue motions[] = {
    {Motion::not_detected, "no motion detected"},
    {Motion::detected, "motion detected"},
    {Motion::error, "error", Meaning::failure},
    {Motion::not_available, "not available", Meaning::invalid}};
/// Fields of 6484h and 6521h (errata 73).
inline constexpr FieldInfo drive_fields[] = {
    reserved<4>(0),
    field(4, 2, "drive recognition", motions),
    field(6, 2, "direction indicator", directions),
};
inline constexpr auto drive_flag_and_direction_flag_object =
    variable(0x6484, "drive_flag_and_direction_flag", "9.2.15.4",
             "Whether the vehicle moves (pulses of the sensor for 5 s), and which way.",
             entry(unsigned8, ro, optional, {}, drive_fields), {.errata = "72"});
inline constexpr auto compass_bearing_object =
    variable(0x6486, "compass_bearing", "9.2.15.5", "Where the vehicle heads to, by compass.",
             entry(unsigned16, ro, optional, {}, heading), {.errata = "63, 64"});
inline constexpr auto compass_bearing_precision_object = variable(
    0x6487, "compass_bearing_precision", "9.2.15.6", "How exact 6486h is.",
    entry(unsigned16, ro, optional, 0xFFFF,
          {.unit = Unit::degree, .scale = {.denominator = 128}, .names = precision_unknown_16}),
    {.condition = "if object 6486h is implemented", .errata = "104"});

// Doors.

/// State of all doors together (6488h).
enum class Doors : std::uint8_t { all_closed = 0, open = 1 };
/// Whether passengers may open the doors of a side (6488h).
enum class Release : std::uint8_t { blocked = 0, released = 1 };
/// State of one door (6488h).
enum class Door : std::uint8_t { closed = 0, open = 1 };
/// Whether the state of one door is known (6488h).
enum class Validity : std::uint8_t { invalid = 0, valid = 1 };
inline constexpr NamedValue doors_states[] = {{Doors::all_closed, "all valid doors closed"},
                                              {Doors::open, "at least one door open"}};
inline constexpr NamedValue release_states[] = {{Release::blocked, "doors blocked"},
                                                {Release::released, "doors released"}};
inline constexpr NamedValue door_states[] = {{Door::closed, "door closed"},
                                             {Door::open, "door open"}};
inline constexpr NamedValue validities[] = {{Validity::invalid, "door invalid"},
                                            {Validity::valid, "door valid"}};
inline constexpr FieldInfo general_door_fields[] = {
    reserved<5>(0),
    field(5, 1, "right side doors", release_states),
    field(6, 1, "left side doors", release_states),
    field(7, 1, "all doors", doors_states),
};
/// Four doors in a byte: the first of them, N, in the highest bits.
inline constexpr FieldInfo specific_door_fields[] = {
    field(0, 1, "door N+3 valid", validities), field(1, 1, "door N+3", door_states),
    field(2, 1, "door N+2 valid", validities), field(3, 1, "door N+2", door_states),
    field(4, 1, "door N+1 valid", validities), field(5, 1, "door N+1", door_states),
    field(6, 1, "door N valid", validities),   field(7, 1, "door N", door_states),
};
/// 6488h: the general state, then four doors at each sub-index.
constexpr std::array<EntryInfo, 6> make_state_of_doors_entries() {
  EntryInfo general = by_device(
      sub_index(1, "general_state", entry(unsigned8, ro, optional, {}, general_door_fields)));
  EntryInfo four = by_device({.mapping = Mapping::optional,
                              .fields = specific_door_fields,
                              .description = "Of the doors from N = 4 x sub-index - 7 on."});
  EntryInfo first = at(2, four);
  first.name = "specific_state_1_to_4";
  EntryInfo second = optional_at(3, 3, four);
  second.name = "specific_state_5_to_8";
  EntryInfo others = optional_at(4, 253, four);
  others.name = "specific_state_of_four_doors_#";
  others.first_number = 3;
  EntryInfo last = optional_at(254, 254, four);
  last.name = "specific_state_1009_to_1012";
  return {entries_within(2, 254), general, first, second, others, last};
}
inline constexpr auto state_of_doors_entries = make_state_of_doors_entries();
inline constexpr auto state_of_doors_object =
    array(0x6488, "state_of_doors", "9.2.15.7", "Which doors are open, and which may be opened.",
          state_of_doors_entries, "10, 44, 78, 79");

// Temperatures, fuel and times of operation.

inline constexpr auto ambient_air_temperature_object = variable(
    0x6489, "ambient_air_temperature", "9.2.15.8", "The temperature outside: -273 to 1735 °C.",
    entry(unsigned16, ro, optional, {},
          coded_16(Unit::degree_celsius, {.denominator = 32, .offset = -273 * 32})),
    {.errata = "60"});

/// Members of 0080h, in the shape of 648Ah (errata 66).
constexpr std::array<EntryInfo, 7> fuel_members(const EntryInfo& number, const EntryInfo& shape) {
  const auto member = [&](std::uint8_t sub, std::string_view name, DataType type,
                          const ValueInfo& value, std::string_view description) {
    EntryInfo entry = at(sub, shape);
    entry.name = name;
    entry.type = type;
    entry.value = value;
    entry.description = description;
    return entry;
  };
  constexpr ValueInfo rate = coded_16(Unit::litre_per_hour, {.denominator = 20});
  constexpr ValueInfo economy = coded_16(Unit::kilometre_per_litre, {.denominator = 512});
  constexpr ValueInfo volume = coded_32(Unit::litre, {.denominator = 2});
  return {number,
          member(1, "fuel_rate", DataType::unsigned16, rate, "What the engine takes."),
          member(2, "instantaneous_fuel_economy", DataType::unsigned16, economy,
                 "How far a litre takes the vehicle at present."),
          member(3, "average_fuel_economy", DataType::unsigned16, economy,
                 "The mean of it over a stretch of interest."),
          member(4, "total_fuel_used", DataType::unsigned32, volume, "In all of the operation."),
          member(5, "trip_fuel", DataType::unsigned32, volume, "In a journey, or part of one."),
          member(6, "total_idle_fuel_used", DataType::unsigned32, volume, "While idling.")};
}
inline constexpr auto fuel_economy_entries =
    fuel_members(entries_always(6), by_device(entry(unsigned8, ro, optional)));
inline constexpr auto fuel_economy_object =
    record(0x648A, "fuel_economy", "9.2.15.9", "What the engine consumes (record type 0080h).",
           fuel_economy_entries, "65, 66, 67, 105");

/// State of the brake pedal (648Bh).
enum class BrakePedal : std::uint8_t {
  released = 0,
  depressed = 1,
  error = 2,
  not_available = 3,
};
inline constexpr NamedValue brake_pedal_states[] = {
    {BrakePedal::released, "brake pedal released"},
    {BrakePedal::depressed, "brake pedal depressed"},
    {BrakePedal::error, "error", Meaning::failure},
    {BrakePedal::not_available, "information not available", Meaning::invalid}};
inline constexpr FieldInfo brake_switch_fields[] = {
    reserved<6>(0),
    field(6, 2, "brake pedal", brake_pedal_states),
};
inline constexpr auto brake_switch_object =
    variable(0x648B, "brake_switch", "9.2.15.10", "Whether the driver brakes.",
             entry(unsigned8, ro, optional, {}, brake_switch_fields));
inline constexpr auto engine_coolant_temperature_object =
    variable(0x648C, "engine_coolant_temperature", "9.2.15.11",
             "The temperature of the liquid that cools the engine: -40 to 210 °C.",
             entry(unsigned8, ro, optional, {}, coded_8(Unit::degree_celsius, {.offset = -40})));

/// A time of 648Dh.
constexpr EntryInfo operation_time(std::uint8_t sub, std::string_view name,
                                   std::string_view description) {
  return by_device(sub_index(
      sub, name, entry(unsigned32, ro, optional, {}, coded_32(Unit::hour, {.denominator = 20})),
      {.category = Category::optional, .description = description}));
}
inline constexpr EntryInfo operation_times_entries[] = {
    entries_within(1, 4), operation_time(1, "total_idle_hours", "The engine idles."),
    operation_time(2, "total_vehicle_hours", "The vehicle is in operation."),
    operation_time(3, "total_engine_hours", "The engine is in operation."),
    operation_time(4, "total_power_takeoff_hours", "The power take-off is in operation.")};
inline constexpr auto operation_times_object =
    array(0x648D, "operation_times", "9.2.15.12", "How long the vehicle and its parts have worked.",
          operation_times_entries, "6, 50");

// Tachograph.

inline constexpr auto tachograph_speed_object =
    variable(0x6520, "tachograph_speed", "9.2.17.1", "The speed, forward or backward, to 1 km/h.",
             entry(unsigned16, ro, optional, {}, speed), {.errata = "61"});
inline constexpr auto drive_recognition_and_direction_indication_object =
    variable(0x6521, "drive_recognition_and_direction_indication", "9.2.17.2",
             "Whether the vehicle moves (pulses of the sensor for 5 s), and which way.",
             entry(unsigned8, ro, optional, {}, drive_fields), {.errata = "73"});

/// A distance in steps of 5 m.
constexpr EntryInfo vehicle_distance(std::uint8_t sub, std::string_view name) {
  return by_device(sub_index(sub, name, entry(unsigned32, ro, optional, {}, distance)));
}
inline constexpr EntryInfo high_resolution_vehicle_distance_entries[] = {
    entries_within(1, 2), vehicle_distance(1, "total_vehicle_distance"),
    vehicle_distance(2, "trip_distance")};
inline constexpr auto high_resolution_vehicle_distance_object =
    array(0x6522, "high_resolution_vehicle_distance", "9.2.17.3",
          "The distance gone in all, and in a journey or part of one; exact to 10 m.",
          high_resolution_vehicle_distance_entries, "4");

/// Members of 0081h, in the shape of 6523h and 6680h (errata 48, 53).
constexpr std::array<EntryInfo, 9> time_members(const EntryInfo& number, const EntryInfo& shape) {
  std::array<EntryInfo, 9> entries{};
  entries[0] = number;
  entries[1] = at(1, shape);
  entries[1].name = "local_hour";
  entries[1].value = offset_hours;
  entries[2] = at(2, shape);
  entries[2].name = "local_minute";
  entries[2].value = offset_minutes;
  for (std::size_t i : {1U, 2U}) {
    entries[i].type = DataType::integer8;
    entries[i].initial = 0;
    entries[i].description = "Offset of the local time to GMT.";
  }
  const auto parts = date_and_time(3, shape);
  for (std::size_t i = 0; i < parts.size(); ++i) entries[i + 3] = parts[i];
  return entries;
}
/// The clause refers to ISO 16844-7, and so has its codes for unavailable values.
inline constexpr auto tachograph_time_and_date_entries =
    time_members(entries_always(8), by_device(entry(unsigned8, ro, optional, {}, not_values_8)));
inline constexpr auto tachograph_time_and_date_object = record(
    0x6523, "tachograph_time_and_date", "9.2.17.4", "Time and date in UTC (record type 0081h).",
    tachograph_time_and_date_entries, "48, 52, 53, 56, 105");

/// Identification of a driver's card, 19 characters.
constexpr EntryInfo driver_card(std::uint8_t sub, std::string_view name) {
  return by_device({.sub_first = sub,
                    .name = name,
                    .type = DataType::visible_string,
                    .capacity = 19,
                    .capacity_is_printed = true});
}
inline constexpr EntryInfo tachograph_driver_id_entries[] = {
    entries_always(2), driver_card(1, "driver_1"), driver_card(2, "driver_2")};
inline constexpr auto tachograph_driver_id_object =
    array(0x6524, "tachograph_driver_ID", "9.2.17.5",
          "The driver cards in both slots: 3 bytes of the member state, 16 of the card's number.",
          tachograph_driver_id_entries, "84");

/// A driving time in minutes.
constexpr EntryInfo driving_time(std::uint8_t sub, std::string_view name) {
  return by_device(
      sub_index(sub, name, entry(unsigned16, ro, optional, {}, {.unit = Unit::minute})));
}
inline constexpr EntryInfo continuous_driving_time_entries[] = {
    entries_always(2), driving_time(1, "driver_1"), driving_time(2, "driver_2")};
inline constexpr auto continuous_driving_time_object = array(
    0x6525, "continuous_driving_time", "9.2.17.6",
    "How long each driver has driven without a break.", continuous_driving_time_entries, "84");

}  // namespace canvoy::cia407
