// Handles for bits of CiA 417-4 objects that the maker of the device defines, or that depend on the
// mode of a drive. Position units are numbered from 1.
//
//     drive[cia417::manufacturer_control] = 0x1F;  // bits 11 to 15 of 6400h
#pragma once

#include "canvoy/profiles/cia417/drive.hpp"
#include "canvoy/profiles/cia417/encoder.hpp"
#include "canvoy/profiles/cia417/position.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia417 {

inline constexpr Flag<controlword_object, "", "Operation mode specific"> operation_mode_specific;
inline constexpr Number<controlword_object, "", "Manufacturer-specific"> manufacturer_control;
inline constexpr Flag<statusword_object, "", "Manufacturer-specific"> manufacturer_status;
inline constexpr Number<statusword_object, "", "Manufacturer-specific bits">
    manufacturer_status_bits;

inline constexpr Number<operating_parameter_object, "Position unit #", "Manufacturer-specific">
    manufacturer_operating_parameter;
inline constexpr Number<operating_status_object, "Position unit #", "Manufacturer-specific">
    manufacturer_operating_status;
inline constexpr Number<supported_warnings_object, "Position unit #", "Manufacturer-specific">
    manufacturer_supported_warnings;
inline constexpr Number<warnings_object, "Position unit #", "Manufacturer-specific">
    manufacturer_warnings;
inline constexpr Number<supported_alarms_object, "Position unit #", "Manufacturer-specific">
    manufacturer_supported_alarms;
inline constexpr Number<alarms_object, "Position unit #", "Manufacturer-specific">
    manufacturer_alarms;

}  // namespace canvoy::cia417
