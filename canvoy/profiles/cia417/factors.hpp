// Units and scale factors of the drive of the car (CiA 417-4, 4.11.3). Values are those of CiA 402,
// at other indices.
//
//     cia417::gear_ratio_object.index  // 6416h
#pragma once

#include "canvoy/profiles/cia417/drive.hpp"

namespace canvoy::cia417 {

// 6410h to 6413h, and 0080h: a power of ten and a dimension.

inline constexpr std::uint16_t dimension_record_index = 0x0080;
inline constexpr EntryInfo dimension_record_members[] = {
    {.name = "Number of entries"},
    sub_index(1, "Notation index", entry(integer8, ro)),
    sub_index(2, "Dimension index", entry(unsigned8, ro))};

/// Power of ten, and code of the unit.
constexpr std::array<EntryInfo, 3> dimension_record(std::string_view notation,
                                                    std::string_view dimension) {
  return {number_of_entries(0x02),
          at(1, with_default(named(notation, drive_setting(DataType::integer8)), 0)),
          at(2, named(dimension, drive_setting(DataType::unsigned8, hexadecimal)))};
}
inline constexpr auto position_dimension_entries =
    dimension_record("Position notation index", "Position dimension index");
inline constexpr auto position_dimension_object =
    record_object(0x6410, "Position dimension", "4.11.3.1",
                  "As 6089h and 608Ah of CiA 402: power of ten and unit of positions.",
                  position_dimension_entries, {.category = Category::optional});
inline constexpr auto velocity_dimension_entries =
    dimension_record("Velocity notation index", "Velocity dimension index");
inline constexpr auto velocity_dimension_object =
    record_object(0x6411, "Velocity dimension", "4.11.3.2", "As 608Bh and 608Ch of CiA 402.",
                  velocity_dimension_entries, {.category = Category::optional});
inline constexpr auto acceleration_dimension_entries =
    dimension_record("Acceleration notation index", "Acceleration dimension index");
inline constexpr auto acceleration_dimension_object =
    record_object(0x6412, "Acceleration dimension", "4.11.3.3", "As 608Dh and 608Eh of CiA 402.",
                  acceleration_dimension_entries, {.category = Category::optional});
inline constexpr auto jerk_dimension_entries =
    dimension_record("Jerk notation index", "Jerk dimension index");
inline constexpr auto jerk_dimension_object =
    record_object(0x6413, "Jerk dimension", "4.11.3.4", "Power of ten and unit of jerks.",
                  jerk_dimension_entries, {.category = Category::optional, .errata = "B7"});

// 6414h to 641Dh: fractions.

/// Two numbers, 1 by default.
constexpr std::array<EntryInfo, 3> fraction(std::string_view numerator, std::string_view divisor) {
  return {
      number_of_entries(0x02),
      at(1, with_default(named(numerator, drive_setting(DataType::unsigned32, drive_amount)), 1)),
      at(2, with_default(named(divisor, drive_setting(DataType::unsigned32, drive_amount)), 1))};
}
/// One of the fractions 6414h to 641Dh.
constexpr ObjectInfo factor(std::uint16_t index, std::string_view clause, std::string_view name,
                            Items<EntryInfo> entries, std::string_view description,
                            std::string_view errata = {}) {
  return array_object(index, name, clause, description, entries,
                      {.category = Category::optional, .errata = errata});
}
inline constexpr auto position_encoder_resolution_entries =
    fraction("Encoder increments", "Motor revolutions");
inline constexpr auto velocity_encoder_resolution_entries =
    fraction("Encoder increments per second", "Motor revolutions per second");
inline constexpr auto gear_ratio_entries = fraction("Motor revolutions", "Shaft revolutions");
inline constexpr auto feed_constant_entries = fraction("Feed", "Shaft revolutions");
inline constexpr auto position_factor_entries = fraction("Numerator", "Feed constant");
inline constexpr auto factor_entries = fraction("Numerator", "Divisor");

inline constexpr ObjectInfo position_encoder_resolution_object =
    factor(0x6414, "4.11.3.5", "Position encoder resolution", position_encoder_resolution_entries,
           "As 608Fh of CiA 402.");
inline constexpr ObjectInfo velocity_encoder_resolution_object =
    factor(0x6415, "4.11.3.6", "Velocity encoder resolution", velocity_encoder_resolution_entries,
           "As 6090h of CiA 402.");
inline constexpr ObjectInfo gear_ratio_object =
    factor(0x6416, "4.11.3.7", "Gear ratio", gear_ratio_entries, "As 6091h of CiA 402.", "C5");
inline constexpr ObjectInfo feed_constant_object =
    factor(0x6417, "4.11.3.8", "Feed constant", feed_constant_entries, "As 6092h of CiA 402.");
inline constexpr ObjectInfo position_factor_object =
    factor(0x6418, "4.11.3.9", "Position factor", position_factor_entries,
           "As 6093h of CiA 402; sub-index 02h is the divisor.", "B24");
inline constexpr ObjectInfo velocity_encoder_factor_object =
    factor(0x6419, "4.11.3.10", "Velocity encoder factor", factor_entries, "As 6094h of CiA 402.");
inline constexpr ObjectInfo velocity_factor_1_object =
    factor(0x641A, "4.11.3.11", "Velocity factor 1", factor_entries, "As 6095h of CiA 402.");
inline constexpr ObjectInfo velocity_factor_2_object =
    factor(0x641B, "4.11.3.12", "Velocity factor 2", factor_entries, "As 6096h of CiA 402.");
inline constexpr ObjectInfo acceleration_factor_object =
    factor(0x641C, "4.11.3.13", "Acceleration factor", factor_entries, "As 6097h of CiA 402.");
inline constexpr ObjectInfo jerk_factor_object =
    factor(0x641D, "4.11.3.14", "Jerk factor", factor_entries,
           "Turns jerks into what the drive counts in.", "B7");

// 641Eh

inline constexpr auto polarity_object = var_object(
    0x641E, "Polarity", "4.11.3.15",
    "As 607Eh of CiA 402: whether positions and velocities change their sign.",
    entry(unsigned8, rw, no, 0x00, {.notation = Notation::bit_mask}, cia402::polarity_fields),
    {.category = Category::optional});

}  // namespace canvoy::cia417
