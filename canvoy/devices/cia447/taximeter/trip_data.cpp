#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

void tell(Dictionary& dictionary, const TripData& data) {
  const Values meter(dictionary);
  meter[taxi_trip_payment_fare].set_raw(data.fare);
  meter[taxi_trip_payment_supplement_charge].set_raw(data.supplements);
  meter[taxi_trip_payment_total_charged].set_raw(data.total);
  meter[taxi_trip_payment_fare_calculation_mode] = data.mode;
  meter[taxi_trip_payment_minimum_fare].set_raw(data.minimum_fare);
  meter[taxi_trip_payment_initial_fare].set_raw(data.initial_fare);
  meter[taxi_trip_distance_travelled].set_raw(data.distance);
  meter[taxi_trip_time_information_duration].set_raw(data.duration);
  meter[taxi_trip_time_information_fare_relevant_waiting].set_raw(data.waiting);
  meter[taxi_trip_time_information_start].set_raw(data.start);
  meter[taxi_trip_time_information_finish].set_raw(data.finish);
  meter[taxi_trip_tariff_level_character_1].set_raw(data.level[0]);
  meter[taxi_trip_tariff_level_character_2].set_raw(data.level[1]);
  meter[taxi_trip_tariff_value_time].set_raw(data.time_rate);
  meter[taxi_trip_tariff_value_distance].set_raw(data.distance_rate);
}

}  // namespace canvoy::cia447
