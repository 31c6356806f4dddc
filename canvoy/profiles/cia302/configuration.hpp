// Descriptions of the objects of a configuration manager, 1F20h to 1F27h (CiA 302-3).
//
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::configuration());
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/device_description.hpp"

namespace canvoy::cia302 {

/// Of arrays with one entry for each slave.
inline constexpr EntryInfo last_slave = {
    .name = "Highest sub-index supported", .access = Access::const_, .initial = highest_sub()};

inline constexpr EntryInfo store_dcf_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "DCF of slave",
     .type = DataType::domain,
     .access = Access::rw},
};
inline constexpr ObjectInfo store_dcf_object = {
    .index = 0x1F20,
    .code = ObjectCode::array,
    .name = "Store DCF",
    .category = Category::optional,
    .clause = "302-3",
    .description = "The device configuration file of each slave, sub-index is node-ID.",
    .subs = store_dcf_entries};

inline constexpr NamedValue dcf_formats[] = {{0, "ASCII, not compressed"}};
inline constexpr EntryInfo dcf_format_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Format of the DCF of slave",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = dcf_formats}},
};
inline constexpr ObjectInfo dcf_format_object = {.index = 0x1F21,
                                                 .code = ObjectCode::array,
                                                 .name = "DCF storage format",
                                                 .category = Category::conditional,
                                                 .condition = "if 1F20h is supported",
                                                 .clause = "302-3",
                                                 .subs = dcf_format_entries};

inline constexpr EntryInfo concise_dcf_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Concise DCF of slave",
     .type = DataType::domain,
     .access = Access::rw},
};
inline constexpr ObjectInfo concise_dcf_object = {
    .index = 0x1F22,
    .code = ObjectCode::array,
    .name = "Concise DCF",
    .category = Category::optional,
    .clause = "302-3",
    .description =
        "A count (UNSIGNED32), then for each entry its index (UNSIGNED16), sub-index (UNSIGNED8), "
        "size in bytes (UNSIGNED32) and value.",
    .subs = concise_dcf_entries};

inline constexpr EntryInfo slave_eds_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "EDS of slave",
     .type = DataType::domain,
     .access = Access::rw},
};
inline constexpr ObjectInfo slave_eds_object = {.index = 0x1F23,
                                                .code = ObjectCode::array,
                                                .name = "Store EDS of slaves",
                                                .category = Category::optional,
                                                .clause = "302-3",
                                                .subs = slave_eds_entries};

inline constexpr EntryInfo slave_eds_format_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Format of the EDS of slave",
     .access = Access::rw,
     .initial = 0,
     .value = {.names = dcf_formats}},
};
inline constexpr ObjectInfo slave_eds_format_object = {.index = 0x1F24,
                                                       .code = ObjectCode::array,
                                                       .name = "EDS storage format",
                                                       .category = Category::conditional,
                                                       .condition = "if 1F23h is supported",
                                                       .clause = "302-3",
                                                       .subs = slave_eds_format_entries};

inline constexpr EntryInfo configure_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Configure slave",
     .type = DataType::unsigned32,
     .access = Access::wo,
     .initial = 0,
     .value = cia301::code,
     .description = "The signature \"conf\" (666E6F63h) starts it."},
    {.sub_first = 128,
     .name = "Configure all slaves",
     .type = DataType::unsigned32,
     .access = Access::wo,
     .initial = 0,
     .value = cia301::code},
};
inline constexpr ObjectInfo configure_object = {.index = 0x1F25,
                                                .code = ObjectCode::array,
                                                .name = "Configure slaves",
                                                .category = Category::optional,
                                                .clause = "302-3",
                                                .subs = configure_entries};

inline constexpr EntryInfo expected_date_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Configuration date expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = {.unit = Unit::day},
     .description = "Days since 1 January 1984; 0: any."},
};
inline constexpr ObjectInfo expected_date_object = {.index = 0x1F26,
                                                    .code = ObjectCode::array,
                                                    .name = "Expected configuration date",
                                                    .category = Category::optional,
                                                    .clause = "302-3",
                                                    .subs = expected_date_entries};

inline constexpr EntryInfo expected_time_entries[] = {
    last_slave,
    {.sub_first = 1,
     .sub_last = 127,
     .name = "Configuration time expected of slave",
     .type = DataType::unsigned32,
     .access = Access::rw,
     .initial = 0,
     .value = cia301::milliseconds,
     .description = "Since midnight; 0: any."},
};
inline constexpr ObjectInfo expected_time_object = {.index = 0x1F27,
                                                    .code = ObjectCode::array,
                                                    .name = "Expected configuration time",
                                                    .category = Category::optional,
                                                    .clause = "302-3",
                                                    .subs = expected_time_entries};

/// What a configuration manager needs: 1F22h and 1F25h to 1F27h.
constexpr auto configuration() {
  DeviceDescription<4> parts;
  parts.add(concise_dcf_object);
  parts.add(configure_object);
  parts.add(expected_date_object);
  parts.add(expected_time_object);
  return parts;
}

/// What it needs beside, where tools store DCFs and EDS in it: 1F20h, 1F21h, 1F23h and 1F24h.
constexpr auto stored_configuration() {
  DeviceDescription<4> parts;
  parts.add(store_dcf_object);
  parts.add(dcf_format_object);
  parts.add(slave_eds_object);
  parts.add(slave_eds_format_object);
  return parts;
}

}  // namespace canvoy::cia302
