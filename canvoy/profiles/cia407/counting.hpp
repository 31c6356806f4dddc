// Objects of CiA 407 that the passenger counter provides, 6700h (9.2.25), and those that the
// passenger counting manager provides, 6720h to 6723h (9.2.26).
//
//     cia407::counter_passenger_sum_object.index  // 6722h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

inline constexpr ValueInfo passengers = {.counting = Counting::counts};
inline constexpr FieldInfo passenger_counting_fields[] = {
    field(0, 8, "number of outgoing passengers", passengers),
    field(8, 8, "number of incoming passengers", passengers),
};
inline constexpr auto passenger_counting_in_and_out_per_door_object =
    variable(0x6700, "passenger_counting_in_and_out_per_door", "9.2.25.1",
             "How many passengers came in and went out by the door.",
             entry(unsigned16, ro, optional, 0, passenger_counting_fields));

inline constexpr auto passenger_counting_manager_data_object = variable(
    0x6720, "passenger_counting_manager_data", "9.2.26.1", "Transparent data.", entry(domain, ro));

/// A number of passengers, 0 at first.
constexpr EntryInfo total_of_passengers(std::uint8_t sub, std::string_view name) {
  return by_device(sub_index(sub, name, entry(unsigned16, ro, no, 0, passengers)));
}
inline constexpr EntryInfo total_in_out_passenger_counting_value_entries[] = {
    entries_always(2), total_of_passengers(1, "number_incoming_passengers"),
    total_of_passengers(2, "number_outgoing_passengers")};
inline constexpr auto total_in_out_passenger_counting_value_object =
    array(0x6721, "total_in_out_passenger_counting_value", "9.2.26.2",
          "How many passengers came in and went out of the car.",
          total_in_out_passenger_counting_value_entries, "39");
inline constexpr auto counter_passenger_sum_object =
    variable(0x6722, "counter_passenger_sum", "9.2.26.3", "How many passengers are in the car.",
             entry(unsigned16, ro, optional, 0, passengers));
inline constexpr auto passenger_capacity_usage_object =
    variable(0x6723, "passenger_capacity_usage", "9.2.26.4", "How full the car is.",
             entry(unsigned8, ro, optional, 0, {.unit = Unit::percent}), {.errata = "40"});

}  // namespace canvoy::cia407
