// Errors of clause 7.3 that hardware senses: checked every 100 ms, and reported as emergencies when
// they come and go.
//
//     ErrorWatch watch(device, codes, hardware.has_error);
#pragma once

#include <span>

#include "canvoy/devices/cia407/kit/virtual_devices.hpp"

namespace canvoy::cia407 {

class ErrorWatch {
 public:
  static constexpr Duration period = 100ms;  ///< of checks

  /// Everything to which `has_error` refers must outlive this; empty: no errors.
  ErrorWatch(VirtualDevice& device, std::span<const std::uint16_t> codes,
             Callback<bool(std::uint16_t code)> has_error)
      : device_(device),
        codes_(codes),
        has_error_(has_error),
        timer_(callback<&ErrorWatch::look>(*this)) {}

  /// Checks all errors, if it is time, and reports what has changed.
  void look(Time now) {
    if (!has_error_ || codes_.empty()) return;
    device_.node().timers().arm(timer_, now + period);
    for (const std::uint16_t code : codes_) {
      device_.report(code, has_error_(code), register_bit(code));
    }
  }

 private:
  /// 2xxxh are errors of current, 3xxxh of voltage (CiA 301, 7.2.7.1).
  static constexpr std::uint8_t register_bit(std::uint16_t code) {
    switch (code >> 12) {
      case 2:
        return error_register::current;
      case 3:
        return error_register::voltage;
      default:
        return 0;
    }
  }

  VirtualDevice& device_;
  std::span<const std::uint16_t> codes_;
  Callback<bool(std::uint16_t)> has_error_;
  Timer timer_;
};

}  // namespace canvoy::cia407
