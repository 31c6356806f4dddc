#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr Duration tick_period = 1s;
/// A slice of a trip: the speed in it decides in mode S.
constexpr Duration shortest_slice = 1s;
/// Without a valid count for this time, there is no wheel signal: 4.2.4.6 requires one every 100
/// ms, and allows for some losses.
constexpr Duration wheel_signal_lasts = 2s;
/// The PDO with 6050h, 6053h and 6055h.
constexpr unsigned wheel_pdo = 17;
constexpr std::uint64_t seconds_per_hour = 3600;

constexpr TariffLevel no_level = {};

/// Parameters of SDO servers and clients, and of RPDOs, are behind the seal.
constexpr std::uint16_t first_sealed = 0x1200;
constexpr std::uint16_t last_sealed = 0x17FF;

constexpr std::uint16_t wheel_objects[] = {wheel_signal_source_object.index,
                                           wheel_pulse_counter_overrun_value_object.index};
constexpr const ObjectInfo* provided_wheels[] = {&actual_engine_revolutions_object,
                                                 &wheel_rpm_object,
                                                 &wheel_signal_source_object,
                                                 &wheel_pulse_counter_object,
                                                 &wheel_pulse_counter_overrun_value_object,
                                                 &pulses_per_wheel_rotation_object};

}  // namespace

constexpr AccessHandlers TaximeterUnit::hook_calls[] = {
    after_write<&TaximeterUnit::source_came, wheel_signal_source_object>,
    after_write<&TaximeterUnit::count_came, wheel_pulse_counter_object>,
    after_write<&TaximeterUnit::source_came, wheel_pulse_counter_overrun_value_object>,
    before_read<&TaximeterUnit::report_audit, audit_object>,
    before_read<&TaximeterUnit::report_audit_line, audit_log_object>};
constexpr ServiceHandlers TaximeterUnit::service_calls = {.reset = method<&TaximeterUnit::reset>,
                                                          .hooks = hook_calls};

