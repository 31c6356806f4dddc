// Emergency error codes that CiA 417 adds to those of CiA 301 (CiA 417-1, 8.4).
//
//     node.raise({.code = cia417::emergency_code::light_barrier_defect, .instance = door});
#pragma once

#include <cstdint>

namespace canvoy::cia417::emergency_code {

inline constexpr std::uint16_t can_warning_level = 0x0010;
inline constexpr std::uint16_t light_barrier_defect = 0xFF01;
inline constexpr std::uint16_t finger_protector_defect = 0xFF02;
inline constexpr std::uint16_t motion_detection_defect = 0xFF03;
inline constexpr std::uint16_t application_error = 0xFF04;
inline constexpr std::uint16_t overspeed = 0xFF05;
inline constexpr std::uint16_t unintended_car_movement = 0xFF06;

}  // namespace canvoy::cia417::emergency_code
