// The driver's keys of a taximeter, and the resulting trips (CiA 447-3, 4.2.12.6).
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

namespace canvoy::cia447 {

namespace {

constexpr Duration save_again = 100ms;

}  // namespace

bool TaximeterUnit::enter(Taximeter state) {
  record_.state = state;
  is_turning_off_ = false;
  network_.node().timers().disarm(off_);
  keep();
  publish();
  object_to_sleep();
  return true;
}

/// The network stays awake while passengers are in the car.
void TaximeterUnit::object_to_sleep() {
  constexpr std::uint8_t trip_under_way = 1;
  std::optional<std::uint8_t> reason;
  if (has_trip_under_way()) reason = trip_under_way;
  network_.object_to_sleep(reason);
}

bool TaximeterUnit::sign_on() {
  if (record_.state != Taximeter::signed_off) return false;
  advance(0, false);
  record_.shift = {};
  record_.shift_begin = utc_now();
  return enter(Taximeter::for_hire);
}

bool TaximeterUnit::sign_off() {
  return record_.state == Taximeter::for_hire && enter(Taximeter::signed_off);
}

bool TaximeterUnit::hire() {
  const bool is_paused = record_.state == Taximeter::stopped;
  const bool is_free = record_.state == Taximeter::for_hire && record_.tampering == 0;
  if (!is_paused && !is_free) return false;
  advance(0, false);
  slice_ = {};
  if (is_paused) {
    record_.trip.finish = no_time;
  } else {
    begin_trip();
  }
  return enter(Taximeter::hired);
}

void TaximeterUnit::begin_trip() {
  watch_clock_step();
  change_tariff();
  const bool is_odometer = record_.mode == TaximeterMode::odometer_operation;
  const bool is_fixed = agreed_price_.has_value() || is_odometer;
  record_.trip = {};
  record_.trip.is_there = true;
  record_.trip.has_fare = agreed_price_.has_value() || !is_odometer;
  record_.trip.start = utc_now();
  fare_.begin({.mode = is_fixed ? FareMode::fixed_price : settings_.calculation,
               .k = record_.k,
               .fixed_price = agreed_price_.value_or(0)},
              present_level());
  agreed_price_.reset();
  TaxiTotals::add(record_.total.hirings, 1);
  TaxiTotals::add(record_.shift.hirings, 1);
}

bool TaximeterUnit::stop() {
  if (!is_hired()) return false;
  advance(0, false);
  fare_.close_slice();
  record_.trip.finish = utc_now();
  return enter(Taximeter::stopped);
}

bool TaximeterUnit::for_hire() {
  if (record_.state != Taximeter::stopped) return false;
  end_trip();
  return enter(Taximeter::for_hire);
}

/// In one record with the state "for hire", so that it is added once.
void TaximeterUnit::end_trip() {
  fare_.close_slice();
  const std::uint32_t fare = record_.trip.has_fare ? fare_.fare() : 0;
  const std::uint64_t income = std::uint64_t{fare} + record_.trip.supplements;
  for (TaxiTotals* totals : {&record_.total, &record_.shift}) {
    TaxiTotals::add(totals->fare, fare);
    TaxiTotals::add(totals->supplements, record_.trip.supplements);
    TaxiTotals::add(totals->income, income);
  }
  record_.chosen_level = TaximeterRecord::no_level;
}

bool TaximeterUnit::standby() {
  const bool is_idle =
      record_.state == Taximeter::for_hire || record_.state == Taximeter::signed_off;
  if (!is_idle) return false;
  record_.before_standby = record_.state;
  return enter(Taximeter::standby_mode);
}

bool TaximeterUnit::wake() {
  if (record_.state == Taximeter::standby_mode) return enter(record_.before_standby);
  return is_turning_off_ && enter(record_.state);
}

bool TaximeterUnit::turn_off() {
  if (has_trip_under_way() || record_.state == Taximeter::service_mode) return false;
  is_turning_off_ = true;
  keep();
  publish();
  network_.node().timers().arm(off_, network_.node().now() + settings_.turning_off);
  return true;
}

void TaximeterUnit::off(Time now) {
  if (memory_.is_busy()) {
    network_.node().timers().arm(off_, now + save_again);
  } else {
    hardware_.turned_off();
  }
}

bool TaximeterUnit::choose_level(unsigned level) {
  if (level >= tariff_.levels.size() || level >= TaximeterRecord::no_level) return false;
  if (record_.state != Taximeter::for_hire && !is_hired()) return false;
  record_.chosen_level = static_cast<std::uint8_t>(level);
  advance(0, false);
  watch_clock();
  publish();
  return true;
}

bool TaximeterUnit::charge(unsigned kind) {
  const bool is_one =
      kind < tariff_.supplements.size() && kind < record_.trip.supplements_of_kind.size();
  if (!is_one || !has_trip_under_way()) return false;
  std::uint32_t& of_kind = record_.trip.supplements_of_kind[kind];
  of_kind = capped(std::uint64_t{of_kind} + tariff_.supplements[kind].price);
  return add_supplement(tariff_.supplements[kind].price);
}

bool TaximeterUnit::add_supplement(std::uint32_t amount) {
  if (!has_trip_under_way()) return false;
  record_.trip.supplements = capped(std::uint64_t{record_.trip.supplements} + amount);
  publish();
  return true;
}

bool TaximeterUnit::clear_supplements() {
  if (!has_trip_under_way()) return false;
  record_.trip.supplements = 0;
  record_.trip.supplements_of_kind = {};
  publish();
  return true;
}

bool TaximeterUnit::agree_price(std::uint32_t price) {
  if (price > amount_max) return false;
  if (record_.state == Taximeter::for_hire) {
    agreed_price_ = price;
    return true;
  }
  if (!is_hired()) return false;
  advance(0, false);
  fare_.agree(price);
  record_.trip.has_fare = true;
  publish();
  return true;
}

}  // namespace canvoy::cia447