TaximeterUnit::TaximeterUnit(CarNetwork& network, const TaximeterHardware& hardware,
                             const TaximeterSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      bus_clock_(network.node()),
      memory_(network.node(), hardware.flash, settings.memory),
      audit_memory_(network.node(), hardware.flash, settings.audit_memory),
      objects_(network.node()),
      wheels_(network, {.provider = settings.wheel_node,
                        .objects = provided_wheels,
                        .refused = callback<&TaximeterUnit::write_refused>(*this)}),
      clock_objects_(network, {.provider = settings.clock_node,
                               .objects = bus_clock_objects,
                               .refused = callback<&TaximeterUnit::write_refused>(*this),
                               .check = check_of_date}),
      wheel_reader_(network, {.server = settings.wheel_node,
                              .indices = wheel_objects,
                              .period = settings.asking_period,
                              .came = callback<&TaximeterUnit::source_was_read>(*this)}),
      clock_reader_(network, {.server = settings.clock_node,
                              .indices = clock_objects,
                              .period = settings.asking_period,
                              .came = callback<&TaximeterUnit::clock_was_read>(*this)}),
      tariff_(settings.tariff),
      tick_(callback<&TaximeterUnit::tick>(*this)),
      off_(callback<&TaximeterUnit::off>(*this)) {
  network.node().attach(service_);
  sealed_parameters_.first = first_sealed;
  sealed_parameters_.last = last_sealed;
  sealed_parameters_.before_write = callback<&TaximeterUnit::check_settings>(*this);
  network.node().dictionary().attach(sealed_parameters_);
}

// Power, and resets of the bus, which change neither a trip nor a total.

void TaximeterUnit::reset(ResetScope /*scope*/) {
  if (!has_started_) power_on();
  has_started_ = true;
  for (unsigned error = 1; error <= static_cast<unsigned>(TaximeterError::seal); ++error) {
    if ((errors_ >> error & 1) != 0) report(static_cast<TaximeterError>(error), true);
  }
  publish(true);
  object_to_sleep();
  network_.node().timers().arm(tick_, network_.node().now() + tick_period);
}

void TaximeterUnit::power_on() {
  const TaximeterMemory::Found found = memory_.load();
  audit_ = audit_memory_.load().value_or(AuditLog());
  if (found.record) {
    record_ = *found.record;
  } else {
    record_.totals_are_known = !found.is_damaged;
    record_.k = std::max<std::uint32_t>(settings_.k, 1);
    record_.tariff = settings_.tariff.id;
  }
  if (record_.mode == TaximeterMode::not_available) record_.mode = settings_.mode;
  advanced_to_ = counted_at_ = kept_at_ = network_.node().now();
  kept_distance_ = record_.total.distance;
  fare_.restore(record_.trip.fare);
  const bool is_future =
      settings_.future_tariff.id != 0 && record_.tariff == settings_.future_tariff.id;
  tariff_ = is_future ? settings_.future_tariff : settings_.tariff;
  record_.tariff = tariff_.id;
  set_fastest();
  if (!record_.totals_are_known) set_error(TaximeterError::memory, true);
  if (is_tampered(tampering::source)) errors_ |= bit_of(TaximeterError::wheel_source);
  if (is_tampered(tampering::seal)) errors_ |= bit_of(TaximeterError::seal);
  // From here on, an older record always exists.
  if (!found.record && !found.is_damaged) keep();
  resume();
}

/// A trip continues after a short loss of power, which is not charged; a longer one has ended it,
/// with the kept values.
void TaximeterUnit::resume() {
  if (!has_trip_under_way()) return;
  const std::int64_t now = utc_now();
  const bool is_known = now != no_time && record_.saved_at != no_time;
  const auto away = std::chrono::seconds(is_known ? now - record_.saved_at : 0);
  const bool goes_on = is_known && away >= 0s && away <= settings_.longest_power_cut;
  if (goes_on) return;
  if (is_hired()) record_.trip.finish = record_.saved_at;
  end_trip();
  note(AuditEvent::trip_cut, 0, trip_data(record_.trip, fare_).total);
  record_.state = Taximeter::for_hire;
  keep();
}

void TaximeterUnit::power_fails() {
  advance(0, false);
  record_.saved_at = utc_now();
  memory_.save_now(kept());
  keep_audit(true);
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

/// At a reset of the bus, writes all, otherwise the changes.
void TaximeterUnit::publish(bool is_all) {
  const TripData data = trip_data(record_.trip, fare_);
  objects_.report_trip(data, is_all);
  objects_.report_state(record_.state, is_turning_off_);
  objects_.report_totals(record_);
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

/// The clock on the bus has priority; the meter's own one continues from it, also over a loss of
/// power. In a trip, neither changes the time.
std::optional<LocalTime> TaximeterUnit::clock() {
  const std::optional<LocalTime> told = reported_time();
  if (!told) return std::nullopt;
  return clock_bounds_.take(*told, network_.node().now(), has_trip_under_way());
}

std::optional<LocalTime> TaximeterUnit::reported_time() {
  const std::optional<LocalTime> told = bus_clock_.read();
  std::optional<LocalTime> own = hardware_.clock();
  const bool is_refused =
      told && has_trip_under_way() && clock_bounds_.is_beyond(*told, network_.node().now());
  if (told && own && !is_refused) {
    record_.own_clock_ahead = own->seconds - told->seconds;
    record_.own_offset_ahead = own->utc_offset - told->utc_offset;
  }
  if (told || !own) return told;
  own->seconds -= record_.own_clock_ahead;
  own->utc_offset -= record_.own_offset_ahead;
  return own;
}

/// Each step has an entry; a refused one only once in a trip.
void TaximeterUnit::watch_clock_step() {
  const Time now = network_.node().now();
  const std::optional<LocalTime> told = reported_time();
  if (!told) return;
  const bool has_trip = has_trip_under_way();
  if (!has_trip) is_clock_refused_ = false;
  if (!clock_bounds_.is_beyond(*told, now)) return;
  const auto step = static_cast<std::uint32_t>(clock_bounds_.step(*told, now));
  const NodeId who = bus_clock_.read() ? settings_.clock_node : NodeId{by_meter};
  if (has_trip) {
    if (!is_clock_refused_) note(AuditEvent::clock_refused, 0, step, who);
    is_clock_refused_ = true;
  } else {
    note(AuditEvent::clock_step, 0, step, who);
    clock_bounds_.settle(*told, now);
  }
}

std::int64_t TaximeterUnit::utc_now() {
  const std::optional<LocalTime> now = clock();
  return now ? now->utc() : no_time;
}

void TaximeterUnit::tick(Time now) {
  network_.node().timers().arm(tick_, now + tick_period);
  advance(0, false);
  watch_clock_step();
  watch_clock();
  watch_seal();
  if (!memory_.is_busy()) {
    set_error(TaximeterError::memory, memory_.has_failed() || !record_.totals_are_known);
  }
  const bool is_changing = has_trip_under_way() || record_.total.distance != kept_distance_;
  if (is_changing && now - kept_at_ >= settings_.keeping_period) keep();
  keep_audit(false);
  publish();
}

/// The level may change during a trip, the tariff only between two trips.
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
  note(AuditEvent::tariff_changed, record_.tariff, settings_.future_tariff.id);
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
  if (is_tampered(tampering::source)) return;
  const Time now = network_.node().now();
  const auto valid = value(wheel_pulse_counter_valid).value().value_or(Signal::not_available);
  const auto count = value(wheel_pulse_counter).raw();
  const std::uint32_t turned = wheel_.count(count, valid, now);
  const bool counts = check_wheels(turned, now - counted_at_);
  advance(counts ? turned : 0, valid == Signal::yes);
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

/// In service mode, the present source is accepted.
void TaximeterUnit::adopt_source() {
  const auto source = value(wheel_signal_source).value();
  if (source && *source <= WheelSource::average_all) record_.wheel_source = *source;
  const NodeId sender = network_.source_of(wheel_pdo);
  if (sender != 0) record_.wheel_node = sender;
}

bool TaximeterUnit::has_wheel_signal() const {
  return network_.node().now() - counted_at_ <= wheel_signal_lasts;
}

/// Removed pulses do not stop the wheels, and added ones do not turn them. False: the pulses are
/// not from the wheels.
bool TaximeterUnit::check_wheels(std::uint32_t turned, Duration since) {
  const auto rpm = value(wheel_rpm);
  const auto engine = value(actual_engine_revolutions);
  WheelSeen seen{.turned = turned, .since = since, .half_rpm = {}, .engine = {}, .k = record_.k};
  if (rpm.is_valid()) seen.half_rpm = rpm.raw();
  if (engine.is_valid()) seen.engine = engine.raw();
  const bool counts = wheel_check_.take(seen);
  set_error(TaximeterError::wheel_stands, wheel_check_.lacks_pulses());
  set_error(TaximeterError::extra_pulses, wheel_check_.has_extra_pulses());
  const bool stood = std::exchange(stands_engine_, wheel_check_.has_standing_engine());
  if (stands_engine_ && !stood) note(AuditEvent::engine_stands);
  if (counts && calibration_) *calibration_ += turned;
  return counts;
}

void TaximeterUnit::set_fastest() {
  wheel_.set_fastest(
      capped(settings_.fastest_speed * std::uint64_t{record_.k} / seconds_per_hour + 1));
}

/// Up to the present. Distance after a time without wheel signal, which mode S has already charged
/// as time, costs nothing.
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

}  // namespace canvoy::cia447
