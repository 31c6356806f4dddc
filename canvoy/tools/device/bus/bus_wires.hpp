// What is wired to the generic I/O of a bus (CiA 407, 6.24) that `canvoy device` runs: switches at
// its digital inputs, and who tells what its outputs are.
//
//     BusWires wires(errors, output);
//     wires.join(site);
//     wires.act(parse_bus_press(units, "input:5@2s"));
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/bus/bus_errors.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

class BusWires {
 public:
  /// Both must outlive this.
  BusWires(const BusErrors& errors, const DeviceOutput& output)
      : errors_(errors), output_(output) {}
  BusWires(const BusWires&) = delete;
  BusWires& operator=(const BusWires&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// `input` throws a switch; others do nothing.
  void act(const BusPress& press);

 private:
  cia407::GenericIoHardware hardware();
  std::uint32_t inputs() { return inputs_; }
  void set_outputs(std::uint32_t outputs);
  void set_analogue(unsigned channel, std::int16_t value);
  bool has_error(std::uint16_t code) { return errors_.has(code); }

  const BusErrors& errors_;
  const DeviceOutput& output_;
  std::uint32_t inputs_ = 0;
  std::uint32_t outputs_ = 0;
  std::array<std::int16_t, 8> analogue_{};
};

}  // namespace canvoy::tools
