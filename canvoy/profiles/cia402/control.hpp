// State machine, modes and motor of CiA 402: see cia402.hpp for how certain they are.
//
//     cia402::controlword_object.index  // 6040h
#pragma once

#include "canvoy/profiles/cia402/shapes.hpp"

namespace canvoy::cia402 {

// State machine and modes.

inline constexpr ObjectInfo abort_connection_option_code_object =
    variable(0x6007, "Abort connection option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .value = {.names = abort_connection_option_names}},
             "What a lost connection leads to.");
inline constexpr ObjectInfo error_code_object =
    variable(0x603F, "Error code",
             {.type = DataType::unsigned16,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.notation = Notation::hexadecimal}},
             "The emergency error code of the last fault.");
inline constexpr ObjectInfo controlword_object =
    variable(0x6040, "Controlword",
             {.type = DataType::unsigned16,
              .access = Access::rw,
              .mapping = Mapping::by_default,
              .value = {.notation = Notation::hexadecimal},
              .fields = controlword_fields},
             "Moves the state machine of the drive.");
inline constexpr ObjectInfo statusword_object =
    variable(0x6041, "Statusword",
             {.type = DataType::unsigned16,
              .access = Access::ro,
              .mapping = Mapping::by_default,
              .value = {.notation = Notation::hexadecimal},
              .fields = statusword_fields},
             "The state of the drive, and whether it has arrived.");
inline constexpr ObjectInfo quick_stop_option_code_object =
    variable(0x605A, "Quick stop option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .initial = 2,
              .value = {.names = quick_stop_option_names}},
             "What the quick stop does.");
inline constexpr ObjectInfo shutdown_option_code_object =
    variable(0x605B, "Shutdown option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .initial = 0,
              .value = {.names = shutdown_option_names}},
             "From operation enabled to ready to switch on.");
inline constexpr ObjectInfo disable_operation_option_code_object =
    variable(0x605C, "Disable operation option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .initial = 1,
              .value = {.names = shutdown_option_names}},
             "From operation enabled to switched on.");
inline constexpr ObjectInfo halt_option_code_object =
    variable(0x605D, "Halt option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .initial = 1,
              .value = {.names = halt_option_names}},
             "What bit 8 of the controlword does.");
inline constexpr ObjectInfo fault_reaction_option_code_object =
    variable(0x605E, "Fault reaction option code",
             {.type = DataType::integer16,
              .access = Access::rw,
              .initial = 2,
              .value = {.names = halt_option_names}},
             "What a fault leads to.");
inline constexpr ObjectInfo modes_of_operation_object =
    variable(0x6060, "Modes of operation",
             {.type = DataType::integer8,
              .access = Access::rw,
              .mapping = Mapping::optional,
              .value = {.names = drive_mode_names}},
             "The mode that is wanted.");
inline constexpr ObjectInfo modes_of_operation_display_object =
    variable(0x6061, "Modes of operation display",
             {.type = DataType::integer8,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.names = drive_mode_names}},
             "The mode that the drive is in.");

// The motor, and what the drive can do.

inline constexpr ObjectInfo motor_type_object =
    variable(0x6402, "Motor type", {.type = DataType::unsigned16, .access = Access::rw});
inline constexpr ObjectInfo motor_catalogue_number_object =
    variable(0x6403, "Motor catalogue number",
             {.type = DataType::visible_string, .access = Access::rw, .capacity = text_capacity});
inline constexpr ObjectInfo motor_manufacturer_object =
    variable(0x6404, "Motor manufacturer",
             {.type = DataType::visible_string, .access = Access::rw, .capacity = text_capacity});
inline constexpr ObjectInfo http_motor_catalogue_address_object =
    variable(0x6405, "HTTP motor catalogue address",
             {.type = DataType::visible_string, .access = Access::rw, .capacity = text_capacity});
inline constexpr ObjectInfo motor_calibration_date_object = variable(
    0x6406, "Motor calibration date", {.type = DataType::time_of_day, .access = Access::rw});
inline constexpr ObjectInfo supported_drive_modes_object =
    variable(0x6502, "Supported drive modes",
             {.type = DataType::unsigned32,
              .access = Access::ro,
              .mapping = Mapping::optional,
              .value = {.notation = Notation::bit_mask},
              .fields = supported_mode_fields},
             "The bit of a mode is one below its number.");

}  // namespace canvoy::cia402
