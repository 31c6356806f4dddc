// Descriptions of the objects of a configuration manager, 1F20h to 1F27h (CiA 302-3).
//
//     constexpr auto my_manager = describe(cia301::device_type(0), cia302::configuration());
#pragma once

#include "canvoy/profiles/cia301/objects.hpp"
#include "canvoy/profiles/model/device_description.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia302 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Highest sub-index of arrays with one entry for each slave.
inline constexpr EntryInfo last_slave =
    sub_index(0, "Highest sub-index supported", entry(unsigned8, const_, no, highest_sub()));

inline constexpr EntryInfo store_dcf_entries[] = {
    last_slave,
    sub_index(1, 127, "DCF of slave", entry(domain, rw)),
};
inline constexpr auto store_dcf_object =
    array_object(0x1F20, "Store DCF", "302-3",
                 "The device configuration file of each slave, sub-index is node-ID.",
                 store_dcf_entries, {.category = Category::optional});

inline constexpr NamedValue dcf_formats[] = {{0, "ASCII, not compressed"}};
inline constexpr EntryInfo dcf_format_entries[] = {
    last_slave,
    sub_index(1, 127, "Format of the DCF of slave", entry(unsigned8, rw, no, 0, dcf_formats)),
};
inline constexpr auto dcf_format_object =
    array_object(0x1F21, "DCF storage format", "302-3", "", dcf_format_entries,
                 {.condition = "if 1F20h is supported"});

inline constexpr EntryInfo concise_dcf_entries[] = {
    last_slave,
    sub_index(1, 127, "Concise DCF of slave", entry(domain, rw)),
};
inline constexpr auto concise_dcf_object =
    array_object(0x1F22, "Concise DCF", "302-3",
                 "A count (UNSIGNED32), then for each entry its index (UNSIGNED16), sub-index "
                 "(UNSIGNED8), size in bytes (UNSIGNED32) and value.",
                 concise_dcf_entries, {.category = Category::optional});

inline constexpr EntryInfo slave_eds_entries[] = {
    last_slave,
    sub_index(1, 127, "EDS of slave", entry(domain, rw)),
};
inline constexpr auto slave_eds_object =
    array_object(0x1F23, "Store EDS of slaves", "302-3", "", slave_eds_entries,
                 {.category = Category::optional});

inline constexpr EntryInfo slave_eds_format_entries[] = {
    last_slave,
    sub_index(1, 127, "Format of the EDS of slave", entry(unsigned8, rw, no, 0, dcf_formats)),
};
inline constexpr auto slave_eds_format_object =
    array_object(0x1F24, "EDS storage format", "302-3", "", slave_eds_format_entries,
                 {.condition = "if 1F23h is supported"});

inline constexpr EntryInfo configure_entries[] = {
    last_slave,
    sub_index(1, 127, "Configure slave", entry(unsigned32, wo, no, 0, cia301::code),
              {.description = "The signature \"conf\" (666E6F63h) starts it."}),
    sub_index(128, "Configure all slaves", entry(unsigned32, wo, no, 0, cia301::code)),
};
inline constexpr auto configure_object = array_object(
    0x1F25, "Configure slaves", "302-3", "", configure_entries, {.category = Category::optional});

inline constexpr EntryInfo expected_date_entries[] = {
    last_slave,
    sub_index(1, 127, "Configuration date expected of slave",
              entry(unsigned32, rw, no, 0, {.unit = Unit::day}),
              {.description = "Days since 1 January 1984; 0: any."}),
};
inline constexpr auto expected_date_object =
    array_object(0x1F26, "Expected configuration date", "302-3", "", expected_date_entries,
                 {.category = Category::optional});

inline constexpr EntryInfo expected_time_entries[] = {
    last_slave,
    sub_index(1, 127, "Configuration time expected of slave",
              entry(unsigned32, rw, no, 0, cia301::milliseconds),
              {.description = "Since midnight; 0: any."}),
};
inline constexpr auto expected_time_object =
    array_object(0x1F27, "Expected configuration time", "302-3", "", expected_time_entries,
                 {.category = Category::optional});

/// What a configuration manager needs: 1F22h and 1F25h to 1F27h.
constexpr auto configuration() {
  DeviceDescription<4> parts;
  parts.add(concise_dcf_object);
  parts.add(configure_object);
  parts.add(expected_date_object);
  parts.add(expected_time_object);
  return parts;
}

}  // namespace canvoy::cia302
