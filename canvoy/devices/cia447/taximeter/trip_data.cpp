#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

#include "canvoy/devices/cia447/taximeter/trip_parts.hpp"

namespace canvoy::cia447 {

void tell(Dictionary& dictionary, const TripData& data) {
  for (const TripPart& part : trip_parts) write_field(dictionary, part.place, data.*part.value);
  const Values meter(dictionary);
  meter[taxi_trip_payment_fare_calculation_mode] = data.mode;
  meter[taxi_trip_tariff_level_character_1].set_raw(data.level[0]);
  meter[taxi_trip_tariff_level_character_2].set_raw(data.level[1]);
}

}  // namespace canvoy::cia447
