#include "canvoy/devices/cia447/taximeter/bus_clock.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/real_time_clock/civil_time.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr Duration one_day = 24h;
constexpr std::int32_t quarter_of_an_hour = 900;
constexpr std::int32_t offset_of_no_hours = 48;  ///< in quarters

}  // namespace

AbortCode check_date(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.index != rtc_date_object.index) return AbortCode::none;
  const std::uint64_t date = load_unsigned(value);
  const auto code = [date](const FieldPlace& place) {
    return static_cast<std::uint32_t>(date >> place.first_bit & ((1U << place.bits) - 1));
  };
  const std::uint32_t year = code(place_of(rtc_date_year));
  const std::uint32_t month = code(place_of(rtc_date_month));
  const std::uint32_t day = code(place_of(rtc_date_day));
  constexpr std::uint32_t year_max = 0xFFFD;
  constexpr std::uint32_t day_max = 31;
  const bool is_date = year >= 1 && year <= year_max && month >= 1 && month <= 12 && day <= day_max;
  return is_date && day > days_of_month(year, month) ? AbortCode::value_range : AbortCode::none;
}

constexpr AccessHandlers BusClock::hook_calls[] = {
    after_write<&BusClock::date_came, rtc_date_object>,
    after_write<&BusClock::time_came, rtc_time_object>,
    after_write<&BusClock::date_came, rtc_type_and_status_object>};
constexpr ServiceHandlers BusClock::service_calls = {.hooks = hook_calls};

BusClock::BusClock(Node& node) : node_(node) {
  node.attach(service_);
}

std::optional<std::int64_t> BusClock::reported_days() const {
  const Values values(node_.dictionary());
  const auto year = values[rtc_date_year];
  const auto month = values[rtc_date_month];
  const auto of_month = values[rtc_date_day];
  if (!year.is_valid() || !month.is_valid() || !of_month.is_valid()) return std::nullopt;
  if (of_month.raw() > days_of_month(year.raw(), month.raw())) return std::nullopt;
  return days_since_1970(year.raw(), month.raw(), of_month.raw());
}

std::optional<Duration> BusClock::reported_time() const {
  const Values values(node_.dictionary());
  const auto hour = values[rtc_time_hour];
  const auto minute = values[rtc_time_minute];
  const auto second = values[rtc_time_second];
  if (!hour.is_valid() || !minute.is_valid() || !second.is_valid()) return std::nullopt;
  return std::chrono::hours(hour.raw()) + std::chrono::minutes(minute.raw()) +
         10ms * std::int64_t{second.raw()};
}

void BusClock::told(std::uint16_t index) {
  take(index == rtc_time_hour.index());
}

void BusClock::take(bool has_new_time) {
  const auto days = reported_days();
  const auto time = reported_time();
  const bool is_new = has_new_time || days != days_before_ || time != time_before_;
  const bool is_date_only = !has_new_time && time == time_before_ && is_told_;
  if (!is_new) return;
  days_before_ = days;
  time_before_ = time;
  if (!days || !time) {
    is_told_ = false;
    return;
  }
  time_of_day_ = is_date_only ? (time_of_day_ + (node_.now() - told_at_)) % one_day : *time;
  told_at_ = node_.now();
  days_ = *days;
  is_told_ = true;
}

std::optional<LocalTime> BusClock::read() {
  take(false);
  const Values values(node_.dictionary());
  const auto status = values[rtc_type_and_status_valid];
  if (!is_told_ || status.is(Signal::no) || status.is(Signal::failure)) return std::nullopt;
  const auto offset = values[rtc_type_and_status_utc_offset];
  const Duration of_day = time_of_day_ + (node_.now() - told_at_);
  const std::int64_t of_days = std::chrono::floor<std::chrono::seconds>(of_day).count();
  const std::int32_t quarters = offset.is_valid() ? offset.raw() - offset_of_no_hours : 0;
  return LocalTime{.seconds = days_ * seconds_a_day + of_days,
                   .utc_offset = quarters * quarter_of_an_hour};
}

}  // namespace canvoy::cia447
