// Locations of the numbers of a trip in the dictionary, for writer and reader.
//
//     for (const auto& part : trip_parts) write_field(dictionary, part.place, data.*part.value);
#pragma once

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

/// A number of the trip, and its place.
struct TripPart {
  FieldPlace place;                ///< in the dictionary
  std::uint32_t TripData::*value;  ///< member
};

/// All numbers of 32 bits; mode (60D0h:04h) and level (60D3h) are none.
inline constexpr TripPart trip_parts[] = {
    {place_of(taxi_trip_payment_fare), &TripData::fare},
    {place_of(taxi_trip_payment_supplement_charge), &TripData::supplements},
    {place_of(taxi_trip_payment_total_charged), &TripData::total},
    {place_of(taxi_trip_payment_minimum_fare), &TripData::minimum_fare},
    {place_of(taxi_trip_payment_initial_fare), &TripData::initial_fare},
    {place_of(taxi_trip_distance_travelled), &TripData::distance},
    {place_of(taxi_trip_time_information_duration), &TripData::duration},
    {place_of(taxi_trip_time_information_fare_relevant_waiting), &TripData::waiting},
    {place_of(taxi_trip_time_information_start), &TripData::start},
    {place_of(taxi_trip_time_information_finish), &TripData::finish},
    {place_of(taxi_trip_tariff_value_time), &TripData::time_rate},
    {place_of(taxi_trip_tariff_value_distance), &TripData::distance_rate},
};

}  // namespace canvoy::cia447
