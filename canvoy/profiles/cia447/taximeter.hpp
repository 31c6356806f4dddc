// CiA 447-3, clause 4.2.12: the taximeter: the trip (the present one, or the last one while the
// taxi is for hire), totals, configuration.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

inline constexpr ValueInfo money = measured<32>(Unit::local_currency, {.denominator = 1000});
inline constexpr ValueInfo distance = measured<32>(Unit::local_distance, {.denominator = 1000});
inline constexpr ValueInfo seconds = measured<32>(Unit::second);
/// Seconds since 1970-01-01; the time zone is not specified (errata Z42).
inline constexpr ValueInfo date_in_seconds = measured<32>(Unit::second);
inline constexpr ValueInfo plain_count = measured<32>();

/// A value of 32 bits in an array.
constexpr EntryInfo status_32(unsigned sub, std::string_view name, const ValueInfo& value,
                              Category category = Category::optional) {
  return at(sub, name, status(DataType::unsigned32, Mapping::no, value), category);
}

// 4.2.12.1 to 4.2.12.5: the trip. 60DBh reports a change of the trip during reading.

inline constexpr auto fare_calculation_modes =
    status_values<32>("Single calculation mode S", "Double calculation mode D", "Fixed price");
inline constexpr EntryInfo taxi_trip_payment_entries[] = {
    highest_sub_index(3, 6, Access::const_),
    status_32(1, "Trip fare", money, Category::mandatory),
    status_32(2, "Trip supplement charge", money, Category::mandatory),
    status_32(3, "Total charged", money, Category::mandatory),
    status_32(4, "Trip fare calculation mode", ValueInfo{.names = fare_calculation_modes}),
    status_32(5, "Trip minimum fare", money),
    status_32(6, "Trip initial fare", money)};
inline constexpr auto taxi_trip_payment_object =
    array_object(0x60D0, "Taxi trip payment", "4.2.12.1",
                 "What the trip costs; begins anew when the taxi is hired.",
                 taxi_trip_payment_entries, {.errata = "Z30, Z33, Z42"});

inline constexpr auto taxi_trip_distance_travelled_object =
    variable_object(0x60D1, "Taxi trip distance travelled", "4.2.12.2",
                    "How long the trip is; begins anew when the taxi is hired.",
                    status(DataType::unsigned32, Mapping::no, distance), {.errata = "Z42"});

inline constexpr EntryInfo taxi_trip_time_information_entries[] = {
    highest_sub_index(1, 4, Access::const_),
    status_32(1, "Trip duration", seconds, Category::mandatory),
    status_32(2, "Fare relevant waiting time", seconds),
    status_32(3, "Trip start time", date_in_seconds),
    status_32(4, "Trip finish time", date_in_seconds)};
inline constexpr auto taxi_trip_time_information_object =
    array_object(0x60D2, "Taxi trip time information", "4.2.12.3",
                 "Durations in seconds; start and finish in seconds since 1970-01-01.",
                 taxi_trip_time_information_entries, {.errata = "Z33, Z42"});

/// A printable character of ISO 10646, or 0 for none (errata Z12).
inline constexpr NamedValue tariff_character_names[] = {
    status_sentinels<8>.second_highest, status_sentinels<8>.highest, reserved_codes(0x01, 0x1F),
    reserved_codes(0x7F, 0xFD)};
inline constexpr ValueInfo tariff_character = {.limits = within(0x00, 0x7E),
                                               .names = tariff_character_names,
                                               .notation = Notation::characters};
inline constexpr auto tariff_level_fields =
    side_by_side(field(8, "tariff level character 1", "", tariff_character),
                 field(8, "tariff level character 2", "", tariff_character));
inline constexpr auto taxi_trip_tariff_level_object = variable_object(
    0x60D3, "Taxi trip tariff level", "4.2.12.4", "The tariff that holds on the trip.",
    status(DataType::unsigned16, Mapping::no, tariff_level_fields), {.errata = "Z12, Z46"});

inline constexpr EntryInfo taxi_trip_tariff_value_entries[] = {
    highest_sub_index(2, 2, Access::const_),
    status_32(1, "Time tariff value",
              measured<32>(Unit::local_currency_per_hour, {.denominator = 1000}),
              Category::mandatory),
    status_32(2, "Distance tariff value",
              measured<32>(Unit::local_currency_per_distance, {.denominator = 1000}),
              Category::mandatory)};
inline constexpr auto taxi_trip_tariff_value_object =
    array_object(0x60D4, "Taxi trip tariff value", "4.2.12.5", "What an hour and a distance cost.",
                 taxi_trip_tariff_value_entries, {.errata = "Z18, Z33, Z41, Z42"});

