// CiA 447-3: handles for application code, of printer, clock and driver identification (4.2.13 to
// 4.2.15).
//
//     Values printer(node.dictionary());
//     printer[cia447::printer_mode_command] = cia447::PrinterMode::text;
#pragma once

#include "canvoy/profiles/cia447/add_on_states.hpp"
#include "canvoy/profiles/cia447/clock.hpp"
#include "canvoy/profiles/cia447/printer.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

// 4.2.13.

inline constexpr State<PrinterState, printer_status_object, "", "printer status"> printer_status;
inline constexpr State<Signal, printer_status_object, "", "buffer empty">
    printer_status_buffer_empty;
inline constexpr State<Signal, printer_errors_object, "", "np"> printer_errors_no_paper;

inline constexpr State<Signal, printer_features_object, "", "apt">
    printer_features_able_to_print_text;
inline constexpr State<Signal, printer_features_object, "", "apb">
    printer_features_able_to_print_bold;
inline constexpr State<Signal, printer_features_object, "", "apc">
    printer_features_able_to_print_cursive;
inline constexpr State<Signal, printer_features_object, "", "ast">
    printer_features_able_to_scale_text;
inline constexpr State<Signal, printer_features_object, "", "vws">
    printer_features_variable_width_supported;
inline constexpr State<Signal, printer_features_object, "", "fws">
    printer_features_fixed_width_supported;
inline constexpr State<Signal, printer_features_object, "", "apg">
    printer_features_able_to_print_graphics;
inline constexpr State<Signal, printer_features_object, "", "apbw">
    printer_features_able_to_print_black_white;
inline constexpr State<Signal, printer_features_object, "", "apgr">
    printer_features_able_to_print_gray;
inline constexpr State<Signal, printer_features_object, "", "rgb">
    printer_features_able_to_print_rgb;
inline constexpr State<Signal, printer_features_object, "", "cymk">
    printer_features_able_to_print_cmyk;
inline constexpr Number<printer_features_object, "", "logo number"> printer_features_logo_number;
inline constexpr State<Signal, printer_features_object, "", "atcp">
    printer_features_able_to_cut_paper;
inline constexpr Number<printer_features_object, "", "ltff"> printer_features_lines_to_form_feed;

inline constexpr Number<printer_text_status_object, "Maximum number of characters per full line">
    printer_text_status_maximum_number_of_characters_per_full_line;
inline constexpr Number<printer_text_status_object, "Minimum number of characters per full line">
    printer_text_status_minimum_number_of_characters_per_full_line;
inline constexpr Number<printer_text_status_object, "Current number of characters per full line">
    printer_text_status_current_number_of_characters_per_full_line;
inline constexpr Quantity<printer_text_status_object, "Maximum text height">
    printer_text_status_maximum_height;
inline constexpr Quantity<printer_text_status_object, "Minimum text height">
    printer_text_status_minimum_height;
inline constexpr Quantity<printer_text_status_object, "Current text height">
    printer_text_status_current_height;
inline constexpr Quantity<printer_text_status_object, "Maximum text width">
    printer_text_status_maximum_width;
inline constexpr Quantity<printer_text_status_object, "Minimum text width">
    printer_text_status_minimum_width;
inline constexpr Quantity<printer_text_status_object, "Current text width">
    printer_text_status_current_width;

inline constexpr Quantity<printer_graphics_status_object, "Number of dots per line">
    printer_graphics_status_number_of_dots_per_line;
inline constexpr Number<printer_graphics_status_object, "Number of grayscales">
    printer_graphics_status_number_of_grayscales;
inline constexpr Number<printer_graphics_status_object, "Number of bits per colour channel">
    printer_graphics_status_number_of_bits_per_colour_channel;

inline constexpr State<FontCommand, printer_configuration_command_object, "", "pb">
    printer_configuration_command_print_bold;
inline constexpr State<FontCommand, printer_configuration_command_object, "", "pc">
    printer_configuration_command_print_cursive;
inline constexpr State<FontCommand, printer_configuration_command_object, "", "uvwf">
    printer_configuration_command_use_variable_width_font;
inline constexpr State<ColorSpaceCommand, printer_configuration_command_object, "", "uccs">
    printer_configuration_command_use_certain_color_space;
