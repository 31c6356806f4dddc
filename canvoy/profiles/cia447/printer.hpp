// CiA 447-3, clause 4.2.13: the printer.
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

// 4.2.13.1 to 4.2.13.3: state and capabilities.

inline constexpr auto printer_states = status_values<4>("Ready", "Busy", "Standby mode");
inline constexpr auto buffer_states = status_values<2>("Buffer is not empty", "Buffer is empty");
inline constexpr auto printer_status_fields = side_by_side(
    field(4, "printer status", "what the printer does", printer_states),
    field(2, "buffer empty", "whether all is printed", buffer_states), reserved<1, 2>());
inline constexpr auto printer_status_object =
    variable_object(0x60E0, "Printer status", "4.2.13.1", "What the printer does.",
                    status(DataType::unsigned8, Mapping::by_default, printer_status_fields));

inline constexpr auto paper_errors = status_values<2>("No error", "Error (printer has no paper)");
inline constexpr auto printer_errors_fields =
    side_by_side(field(2, "np", "no paper", paper_errors), reserved<2, 7>());
inline constexpr auto printer_errors_object = variable_object(
    0x60E1, "Printer errors", "4.2.13.2", "Why the printer does not print.",
    status(DataType::unsigned16, Mapping::by_default, printer_errors_fields), {.errata = "Z45"});

/// 0: no logos.
inline constexpr NamedValue logo_number_names[] = {status_sentinels<5>.second_highest,
                                                   status_sentinels<5>.highest,
                                                   {0x00, "The printer is not able to store logos"},
                                                   reserved_codes(0x15, 0x1D)};
inline constexpr NamedValue form_feed_names[] = {
    status_sentinels<3>.second_highest,
    status_sentinels<3>.highest,
    {0x00, "The printer generates automatic linefeeds at the end of the print job"}};
inline constexpr ValueInfo logo_number = {.limits = within(0x00, 0x14), .names = logo_number_names};
inline constexpr ValueInfo form_feed_lines = {.limits = within(0x00, 0x05),
                                              .names = form_feed_names};
inline constexpr auto printer_features_fields = side_by_side(
    field(2, "apt", "able to print text", no_yes), field(2, "apb", "able to print bold", no_yes),
    field(2, "apc", "able to print cursive", no_yes), field(2, "ast", "able to scale text", no_yes),
    field(2, "vws", "variable width supported", no_yes),
    field(2, "fws", "fixed width supported", no_yes),
    field(2, "apg", "able to print graphics", no_yes),
    field(2, "apbw", "able to print black/white", no_yes),
    field(2, "apgr", "able to print gray", no_yes),
    field(2, "rgb", "able to print RGB colors", no_yes),
    field(2, "cymk", "able to print CMYK colors", no_yes),
    field(5, "logo number", "how many logos it can store", logo_number),
    field(2, "atcp", "able to cut paper", no_yes),
    field(3, "ltff", "lines to form feed", form_feed_lines));
inline constexpr auto printer_features_object = variable_object(
    0x60E2, "Printer features", "4.2.13.3", "What the printer can do.",
    status(DataType::unsigned32, Mapping::no, printer_features_fields), {.errata = "Z44"});

// 4.2.13.4 and 4.2.13.5. The printed ranges are "Unsigned8" and "Unsigned16", but the two highest
// codes are sentinels (errata Z29).

/// A measure of text, in dots or another unit.
constexpr EntryInfo text_measure(unsigned sub, std::string_view name, Unit unit = Unit::none,
                                 Category category = Category::optional) {
  return at(sub, name, status(DataType::unsigned8, Mapping::no, measured<8>(unit)), category);
}
/// A measure of graphics, in dots or another unit.
constexpr EntryInfo graphics_measure(unsigned sub, std::string_view name, Unit unit = Unit::none,
                                     Category category = Category::optional) {
  return at(sub, name, status(DataType::unsigned16, Mapping::no, measured<16>(unit)), category);
}
inline constexpr EntryInfo printer_text_status_entries[] = {
    highest_sub_index(1, 9, Access::const_),
    text_measure(1, "Maximum number of characters per full line", Unit::none, Category::mandatory),
    text_measure(2, "Minimum number of characters per full line"),
    text_measure(3, "Current number of characters per full line"),
    text_measure(4, "Maximum text height", Unit::pixel),
    text_measure(5, "Minimum text height", Unit::pixel),
    text_measure(6, "Current text height", Unit::pixel),
    text_measure(7, "Maximum text width", Unit::pixel),
    text_measure(8, "Minimum text width", Unit::pixel),
    text_measure(9, "Current text width", Unit::pixel)};
inline constexpr auto printer_text_status_object =
    array_object(0x60E3, "Printer text status", "4.2.13.4", "Sizes of text.",
                 printer_text_status_entries, {.errata = "Z29, Z33"});
inline constexpr EntryInfo printer_graphics_status_entries[] = {
    highest_sub_index(1, 3, Access::const_),
    graphics_measure(1, "Number of dots per line", Unit::pixel, Category::mandatory),
    graphics_measure(2, "Number of grayscales"),
    graphics_measure(3, "Number of bits per colour channel")};
