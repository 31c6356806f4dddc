// CiA 447-3, clauses 4.2.14 and 4.2.15: real time clock and driver identification.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.14.1 and 4.2.14.2. The figure gives the day 4 bits and the month 8. This description has the
// day in bits 27 to 20 and the month in bits 19 to 16, in the order of names and tables. The other
// reading, month in bits 27 to 24 and day in bits 23 to 16, is selectable (Profile::readings).

/// Numbers from 1 to `high` in a status; 0 has a separate meaning.
template <unsigned bits, std::int64_t high>
constexpr auto date_names() {
  constexpr bool has_gap = high < all_ones(bits) - 2;
  std::array<NamedValue, has_gap ? 4 : 3> names{};
  names[0] = status_sentinels<bits>.second_highest;
  names[1] = status_sentinels<bits>.highest;
  names[2] = NamedValue{0, "No date is set", Meaning::invalid};
  if constexpr (has_gap) names[3] = reserved_codes(high + 1, all_ones(bits) - 2);
  return names;
}
/// Numbers from 1 to `high` in a command. Its second highest code is reserved (errata Z35).
template <unsigned bits, std::int64_t high>
inline constexpr NamedValue set_date_names[] = {command_sentinels<bits>.highest,
                                                {0, "Reset the date"},
                                                reserved_codes(high + 1, all_ones(bits) - 1)};
template <unsigned bits, std::int64_t high>
inline constexpr auto rtc_date_names = date_names<bits, high>();
/// A part of the date from 1 to `high`.
template <unsigned bits, std::int64_t high>
constexpr ValueInfo rtc_date_part(Unit unit) {
  return {.unit = unit, .limits = within(1, high), .names = rtc_date_names<bits, high>};
}
/// See rtc_date_part(); 0 resets the date.
template <unsigned bits, std::int64_t high>
constexpr ValueInfo set_date_part(Unit unit) {
  return {.unit = unit, .limits = within(0, high), .names = set_date_names<bits, high>};
}

inline constexpr auto rtc_year =
    field(16, "RTC date year", "", rtc_date_part<16, 0xFFFD>(Unit::year));
inline constexpr auto rtc_month = field(4, "RTC date month", "", rtc_date_part<4, 12>(Unit::month));
inline constexpr auto rtc_day = field(8, "RTC date day", "", rtc_date_part<8, 31>(Unit::day));
inline constexpr auto set_rtc_year =
    field(16, "RTC date year", "", set_date_part<16, 0xFFFD>(Unit::year));
inline constexpr auto set_rtc_month =
    field(4, "RTC date month", "", set_date_part<4, 12>(Unit::month));
inline constexpr auto set_rtc_day = field(8, "RTC date day", "", set_date_part<8, 31>(Unit::day));

inline constexpr auto rtc_date_fields = side_by_side(rtc_year, rtc_month, rtc_day, reserved<4>());
inline constexpr auto rtc_date_month_above_fields =
    side_by_side(rtc_year, rtc_day, rtc_month, reserved<4>());
inline constexpr auto set_rtc_date_fields =
    side_by_side(set_rtc_year, set_rtc_month, set_rtc_day, reserved<4>());
inline constexpr auto set_rtc_date_month_above_fields =
    side_by_side(set_rtc_year, set_rtc_day, set_rtc_month, reserved<4>());

/// 60F0h with these fields.
constexpr ObjectInfo rtc_date_with(Items<FieldInfo> fields) {
  return variable_object(0x60F0, "RTC date", "4.2.14.1", "The date of the clock.",
                         status(DataType::unsigned32, Mapping::no, fields), {.errata = "Z02"});
}
/// 60F1h with these fields.
constexpr ObjectInfo set_rtc_date_with(Items<FieldInfo> fields) {
  return variable_object(0x60F1, "Set RTC date", "4.2.14.2", "Sets the date of the clock.",
                         command(DataType::unsigned32, fields), {.errata = "Z02, Z35"});
}
inline constexpr auto rtc_date_object = rtc_date_with(rtc_date_fields);
inline constexpr auto rtc_date_month_above_object = rtc_date_with(rtc_date_month_above_fields);
inline constexpr auto set_rtc_date_object = set_rtc_date_with(set_rtc_date_fields);
inline constexpr auto set_rtc_date_month_above_object =
    set_rtc_date_with(set_rtc_date_month_above_fields);

// 4.2.14.3 and 4.2.14.4. Seconds start at 0: otherwise, a full minute could not be expressed
// (errata Z07).

inline constexpr Scale hundredths = {.denominator = 100};
inline constexpr auto rtc_time_fields =
    side_by_side(field(8, "RTC hour", "", measured<8, 23>(Unit::hour)),
                 field(8, "RTC minute", "", measured<8, 59>(Unit::minute)),
                 field(16, "RTC second", "", measured<16, 5999>(Unit::second, hundredths)));
inline constexpr auto rtc_time_object =
    variable_object(0x60F2, "RTC time", "4.2.14.3", "The time of the clock.",
                    status(DataType::unsigned32, Mapping::no, rtc_time_fields), {.errata = "Z07"});

