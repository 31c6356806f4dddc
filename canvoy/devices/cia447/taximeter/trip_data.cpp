#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

#include <algorithm>

#include "canvoy/devices/cia447/taximeter/trip_parts.hpp"

namespace canvoy::cia447 {

namespace {

std::uint32_t reported_seconds(Duration time) {
  return capped(static_cast<std::uint64_t>(std::chrono::floor<std::chrono::seconds>(time).count()));
}

void fill_fare(TripData& data, const FareCalculation& fare) {
  const bool is_fixed = fare.mode() == FareMode::fixed_price;
  const TariffLevel& level = fare.level();
  data.fare = fare.fare();
  data.total = capped(std::uint64_t{data.fare} + data.supplements);
  data.mode = fare.mode();
  data.minimum_fare = is_fixed ? 0 : fare.minimum_fare();
  data.initial_fare = is_fixed ? 0 : fare.initial_fare();
  data.waiting = reported_seconds(fare.charged_time());
  data.level = {static_cast<std::uint8_t>(level.name[0]), static_cast<std::uint8_t>(level.name[1])};
  data.time_rate = is_fixed ? 0 : level.time_rate;
  data.distance_rate = is_fixed ? 0 : level.distance_rate;
}

}  // namespace

std::uint32_t seconds_since_1970(std::int64_t time) {
  const bool is_known = time >= 0 && time <= std::int64_t{amount_max};
  return is_known ? static_cast<std::uint32_t>(time) : TripData::unknown;
}

TripData trip_data(const TaxiTrip& trip, const FareCalculation& fare) {
  TripData data;
  if (!trip.is_there) return data;
  data.supplements = trip.supplements;
  data.distance =
      capped(trip.pulses * thousandths / std::max<std::uint32_t>(fare.state().conditions.k, 1U));
  data.duration = reported_seconds(Duration(trip.duration));
  data.start = seconds_since_1970(trip.start);
  data.finish = seconds_since_1970(trip.finish);
  if (trip.has_fare) fill_fare(data, fare);
  return data;
}

void tell(Dictionary& dictionary, const TripData& data) {
  for (const TripPart& part : trip_parts) write_field(dictionary, part.place, data.*part.value);
  const Values meter(dictionary);
  meter[taxi_trip_payment_fare_calculation_mode] = data.mode;
  meter[taxi_trip_tariff_level_character_1].set_raw(data.level[0]);
  meter[taxi_trip_tariff_level_character_2].set_raw(data.level[1]);
}

}  // namespace canvoy::cia447
