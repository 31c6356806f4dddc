#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* set_commands[] = {&set_rtc_date_object, &set_rtc_time_object};
constexpr Duration day = 24h;
constexpr Duration hundredth = 10ms;
constexpr std::int64_t year_max = 0xFFFD;
constexpr std::int32_t quarter_minutes = 15;
constexpr std::int32_t quarters_of_no_offset = 48;
constexpr std::size_t zone_characters = 6;

std::int64_t whole_seconds(Duration time) {
  return std::chrono::floor<std::chrono::seconds>(time).count();
}

/// The number in a field of a command; nothing: "don't care".
template <class Handle>
std::optional<std::uint32_t> wanted_in(const Handle& /*handle*/, std::uint32_t raw) {
  using Place = typename Handle::Place;
  const auto number = static_cast<std::uint32_t>(extract(raw, Place::bits));
  const auto not_care = static_cast<std::uint32_t>((std::uint64_t{1} << Place::bits.bits) - 1);
  if (number == not_care) return std::nullopt;
  return number;
}

/// Number of bytes of the first characters of a UTF-8 text.
std::size_t bytes_of_characters(std::string_view text, std::size_t characters) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_character = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
    if (begins_character && count++ == characters) return i;
  }
  return text.size();
}
std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

constexpr AccessHandlers RealTimeClockUnit::hook_calls[] = {
    before_read<&RealTimeClockUnit::refresh, rtc_date_object, rtc_type_and_status_object>,
    before_write<&RealTimeClockUnit::check_date, set_rtc_date_object>,
    before_write<&RealTimeClockUnit::check_time, set_rtc_time_object>,
    after_write<&RealTimeClockUnit::date_written, set_rtc_date_object>,
    after_write<&RealTimeClockUnit::time_written, set_rtc_time_object>};
constexpr ServiceHandlers RealTimeClockUnit::service_calls = {
    .reset = method<&RealTimeClockUnit::reset>, .hooks = hook_calls};

