#include "canvoy/devices/cia447/taximeter/taximeter_objects.hpp"

#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

void TaximeterObjects::report_trip(const TripData& data, bool is_all) {
  if (!is_all && data == told_) return;
  told_ = data;
  sequence_ = next_sequence(sequence_);
  tell(node_.dictionary(), data);
  value(taxi_trip_data_sequence_counter).set_raw(sequence_);
}

void TaximeterObjects::report_state(Taximeter state, bool is_turning_off) {
  value(taximeter_status) = state;
  value(taximeter_status_changing_to_off) = is_turning_off ? Signal::yes : Signal::no;
}

/// Lost totals are a failure until the meter is sealed again.
void TaximeterObjects::report_totals(const TaximeterRecord& record) {
  constexpr std::uint32_t failure = 0xFFFF'FFFE;
  const auto tell = [&, this](const auto& handle, std::uint32_t total) {
    value(handle).set_raw(record.totals_are_known ? total : failure);
  };
  const TaxiTotals& total = record.total;
  const TaxiTotals& shift = record.shift;
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

void TaximeterObjects::report_configuration(const TaximeterRecord& record,
                                            const TaximeterSettings& settings) {
  value(taximeter_configuration_k_value).set_raw(record.k);
  value(taximeter_configuration_mode) = record.mode;
  value(taximeter_configuration_tariff) = record.tariff;
  value(taximeter_configuration_taxi_identifier) = settings.taxi_identifier;
  const bool is_double = settings.calculation == FareMode::double_calculation;
  value(taximeter_configuration_calculation_of_fare) = is_double ? "D" : "S";
  value(taximeter_configuration_date_of_securing)
      .set_raw(seconds_since_1970(record.date_of_securing));
  const bool has_future =
      settings.future_tariff.id != 0 && record.tariff != settings.future_tariff.id;
  if (has_future) {
    value(taximeter_configuration_future_tariff) = settings.future_tariff.id;
  } else {
    value(taximeter_configuration_future_tariff) = std::nullopt;
  }
  value(taximeter_configuration_actual_currency) = settings.currency.code;
  value(taximeter_configuration_actual_local_distance_unit) = settings.distance_unit;
}

}  // namespace canvoy::cia447
