// CiA 852: provisions for communication objects beyond CiA 301 (clause 11 and Annex A).
//
//     cia852::device_type({.joystick = true, .joystick_with_inputs = true})  // 8185'0191h
#pragma once

#include "canvoy/profiles/cia302/program.hpp"
#include "canvoy/profiles/cia401.hpp"
#include "canvoy/profiles/cia852/values.hpp"
#include "canvoy/profiles/model/rows.hpp"

namespace canvoy::cia852 {

using namespace rows;  // NOLINT(google-build-using-namespace): the columns of its tables

/// Functional elements of a device.
struct Functions {
  bool joystick = false;              ///< the device has one at least
  bool joystick_with_inputs = false;  ///< with buttons, or a memory function
  bool foot_pedal = false;            ///< the device has one at least
  bool encoder = false;               ///< the device has one at least
  bool wheel = false;                 ///< the device has one at least
  bool push_button_cluster = false;   ///< the device has one at least
  bool indicator_cluster = false;     ///< the device has one at least
  bool display = false;               ///< the device has one at least
};

// The specific functionality in 1000h: a bit for each kind of element (Table 8).
inline constexpr std::uint8_t joystick_bit = 24;
inline constexpr std::uint8_t foot_pedal_bit = 25;
inline constexpr std::uint8_t encoder_bit = 26;
inline constexpr std::uint8_t wheel_bit = 27;
inline constexpr std::uint8_t push_button_cluster_bit = 28;
inline constexpr std::uint8_t indicator_cluster_bit = 29;
inline constexpr std::uint8_t display_bit = 30;
inline constexpr std::uint8_t always_bit = 31;  ///< 1 in all rows of the table (errata 41)

/// 1000h (11.2). The I/O bits are those of CiA 401: an encoder is a digital input, a display an
/// analogue output, and any digital input sets its bit (errata 38 to 40).
constexpr std::uint32_t device_type(const Functions& functions) {
  const auto bit = [](bool set, const FieldInfo& field) {
    return set ? std::uint32_t{1} << field.first_bit : 0;
  };
  const auto function = [](bool set, std::uint8_t place) {
    return set ? std::uint32_t{1} << place : 0;
  };
  const bool digital_input = functions.joystick_with_inputs || functions.foot_pedal ||
                             functions.encoder || functions.push_button_cluster;
  const bool analogue_input = functions.joystick || functions.foot_pedal || functions.wheel;
  return cia401::profile_number | bit(digital_input, cia401::digital_input_field) |
         bit(functions.indicator_cluster, cia401::digital_output_field) |
         bit(analogue_input, cia401::analogue_input_field) |
         bit(functions.display, cia401::analogue_output_field) |
         bit(true, cia401::pdo_mapping_field) | function(functions.joystick, joystick_bit) |
         function(functions.foot_pedal, foot_pedal_bit) | function(functions.encoder, encoder_bit) |
         function(functions.wheel, wheel_bit) |
         function(functions.push_button_cluster, push_button_cluster_bit) |
         function(functions.indicator_cluster, indicator_cluster_bit) |
         function(functions.display, display_bit) | function(true, always_bit);
}
/// Bits that distinguish these devices from others of CiA 401. The bits of CiA 401 that Table 8
/// leaves out (20 to 22) are 0. Modules with several logical devices have FFFFh above the number,
/// whatever their kind (CiA 301, 7.5.2.1).
inline constexpr std::uint32_t device_type_mask = 0x80F0'FFFF;

inline constexpr NamedValue one_names[] = {{0, "reserved", Meaning::reserved}, {1, "1"}};
/// A bit of 1000h: whether the device has such elements.
constexpr FieldInfo function_field(std::uint8_t bit, std::string_view name) {
  return field(bit, 1, name, cia401::presence_names);
}
inline constexpr FieldInfo device_type_fields[] = {
    cia401::profile_field,
    cia401::digital_input_field,
    cia401::digital_output_field,
    cia401::analogue_input_field,
    cia401::analogue_output_field,
    field(cia401::pdo_mapping_field.first_bit, 1, cia401::pdo_mapping_field.name, one_names,
          "PDOs are mapped as the device has it, not as CiA 401 pre-defines it."),
    function_field(joystick_bit, "Joystick"),
    function_field(foot_pedal_bit, "Foot-pedal"),
    function_field(encoder_bit, "Encoder"),
    function_field(wheel_bit, "Wheel"),
    function_field(push_button_cluster_bit, "Push-button cluster"),
    function_field(indicator_cluster_bit, "Indicator cluster"),
    function_field(display_bit, "Display"),
    field(always_bit, 1, "Operator environment", one_names),
};

/// The object with the name that this profile gives it.
constexpr ObjectInfo named(std::string_view name, ObjectInfo object) {
  object.name = name;
  return object;
}
/// Names and categories from Table A 1.
inline constexpr std::string_view annex = "Annex A, Table A 1";
/// The object, which devices with outputs must have.
constexpr ObjectInfo for_outputs(const ObjectInfo& object) {
  return cia301::refined(object, Category::conditional, annex, {},
                         "if digital or analogue outputs are implemented");
}

inline constexpr ObjectInfo device_type_object = [] {
  ObjectInfo object =
      cia301::refined(cia301::device_type_object, Category::mandatory, "11.2", "37 to 41");
  object.description = "Which functional elements the device has.";
  object.entry.fields = device_type_fields;
  return object;
}();

inline constexpr ObjectInfo error_register_object = cia301::error_register_with_reserve("11.3");

/// All four numbers are mandatory (11.4).
inline constexpr auto identity_entries = [] {
  std::array<EntryInfo, std::size(cia301::identity_entries)> entries{};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i] = cia301::identity_entries[i];
    entries[i].category = Category::mandatory;
  }
  return entries;
}();
inline constexpr ObjectInfo identity_object = [] {
  ObjectInfo object =
      named("Identity", cia301::refined(cia301::identity_object, Category::mandatory, "11.4"));
  object.subs = identity_entries;
  return object;
}();

