// Descriptions of the objects of program download, 1F50h to 1F57h (CiA 302-3).
//
//     constexpr auto my_bootloader = describe(cia301::device_type(0), cia302::programs(1));
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::expected_programs());
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia302 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Highest sub-index of arrays with one entry for each program, or for each slave.
inline constexpr EntryInfo last_program =
    sub_index(0, "Highest sub-index supported", entry(unsigned8, const_, no, highest_sub()));

inline constexpr EntryInfo program_data_entries[] = {
    last_program,
    sub_index(1, 254, "Program", entry(domain, wo)),
};
inline constexpr auto program_data_object =
    array_object(0x1F50, "Program data", "302-3", "Downloads a program; sub-index is its number.",
                 program_data_entries, {.category = Category::optional});

inline constexpr NamedValue program_controls[] = {
    {0, "stop"}, {1, "start"}, {2, "reset"}, {3, "clear"}};
inline constexpr EntryInfo program_control_entries[] = {
    last_program,
    sub_index(
        1, 254, "Program control", entry(unsigned8, rw, no, 0, program_controls),
        {.description = "Read, it is 0 for a program that is stopped and 1 for one that runs."}),
};
inline constexpr auto program_control_object =
    array_object(0x1F51, "Program control", "302-3", "", program_control_entries,
                 {.condition = "if 1F50h is supported"});

inline constexpr EntryInfo verify_program_entries[] = {
    last_program, cia301::date_entry("Application software date"),
    cia301::time_entry("Application software time")};
inline constexpr auto verify_program_object =
    array_object(0x1F52, "Verify application software", "302-3", "", verify_program_entries,
                 {.category = Category::optional});

inline constexpr EntryInfo expected_program_date_entries[] = {
    last_program,
    sub_index(1, 127, "Application software date expected of slave",
              entry(unsigned32, rw, no, 0, {.unit = Unit::day}),
              {.description = "Days since 1 January 1984; 0: any."}),
};
inline constexpr auto expected_program_date_object =
    array_object(0x1F53, "Expected application software date", "302-3", "",
                 expected_program_date_entries, {.category = Category::optional});

inline constexpr EntryInfo expected_program_time_entries[] = {
    last_program,
    sub_index(1, 127, "Application software time expected of slave",
              entry(unsigned32, rw, no, 0, cia301::milliseconds),
              {.description = "Since midnight; 0: any."}),
};
inline constexpr auto expected_program_time_object =
    array_object(0x1F54, "Expected application software time", "302-3", "",
                 expected_program_time_entries, {.category = Category::optional});

inline constexpr EntryInfo expected_identification_entries[] = {
    last_program,
    sub_index(1, 127, "Application software identification expected of slave",
              entry(unsigned32, rw, no, 0, cia301::code), {.description = "0: any."}),
};
inline constexpr auto expected_identification_object =
    array_object(0x1F55, "Expected application software identification", "302-3", "",
                 expected_identification_entries, {.category = Category::optional});

inline constexpr EntryInfo program_identification_entries[] = {
    last_program,
    sub_index(1, 254, "Program software identification", entry(unsigned32, ro, no, 0, cia301::code),
              {.description = "0 while there is no valid program."}),
};
inline constexpr auto program_identification_object =
    array_object(0x1F56, "Program software identification", "302-3", "",
                 program_identification_entries, {.category = Category::optional});

inline constexpr NamedValue flash_errors[] = {
    {0, "no error"},          {1, "no valid program"},
    {2, "unknown format"},    {3, "checksum or format error"},
    {4, "not cleared"},       {5, "write error"},
    {6, "address error"},     {7, "secured"},
    {63, "unspecified error"}};
inline constexpr FieldInfo flash_status_fields[] = {
    field(0, 1, "Busy"),
    field(1, 7, "Error", flash_errors),
    field(16, 16, "Manufacturer-specific"),
};
inline constexpr EntryInfo flash_status_entries[] = {
    last_program,
    sub_index(1, 254, "Flash status",
              entry(unsigned32, ro, no, 0, cia301::code, flash_status_fields)),
};
inline constexpr auto flash_status_object =
    array_object(0x1F57, "Flash status identification", "302-3", "", flash_status_entries,
                 {.category = Category::optional});

/// 1F50h to 1F52h, 1F56h and 1F57h of a device with `count` programs.
constexpr auto programs(unsigned count) {
  DeviceDescription<5> parts;
  parts.add(Part(program_data_object).up_to(count));
  parts.add(Part(program_control_object).up_to(count));
  parts.add(verify_program_object);
  parts.add(Part(program_identification_object).up_to(count));
  parts.add(Part(flash_status_object).up_to(count));
  return parts;
}

/// 1F53h to 1F55h of a manager.
constexpr auto expected_programs() {
  DeviceDescription<3> parts;
  parts.add(expected_program_date_object);
  parts.add(expected_program_time_object);
  parts.add(expected_identification_object);
  return parts;
}

}  // namespace canvoy::cia302
