#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace canvoy::cia407 {

namespace {

using Card = TachographReading::Card;

constexpr std::uint8_t flag_reset_trip = 1;
constexpr std::uint8_t flag_adjust_hour = 2;
constexpr std::uint8_t flag_adjust_minute = 4;

constexpr std::int8_t hours_of(std::uint16_t information) {
  return static_cast<std::int8_t>(information & 0xFF);
}
constexpr std::int8_t minutes_of(std::uint16_t information) {
  return static_cast<std::int8_t>(information >> 8);
}

/// All zeros: no card.
Card card_of(std::string_view text) {
  Card card{};
  std::ranges::copy(text.substr(0, card.size()), card.begin());
  return card;
}

}  // namespace

constexpr AccessHandlers TachographUnit::hook_calls[] = {
    before_write<&TachographUnit::check_event, events_for_virtual_devices_object>};

TachographUnit::TachographUnit(VirtualDevice& device, const TachographHardware& hardware,
                               const TachographSettings& settings)
    : device_(device),
      hardware_(hardware),
      settings_(settings),
      trip_begin_(settings.trip_begin_metres),
      timer_(callback<&TachographUnit::look>(*this)) {
  device.on_reset = callback<&TachographUnit::reset>(*this);
  device.react(*this, hook_calls);
  device.on_event = callback<&TachographUnit::take_event>(*this);
}

/// Data that a tachograph has recorded outlive an NMT reset.
void TachographUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) flags_ = 0;
  look(device_.node().now());
}

/// An offset that the clock cannot have is refused.
AbortCode TachographUnit::check_event(const Entry& entry, std::span<const std::uint8_t> value) {
  if (entry.sub != device_.number()) return AbortCode::none;
  const std::uint32_t word = load_word(value);
  const auto information = static_cast<std::uint16_t>(word >> event_information_bit);
  const auto hours = hours_of(information);
  const auto minutes = minutes_of(information);
  const bool is_hour_wrong = (word & flag_adjust_hour) != 0 && (hours < -23 || hours > 23);
  const bool is_minute_wrong = (word & flag_adjust_minute) != 0 && (minutes < -59 || minutes > 59);
  return is_hour_wrong || is_minute_wrong ? AbortCode::value_range : AbortCode::none;
}

/// A flag is set as long as its event is pending (9.2.5): the same one may be received again, for
/// example at a start of its sender, and is no new event.
void TachographUnit::take_event(std::uint8_t flags, std::uint16_t information) {
  const unsigned arisen = flags & ~std::exchange(flags_, flags);
  if ((arisen & flag_reset_trip) != 0) trip_begin_ = reading_.distance_metres;
  if ((flags & flag_adjust_hour) != 0) offset_hours_ = hours_of(information);
  if ((flags & flag_adjust_minute) != 0) offset_minutes_ = minutes_of(information);
  tell();
}

void TachographUnit::look(Time now) {
  if (hardware_.read) reading_ = hardware_.read();
  device_.node().timers().arm(timer_, now + settings_.period);
  // Positive backward as well (9.2.17.1).
  if (reading_.speed_kmh) reading_.speed_kmh = std::abs(*reading_.speed_kmh);
  const auto metres_per_second = reading_.speed_kmh
                                     ? std::optional(*reading_.speed_kmh / kmh_of_metres_per_second)
                                     : std::nullopt;
  recognition_.take(metres_per_second
                        ? std::optional(*metres_per_second * settings_.pulses_per_metre)
                        : std::nullopt,
                    now);
  count_driving(reading_, now);
  tell();
}

void TachographUnit::tell() {
  device_.tell(tachograph_speed, reading_.speed_kmh);
  device_.tell(direction_indication, reading_.direction);
  device_.tell(drive_recognition, recognition_.motion());
  device_.tell(total_vehicle_distance, reading_.distance_metres);
  device_.tell(trip_distance, reading_.distance_metres - trip_begin_);
  report_clock(device_, tachograph_clock, reading_.utc);
  device_.tell(tachograph_local_hour, static_cast<double>(offset_hours_));
  device_.tell(tachograph_local_minute, static_cast<double>(offset_minutes_));
  device_.tell(driver_1_card, reading_.cards[0]);
  device_.tell(driver_2_card, reading_.cards[1]);
  const auto driven = std::chrono::duration_cast<std::chrono::minutes>(driven_).count();
  device_.tell(driver_1_driving_time, static_cast<double>(driven));
  device_.tell(driver_2_driving_time, 0.0);
}

/// The driver in the first slot drives. Another card, no card, or a break restarts the driving
/// time.
void TachographUnit::count_driving(const TachographReading& reading, Time now) {
  const Duration passed = now - looked_;
  looked_ = now;
  const bool has_driver = !reading.cards[0].empty();
  const Card card = card_of(reading.cards[0]);
  const bool is_other = card != driver_;
  driver_ = card;
  if (recognition_.motion() == Motion::detected) {
    rested_ = {};
    if (has_driver) driven_ += passed;
  } else {
    rested_ += passed;
  }
  if (is_other || rested_ >= settings_.break_time) driven_ = {};
}

}  // namespace canvoy::cia407
