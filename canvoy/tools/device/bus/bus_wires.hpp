// Wiring of the generic I/O of a bus that `canvoy device` runs: switches at its digital inputs, and
// reports of its outputs (CiA 407, 6.24).
//
//     BusWires wires(errors, output);
//     wires.join(environment);
//     wires.act(parse_bus_press(units, "input:5@2s"));
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/bus/reported_errors.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

class BusWires {
 public:
  /// Both arguments must outlive this.
  BusWires(const ReportedErrors& errors, const DeviceOutput& output)
      : errors_(errors), output_(output) {}
  BusWires(const BusWires&) = delete;
  BusWires& operator=(const BusWires&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// `input` throws a switch; ignores others.
  void act(const BusPress& press);

 private:
  cia407::GenericIoHardware hardware();
  std::uint32_t inputs() { return inputs_; }
  void set_outputs(std::uint32_t outputs);
  void set_analogue(unsigned channel, std::int16_t value);
  bool has_error(std::uint16_t code) { return errors_.has(code); }

  const ReportedErrors& errors_;
  const DeviceOutput& output_;
  std::uint32_t inputs_ = 0;
  std::uint32_t outputs_ = 0;
  std::array<std::int16_t, 8> analogue_{};
};

}  // namespace canvoy::tools
