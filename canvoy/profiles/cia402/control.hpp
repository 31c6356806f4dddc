// State machine, modes and motor of CiA 402. For how certain they are, see cia402.hpp.
//
//     cia402::controlword_object.index  // 6040h
#pragma once

#include "canvoy/profiles/cia402/shapes.hpp"

namespace canvoy::cia402 {

// State machine and modes.

inline constexpr auto abort_connection_option_code_object =
    variable(0x6007, "Abort connection option code",
             entry(integer16, rw, no, {}, abort_connection_option_names),
             "What a lost connection leads to.");
inline constexpr auto error_code_object = variable(
    0x603F, "Error code", entry(unsigned16, ro, optional, {}, {.notation = Notation::hexadecimal}),
    "The emergency error code of the last fault.");
inline constexpr auto controlword_object = variable(
    0x6040, "Controlword",
    entry(unsigned16, rw, by_default, {}, {.notation = Notation::hexadecimal}, controlword_fields),
    "Moves the state machine of the drive.");
inline constexpr auto statusword_object = variable(
    0x6041, "Statusword",
    entry(unsigned16, ro, by_default, {}, {.notation = Notation::hexadecimal}, statusword_fields),
    "The state of the drive, and whether it has arrived.");
inline constexpr auto quick_stop_option_code_object =
    variable(0x605A, "Quick stop option code", entry(integer16, rw, no, 2, quick_stop_option_names),
             "What the quick stop does.");
inline constexpr auto shutdown_option_code_object =
    variable(0x605B, "Shutdown option code", entry(integer16, rw, no, 0, shutdown_option_names),
             "From operation enabled to ready to switch on.");
inline constexpr auto disable_operation_option_code_object = variable(
    0x605C, "Disable operation option code", entry(integer16, rw, no, 1, shutdown_option_names),
    "From operation enabled to switched on.");
inline constexpr auto halt_option_code_object =
    variable(0x605D, "Halt option code", entry(integer16, rw, no, 1, halt_option_names),
             "What bit 8 of the controlword does.");
inline constexpr auto fault_reaction_option_code_object =
    variable(0x605E, "Fault reaction option code", entry(integer16, rw, no, 2, halt_option_names),
             "What a fault leads to.");
inline constexpr auto modes_of_operation_object =
    variable(0x6060, "Modes of operation", entry(integer8, rw, optional, {}, drive_mode_names),
             "The mode that is wanted.");
inline constexpr auto modes_of_operation_display_object =
    variable(0x6061, "Modes of operation display",
             entry(integer8, ro, optional, {}, drive_mode_names), "The mode that the drive is in.");

// The motor and the capabilities of the drive.

inline constexpr auto motor_type_object = variable(0x6402, "Motor type", entry(unsigned16, rw));
inline constexpr auto motor_catalogue_number_object =
    variable(0x6403, "Motor catalogue number", string_entry(visible_string, rw, text_capacity));
inline constexpr auto motor_manufacturer_object =
    variable(0x6404, "Motor manufacturer", string_entry(visible_string, rw, text_capacity));
inline constexpr auto http_motor_catalogue_address_object = variable(
    0x6405, "HTTP motor catalogue address", string_entry(visible_string, rw, text_capacity));
inline constexpr auto motor_calibration_date_object =
    variable(0x6406, "Motor calibration date", entry(time_of_day, rw));
inline constexpr auto supported_drive_modes_object = variable(
    0x6502, "Supported drive modes",
    entry(unsigned32, ro, optional, {}, {.notation = Notation::bit_mask}, supported_mode_fields),
    "The bit of a mode is one below its number.");

}  // namespace canvoy::cia402
