// What is wrong with devices of CiA 407 that `canvoy device` runs (7.3): with outputs and with the
// power supply, by their error codes, and whether radios are connected. Supply and radios are by
// their code alone, and have nothing else.
//
//     BusErrors errors;
//     errors.join(site);
//     errors.act(parse_bus_press(units, "fail:0x3110@2s"));
#pragma once

#include <cstdint>
#include <set>

#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"

namespace canvoy::tools {

class BusErrors {
 public:
  BusErrors() = default;
  BusErrors(const BusErrors&) = delete;
  BusErrors& operator=(const BusErrors&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// `fail`, `mend`, `connect`, `disconnect`; others do nothing.
  void act(const BusPress& press);

  /// Of outputs or of the supply: both have the same codes, and fail together.
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
