// Descriptions of the objects of program download, 1F50h to 1F57h (CiA 302-3).
//
//     constexpr auto my_bootloader = describe(cia301::device_type(0), cia302::programs(1));
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::expected_programs());
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::cia302 {

/// Of arrays with one entry for each program, or for each slave.
inline constexpr EntryInfo last_program = {
    .name = "Highest sub-index supported", .access = Access::const_, .initial = highest_sub()};

inline constexpr EntryInfo program_data_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Program",
     .type = DataType::domain,
     .access = Access::wo},
};
inline constexpr ObjectInfo program_data_object = {
    .index = 0x1F50,
    .code = ObjectCode::array,
    .name = "Program data",
    .category = Category::optional,
    .clause = "302-3",
    .description = "Downloads a program; sub-index is its number.",
    .subs = program_data_entries};

inline constexpr NamedValue program_controls[] = {
    {0, "stop"}, {1, "start"}, {2, "reset"}, {3, "clear"}};
inline constexpr EntryInfo program_control_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Program control",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = program_controls},
     .description = "Read, it is 0 for a program that is stopped and 1 for one that runs."},
};
inline constexpr ObjectInfo program_control_object = {.index = 0x1F51,
                                                      .code = ObjectCode::array,
                                                      .name = "Program control",
                                                      .category = Category::conditional,
                                                      .condition = "if 1F50h is supported",
                                                      .clause = "302-3",
                                                      .subs = program_control_entries};

inline constexpr EntryInfo verify_program_entries[] = {
    last_program, cia301::date_entry("Application software date"),
    cia301::time_entry("Application software time")};
inline constexpr ObjectInfo verify_program_object = {.index = 0x1F52,
                                                     .code = ObjectCode::array,
                                                     .name = "Verify application software",
                                                     .category = Category::optional,
                                                     .clause = "302-3",
                                                     .subs = verify_program_entries};

inline constexpr EntryInfo expected_program_date_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Application software date expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = {.unit = Unit::day},
     .description = "Days since 1 January 1984; 0: any."},
};
inline constexpr ObjectInfo expected_program_date_object = {
    .index = 0x1F53,
    .code = ObjectCode::array,
    .name = "Expected application software date",
    .category = Category::optional,
    .clause = "302-3",
    .subs = expected_program_date_entries};

inline constexpr EntryInfo expected_program_time_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Application software time expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = cia301::milliseconds,
     .description = "Since midnight; 0: any."},
};
inline constexpr ObjectInfo expected_program_time_object = {
    .index = 0x1F54,
    .code = ObjectCode::array,
    .name = "Expected application software time",
    .category = Category::optional,
    .clause = "302-3",
    .subs = expected_program_time_entries};

inline constexpr EntryInfo expected_identification_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Application software identification expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = cia301::code,
     .description = "0: any."},
};
inline constexpr ObjectInfo expected_identification_object = {
    .index = 0x1F55,
    .code = ObjectCode::array,
    .name = "Expected application software identification",
    .category = Category::optional,
    .clause = "302-3",
    .subs = expected_identification_entries};

inline constexpr EntryInfo program_identification_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Program software identification",
     .type = DataType::unsigned32,
     .initial = 0,
     .value = cia301::code,
     .description = "0 while there is no valid program."},
};
inline constexpr ObjectInfo program_identification_object = {
    .index = 0x1F56,
    .code = ObjectCode::array,
    .name = "Program software identification",
    .category = Category::optional,
    .clause = "302-3",
    .subs = program_identification_entries};

inline constexpr NamedValue flash_errors[] = {
    {0, "no error"},          {1, "no valid program"},
    {2, "unknown format"},    {3, "checksum or format error"},
    {4, "not cleared"},       {5, "write error"},
    {6, "address error"},     {7, "secured"},
    {63, "unspecified error"}};
inline constexpr FieldInfo flash_status_fields[] = {
    {.first_bit = 0, .name = "Busy"},
    {.first_bit = 1, .bits = 7, .name = "Error", .value = {.names = flash_errors}},
    {.first_bit = 16, .bits = 16, .name = "Manufacturer-specific"},
};
inline constexpr EntryInfo flash_status_entries[] = {
    last_program,
    {.sub_first = 1,
     .sub_last = 254,
     .name = "Flash status",
     .type = DataType::unsigned32,
     .initial = 0,
     .value = cia301::code,
     .fields = flash_status_fields},
};
inline constexpr ObjectInfo flash_status_object = {.index = 0x1F57,
                                                   .code = ObjectCode::array,
                                                   .name = "Flash status identification",
                                                   .category = Category::optional,
                                                   .clause = "302-3",
                                                   .subs = flash_status_entries};

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
