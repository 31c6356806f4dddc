// Faults of devices of CiA 407 that `canvoy device` runs: of outputs and of the power supply, by
// error code, and whether radios are connected (CiA 407, 7.3). A supply or a radio is selected by
// the code alone.
//
//     ReportedErrors errors;
//     errors.join(environment);
//     errors.act(parse_bus_press(units, "fail:0x3110@2s"));
#pragma once

#include <cstdint>
#include <set>

#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class ReportedErrors {
 public:
  ReportedErrors() = default;
  ReportedErrors(const ReportedErrors&) = delete;
  ReportedErrors& operator=(const ReportedErrors&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `fail`, `mend`, `connect`, `disconnect`; ignores others.
  void act(const BusPress& press);

  /// True if outputs or the supply have this error: both use the same codes, and fail together.
  bool has(std::uint16_t code) const { return errors_.contains(code); }

 private:
  template <cia407::DeviceCode code>
  cia407::CodeOnlyHardware<code> radio();
  bool is_disconnected(std::uint16_t /*code*/) { return is_disconnected_; }
  cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply> supply();

  std::set<std::uint16_t> errors_;
  bool is_disconnected_ = false;  ///< all radios
};

}  // namespace canvoy::tools
