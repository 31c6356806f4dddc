// CiA 852: meanings of the values of functional elements, and the sub-index of each element (clause
// 9). Elements are numbered from 1.
//
//     cia852::joystick_axis_sub(2, 1)  // 04h: x-dimension of the second joystick in 6401h
#pragma once

#include "canvoy/profiles/cia401/values.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia852 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

// Maximum number of each element in an operator environment (9.1).
inline constexpr unsigned joysticks_max = 16;
inline constexpr unsigned foot_pedals_max = 16;
inline constexpr unsigned encoders_max = 8;
inline constexpr unsigned wheels_max = 8;
inline constexpr unsigned push_button_clusters_max = 8;
inline constexpr unsigned indicator_clusters_max = 8;
inline constexpr unsigned displays_max = 8;

inline constexpr unsigned joystick_axes = 3;
inline constexpr unsigned groups_of_cluster = 8;  ///< of 8 push-buttons or indicators each
inline constexpr unsigned parameters_of_display = 12;

// Sub-indices of 6000h, inputs of 8 bits.

/// Sub-index of 6000h with the held directions of a joystick.
constexpr unsigned joystick_memory_sub(unsigned joystick) {
  return 2 * joystick - 1;
}
/// Sub-index of 6000h with the buttons of a joystick.
constexpr unsigned joystick_buttons_sub(unsigned joystick) {
  return 2 * joystick;
}
/// Sub-index of 6000h with the held position of a foot pedal.
constexpr unsigned foot_pedal_memory_sub(unsigned pedal) {
  return 2 * joysticks_max + pedal;
}
/// Sub-index of the n-th 8 push-buttons of a cluster (errata 1).
constexpr unsigned push_buttons_sub(unsigned cluster, unsigned group) {
  return foot_pedal_memory_sub(foot_pedals_max) + groups_of_cluster * (cluster - 1) + group;
}

// Sub-indices of 6401h, analogue inputs of 16 bits.

/// `axis`: 1 is x, 2 is y, 3 is z.
constexpr unsigned joystick_axis_sub(unsigned joystick, unsigned axis) {
  return joystick_axes * (joystick - 1) + axis;
}
/// Sub-index of 6401h with the position of a foot pedal.
constexpr unsigned foot_pedal_position_sub(unsigned pedal) {
  return joystick_axes * joysticks_max + pedal;
}
/// Sub-index of 6401h with the position of a wheel.
constexpr unsigned wheel_position_sub(unsigned wheel) {
  return foot_pedal_position_sub(foot_pedals_max) + wheel;
}

/// The element to which a sub-index of 6000h belongs: the inverse of the functions above.
struct DigitalInputPlace {
  /// What eight digital inputs belong to.
  enum class Kind : std::uint8_t {
    joystick_memory,
    joystick_buttons,
    foot_pedal_memory,
    push_buttons
  };
  Kind kind = Kind::joystick_memory;  ///< see Kind
  unsigned element = 0;               ///< its number, from 1
  unsigned group = 0;                 ///< of push-buttons
};
/// Element of a sub-index of 6000h.
constexpr DigitalInputPlace digital_input_place(unsigned sub) {
  using Kind = DigitalInputPlace::Kind;
  if (sub < foot_pedal_memory_sub(1)) {
    return {sub % 2 != 0 ? Kind::joystick_memory : Kind::joystick_buttons, (sub + 1) / 2, 0};
  }
  if (sub < push_buttons_sub(1, 1)) {
    return {Kind::foot_pedal_memory, sub - foot_pedal_memory_sub(0), 0};
  }
  const unsigned place = sub - push_buttons_sub(1, 1);
  return {Kind::push_buttons, place / groups_of_cluster + 1, place % groups_of_cluster + 1};
}
/// The element to which a sub-index of 6401h belongs.
struct AnalogueInputPlace {
  /// What an analogue input belongs to.
  enum class Kind : std::uint8_t { joystick, foot_pedal, wheel };
  Kind kind = Kind::joystick;  ///< see Kind
  unsigned element = 0;        ///< its number, from 1
  unsigned axis = 0;           ///< of a joystick
};
/// Element of a sub-index of 6401h.
constexpr AnalogueInputPlace analogue_input_place(unsigned sub) {
  using Kind = AnalogueInputPlace::Kind;
  if (sub < foot_pedal_position_sub(1)) {
    return {Kind::joystick, (sub - 1) / joystick_axes + 1, (sub - 1) % joystick_axes + 1};
  }
  if (sub < wheel_position_sub(1)) {
    return {Kind::foot_pedal, sub - foot_pedal_position_sub(0), 0};
  }
  return {Kind::wheel, sub - wheel_position_sub(0), 0};
}

