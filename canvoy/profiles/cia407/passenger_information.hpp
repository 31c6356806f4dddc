// Objects of CiA 407 that identification provides, 6190h to 6198h (9.2.7), and those that passenger
// information has, 6200h to 6205h (9.2.8).
//
//     cia407::display_mapping_object.index  // 6203h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

// Identification.

inline constexpr auto driver_id_object =
    variable(0x6190, "driver_ID", "9.2.7.1",
             "Identifies the driver, as 6524h does by the card; 6198h is its text.",
             entry(unsigned32, ro, by_default, 0), {.errata = "85"});
inline constexpr auto destination_number_object =
    variable(0x6191, "destination_number", "9.2.7.2", "Where the line goes.",
             entry(unsigned32, ro, by_default, 0));
inline constexpr auto line_id_object =
    variable(0x6192, "line_ID", "9.2.7.3", "Identifies the line; 6196h is its text.",
             entry(unsigned16, ro, by_default, 0));
inline constexpr auto route_number_object =
    variable(0x6193, "route_number", "9.2.7.4", "The sequence of stops of a line.",
             entry(unsigned16, ro, by_default, 0), {.errata = "25"});
inline constexpr auto block_id_object = variable(
    0x6194, "block_ID", "9.2.7.5",
    "The work of the vehicle from leaving a parking point to the return; 6197h is its text.",
    entry(unsigned32, ro, by_default, 0));
inline constexpr NamedValue journey_numbers[] = {{0, "non-service journey"}};
inline constexpr auto journey_number_object =
    variable(0x6195, "journey_number", "9.2.7.6",
             "A journey from one terminal to another by a time table; 0: not in service.",
             entry(unsigned16, ro, by_default, 0,
                   {.names = journey_numbers, .counting = Counting::identifies}));

// Provided by identification or the main on-board computer.
inline constexpr auto line_id_text_object = variable(
    0x6196, "line_ID_text", "9.2.7.7", "The text to 6192h.", visible_text, {.errata = "26"});
inline constexpr auto block_id_text_object = variable(
    0x6197, "block_ID_text", "9.2.7.8", "The text to 6194h.", visible_text, {.errata = "26"});
inline constexpr auto driver_id_text_object = variable(
    0x6198, "driver_ID_text", "9.2.7.9", "The text to 6190h.", visible_text, {.errata = "26"});

// Passenger information: files.

/// An entry of an object of the display itself, which no other device consumes.
constexpr EntryInfo of_display(EntryInfo entry) {
  entry.access = Access::rw;
  entry.access_by_device = true;
  return entry;
}
/// An entry with a file or a segment of one; `capacity` in octets, 0: that of the device.
constexpr EntryInfo file(std::string_view name, DataType type, std::uint16_t capacity = 0) {
  return of_display(sub_index(0, name, string_entry(type, ro, capacity)));
}
inline constexpr auto xml_text_entries = one_or_more(
    entries_within(1, 254), file("XML_file_#", DataType::visible_string, xml_capacity), 254);
inline constexpr auto xml_text_object =
    array(0x6200, "XML_text", "9.2.8.1",
          "XML files, or segments of them; shown when 6203h says so.", xml_text_entries);
inline constexpr auto special_character_files_entries =
    one_or_more(entries_within(1, 254), file("special_character_file_#", DataType::domain), 254);
inline constexpr auto special_character_files_object =
    array(0x6201, "special_character_files", "9.2.8.2",
          "Each describes a special character of the display.", special_character_files_entries);
inline constexpr auto referenced_files_entries =
    one_or_more(entries_within(1, 254), file("reference_file_#", DataType::domain), 254);
inline constexpr auto referenced_files_for_xml_files_object =
    array(0x6202, "referenced_files_for_XML_files", "9.2.8.3",
          "Pictures that the XML files name; shown when 6203h says so.", referenced_files_entries);

// Display contents.