inline constexpr auto printer_graphics_status_object = array_object(
    0x60E4, "Printer graphics status", "4.2.13.5", "How finely the printer prints graphics.",
    printer_graphics_status_entries, {.errata = "Z29, Z33"});

// 4.2.13.6 and 4.2.13.7. "01h0" is read as 01h (errata Z15). Command and status do not share the
// codes of the color space (errata Z16).

inline constexpr NamedValue font_command_names[] = {command_sentinels<8>.second_highest,
                                                    command_sentinels<8>.highest,
                                                    {0x00, "No command", Meaning::do_not_care},
                                                    reserved_codes(0xFD, 0xFD)};
inline constexpr NamedValue font_status_names[] = {status_sentinels<8>.second_highest,
                                                   status_sentinels<8>.highest,
                                                   {0x00, "No value is set", Meaning::invalid}};
/// A property of the font that is to be used.
constexpr ValueInfo font_command(Unit unit) {
  return {.unit = unit, .limits = within(0x01, 0xFC), .names = font_command_names};
}
/// A property of the font in use.
constexpr ValueInfo font_status(Unit unit) {
  return {.unit = unit, .limits = within(0x01, 0xFD), .names = font_status_names};
}
inline constexpr auto print_commands = command_values<2>("No command", "Execute the command");
inline constexpr auto color_space_commands =
    three_commands("No command", "Use RGB color space", "Use CMYK color space");
inline constexpr auto printer_configuration_command_fields = side_by_side(
    field(2, "pb", "print bold", print_commands), field(2, "pc", "print cursive", print_commands),
    field(2, "uvwf", "use variable width font", print_commands),
    field(2, "uccs", "use certain color space", color_space_commands),
    field(8, "height of used font", "", font_command(Unit::pixel)),
    field(8, "width of used font", "", font_command(Unit::pixel)),
    field(8, "number of chars per line", "", font_command(Unit::none)));
inline constexpr auto printer_configuration_command_object =
    variable_object(0x60E5, "Printer configuration command", "4.2.13.6", "Chooses font and colors.",
                    command(DataType::unsigned32, printer_configuration_command_fields),
                    {.errata = "Z15, Z16, Z35, Z44"});
inline constexpr auto bold_states = status_values<2>("Text bold is not set", "Text bold is set");
inline constexpr auto cursive_states =
    status_values<2>("Text cursive is not set", "Text cursive is set");
inline constexpr auto variable_width_states =
    status_values<2>("Variable width font is not set", "Variable width font is set");
inline constexpr auto color_space_states =
    status_values<2>("RGB color space is set", "CMYK color space is set");
inline constexpr auto printer_configuration_status_fields = side_by_side(
    field(2, "text bold", "", bold_states), field(2, "text cursive", "", cursive_states),
    field(2, "variable width font", "", variable_width_states),
    field(2, "color space", "", color_space_states),
    field(8, "height of used font", "", font_status(Unit::pixel)),
    field(8, "width of used font", "", font_status(Unit::pixel)),
    field(8, "number of chars per line", "", font_status(Unit::none)));
inline constexpr auto printer_configuration_status_object = variable_object(
    0x60E6, "Printer configuration status", "4.2.13.7", "Font and colors that are set.",
    status(DataType::unsigned32, Mapping::no, printer_configuration_status_fields),
    {.errata = "Z15, Z16, Z44"});

// 4.2.13.8 to 4.2.13.10: contents to print.

inline constexpr auto printer_mode_commands =
    command_values<8>("Print Text", "Print graphics black with ESC", "Print graphics gray with ESC",
                      "Print graphics RGB with ESC", "Print graphics CMYK with ESC", "Print logo");
inline constexpr auto printer_mode_command_object = variable_object(
    0x60E9, "Printer mode command", "4.2.13.8", "Chooses what 60EBh takes.",
    command(DataType::unsigned8, ValueInfo{.names = printer_mode_commands}), {.errata = "Z44"});
inline constexpr auto printer_modes =
    status_values<8>("Text", "Graphics black with ESC", "Graphics gray with ESC",
                     "Graphics RGB with ESC", "Graphics CMYK with ESC", "Logo mode");
inline constexpr auto printer_mode_status_object =
    variable_object(0x60EA, "Printer mode status", "4.2.13.9", "What 60EBh takes.",
                    status(DataType::unsigned8, Mapping::no, ValueInfo{.names = printer_modes}),
                    {.errata = "Z44, Z45"});

inline constexpr auto printer_transport_object = variable_object(
    0x60EB, "Printer transport", "4.2.13.10",
    "What to print, as 60EAh says: UTF-8 text, dots (1 bit, 1, 3 or 4 bytes each), or logos.",
    {.type = DataType::domain, .access = Access::rw}, {.errata = "Z23, Z44"});

/// Control bytes in the transport. In text and logo mode they are sent as they are; in the graphics
/// modes they follow `escape`, and the escape itself is sent twice (errata Z23).
enum class PrinterControl : std::uint8_t {
  cut_paper = 0x04,
  new_line = 0x0A,
  carriage_return = 0x0D,
  escape = 0x1B,
};
/// The byte that prints logo 1 in logo mode. The next bytes print logos 2 to 20.
inline constexpr std::uint8_t first_logo = 0x20;
inline constexpr unsigned logo_count = 20;

}  // namespace canvoy::cia447
