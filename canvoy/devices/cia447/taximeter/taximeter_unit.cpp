#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

#include <algorithm>

#include "canvoy/profiles/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr Duration tick_period = 1s;
/// A slice of a trip: the speed in it decides in mode S.
constexpr Duration shortest_slice = 1s;
/// Without a valid count for so long there is no wheel signal: 4.2.4.6 wants one each 100 ms, and
/// lets some be lost.
constexpr Duration wheel_signal_lasts = 2s;
/// The PDO with 6050h, 6053h and 6055h.
constexpr unsigned wheel_pdo = 17;
/// In 0,5/min: some 3 km/h, from where on 6053h is true to 1 % (4.2.4.4).
constexpr std::uint16_t turning_rpm = 60;
constexpr Duration standing_max = 5s;
constexpr std::uint64_t seconds_per_hour = 3600;
constexpr Duration save_again = 100ms;

constexpr TariffLevel no_level = {};

constexpr std::uint16_t wheel_objects[] = {wheel_signal_source_object.index,
                                           wheel_pulse_counter_overrun_value_object.index};

}  // namespace

constexpr HookCalls TaximeterUnit::hook_calls[] = {
    after_write<&TaximeterUnit::source_came, wheel_signal_source_object>,
    after_write<&TaximeterUnit::count_came, wheel_pulse_counter_object>,
    after_write<&TaximeterUnit::source_came, wheel_pulse_counter_overrun_value_object>};
constexpr ServiceCalls TaximeterUnit::service_calls = {.reset = method<&TaximeterUnit::reset>,
                                                       .hooks = hook_calls};