/// Flashing of an element of a display mapping (6203h).
enum class FlashSpeed : std::uint8_t { no_flash = 0, slow = 1, medium = 2, fast = 3 };
/// Style of an element of a display mapping (6203h).
enum class FontStyle : std::uint8_t { no_mode = 0, regular = 1, bold = 2, scrolling = 3 };
/// Alignment of an element of a display mapping (6203h).
enum class Alignment : std::uint8_t { no_mode = 0, left = 1, center = 2, right = 3 };
/// Size of an element of a display mapping (6203h).
enum class FontSize : std::uint8_t { no_mode = 0, small = 1, regular = 2, large = 3 };
inline constexpr NamedValue flash_speeds[] = {{FlashSpeed::no_flash, "no flash mode"},
                                              {FlashSpeed::slow, "slow"},
                                              {FlashSpeed::medium, "medium"},
                                              {FlashSpeed::fast, "fast"}};
inline constexpr NamedValue font_styles[] = {{FontStyle::no_mode, "no mode"},
                                             {FontStyle::regular, "regular"},
                                             {FontStyle::bold, "bold"},
                                             {FontStyle::scrolling, "scrolling from left"}};
inline constexpr NamedValue alignments[] = {{Alignment::no_mode, "no mode"},
                                            {Alignment::left, "align left"},
                                            {Alignment::center, "center"},
                                            {Alignment::right, "align right"}};
inline constexpr NamedValue font_sizes[] = {{FontSize::no_mode, "no mode"},
                                            {FontSize::small, "small"},
                                            {FontSize::regular, "regular"},
                                            {FontSize::large, "large"}};

/// Bytes of an entry of 6203h, by the number of their first bit.
struct DisplayLayout {
  std::uint8_t sub_index;  ///< of the entry to show
  std::uint8_t index_msb;  ///< of its object, high byte
  std::uint8_t index_lsb;  ///< of its object, low byte
  std::uint8_t format;     ///< font, alignment and flashing

  /// Makes an entry that shows this object without a format.
  constexpr std::uint32_t show(unsigned index, unsigned sub) const {
    return sub << sub_index | (index >> 8) << index_msb | (index & 0xFF) << index_lsb;
  }
};
/// The figure read by its bit numbers, or read as the order on the wire (errata 74).
inline constexpr DisplayLayout display_by_bit_number = {0, 8, 16, 24};
inline constexpr DisplayLayout display_by_byte_order = {24, 16, 8, 0};

/// Fields of an entry in that layout.
constexpr std::array<FieldInfo, 7> display_fields(const DisplayLayout& layout) {
  const auto byte = [](std::uint8_t first, std::string_view name) {
    return field(first, 8, name, {.notation = Notation::hexadecimal});
  };
  const auto mode = [&](unsigned offset, std::string_view name, const Items<NamedValue>& names) {
    return field(static_cast<std::uint8_t>(layout.format + offset), 2, name, names);
  };
  return {byte(layout.sub_index, "Sub-Index"), byte(layout.index_msb, "Index-MSB"),
          byte(layout.index_lsb, "Index-LSB"), mode(0, "font size", font_sizes),
          mode(2, "alignment", alignments),    mode(4, "font style", font_styles),
          mode(6, "flash speed", flash_speeds)};
}
inline constexpr auto display_mapping_fields = display_fields(display_by_bit_number);
inline constexpr auto display_mapping_fields_reversed = display_fields(display_by_byte_order);

inline constexpr FieldInfo display_update_fields[] = {
    field(0, 8, "number of mapped objects"),
    field(8, 24, "manufacturer-specific", {.notation = Notation::hexadecimal}),
};
/// Two texts are shown from the start (errata 75, 76): the first of 610Ch and the first of 6112h,
/// since the specification gives neither sub-index nor format.
constexpr std::array<EntryInfo, 5> display_entries(const DisplayLayout& layout,
                                                   const Items<FieldInfo>& fields) {
  const EntryInfo shown = of_display(
      sub_index(0, "mapped_object_#",
                entry(unsigned32, ro, optional, {}, {.notation = Notation::hexadecimal}, fields),
                {.errata = "74, 75, 76"}));
  EntryInfo update = at(1, shown);
  update.name = "display_update";
  update.initial = 2;
  update.fields = display_update_fields;
  update.description = "Writing it shows what the following entries refer to.";
  EntryInfo first = at(2, shown);
  first.initial = layout.show(0x610C, 1);
  EntryInfo second = optional_at(3, 3, shown);
  second.first_number = 2;
  second.initial = layout.show(0x6112, 1);
  EntryInfo others = optional_at(4, 254, shown);
  others.first_number = 3;
  return {entries_within(2, 254), update, first, second, others};
}
inline constexpr auto display_mapping_entries =
    display_entries(display_by_bit_number, display_mapping_fields);