/// Numbers in a command that has only one sentinel (errata Z35).
template <unsigned bits, std::int64_t high>
inline constexpr NamedValue set_time_names[] = {command_sentinels<bits>.highest,
                                                reserved_codes(high + 1, all_ones(bits) - 1)};
/// A part of the time from 0 to `high`.
template <unsigned bits, std::int64_t high>
constexpr ValueInfo set_time_part(Unit unit, const Scale& scale = {}) {
  return {
      .unit = unit, .scale = scale, .limits = within(0, high), .names = set_time_names<bits, high>};
}
inline constexpr auto set_rtc_time_fields =
    side_by_side(field(8, "RTC hour", "", set_time_part<8, 23>(Unit::hour)),
                 field(8, "RTC minute", "", set_time_part<8, 59>(Unit::minute)),
                 field(16, "RTC second", "", set_time_part<16, 5999>(Unit::second, hundredths)));
inline constexpr auto set_rtc_time_object =
    variable_object(0x60F3, "Set RTC time", "4.2.14.4", "Sets the time of the clock.",
                    command(DataType::unsigned32, set_rtc_time_fields), {.errata = "Z07, Z35"});

// 4.2.14.5 and 4.2.14.6: source of the time.

inline constexpr auto rtc_sources =
    status_values<4>("Unknown", "GPS", "Time normal", "Battery buffered RTC (taximeter intern)");
inline constexpr auto rtc_trustability =
    status_values<4>("User adjustable", "Accepted by authority");
inline constexpr auto rtc_validity = status_values<2>("RTC not valid", "RTC valid");
inline constexpr auto dst_support = status_values<2>("DST not supported", "DST supported");
inline constexpr auto dst_states = status_values<2>("DST not active", "DST active");
/// Quarters of an hour from -12 to +14 hours (errata Z14).
inline constexpr ValueInfo utc_offset =
    measured<8, 0x68>(Unit::hour, {.denominator = 4, .offset = -48});
inline constexpr auto rtc_type_and_status_fields =
    side_by_side(field(4, "RTC source", "where the time comes from", rtc_sources),
                 field(4, "RTC trustability", "who vouches for it", rtc_trustability),
                 field(2, "RTC status", "whether the clock is right", rtc_validity),
                 field(2, "DST support", "whether it knows daylight saving time", dst_support),
                 field(2, "DST status", "whether it is daylight saving time", dst_states),
                 field(8, "offset from UTC", "local time less UTC", utc_offset), reserved<10>());
inline constexpr auto rtc_type_and_status_object = variable_object(
    0x60F4, "RTC type and status", "4.2.14.5", "How far the clock can be trusted.",
    status(DataType::unsigned32, Mapping::no, rtc_type_and_status_fields), {.errata = "Z14"});

/// Six characters. In UTF-8, a character has up to four bytes.
inline constexpr std::uint16_t time_zone_capacity = 24;
inline constexpr auto rtc_time_zone_object =
    variable_object(0x60F5, "RTC time zone", "4.2.14.6", "Time zone, in six characters.",
                    status_text(time_zone_capacity));

// 4.2.15: driver identification.

inline constexpr auto unique_driver_id_object = variable_object(
    0x60F9, "Unique driver ID", "4.2.15.1", "Which driver it is.",
    {.type = DataType::unsigned64, .access = Access::ro, .consumer_access = Access::rw},
    {.errata = "Z43"});
inline constexpr auto login_states =
    status_values<2>("Driver is logged out", "Driver is logged in");
inline constexpr auto data_states = status_values<2>("Invalid", "Valid");
inline constexpr auto identification_failures =
    status_values<2>("No identification failure", "Identification failure");
inline constexpr auto driver_id_status_fields = side_by_side(
    field(2, "logged in", "whether a driver is", login_states),
    field(2, "data state", "whether the data are true", data_states),
    field(2, "ID system failure", "whether it works", identification_failures), reserved<1, 2>());
inline constexpr auto driver_id_status_object =
    variable_object(0x60FA, "Driver ID status", "4.2.15.2", "Whether a driver is logged in.",
                    status(DataType::unsigned8, Mapping::by_default, driver_id_status_fields));
/// Six characters are printed, copied from 60F5h; names are longer (errata Z17). The capacity is
/// our choice.
inline constexpr std::uint16_t driver_name_capacity = 64;
inline constexpr auto drivers_name_object =
    variable_object(0x60FB, "Drivers name", "4.2.15.3", "Who the driver is.",
                    status_text(driver_name_capacity), {.errata = "Z17"});
/// Seconds since 1970-01-01; the time zone is not specified (errata Z42).
constexpr EntryInfo login_time(unsigned sub, std::string_view name) {
  return at(sub, name, status(DataType::unsigned32, Mapping::no, measured<32>(Unit::second)));
}
inline constexpr EntryInfo driver_login_and_logout_time_entries[] = {
    highest_sub_index(2, 2), login_time(1, "Driver login time"),
    login_time(2, "Driver logout time")};
inline constexpr auto driver_login_and_logout_time_object =
    array_object(0x60FC, "Driver login and logout time", "4.2.15.4", "Seconds since 1970-01-01.",
                 driver_login_and_logout_time_entries, {.errata = "Z29, Z42"});

}  // namespace canvoy::cia447