TaximeterUnit::TaximeterUnit(CarNetwork& network, const TaximeterHardware& hardware,
                             const TaximeterSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      bus_clock_(network.node()),
      memory_(network.node(), hardware.flash, settings.memory),
      objects_(network.node()),
      wheel_reader_(
          network,
          {.server = settings.wheel_node,
           .indices = wheel_objects,
           .period = settings.asking_period,
           .came = Callback<void(std::uint16_t)>::to<&TaximeterUnit::source_was_read>(*this)}),
      clock_reader_(
          network,
          {.server = settings.clock_node,
           .indices = clock_objects,
           .period = settings.asking_period,
           .came = Callback<void(std::uint16_t)>::to<&TaximeterUnit::clock_was_read>(*this)}),
      tariff_(settings.tariff),
      tick_(Callback<void(Time)>::to<&TaximeterUnit::tick>(*this)),
      off_(Callback<void(Time)>::to<&TaximeterUnit::off>(*this)) {
  network.node().attach(service_);
}

// Power, and resets of the bus: those touch neither a trip nor a total.

void TaximeterUnit::reset(ResetScope /*scope*/) {
  if (!has_started_) power_on();
  has_started_ = true;
  for (unsigned error = 1; error <= static_cast<unsigned>(TaximeterError::memory); ++error) {
    const bool is_present = (errors_ >> error & 1) != 0;
    errors_ = static_cast<std::uint8_t>(errors_ & ~(1U << error));
    set_error(static_cast<TaximeterError>(error), is_present);
  }
  publish(true);
  object_to_sleep();
  network_.node().timers().arm(tick_, network_.node().now() + tick_period);
}

void TaximeterUnit::power_on() {
  const TaximeterMemory::Found found = memory_.load();
  if (found.record) {
    record_ = *found.record;
  } else {
    record_.totals_are_known = !found.is_damaged;
    record_.k = std::max<std::uint32_t>(settings_.k, 1);
    record_.tariff = settings_.tariff.id;
  }
  advanced_to_ = counted_at_ = kept_at_ = network_.node().now();
  kept_distance_ = record_.total.distance;
  fare_.restore(record_.trip.fare);
  const bool is_future =
      settings_.future_tariff.id != 0 && record_.tariff == settings_.future_tariff.id;
  tariff_ = is_future ? settings_.future_tariff : settings_.tariff;
  record_.tariff = tariff_.id;
  wheel_.set_fastest(
      capped(settings_.fastest_speed * std::uint64_t{record_.k} / seconds_per_hour + 1));
  if (!record_.totals_are_known) set_error(TaximeterError::memory, true);
  if (record_.source_has_changed) set_error(TaximeterError::wheel_source, true);
  // From here on there is always an older record to fall back on.
  if (!found.record && !found.is_damaged) keep();
  resume();
}

/// A trip goes on after a short loss of power, of which nothing is charged; a longer one has ended
/// it, with what was kept.
void TaximeterUnit::resume() {
  if (!has_trip_under_way()) return;
  const std::int64_t now = utc_now();
  const bool is_known = now != no_time && record_.saved_at != no_time;
  const auto away = std::chrono::seconds(is_known ? now - record_.saved_at : 0);
  const bool goes_on = is_known && away >= 0s && away <= settings_.longest_power_cut;
  if (goes_on) return;
  if (is_hired()) record_.trip.finish = record_.saved_at;
  end_trip();
  record_.state = Taximeter::for_hire;
  keep();
}

void TaximeterUnit::power_fails() {
  advance(0, false);
  record_.saved_at = utc_now();
  memory_.save_now(kept());
}

TaximeterRecord TaximeterUnit::kept() const {
  TaximeterRecord record = record_;
  record.trip.fare = fare_.state();
  return record;
}

void TaximeterUnit::keep() {
  record_.saved_at = utc_now();
  memory_.save(kept());
  kept_at_ = network_.node().now();
  kept_distance_ = record_.total.distance;
}

/// At a reset of the bus all is told, else what has changed.
void TaximeterUnit::publish(bool is_all) {
  const TripData data = trip_data(record_.trip, fare_);
  objects_.tell_trip(data, is_all);
  objects_.tell_state(record_.state, is_turning_off_);
  objects_.tell_totals(record_);
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

// Time.

/// The clock on the bus leads; the meter's own one goes on from it, over loss of power too.
std::optional<LocalTime> TaximeterUnit::clock() {
  const std::optional<LocalTime> told = bus_clock_.read();
  std::optional<LocalTime> own = hardware_.clock();
  if (told && own) {
    record_.own_clock_ahead = own->seconds - told->seconds;
    record_.own_offset_ahead = own->utc_offset - told->utc_offset;
  }
  if (told || !own) return told;
  own->seconds -= record_.own_clock_ahead;
  own->utc_offset -= record_.own_offset_ahead;
  return own;
}

std::int64_t TaximeterUnit::utc_now() {
  const std::optional<LocalTime> now = clock();
  return now ? now->utc() : no_time;
}

void TaximeterUnit::tick(Time now) {
  network_.node().timers().arm(tick_, now + tick_period);
  advance(0, false);
  watch_clock();
  if (!memory_.is_busy()) {
    set_error(TaximeterError::memory, memory_.has_failed() || !record_.totals_are_known);
  }
  const bool is_changing = has_trip_under_way() || record_.total.distance != kept_distance_;
  if (is_changing && now - kept_at_ >= settings_.keeping_period) keep();
  publish();
}

/// The level may change in the middle of a trip, the tariff only between two.
void TaximeterUnit::watch_clock() {
  if (!has_trip_under_way()) change_tariff();
  if (!is_hired()) return;
  const TariffLevel& level = present_level();
  const TariffLevel& before = fare_.level();
  const bool is_other = level.name != before.name || level.distance_rate != before.distance_rate ||
                        level.time_rate != before.time_rate ||
                        level.crossover_speed != before.crossover_speed ||
                        level.increment != before.increment;
  if (is_other) fare_.change_level(level);
}

void TaximeterUnit::change_tariff() {
  const std::optional<LocalTime> now = clock();
  const bool is_due = now.has_value() && now->seconds >= settings_.future_from &&
                      settings_.future_tariff.id != 0 &&
                      record_.tariff != settings_.future_tariff.id;
  if (!is_due) return;
  tariff_ = settings_.future_tariff;
  record_.tariff = tariff_.id;
  record_.chosen_level = TaximeterRecord::no_level;
  keep();
  publish_configuration();
}

const TariffLevel& TaximeterUnit::present_level() {
  unsigned level = record_.chosen_level;
  if (level == TaximeterRecord::no_level) {
    const std::optional<LocalTime> now = clock();
    level = now ? level_at(tariff_, now->seconds) : 0;
  }
  return level < tariff_.levels.size() ? tariff_.levels[level] : no_level;
}

// Distance.

void TaximeterUnit::count_came() {
  const NodeId sender = network_.source_of(wheel_pdo);
  if (record_.wheel_node == 0) record_.wheel_node = sender;
  if (sender != 0 && sender != record_.wheel_node) {
    if (record_.state == Taximeter::service_mode) {
      adopt_source();
      wheel_.forget();
    } else {
      set_error(TaximeterError::wheel_node, true, record_.wheel_node, sender);
    }
  }
  if (record_.source_has_changed) return;
  const Time now = network_.node().now();
  const auto valid = value(wheel_pulse_counter_valid).value().value_or(Signal::not_available);
  const auto count = value(wheel_pulse_counter).raw();
  const std::uint32_t turned = wheel_.count(count, valid, now);
  check_wheels(turned, now - counted_at_);
  advance(turned, valid == Signal::yes);
}

/// 6054h or 6056h. A source that fails for a while is none that has changed.
void TaximeterUnit::source_came() {
  if (value(wheel_pulse_counter_overrun_value_valid).is(Signal::yes)) {
    wheel_.set_overrun_value(value(wheel_pulse_counter_overrun_value).raw());
  }
  const auto source = value(wheel_signal_source).value();
  const bool is_source = source.has_value() && *source <= WheelSource::average_all;
  if (!is_source || *source == record_.wheel_source) return;
  const bool is_sealed = record_.wheel_source != WheelSource::not_available;
  if (is_sealed && record_.state != Taximeter::service_mode) {
    set_error(TaximeterError::wheel_source, true, static_cast<std::uint8_t>(record_.wheel_source),
              static_cast<std::uint8_t>(*source));
  } else {
    record_.wheel_source = *source;
    keep();
  }
}

void TaximeterUnit::source_was_read(std::uint16_t /*index*/) {
  source_came();
}

/// In service mode what is there is right.
void TaximeterUnit::adopt_source() {
  const auto source = value(wheel_signal_source).value();
  if (source && *source <= WheelSource::average_all) record_.wheel_source = *source;
  const NodeId sender = network_.source_of(wheel_pdo);
  if (sender != 0) record_.wheel_node = sender;
}

bool TaximeterUnit::has_wheel_signal() const {
  return network_.node().now() - counted_at_ <= wheel_signal_lasts;
}

/// Whoever takes the pulses away does not stop the wheels.
void TaximeterUnit::check_wheels(std::uint32_t turned, Duration since) {
  const auto rpm = value(wheel_rpm);
  const bool turns = rpm.is_valid() && rpm.raw() >= turning_rpm;
  standing_ = turns && turned == 0 ? standing_ + since : Duration{};
  set_error(TaximeterError::wheel_stands, standing_ >= standing_max);
}

/// Up to now. What comes after a time without wheel signal, of which mode S has charged the time
/// already, is distance that costs nothing.
void TaximeterUnit::advance(std::uint32_t turned, bool is_count) {
  const Time now = network_.node().now();
  const Duration time = now - advanced_to_;
  const bool is_late = !has_wheel_signal();
  advanced_to_ = now;
  if (is_count) counted_at_ = now;
  add_distance(turned);
  if (!is_hired()) return;
  const bool is_charged = is_late && fare_.mode() == FareMode::single_calculation;
  fare_.advance(is_charged ? 0 : turned, time);
  record_.trip.pulses += turned;
  record_.trip.duration += time.count();
  slice_ += time;
  if (slice_ < shortest_slice || !(is_count || is_late)) return;
  fare_.close_slice();
  slice_ = {};
}

void TaximeterUnit::add_distance(std::uint32_t turned) {
  if (record_.state == Taximeter::service_mode) return;
  const std::uint64_t parts = turned * thousandths + record_.distance_rest;
  const std::uint64_t whole = parts / record_.k;
  record_.distance_rest = static_cast<std::uint32_t>(parts % record_.k);
  TaxiTotals::add(record_.total.distance, whole);
  if (is_signed_on()) TaxiTotals::add(record_.shift.distance, whole);
  if (!is_hired()) return;
  TaxiTotals::add(record_.total.distance_hired, whole);
  TaxiTotals::add(record_.shift.distance_hired, whole);
}

bool TaximeterUnit::is_signed_on() const {
  const bool is_asleep = record_.state == Taximeter::standby_mode;
  const Taximeter state = is_asleep ? record_.before_standby : record_.state;
  return state == Taximeter::for_hire || has_trip_under_way();
}

// Keys.

bool TaximeterUnit::enter(Taximeter state) {
  record_.state = state;
  is_turning_off_ = false;
  network_.node().timers().disarm(off_);
  keep();
  publish();
  object_to_sleep();
  return true;
}

/// The network stays awake while people are in the car.
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
  return enter(Taximeter::for_hire);
}

bool TaximeterUnit::sign_off() {
  return record_.state == Taximeter::for_hire && enter(Taximeter::signed_off);
}

bool TaximeterUnit::hire() {
  const bool is_paused = record_.state == Taximeter::stopped;
  const bool is_free = record_.state == Taximeter::for_hire && !record_.source_has_changed;
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
  change_tariff();
  const bool is_odometer = settings_.mode == TaximeterMode::odometer_operation;
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

/// In one record with the state "for hire": so it is added once.
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

bool TaximeterUnit::add_supplement(std::uint32_t amount) {
  if (!has_trip_under_way()) return false;
  record_.trip.supplements = capped(std::uint64_t{record_.trip.supplements} + amount);
  publish();
  return true;
}

bool TaximeterUnit::clear_supplements() {
  if (!has_trip_under_way()) return false;
  record_.trip.supplements = 0;
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

// Behind the seal.

bool TaximeterUnit::enter_service() {
  const bool is_idle = record_.state == Taximeter::for_hire ||
                       record_.state == Taximeter::signed_off ||
                       record_.state == Taximeter::standby_mode;
  if (!is_idle || !hardware_.seal_is_open()) return false;
  advance(0, false);
  return enter(Taximeter::service_mode);
}

bool TaximeterUnit::leave_service() {
  if (record_.state != Taximeter::service_mode || hardware_.seal_is_open()) return false;
  adopt_source();
  record_.source_has_changed = false;
  record_.totals_are_known = true;
  record_.date_of_securing = utc_now();
  wheel_.forget();
  set_error(TaximeterError::wheel_source, false);
  set_error(TaximeterError::wheel_node, false);
  const bool is_done = enter(Taximeter::signed_off);
  publish_configuration();
  return is_done;
}

bool TaximeterUnit::set_k(std::uint32_t k) {
  if (record_.state != Taximeter::service_mode || k == 0 || k > amount_max) return false;
  record_.k = k;
  record_.distance_rest = 0;
  wheel_.set_fastest(capped(settings_.fastest_speed * std::uint64_t{k} / seconds_per_hour + 1));
  keep();
  publish_configuration();
  return true;
}

void TaximeterUnit::set_error(TaximeterError error, bool is_present, std::uint8_t sealed,
                              std::uint8_t found) {
  const auto number = static_cast<std::uint8_t>(error);
  const bool was_present = (errors_ >> number & 1) != 0;
  if (is_present == was_present) return;
  errors_ = static_cast<std::uint8_t>(errors_ ^ 1U << number);
  const Error told = {.code = emergency_code::taximeter,
                      .instance = number,
                      .register_bits = error_register::profile,
                      .info = {number, sealed, found, 0, 0}};
  network_.node().report(told, is_present);
  const bool is_source =
      error == TaximeterError::wheel_source || error == TaximeterError::wheel_node;
  if (is_source && is_present && !record_.source_has_changed) {
    record_.source_has_changed = true;
    keep();
  }
}

}  // namespace canvoy::cia447
