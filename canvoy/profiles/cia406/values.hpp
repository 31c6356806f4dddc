// Meanings of the values of CiA 406 encoders. Profiles that have them at other indices share them.
//
//     .fields = cia406::alarm_fields
#pragma once

#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia406 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

template <unsigned bits>
inline constexpr NamedValue reserved[] = {
    {0, "0", Meaning::padding}, {1ULL, (1ULL << bits) - 1, "reserved", Meaning::reserved}};
inline constexpr NamedValue manufacturer_4[] = {
    {0, 0xF, "manufacturer-specific", Meaning::manufacturer}};

/// 6000h and 6500h.
inline constexpr NamedValue code_sequence_names[] = {{0, "clockwise"}, {1, "counter-clockwise"}};
inline constexpr NamedValue control_names[] = {{0, "disabled"}, {1, "enabled"}};
inline constexpr NamedValue direction_names[] = {{0, "forward"}, {1, "reverse"}};
inline constexpr FieldInfo operating_fields[] = {
    field(0, 1, "Code sequence", code_sequence_names, "Of rotary encoders: where values rise."),
    field(1, 1, "Commissioning diagnostic control", control_names),
    field(2, 1, "Scaling function control", control_names, "Whether 6001h and 6002h hold."),
    field(3, 1, "Measuring direction", direction_names, "Of linear encoders."),
    field(4, 8, "reserved", reserved<8>),
    field(12, 4, "Manufacturer-specific", manufacturer_4),
};

/// 6400h.
inline constexpr FieldInfo area_state_fields[] = {
    field(0, 1, "Out of range"),
    field(1, 1, "Range overflow"),
    field(2, 1, "Range underflow"),
    field(3, 5, "reserved", reserved<5>),
};

/// 6503h and 6504h. The position may be wrong.
inline constexpr FieldInfo alarm_fields[] = {
    field(0, 1, "Position error"),
    field(1, 1, "Commissioning diagnostics"),
    field(2, 10, "reserved", reserved<10>),
    field(12, 4, "Manufacturer-specific", manufacturer_4),
};
/// 6505h and 6506h. The position is valid, but a value is near its limit.
inline constexpr FieldInfo warning_fields[] = {
    field(0, 1, "Frequency exceeded"),    field(1, 1, "Light control reserve"),
    field(2, 1, "CPU watchdog status"),   field(3, 1, "Operating time limit"),
    field(4, 1, "Battery charge"),        field(5, 1, "Reference point"),
    field(6, 6, "reserved", reserved<6>), field(12, 4, "Manufacturer-specific", manufacturer_4),
};

/// 6300h to 6302h, a bit for each cam of a channel.
inline constexpr NamedValue cam_state_names[] = {{0, "inactive"}, {1, "active"}};
inline constexpr NamedValue cam_polarity_names[] = {{0, "not inverted"}, {1, "inverted"}};
inline constexpr auto cam_state_fields = repeat_field<8>(field(0, 1, "Cam #", cam_state_names));
inline constexpr auto cam_enable_fields = repeat_field<8>(field(0, 1, "Cam #", control_names));
inline constexpr auto cam_polarity_fields =
    repeat_field<8>(field(0, 1, "Cam #", cam_polarity_names));

inline constexpr ValueInfo tenths_of_an_hour = {.unit = Unit::hour, .scale = {.denominator = 10}};

/// The high word of 1000h.
inline constexpr NamedValue encoder_types[] = {
    {0x01, "single-turn absolute rotary encoder"},
    {0x02, "multi-turn absolute rotary encoder"},
    {0x03, "single-turn absolute rotary encoder with electronic turn count"},
    {0x04, "incremental rotary encoder"},
    {0x05, "incremental rotary encoder with electronic count"},
    {0x06, "incremental linear encoder"},
    {0x07, "incremental linear encoder with electronic count"},
    {0x08, "absolute linear encoder"},
    {0x09, "absolute linear encoder with cyclic coding"},
    {0x0A, "multi-sensor encoder interface"},
};

}  // namespace canvoy::cia406