RealTimeClockUnit::RealTimeClockUnit(CarNetwork& network, const RealTimeClockHardware& hardware,
                                     const RealTimeClockSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      commands_(network, set_commands, {}),
      tick_(callback<&RealTimeClockUnit::tick>(*this)) {
  network.node().attach(service_);
}

/// An NMT reset does not change the clock.
void RealTimeClockUnit::reset(ResetScope /*scope*/) {
  if (!has_started_) {
    has_started_ = true;
    base_at_ = network_.node().now();
    base_ = -std::chrono::minutes(settings_.zone.offset_minutes);
    look();
  }
  report_zone();
  tick(network_.node().now());
}

/// At each full second, so that values that are read without a request on the bus are right.
void RealTimeClockUnit::tick(Time now) {
  if (now - looked_at_ >= settings_.comparison_period) look();
  tell();
  const Duration of_second = local() - std::chrono::floor<std::chrono::seconds>(local());
  network_.node().timers().arm(tick_, now + 1s - of_second);
}

void RealTimeClockUnit::look() {
  looked_at_ = network_.node().now();
  const std::optional<ChipTime> found = hardware_.read();
  if (!found) return;
  base_ = found->since_1970;
  base_at_ = network_.node().now();
  has_date_ = found->has_date;
  has_time_ = true;
}

Duration RealTimeClockUnit::utc() const {
  return base_ + (network_.node().now() - base_at_);
}

bool RealTimeClockUnit::is_in_summer() const {
  return has_date_ && is_summer(settings_.zone, whole_seconds(utc()));
}

Duration RealTimeClockUnit::offset() const {
  const auto& summer = settings_.zone.summer;
  const auto minutes = summer && is_in_summer() ? summer->minutes : 0;
  return std::chrono::minutes(settings_.zone.offset_minutes + minutes);
}

Duration RealTimeClockUnit::local() const {
  const Duration shown = utc() + offset();
  return has_date_ ? shown : ((shown % day) + day) % day;
}

void RealTimeClockUnit::refresh() {
  tell();
}

void RealTimeClockUnit::tell() {
  const Duration shown = local();
  const CivilTime time = civil_time(whole_seconds(shown));
  if (has_date_ && (time.year < 1 || time.year > year_max)) forget_date();
  value(rtc_date_year).set_raw(has_date_ ? static_cast<std::uint16_t>(time.year) : 0);
  value(rtc_date_month).set_raw(has_date_ ? static_cast<std::uint8_t>(time.month) : 0);
  value(rtc_date_day).set_raw(has_date_ ? static_cast<std::uint8_t>(time.day) : 0);
  const Duration of_minute = ((shown % 1min) + 1min) % 1min;
  value(rtc_time_hour).set_raw(static_cast<std::uint8_t>(time.hour));
  value(rtc_time_minute).set_raw(static_cast<std::uint8_t>(time.minute));
  value(rtc_time_second).set_raw(static_cast<std::uint16_t>(of_minute / hundredth));
  value(rtc_type_and_status_valid) = is_valid() ? Signal::yes : Signal::no;
  value(rtc_type_and_status_dst_active) = is_in_summer() ? Signal::yes : Signal::no;
  const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(offset()).count();
  value(rtc_type_and_status_utc_offset)
      .set_raw(static_cast<std::uint8_t>(minutes / quarter_minutes + quarters_of_no_offset));
}

void RealTimeClockUnit::report_zone() {
  value(rtc_type_and_status_source) = settings_.source;
  value(rtc_type_and_status_trustability) = settings_.trustability;
  const bool has_summer = settings_.zone.summer.has_value();
  value(rtc_type_and_status_dst_supported) = has_summer ? Signal::yes : Signal::no;
  char name[time_zone_capacity];
  const std::string_view given = settings_.zone.name.substr(
      0, std::min<std::size_t>(bytes_of_characters(settings_.zone.name, zone_characters),
                               time_zone_capacity));
  std::size_t length = given.copy(name, sizeof name);
  for (std::size_t i = characters_in(given); i < zone_characters && length < sizeof name; ++i) {
    name[length++] = ' ';
  }
  value(rtc_time_zone) = std::string_view(name, length);
}

// Setting it.

RealTimeClockUnit::Wanted RealTimeClockUnit::wanted_date(std::uint32_t raw) const {
  return {{wanted_in(set_rtc_date_year, raw), wanted_in(set_rtc_date_month, raw),
           wanted_in(set_rtc_date_day, raw)}};
}
RealTimeClockUnit::Wanted RealTimeClockUnit::wanted_time(std::uint32_t raw) const {
  return {{wanted_in(set_rtc_time_hour, raw), wanted_in(set_rtc_time_minute, raw),
           wanted_in(set_rtc_time_second, raw)}};
}

/// Checks that a single field cannot make: the 30th of February. Commands checks the codes.
AbortCode RealTimeClockUnit::check_date(Raw<std::uint32_t> raw) const {
  const Wanted wanted = wanted_date(raw.bits);
  const AbortCode answer = check_may_set(wanted);
  if (answer != AbortCode::none || wanted.is_nothing()) return answer;
  const bool is_reset =
      std::ranges::any_of(wanted.parts, [](const auto& part) { return part == 0; });
  if (is_reset) return AbortCode::none;
  const bool is_whole = wanted.parts[0] && wanted.parts[1] && wanted.parts[2];
  if (!is_whole && !has_date_) return AbortCode::device_state;
  const CivilTime now = civil_time(whole_seconds(local()));
  const std::int64_t year = wanted.parts[0].value_or(static_cast<std::uint32_t>(now.year));
  const unsigned month = wanted.parts[1].value_or(now.month);
  const unsigned of_month = wanted.parts[2].value_or(now.day);
  return of_month <= days_of_month(year, month) ? AbortCode::none : AbortCode::value_range;
}

AbortCode RealTimeClockUnit::check_time(Raw<std::uint32_t> wanted) const {
  return check_may_set(wanted_time(wanted.bits));
}

AbortCode RealTimeClockUnit::check_may_set(const Wanted& wanted) const {
  const bool is_sealed = settings_.trustability == RtcTrustability::accepted_by_authority;
  return is_sealed && !wanted.is_nothing() ? AbortCode::device_state : AbortCode::none;
}

void RealTimeClockUnit::date_written(const Entry& entry) {
  set_date(wanted_date(entry.word()));
  tick(network_.node().now());
}

void RealTimeClockUnit::time_written(const Entry& entry) {
  set_time(wanted_time(entry.word()));
  tick(network_.node().now());
}

void RealTimeClockUnit::set_date(const Wanted& wanted) {
  if (wanted.is_nothing()) return;
  if (std::ranges::any_of(wanted.parts, [](const auto& part) { return part == 0; })) {
    forget_date();
    return;
  }
  const Duration shown = local();
  const CivilTime now = civil_time(whole_seconds(shown));
  const std::int64_t days =
      days_since_1970(wanted.parts[0].value_or(static_cast<std::uint32_t>(now.year)),
                      wanted.parts[1].value_or(now.month), wanted.parts[2].value_or(now.day));
  const Duration of_day = ((shown % day) + day) % day;
  has_date_ = true;
  set_local(days * day + of_day);
}

void RealTimeClockUnit::set_time(const Wanted& wanted) {
  if (wanted.is_nothing()) return;
  const Duration shown = local();
  const CivilTime now = civil_time(whole_seconds(shown));
  const Duration midnight = shown - ((shown % day) + day) % day;
  const Duration of_minute = ((shown % 1min) + 1min) % 1min;
  const std::optional<std::uint32_t>& hundredths_of_minute = wanted.parts[2];
  const Duration second =
      hundredths_of_minute ? hundredth * std::int64_t{*hundredths_of_minute} : of_minute;
  has_time_ = true;
  set_local(midnight + std::chrono::hours(wanted.parts[0].value_or(now.hour)) +
            std::chrono::minutes(wanted.parts[1].value_or(now.minute)) + second);
}

/// In the hour that occurs twice, the time stays with or without summer time, as before.
void RealTimeClockUnit::set_local(Duration shown) {
  const std::int64_t whole = whole_seconds(shown);
  const Duration fraction = shown - std::chrono::seconds(whole);
  const bool was_summer = is_in_summer();
  const std::int64_t standard = whole - settings_.zone.offset_minutes * seconds_a_minute;
  const std::int64_t as_utc = has_date_ ? utc_of(settings_.zone, whole, was_summer) : standard;
  base_ = std::chrono::seconds(as_utc) + fraction;
  base_at_ = network_.node().now();
  hardware_.write({.since_1970 = base_, .has_date = has_date_});
}

void RealTimeClockUnit::forget_date() {
  const Duration shown = ((local() % day) + day) % day;
  has_date_ = false;
  set_local(shown);
}

void RealTimeClockUnit::set(Duration since_1970_utc) {
  base_ = since_1970_utc;
  base_at_ = network_.node().now();
  has_date_ = true;
  has_time_ = true;
  hardware_.write({.since_1970 = base_, .has_date = true});
  tick(network_.node().now());
}

}  // namespace canvoy::cia447