// 4.2.12.6 and 4.2.12.7: state and totals.

inline constexpr auto taximeter_states =
    status_values<4>("For hire", "Hired", "Stopped", "Signed off", "Service mode", "Standby mode");
inline constexpr auto taximeter_status_fields =
    side_by_side(field(4, "taximeter status", "what the taximeter does", taximeter_states),
                 field(2, "ticof", "taximeter is changing to off mode", no_yes), reserved<1, 2>());
inline constexpr auto taximeter_status_object = variable_object(
    0x60D8, "Taximeter status", "4.2.12.6", "What the taximeter does.",
    status(DataType::unsigned8, Mapping::by_default, taximeter_status_fields), {.errata = "Z39"});

inline constexpr EntryInfo taximeter_totalizers_entries[] = {
    highest_sub_index(1, 12, Access::const_),
    status_32(1, "Total distance travelled", distance, Category::mandatory),
    status_32(2, "Shift distance travelled", distance),
    status_32(3, "Total distance when hired", distance),
    status_32(4, "Shift distance when hired", distance),
    status_32(5, "Total income", money),
    status_32(6, "Shift income", money),
    status_32(7, "Total number of hirings", plain_count),
    status_32(8, "Shift number of hirings", plain_count),
    status_32(9, "Total supplements", money),
    status_32(10, "Shift supplements", money),
    status_32(11, "Total fare", money),
    status_32(12, "Shift fare", money)};
inline constexpr auto taximeter_totalizers_object = array_object(
    0x60D9, "Taximeter totalizers", "4.2.12.7",
    "Sums of all time, and of the shift: of the last one while no driver is signed in.",
    taximeter_totalizers_entries, {.errata = "Z33, Z42"});

// 4.2.12.8. The types of this record are in part 1; they follow from the values and defaults
// (errata Z34).

inline constexpr auto taximeter_modes =
    status_values<8>("Taximeter operation", "Odometer operation");
/// The same value as an identification, which is no amount.
constexpr ValueInfo identification(ValueInfo value) {
  value.counting = Counting::identifies;
  return value;
}
inline constexpr ValueInfo tariff_identification = identification(measured<24, 0xFFFF>());
/// Part 1 may limit these texts; the capacities are our choice.
inline constexpr std::uint16_t identifier_capacity = 32;
inline constexpr std::uint16_t unit_name_capacity = 16;
inline constexpr EntryInfo taximeter_configuration_entries[] = {
    highest_sub_index(3, 9, Access::const_),
    at(1, "Constant of the distance signal generator (k value)",
       status(DataType::unsigned32, Mapping::no, measured<32>(Unit::pulse_per_local_distance))),
    at(2, "Taximeter mode",
       status(DataType::unsigned8, Mapping::no, ValueInfo{.names = taximeter_modes})),
    at(3, "Identification of the tariff",
       status(DataType::unsigned24, Mapping::no, tariff_identification)),
    at(4, "Taxi identifier", status_text(identifier_capacity), Category::optional),
    at(5, "Calculation of fare", status_text(identifier_capacity), Category::optional),
    at(6, "Date of securing", status(DataType::unsigned32, Mapping::no, date_in_seconds),
       Category::optional),
    at(7, "Identification of future tariff",
       status(DataType::unsigned24, Mapping::no, tariff_identification), Category::optional),
    at(8, "Actual currency", status_text(unit_name_capacity), Category::optional),
    at(9, "Actual local distance unit", status_text(unit_name_capacity), Category::optional)};
inline constexpr auto taximeter_configuration_object =
    structured_object(ObjectCode::record, 0x60DA, "Taximeter configuration", "4.2.12.8",
                      "Pulses per distance, mode, tariffs, identity, date of sealing, units.",
                      taximeter_configuration_entries, {.errata = "Z21, Z33, Z34, Z42, Z50"});

// 4.2.12.9.

inline constexpr auto taxi_trip_data_sequence_counter_fields =
    side_by_side(field(8, "taxi trip data sequence counter", "counts changes", measured<8>()));
inline constexpr auto taxi_trip_data_sequence_counter_object = variable_object(
    0x60DB, "Taxi trip data sequence counter", "4.2.12.9",
    "Read before and after 60D0h to 60D3h: where it has changed, they are read again.",
    status(DataType::unsigned8, Mapping::no, taxi_trip_data_sequence_counter_fields),
    {.errata = "Z03, Z41, Z45"});

}  // namespace canvoy::cia447
