// What others read of a taximeter: 60D0h to 60DBh, and its display.
#include <algorithm>

#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447 {

namespace {

std::uint32_t told_seconds(Duration time) {
  return capped(static_cast<std::uint64_t>(std::chrono::floor<std::chrono::seconds>(time).count()));
}
/// Seconds since 1970-01-01 as 32 bits have them.
std::uint32_t told_time(std::int64_t since_1970) {
  const bool is_known = since_1970 >= 0 && since_1970 <= std::int64_t{amount_max};
  return is_known ? static_cast<std::uint32_t>(since_1970) : TripData::unknown;
}

}  // namespace

TripData TaximeterUnit::trip_data() const {
  const TaxiTrip& trip = record_.trip;
  TripData data;
  if (!trip.is_there) return data;
  data.supplements = trip.supplements;
  data.distance = capped(trip.pulses * thousandths / std::max(fare_.state().conditions.k, 1U));
  data.duration = told_seconds(Duration(trip.duration));
  data.start = told_time(trip.start);
  data.finish = told_time(trip.finish);
  if (trip.has_fare) fill_fare(data);
  return data;
}

void TaximeterUnit::fill_fare(TripData& data) const {
  const bool is_fixed = fare_.mode() == FareMode::fixed_price;
  const TariffLevel& level = fare_.level();
  data.fare = fare_.fare();
  data.total = capped(std::uint64_t{data.fare} + data.supplements);
  data.mode = fare_.mode();
  data.minimum_fare = is_fixed ? 0 : fare_.minimum_fare();
  data.initial_fare = is_fixed ? 0 : fare_.initial_fare();
  data.waiting = told_seconds(fare_.charged_time());
  data.level = {static_cast<std::uint8_t>(level.name[0]), static_cast<std::uint8_t>(level.name[1])};
  data.time_rate = is_fixed ? 0 : level.time_rate;
  data.distance_rate = is_fixed ? 0 : level.distance_rate;
}

/// At a reset of the bus all is told, else what has changed.
void TaximeterUnit::publish(bool is_all) {
  const TripData data = trip_data();
  if (is_all || data != told_) {
    told_ = data;
    sequence_ = next_sequence(sequence_);
    tell(network_.node().dictionary(), data);
    value(taxi_trip_data_sequence_counter).set_raw(sequence_);
  }
  value(taximeter_status) = record_.state;
  value(taximeter_status_changing_to_off) = is_turning_off_ ? Signal::yes : Signal::no;
  publish_totals();
  if (is_all) publish_configuration();
  const TaximeterDisplay display = {.state = record_.state,
                                    .trip = data,
                                    .has_error = errors_ != 0,
                                    .has_wheel_signal = has_wheel_signal()};
  if (display == shown_) return;
  shown_ = display;
  hardware_.show(display);
}

void TaximeterUnit::hardware_changed() {
  hardware_.show(shown_);
}

/// Where they were lost, they are a failure until the meter is sealed anew.
void TaximeterUnit::publish_totals() {
  constexpr std::uint32_t failure = 0xFFFF'FFFE;
  const auto tell = [this](const auto& handle, std::uint32_t total) {
    value(handle).set_raw(record_.totals_are_known ? total : failure);
  };
  const TaxiTotals& total = record_.total;
  const TaxiTotals& shift = record_.shift;
  tell(taximeter_totalizers_total_distance_travelled, total.distance);
  tell(taximeter_totalizers_shift_distance_travelled, shift.distance);
  tell(taximeter_totalizers_total_distance_when_hired, total.distance_hired);
  tell(taximeter_totalizers_shift_distance_when_hired, shift.distance_hired);
  tell(taximeter_totalizers_total_income, total.income);
  tell(taximeter_totalizers_shift_income, shift.income);
  tell(taximeter_totalizers_total_number_of_hirings, total.hirings);
  tell(taximeter_totalizers_shift_number_of_hirings, shift.hirings);
  tell(taximeter_totalizers_total_supplements, total.supplements);
  tell(taximeter_totalizers_shift_supplements, shift.supplements);
  tell(taximeter_totalizers_total_fare, total.fare);
  tell(taximeter_totalizers_shift_fare, shift.fare);
}

void TaximeterUnit::publish_configuration() {
  value(taximeter_configuration_k_value).set_raw(record_.k);
  value(taximeter_configuration_mode) = settings_.mode;
  value(taximeter_configuration_tariff) = record_.tariff;
  value(taximeter_configuration_taxi_identifier) = settings_.taxi_identifier;
  const bool is_double = settings_.calculation == FareMode::double_calculation;
  value(taximeter_configuration_calculation_of_fare) = is_double ? "D" : "S";
  value(taximeter_configuration_date_of_securing).set_raw(told_time(record_.date_of_securing));
  const bool has_future =
      settings_.future_tariff.id != 0 && record_.tariff != settings_.future_tariff.id;
  if (has_future) {
    value(taximeter_configuration_future_tariff) = settings_.future_tariff.id;
  } else {
    value(taximeter_configuration_future_tariff) = std::nullopt;
  }
  value(taximeter_configuration_actual_currency) = settings_.currency;
  value(taximeter_configuration_actual_local_distance_unit) = settings_.distance_unit;
}

}  // namespace canvoy::cia447