inline constexpr auto display_mapping_entries_reversed =
    display_entries(display_by_byte_order, display_mapping_fields_reversed);
/// 6203h with these entries.
constexpr ObjectInfo display_mapping(const Items<EntryInfo>& entries) {
  return array(0x6203, "display_mapping", "9.2.8.4",
               "What is shown, and how: texts and files by their index and sub-index.", entries,
               "74, 75, 76, 79");
}
inline constexpr ObjectInfo display_mapping_object = display_mapping(display_mapping_entries);
/// For devices of makers that took the figure as the order of the bytes on the wire.
inline constexpr ObjectInfo display_mapping_object_reversed =
    display_mapping(display_mapping_entries_reversed);

/// Whether passengers have requested a stop (6204h).
enum class BusStop : std::uint8_t { not_requested = 0, requested = 1 };
inline constexpr NamedValue bus_stop_requests[] = {
    {BusStop::not_requested, "bus stop not requested"}, {BusStop::requested, "bus stop requested"}};
inline constexpr auto bus_stop_request_object = variable(
    0x6204, "bus_stop_request", "9.2.8.5", "A passenger wants to get off at the next stop.",
    entry(boolean, ro, optional, 0, bus_stop_requests), {.errata = "28"});

inline constexpr NamedValue character_sets[] = {
    {0x0, "ISO 646-US"},
    {0x1, "ISO 8859-1"},
    {0x2, "ISO 8859-2"},
    {0x3, "ISO 8859-3"},
    {0x4, "ISO 8859-4"},
    {0x5, "ISO 8859-5"},
    {0x6, "ISO 8859-6"},
    {0x7, "ISO 8859-7"},
    {0x8, "ISO 8859-8"},
    {0x9, "ISO 8859-9"},
    {0xA, "ISO 8859-10"},
    {0xB, "ISO 8859-11"},
    {0xC, 0xC, "reserved, since there is no ISO 8859-12", Meaning::reserved},
    {0xD, "ISO 8859-13"},
    {0xE, "ISO 8859-14"},
    {0xF, "ISO 8859-15"},
    {0x0010, 0x7FFF, "reserved", Meaning::reserved},
    {0x8000, 0xFFFF, "manufacturer-specific character set", Meaning::manufacturer},
};
inline constexpr EntryInfo character_set = entry(unsigned16, ro, no, {}, character_sets);
/// 6205h: the selected character set, and up to 253 others that the device offers.
constexpr std::array<EntryInfo, 5> make_character_set_entries() {
  EntryInfo selected = at(1, character_set);
  selected.name = "selected_character_set";
  selected.access = Access::rw;
  selected.initial = 0;
  EntryInfo first = optional_at(2, 2, character_set);
  first.name = "1st additional available character set";
  EntryInfo others = optional_at(3, 253, character_set);
  others.name = "additional available character set #";
  others.first_number = 2;
  EntryInfo last = optional_at(254, 254, character_set);
  last.name = "253rd additional available character set";
  return {entries_within(1, 254), selected, first, others, last};
}
inline constexpr auto character_set_entries = make_character_set_entries();
inline constexpr auto character_set_object =
    array(0x6205, "character_set", "9.2.8.6", "The character set of 610Ch, 610Dh and 6112h.",
          character_set_entries, "29, 77");

}  // namespace canvoy::cia407