/// Sub-index in 6120h, where the lower ones stay empty (errata 15).
constexpr unsigned encoder_position_sub(unsigned encoder) {
  return 0x80 + encoder;
}

/// Sub-index of the n-th 8 indicators of a cluster in 6200h, 6206h and 6207h (errata 2, 3).
constexpr unsigned indicators_sub(unsigned cluster, unsigned group) {
  return groups_of_cluster * (cluster - 1) + group;
}

/// Distance from one display to the next in 6411h and the objects that belong to it: Table 7 can be
/// read in two ways (errata 4, 5).
inline constexpr unsigned display_pitch = parameters_of_display;
inline constexpr unsigned wide_display_pitch = 24;
/// Sub-index of 6411h with a parameter of a display.
constexpr unsigned display_sub(unsigned display, unsigned parameter,
                               unsigned pitch = display_pitch) {
  return pitch * (display - 1) + parameter;
}

// Values.

/// State of a button, push-button, indicator or memory function.
enum class Switch : std::uint8_t { off = 0, on = 1 };
inline constexpr NamedValue switch_names[] = {{Switch::off, "switched-off"},
                                              {Switch::on, "switched-on"}};
inline constexpr NamedValue memory_names[] = {{Switch::off, "off"}, {Switch::on, "on"}};

/// Figures 4, 7 and 8.
inline constexpr auto button_fields =
    repeat_field<8>({.name = "b#", .value = {.names = switch_names}});
inline constexpr auto push_button_fields =
    repeat_field<8>({.name = "pb#", .value = {.names = switch_names}});
inline constexpr auto indicator_fields =
    repeat_field<8>({.name = "i#", .value = {.names = switch_names}});
/// Fields of the error mode and the error value of indicators.
inline constexpr auto indicator_error_mode_fields =
    repeat_field<8>({.name = "i#", .value = {.names = cia401::error_mode_names}});

inline constexpr NamedValue reserved_5_names[] = {{0, "0", Meaning::padding},
                                                  {1, 0x1F, "reserved", Meaning::reserved}};
inline constexpr NamedValue reserved_7_names[] = {{0, "0", Meaning::padding},
                                                  {1, 0x7F, "reserved", Meaning::reserved}};
/// True if the joystick holds its position in a direction. A joystick with two axes has no m-z: 0b
/// (Figure 5).
inline constexpr FieldInfo joystick_memory_fields[] = {
    field(0, 1, "m-x", memory_names),
    field(1, 1, "m-y", memory_names),
    field(2, 1, "m-z", memory_names),
    field(3, 5, "reserved", reserved_5_names),
};
/// Figure 6.
inline constexpr FieldInfo foot_pedal_memory_fields[] = {
    field(0, 1, "m-x", memory_names),
    field(1, 7, "reserved", reserved_7_names),
};

/// An entry that exists where its functional element exists.
constexpr EntryInfo element(unsigned sub, unsigned number, std::string_view name,
                            const EntryInfo& like, std::string_view condition,
                            std::string_view clause) {
  EntryInfo entry = like;
  entry.sub_first = static_cast<std::uint8_t>(sub);
  entry.name = name;
  entry.first_number = static_cast<std::uint16_t>(number);
  entry.category = Category::conditional;
  entry.condition = condition;
  entry.clause = clause;
  return entry;
}
inline constexpr EntryInfo highest_sub_index =
    cia401::number_of_channels("Highest sub-index supported");

}  // namespace canvoy::cia852
