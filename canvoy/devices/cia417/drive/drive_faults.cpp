#include "canvoy/devices/cia417/drive/drive_faults.hpp"

namespace canvoy::cia417 {

namespace {

/// Of CiA 402.
constexpr std::uint16_t following_error_code = 0x8611;
/// Of CiA 301, 7.2.7: an additional module.
constexpr std::uint16_t brake_error_code = 0x7000;

}  // namespace

bool DriveFaults::add(DriveFault fault, std::uint16_t code) {
  if (has(fault)) return false;
  present_ |= bit(fault);
  if (fault == DriveFault::hardware) hardware_code_ = code;
  node_.raise(error_of(fault));
  return true;
}

void DriveFaults::end_all() {
  for (const DriveFault fault : all_drive_faults) {
    if (has(fault)) node_.clear(error_of(fault));
  }
  present_ = 0;
}

Error DriveFaults::error_of(DriveFault fault) const {
  switch (fault) {
    case DriveFault::overspeed:
      return {.code = emergency_code::overspeed};
    case DriveFault::unintended:
      return {.code = emergency_code::unintended_car_movement};
    case DriveFault::following:
      return {.code = following_error_code};
    case DriveFault::hardware:
      return {.code = hardware_code_};
    case DriveFault::brake:
      return {.code = brake_error_code};
  }
  return {};
}

}  // namespace canvoy::cia417
