// Objects of CiA 407 that the diagnostics device provides: 6740h to 6744h (9.2.27). Other devices
// report errors by writing to sub-index 01h.
//
//     cia407::error_class_1_messages_object.index  // 6742h
#pragma once

#include "canvoy/profiles/cia407/values.hpp"

namespace canvoy::cia407 {

/// Sub-index 00h of a history: the number of errors in it. Writing deletes errors (errata 86, 89).
constexpr EntryInfo number_of_reports(std::string_view name, Mapping mapping,
                                      std::string_view errata, std::string_view description) {
  return sub_index(0, name, entry(unsigned8, rw, mapping, {}, {.limits = within(0, 254)}),
                   {.errata = errata, .description = description});
}
/// Sub-index 01h, which reporting devices write, and the others, which they do not write.
constexpr std::array<EntryInfo, 3> reports(const EntryInfo& number, EntryInfo shape) {
  shape.consumer_access = Access::wo;
  std::array<EntryInfo, 3> entries = one_or_more(number, shape, 254);
  entries[1].access = Access::rw;
  entries[1].access_by_device = false;
  return entries;
}

inline constexpr FieldInfo short_error_fields[] = {
    field(0, 16, "error code", {.notation = Notation::hexadecimal}),
    field(16, 16, "device code", {.notation = Notation::hexadecimal},
          "Which device; how devices are numbered is the system's choice."),
};
inline constexpr auto short_diagnostic_error_field_entries = reports(
    number_of_reports("number_of_errors", Mapping::optional, "86, 88",
                      "Writing 0 deletes all; other values are refused (0609 0030h)."),
    sub_index(
        0, "short_error_field_#",
        entry(unsigned32, ro, no, {}, {.notation = Notation::hexadecimal}, short_error_fields),
        {.errata = "87"}));
inline constexpr auto short_diagnostic_error_field_object =
    array(0x6740, "short_diagnostic_error_field", "9.2.27.1",
          "The history of errors of devices and of error inputs: the newest first.",
          short_diagnostic_error_field_entries, "41, 86, 87, 88");

inline constexpr ObjectInfo extended_diagnostic_message_file_object = {
    .index = 0x6741,
    .name = "extended_diagnostic_message_file",
    .category = Category::conditional,
    .condition = by_virtual_device,
    .clause = "9.2.27.2",
    .errata = "91, 92",
    .description =
        "Lines of 7-bit ASCII: all messages since a 0 was written to it; other values "
        "are refused (0609 0030h).",
    .entry = {.type = DataType::domain,
              .access = Access::rw,
              .consumer_access = Access::wo,
              .access_by_device = true}};

/// Three objects of one shape.
inline constexpr auto error_class_entries = reports(
    number_of_reports("number_of_messages", Mapping::no, "89",
                      "Writing 0 deletes what was read, 1 all; more is refused (0609 0030h)."),
    {.name = "message_#",
     .type = DataType::octet_string,
     .access_by_device = true,
     .capacity = 64,
     .capacity_is_printed = true,
     .errata = "90",
     .description = "7-bit ASCII; zeros behind the end."});
/// An array of messages of one class, 64 octets each.
constexpr ObjectInfo error_class(std::uint16_t index, std::string_view name,
                                 std::string_view clause, std::string_view description) {
  return array(index, name, clause, description, error_class_entries, "42, 89, 90, 106");
}
inline constexpr ObjectInfo error_class_1_messages_object =
    error_class(0x6742, "error_class_1_messages", "9.2.27.3",
                "Diagnostic messages of error class 1, in the order in which they came.");
inline constexpr ObjectInfo error_class_2_messages_object =
    error_class(0x6743, "error_class_2_messages", "9.2.27.4",
                "Diagnostic messages of error class 2, in the order in which they came.");
inline constexpr ObjectInfo error_class_3_messages_object =
    error_class(0x6744, "error_class_3_messages", "9.2.27.5",
                "Diagnostic messages of error class 3, in the order in which they came.");

}  // namespace canvoy::cia407
