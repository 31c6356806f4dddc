// Emergency error codes of CiA 407 (7.3) that the devices here raise. Others depend on the
// hardware, and the owner of a node raises them: node.raise({.code =
// bus_error::supply_voltage_too_low}).
#pragma once

#include "canvoy/canopen/protocol/error.hpp"

namespace canvoy::cia407::bus_error {

inline constexpr std::uint16_t out_of_paper = 0xFF01;         ///< of a printer
inline constexpr std::uint16_t no_signal = 0xFF02;            ///< of satellites
inline constexpr std::uint16_t no_radio_connection = 0xFF03;  ///< of a radio
/// Of a display: an object cannot be shown.
inline constexpr std::uint16_t mapping_not_supported = 0xFF04;
/// Of an announcer: none for this stop point.
inline constexpr std::uint16_t no_announcements = 0xFF05;

}  // namespace canvoy::cia407::bus_error
