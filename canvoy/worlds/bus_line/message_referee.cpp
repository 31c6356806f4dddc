#include "canvoy/worlds/bus_line/message_referee.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::bus_line {

namespace {

/// The table of 8.1.4.3, with its numbers read in their order (errata 94).
struct Table {
  std::uint32_t id;
  std::uint8_t length;
  bool is_of_computer;  ///< false: of the identification device
};
constexpr std::array<Table, 8> tables = {{
    {0x181, 6, true},   // year, day, month, hour, minute, second
    {0x381, 6, true},   // route segment, fare zone, blocking, direction, running number
    {0x401, 8, true},   // stop point, events
    {0x481, 8, true},   // line, eight characters
    {0x501, 8, true},   // stop point, eight characters
    {0x201, 4, false},  // driver
    {0x281, 8, false},  // block, line, journey
    {0x301, 6, false},  // destination, route
}};
constexpr std::uint32_t route_id = 0x381;
constexpr std::uint32_t stop_point_id = 0x401;
constexpr std::uint32_t driver_id = 0x201;
constexpr std::uint32_t block_id = 0x281;
constexpr std::uint32_t destination_id = 0x301;

std::uint64_t number_at(const Frame& frame, std::size_t first, std::size_t bytes) {
  return load_unsigned(std::span(frame.data).subspan(first, bytes));
}

bool says(const Frame& frame, const TrueData& data) {
  switch (frame.id) {
    case route_id:
      return number_at(frame, 0, 2) == data.route_segment && frame.data[2] == data.fare_zone;
    case stop_point_id:
      return number_at(frame, 0, 4) == data.stop_point;
    case driver_id:
      return number_at(frame, 0, 4) == data.driver;
    case block_id:
      return number_at(frame, 0, 4) == data.block && number_at(frame, 4, 2) == data.line &&
             number_at(frame, 6, 2) == data.journey;
    case destination_id:
      return number_at(frame, 0, 4) == data.destination && number_at(frame, 4, 2) == data.route;
    default:
      return true;
  }
}

}  // namespace

std::optional<bool> MessageReferee::is_right(Time now, ControllerId sender, const Frame& frame,
                                             const TrueHistory& truth) const {
  const auto table = std::ranges::find(tables, frame.id, &Table::id);
  if (table == tables.end() || frame.is_extended()) return std::nullopt;
  const bool is_from = sender == (table->is_of_computer ? computer_ : identification_);
  if (!is_from || frame.length != table->length || !frame.is_plain()) return false;
  return says(frame, TrueData{}) ||
         truth.is_true(now, [&](const TrueData& data) { return says(frame, data); });
}

bool MessageReferee::is_time(const Frame& frame, const cia407::CivilTime& time) {
  // SAE J1939: years since 1985, quarters of days, quarters of seconds (errata 52, 56).
  constexpr unsigned quarters = 4;
  const cia407::CivilTime told = {.year = 1985 + frame.data[0],
                                  .month = frame.data[2],
                                  .day = (frame.data[1] + quarters - 1) / quarters,
                                  .hour = frame.data[3],
                                  .minute = frame.data[4],
                                  .second = frame.data[5] / quarters};
  if (!cia407::can_be_told(told)) return false;
  const std::int64_t late = cia447::seconds_since_1970(time) - cia447::seconds_since_1970(told);
  return std::abs(late) <= 1;
}

}  // namespace canvoy::bus_line