inline constexpr Quantity<printer_configuration_command_object, "", "height of used font">
    printer_configuration_command_height_of_used_font;
inline constexpr Quantity<printer_configuration_command_object, "", "width of used font">
    printer_configuration_command_width_of_used_font;
inline constexpr Number<printer_configuration_command_object, "", "number of chars per line">
    printer_configuration_command_number_of_chars_per_line;

inline constexpr State<Signal, printer_configuration_status_object, "", "text bold">
    printer_configuration_status_text_bold;
inline constexpr State<Signal, printer_configuration_status_object, "", "text cursive">
    printer_configuration_status_text_cursive;
inline constexpr State<Signal, printer_configuration_status_object, "", "variable width font">
    printer_configuration_status_variable_width_font;
inline constexpr State<ColorSpace, printer_configuration_status_object, "", "color space">
    printer_configuration_status_color_space;
inline constexpr Quantity<printer_configuration_status_object, "", "height of used font">
    printer_configuration_status_height_of_used_font;
inline constexpr Quantity<printer_configuration_status_object, "", "width of used font">
    printer_configuration_status_width_of_used_font;
inline constexpr Number<printer_configuration_status_object, "", "number of chars per line">
    printer_configuration_status_number_of_chars_per_line;
inline constexpr State<PrinterMode, printer_mode_command_object> printer_mode_command;
inline constexpr State<PrinterMode, printer_mode_status_object> printer_mode_status;

// 4.2.14.

inline constexpr Quantity<rtc_date_object, "", "RTC date year"> rtc_date_year;
inline constexpr Quantity<rtc_date_object, "", "RTC date month"> rtc_date_month;
inline constexpr Quantity<rtc_date_object, "", "RTC date day"> rtc_date_day;

inline constexpr Quantity<set_rtc_date_object, "", "RTC date year"> set_rtc_date_year;
inline constexpr Quantity<set_rtc_date_object, "", "RTC date month"> set_rtc_date_month;
inline constexpr Quantity<set_rtc_date_object, "", "RTC date day"> set_rtc_date_day;

inline constexpr Quantity<rtc_time_object, "", "RTC hour"> rtc_time_hour;
inline constexpr Quantity<rtc_time_object, "", "RTC minute"> rtc_time_minute;
inline constexpr Quantity<rtc_time_object, "", "RTC second"> rtc_time_second;

inline constexpr Quantity<set_rtc_time_object, "", "RTC hour"> set_rtc_time_hour;
inline constexpr Quantity<set_rtc_time_object, "", "RTC minute"> set_rtc_time_minute;
inline constexpr Quantity<set_rtc_time_object, "", "RTC second"> set_rtc_time_second;

inline constexpr State<RtcSource, rtc_type_and_status_object, "", "RTC source">
    rtc_type_and_status_source;
inline constexpr State<RtcTrustability, rtc_type_and_status_object, "", "RTC trustability">
    rtc_type_and_status_trustability;
inline constexpr State<Signal, rtc_type_and_status_object, "", "RTC status">
    rtc_type_and_status_valid;
inline constexpr State<Signal, rtc_type_and_status_object, "", "DST support">
    rtc_type_and_status_dst_supported;
inline constexpr State<Signal, rtc_type_and_status_object, "", "DST status">
    rtc_type_and_status_dst_active;
inline constexpr Quantity<rtc_type_and_status_object, "", "offset from UTC">
    rtc_type_and_status_utc_offset;
inline constexpr Text<rtc_time_zone_object> rtc_time_zone;

// 4.2.15.

inline constexpr Number<unique_driver_id_object> unique_driver_id;

inline constexpr State<Signal, driver_id_status_object, "", "logged in"> driver_id_status_logged_in;
inline constexpr State<Signal, driver_id_status_object, "", "data state">
    driver_id_status_data_state;
inline constexpr State<Signal, driver_id_status_object, "", "ID system failure">
    driver_id_status_system_failure;
inline constexpr Text<drivers_name_object> drivers_name;

inline constexpr Quantity<driver_login_and_logout_time_object, "Driver login time">
    driver_login_time;
inline constexpr Quantity<driver_login_and_logout_time_object, "Driver logout time">
    driver_logout_time;

}  // namespace canvoy::cia447
