#include "canvoy/tools/device/car/gps_hands.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>

#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/device_car.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"

namespace canvoy::tools {

namespace gps_hand_rows {
namespace {

using namespace hand_rows;
using namespace cia447;

constexpr double metres_per_second = 1 / 3.6;

/// Numbers of a reading, which may be unknown or invalid.
template <auto part>
DeviceHand reading_number(const char* name, const FieldPlace& place, const HandRange& range,
                          double scale = 1) {
  DeviceHand hand = number<GpsUnit>(
      name, place, range,
      [name, scale](GpsUnit& unit, const HandValue& value, const HandTarget& target) {
        target.car->sense_gps(name, [value, scale](GpsReading& reading) {
          using Number = typename std::remove_reference_t<decltype(reading.*part)>::value_type;
          const bool is_number = value.meaning == Meaning::state;
          reading.*part = std::nullopt;
          if (is_number) reading.*part = static_cast<Number>(value.number * scale);
        });
        unit.hardware_changed();
        return true;
      });
  hand.words = {{"not-available", 0, Meaning::invalid}};
  return hand;
}

DeviceHand receiver_hand() {
  return choice<GpsUnit>("receiver", whole(gps_status_object), {"working", "failure"},
                         [](GpsUnit& unit, const HandValue& value, const HandTarget& target) {
                           target.car->sense_gps("receiver",
                                                 [fails = value.code == 1](GpsReading& reading) {
                                                   reading.has_failed = fails;
                                                 });
                           unit.hardware_changed();
                           return true;
                         });
}

DeviceHand fix_hand() {
  return status<GpsUnit>("fix", place_of(gps_status_fix),
                         [](GpsUnit& unit, const HandValue& value, const HandTarget& target) {
                           target.car->sense_gps("fix", [value](GpsReading& reading) {
                             reading.fix = static_cast<GpsFix>(value.code);
                           });
                           unit.hardware_changed();
                           return true;
                         });
}

DeviceHand clock_hand() {
  return text<GpsUnit>("time", {whole(gps_date_object), whole(gps_utc_time_object)},
                       "2026-10-25T00:59:50", check_clock_text,
                       [](GpsUnit& unit, const HandValue& value, const HandTarget& target) {
                         target.car->set_clock(CarClock::receiver, parse_clock_text(value.text));
                         unit.hardware_changed();
                         return true;
                       });
}

CarHandTable table_of_rows() {
  CarHandTable table{.device = GpsKind::info.name};
  using Reading = GpsReading;
  table.rows = {
      receiver_hand(),
      fix_hand(),
      reading_number<&Reading::latitude>("latitude", place_of(gps_current_position_latitude),
                                         {-90, 90, "degrees, south below 0"}),
      reading_number<&Reading::longitude>("longitude", place_of(gps_current_position_longitude),
                                          {-180, 180, "degrees, west below 0"}),
      reading_number<&Reading::altitude>("altitude", place_of(gps_altitude), {-1000, 10'000, "m"}),
      reading_number<&Reading::velocity>("velocity", place_of(gps_velocity), {0, 250, "km/h"},
                                         metres_per_second),
      reading_number<&Reading::heading>("heading", place_of(gps_heading),
                                        {0, 359.9, "degrees from north"}),
      reading_number<&Reading::visible_satellites>("visible-satellites",
                                                   place_of(gps_satellites_visible), {0, 13}),
      reading_number<&Reading::tracked_satellites>("tracked-satellites",
                                                   place_of(gps_satellites_tracked), {0, 13}),
      reading_number<&Reading::vdop>("vdop", place_of(gps_status_vdop), {0, 80}),
      reading_number<&Reading::hdop>("hdop", place_of(gps_status_hdop), {0, 80}),
      reading_number<&Reading::pdop>("pdop", place_of(gps_status_pdop), {0, 80}),
      clock_hand()};
  for (DeviceHand& hand : table.rows) hand.is_around = true;
  return table;
}

}  // namespace
}  // namespace gps_hand_rows

CarHandTable gps_hands() {
  return gps_hand_rows::table_of_rows();
}

Duration parse_clock_text(std::string_view text) {
  const std::string whole_text(text);
  int year = 0;
  unsigned month = 0, day = 0, hour = 0, minute = 0, second = 0;
  int end = -1;
  const int found = std::sscanf(whole_text.c_str(), "%4d-%2u-%2uT%2u:%2u:%2u%n", &year, &month,
                                &day, &hour, &minute, &second, &end);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  const bool is_time = found == 6 && end == static_cast<int>(text.size()) && date.ok() &&
                       year >= 1970 && year <= 2099 && hour <= 23 && minute <= 59 && second <= 59;
  if (!is_time) {
    throw UsageError(fmt::format("'{}' is no time: write it as 2026-10-25T00:59:50", text));
  }
  return std::chrono::sys_days(date).time_since_epoch() + std::chrono::hours(hour) +
         std::chrono::minutes(minute) + std::chrono::seconds(second);
}

}  // namespace canvoy::tools
