// The wires of the input/output module that `canvoy device io-401` runs: its inputs are set by
// hand, its outputs are reported.
//
//     IoWires wires(output);
//     wires.join(environment);
//     wires.set_input(5, true);
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia401/io_device.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

class IoWires {
 public:
  static constexpr unsigned digital_inputs = cia401::default_io.digital_inputs;
  static constexpr unsigned analogue_inputs = cia401::default_io.analogue_inputs;

  /// `output` must outlive this, and this must outlive the module.
  explicit IoWires(const DeviceOutput& output) : output_(output) {}
  IoWires(const IoWires&) = delete;
  IoWires& operator=(const IoWires&) = delete;

  void join(Environment& environment);
  /// Sets an input, counted from 1; the module reads it at once.
  void set_input(unsigned number, bool is_on);
  void set_analogue_input(unsigned number, std::int16_t value);

 private:
  static constexpr unsigned inputs_of_group = 8;

  cia401::IoHardware hardware();
  std::uint8_t sense(unsigned group) { return inputs_.at(group - 1); }
  /// Value of a converter: the upper 16 of 32 bits.
  std::int32_t measure(unsigned channel) { return analogue_inputs_.at(channel - 1) * 0x1'0000; }
  void drive(unsigned group, std::uint8_t outputs);
  void drive_analogue(unsigned channel, std::int32_t value);
  void look() const;

  const DeviceOutput& output_;
  cia401::IoUnit* unit_ = nullptr;
  std::array<std::uint8_t, digital_inputs / inputs_of_group> inputs_{};
  std::array<std::int16_t, analogue_inputs> analogue_inputs_{};
  std::array<std::uint8_t, 256> outputs_{};           ///< by group, as last reported
  std::array<std::int32_t, 256> analogue_outputs_{};  ///< including those of 16 bits
};

}  // namespace canvoy::tools
