// Car doors and their light barriers: commands, states, configuration (CiA 417-4, 4.6 to 4.8).
//
//     door[cia417::door_command] = cia417::DoorCommand::open_with_limit_force;
#pragma once

#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

inline constexpr std::string_view door_name = "Door #";

// 6300h Door controlword

/// Command of a door controlword (6300h).
enum class DoorCommand : std::uint8_t {
  close_without_limit_force = 0x0,
  close_with_limit_force = 0x1,
  open_without_limit_force = 0x3,
  open_with_limit_force = 0x4,
  stop_without_limit_force = 0x7,
  stop_with_limit_force = 0x8,
  reset = 0xE,
  no_action = 0xF,
};
inline constexpr NamedValue door_command_names[] = {
    {DoorCommand::close_without_limit_force, "Close door without limit force"},
    {DoorCommand::close_with_limit_force, "Close door with limit force"},
    {0x2, "reserved", Meaning::reserved},
    {DoorCommand::open_without_limit_force, "Open door without limit force"},
    {DoorCommand::open_with_limit_force, "Open door with limit force"},
    {0x5, 0x6, "reserved", Meaning::reserved},
    {DoorCommand::stop_without_limit_force, "Stop door without limit force"},  // errata B2
    {DoorCommand::stop_with_limit_force, "Stop door with limit force"},
    {0x9, 0xD, "reserved", Meaning::reserved},
    {DoorCommand::reset, "Reset door"},
    {DoorCommand::no_action, "do not care / take no action", Meaning::do_not_care},
};

/// Speed of a door controlword (6300h).
enum class DoorVelocity : std::uint8_t { standard = 0, reduced = 1, no_action = 3 };
inline constexpr NamedValue door_velocity_names[] = {
    {DoorVelocity::standard, "Move door with standard speed"},
    {DoorVelocity::reduced, "Move door with reduced speed"},
    {2, "reserved", Meaning::reserved},
    {DoorVelocity::no_action, "do not care / take no action", Meaning::do_not_care}};
/// Setting of motion detector, finger protector and lock.
enum class Disabling : std::uint8_t { enable = 0, disable = 1, no_action = 3 };
inline constexpr NamedValue motion_detector_command_names[] = {
    {Disabling::enable, "Enable motion detector"},
    {Disabling::disable, "Disable motion detector"},
    {2, "reserved", Meaning::reserved},
    {Disabling::no_action, "do not care / take no action", Meaning::do_not_care}};
inline constexpr NamedValue finger_protector_command_names[] = {
    {Disabling::enable, "Enable finger protector"},
    {Disabling::disable, "Disable finger protector"},
    {2, "reserved", Meaning::reserved},
    {Disabling::no_action, "do not care / take no action", Meaning::do_not_care}};
inline constexpr NamedValue door_lock_command_names[] = {
    {Disabling::enable, "Enable door lock"},
    {Disabling::disable, "Disable door lock"},
    {2, "reserved", Meaning::reserved},
    {Disabling::no_action, "do not care / take no action", Meaning::do_not_care}};
/// Setting of the battery, where 0 is the other way round.
enum class Enabling : std::uint8_t { disable = 0, enable = 1, no_action = 3 };
inline constexpr NamedValue battery_power_command_names[] = {
    {Enabling::disable, "Battery power supply disabled"},
    {Enabling::enable, "Battery power supply enabled"},
    {2, "reserved", Meaning::reserved},
    {Enabling::no_action, "do not care / take no action", Meaning::do_not_care}};

inline constexpr FieldInfo door_controlword_fields[] = {
    reserved_ones<2>(0),
    field(2, 2, "Battery power", battery_power_command_names),
    field(4, 2, "Door lock", door_lock_command_names),
    field(6, 2, "Finger protector", finger_protector_command_names),
    field(8, 2, "Motion detector", motion_detector_command_names),
    field(10, 2, "Door velocity", door_velocity_names),
    field(12, 4, "Command", door_command_names)};
/// The default is printed for the consumer; the provider begins with it, too, as it takes no action
/// (errata B27).
inline constexpr EntryInfo door_controlword_entry = provided(sub_index(
    0, door_name, entry(unsigned16, ro, by_default, 0xFFFF, hexadecimal, door_controlword_fields)));
inline constexpr EntryInfo door_controlword_entries[] = {
    number_of_entries(1, door_count), at(1, door_controlword_entry),
    optional_at(2, door_count, door_controlword_entry)};
inline constexpr auto door_controlword_object = array_object(
    0x6300, "Door controlword", "4.6.1", "What the car door controller wants of each door.",
    door_controlword_entries, {.condition = see_part_2, .errata = "B2, B27"});

// 6301h Door statusword