inline constexpr ObjectInfo sync_cob_id_object = named(
    "COB-ID SYNC", cia301::refined(cia301::sync_cob_id_object, Category::mandatory, annex, "44"));
inline constexpr auto sync_window_object =
    cia301::refined(cia301::sync_window_object, Category::optional, annex);
inline constexpr auto store_object =
    cia301::refined(cia301::store_object, Category::optional, annex);
inline constexpr auto restore_object =
    cia301::refined(cia301::restore_object, Category::optional, annex);
inline constexpr ObjectInfo emergency_cob_id_object = named(
    "COB-ID EMCY", cia301::refined(cia301::emergency_cob_id_object, Category::mandatory, annex));
inline constexpr auto emergency_inhibit_object =
    cia301::refined(cia301::emergency_inhibit_object, Category::mandatory, annex);
inline constexpr ObjectInfo consumer_heartbeat_object =
    for_outputs(cia301::consumer_heartbeat_object);
inline constexpr auto producer_heartbeat_object =
    cia301::refined(cia301::producer_heartbeat_object, Category::mandatory, annex);
inline constexpr ObjectInfo emergency_consumer_object =
    named("Emergency consumer", for_outputs(cia301::emergency_consumer_object));
inline constexpr ObjectInfo error_behavior_object =
    named("Error behavior",
          cia301::refined(cia301::error_behavior_object, Category::mandatory, "11.5", "42"));
/// Recommended for the more sophisticated modules.
inline constexpr auto program_data_object =
    cia301::refined(cia302::program_data_object, Category::optional, "11.7");

/// Table 37.
inline constexpr ErrorCodeInfo error_codes[] = {
    {0x0000, "Error reset or no error", "14"},
    {cia401::analogue_inputs_disabled.code, cia401::analogue_inputs_disabled.text, "14, 8.6",
     "Sent on the way to Operational, where 6423h is FALSE (errata 47, 48)."},
    {0x2000, "Generic current error", "14"},
    {0x3000, "Generic voltage error", "14"},
    {0x4000, "Generic temperature error", "14"},
    {0x5000, "Generic CANopen device hardware error", "14"},
    {0x6000, "Generic CANopen device software error", "14"},
    {0x7000, "Generic additional modules error", "14"},
    {0x8110, "CAN overrun (objects lost)", "14"},
    {0x8120, "CAN in error passive mode", "14"},
    {0x8140, "Recovered from bus-off", "14"},
    {0x8150, "CAN-ID collision", "14"},
    {0x8200, "Generic CANopen protocol error", "14"},
    {0x8240, "Unexpected SYNC data length", "14"},
};

}  // namespace canvoy::cia852