/// State of a door statusword (6301h).
enum class DoorState : std::uint8_t {
  closed_with_torque = 0x0,
  closed_without_torque = 0x1,
  closing = 0x2,
  opened_with_torque = 0x3,
  opened_without_torque = 0x4,
  opening = 0x5,
  re_opening = 0x6,
  stopped = 0x7,
  error = 0xE,
  not_available = 0xF,
};
inline constexpr NamedValue door_state_names[] = {
    {DoorState::closed_with_torque, "Door closed with torque"},
    {DoorState::closed_without_torque, "Door closed without torque"},
    {DoorState::closing, "Closing"},
    {DoorState::opened_with_torque, "Door opened with torque"},
    {DoorState::opened_without_torque, "Door opened without torque"},
    {DoorState::opening, "Opening"},
    {DoorState::re_opening, "Re-opening"},
    {DoorState::stopped, "Stopped"},
    {0x8, 0xD, "reserved", Meaning::reserved},
    {DoorState::error, "Error indicator", Meaning::failure},
    {DoorState::not_available, "not available / not installed", Meaning::invalid},
};

/// State of a contact or detector at a door.
enum class Detection : std::uint8_t { no = 0, yes = 1, error = 2, not_available = 3 };
inline constexpr NamedValue force_limit_names[] = {
    {Detection::no, "Force limit not reached"},
    {Detection::yes, "Force limit reached"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};
inline constexpr NamedValue motion_detector_names[] = {
    {Detection::no, "Motion not detected"},
    {Detection::yes, "Motion detected"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};
inline constexpr NamedValue finger_protector_names[] = {
    {Detection::no, "No finger detected"},
    {Detection::yes, "Finger detected"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};
inline constexpr NamedValue door_lock_names[] = {
    {Detection::no, "Door not locked"},
    {Detection::yes, "Door locked"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};
inline constexpr NamedValue battery_power_names[] = {
    {Detection::no, "No battery power used"},
    {Detection::yes, "Battery power used"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};
inline constexpr NamedValue safety_contact_names[] = {
    {Detection::no, "Contact not closed"},
    {Detection::yes, "Contact closed"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available or not installed", Meaning::invalid}};

inline constexpr FieldInfo door_statusword_fields[] = {
    field(0, 2, "Safety contact", safety_contact_names),
    field(2, 2, "Battery power", battery_power_names),
    field(4, 2, "Door lock", door_lock_names),
    field(6, 2, "Finger protector", finger_protector_names),
    field(8, 2, "Motion detector", motion_detector_names),
    field(10, 2, "Force limit", force_limit_names),
    field(12, 4, "Status", door_state_names)};
inline constexpr EntryInfo door_statusword_entry = provided(sub_index(
    0, door_name, entry(unsigned16, ro, by_default, 0xFFFF, hexadecimal, door_statusword_fields)));
inline constexpr EntryInfo door_statusword_entries[] = {
    number_of_entries(1, door_count), at(1, door_statusword_entry),
    optional_at(2, door_count, door_statusword_entry)};
inline constexpr auto door_statusword_object =
    array_object(0x6301, "Door statusword", "4.7.1",
                 "What each door does, and what its contacts and detectors say.",
                 door_statusword_entries, {.condition = see_part_2, .errata = "A1, B27, C19"});

// 6302h Door position

inline constexpr NamedValue door_position_names[] = {
    {0x0000, "door is closed"}, {0xFFFF, "not available or not requested", Meaning::invalid}};
inline constexpr EntryInfo door_position_entry =
    provided(sub_index(0, door_name,
                       entry(unsigned16, ro, optional, 0xFFFF,
                             {.unit = Unit::millimetre, .names = door_position_names})));
inline constexpr EntryInfo door_position_entries[] = {
    number_of_entries(1, door_count), at(1, door_position_entry),
    optional_at(2, door_count, door_position_entry)};
inline constexpr auto door_position_object = array_object(
    0x6302, "Door position", "4.7.2", "How far the closing edges of each door are apart.",
    door_position_entries, {.condition = see_part_2, .errata = "B27"});

// 6304h to 6307h Door configuration

inline constexpr NamedValue velocity_profile_names[] = {
    {0x00, "default velocity profile"},
    {0x01, 0xFF, "manufacturer-specific velocity profile", Meaning::manufacturer}};
inline constexpr NamedValue width_profile_names[] = {
    {0x00, "default width profile"},
    {0x01, 0xFF, "manufacturer-specific width profile", Meaning::manufacturer}};  // errata B3
/// Kind of door (6304h).
enum class DoorType : std::uint8_t {
  undefined = 0x00,
  center_opening = 0x01,
  left_side_opening = 0x02,
  right_side_opening = 0x03,
};
inline constexpr NamedValue door_type_names[] = {
    {DoorType::undefined, "undefined"},
    {DoorType::center_opening, "center opening"},
    {DoorType::left_side_opening, "left side opening"},
    {DoorType::right_side_opening, "right side opening"},
    {0x04, 0xFF, "reserved", Meaning::reserved}};
/// Automatic reaction of a door. For the finger protector, `turn` means to re-close.
enum class DoorReaction : std::uint8_t { status_only = 0x00, turn = 0x01, stop = 0x02 };
inline constexpr NamedValue light_barrier_modus_names[] = {
    {DoorReaction::status_only, "sends only its status by PDO"},
    {DoorReaction::turn, "re-opens"},
    {DoorReaction::stop, "stops"},
    {0x03, 0xFF, "reserved", Meaning::reserved}};
inline constexpr NamedValue finger_protector_modus_names[] = {  // errata B14
    {DoorReaction::status_only, "sends only its status by PDO"},
    {DoorReaction::turn, "re-closes while the finger protector is active"},
    {DoorReaction::stop, "stops"},
    {0x03, 0xFF, "reserved", Meaning::reserved}};
inline constexpr NamedValue motion_detection_modus_names[] = {
    {DoorReaction::status_only, "sends only its status by PDO"},
    {DoorReaction::turn, "re-opens until no motion is detected"},
    {DoorReaction::stop, "stops"},
    {0x03, 0xFF, "reserved", Meaning::reserved}};
inline constexpr NamedValue reclose_names[] = {{0x00, "timer disabled"}};
inline constexpr ValueInfo reclose_time = {.unit = Unit::second, .names = reclose_names};
inline constexpr ValueInfo reclose_broken_time = {
    .unit = Unit::second, .scale = {.numerator = 2}, .names = reclose_names};
/// Reaction of a door to the loss of its controller (6304h:0Bh).
enum class HeartbeatLoss : std::uint8_t {
  stop_without_torque = 0x00,
  stop_with_torque = 0x01,
  close_with_reduced_speed = 0x02,
};
inline constexpr NamedValue heartbeat_loss_names[] = {
    {HeartbeatLoss::stop_without_torque, "door stops without torque"},
    {HeartbeatLoss::stop_with_torque, "door stops with torque"},
    {HeartbeatLoss::close_with_reduced_speed, "door closes with reduced speed"},
    {0x03, 0xFF, "reserved", Meaning::reserved}};

/// Errata B15: two of the settings cannot be mapped.
constexpr EntryInfo door_setting(std::uint8_t sub, std::string_view name, Mapping mapping,
                                 const ValueInfo& value, std::string_view errata = {}) {
  return sub_index(sub, name, entry(unsigned8, rw, mapping, 0x00, value),
                   {.category = Category::optional, .errata = errata});
}
inline constexpr EntryInfo door_configuration_entries[] = {
    number_of_entries(0x01, 0x0B),
    door_setting(0x01, "Door velocity profile", Mapping::no, {.names = velocity_profile_names}),
    door_setting(0x02, "Door open width profile", Mapping::optional, {.names = width_profile_names},
                 "B3"),
    door_setting(0x03, "Door type", Mapping::optional, {.names = door_type_names}),
    door_setting(0x04, "Light barrier event modus", Mapping::optional,
                 {.names = light_barrier_modus_names}),
    door_setting(0x05, "Force limit reached modus", Mapping::no,
                 {.names = light_barrier_modus_names}),
    door_setting(0x06, "Finger protector modus", Mapping::optional,
                 {.names = finger_protector_modus_names}, "B14"),
    door_setting(0x07, "Motion detection modus", Mapping::optional,
                 {.names = motion_detection_modus_names}),
    door_setting(0x08, "Light barrier reclose", Mapping::optional, reclose_time),
    door_setting(0x09, "Closing force limit reclose", Mapping::optional, reclose_time),
    door_setting(0x0A, "Light barrier broken", Mapping::optional, reclose_broken_time, "B12, B13"),
    door_setting(0x0B, "Lost of heartbeat", Mapping::optional, {.names = heartbeat_loss_names})};
inline constexpr auto door_configuration_object = array_object(
    0x6304, "Door # configuration", "4.7.3 to 4.7.6",
    "Profiles of movement, and what a door does of its own accord.", door_configuration_entries,
    {.count = door_count, .condition = see_part_2, .errata = "B15, B30, C12"});

// 6310h Light barrier status

inline constexpr NamedValue light_barrier_names[] = {
    {Detection::no, "No subject detected"},
    {Detection::yes, "Subject detected"},
    {Detection::error, "Error indicator", Meaning::failure},
    {Detection::not_available, "not available / not installed", Meaning::invalid}};
inline constexpr FieldInfo light_barrier_fields[] = {reserved_ones<6>(0),
                                                     field(6, 2, "Status", light_barrier_names)};
inline constexpr EntryInfo light_barrier_entry = provided(sub_index(
    0, door_name, entry(unsigned8, ro, by_default, 0xFF, hexadecimal, light_barrier_fields)));
inline constexpr EntryInfo light_barrier_status_entries[] = {
    number_of_entries(1, door_count), at(1, light_barrier_entry),
    optional_at(2, door_count, light_barrier_entry)};
inline constexpr auto light_barrier_status_object = array_object(
    0x6310, "Light barrier status", "4.8.1", "What the light barrier of each door sees.",
    light_barrier_status_entries, {.condition = see_part_2, .errata = "B27"});

}  // namespace canvoy::cia417
