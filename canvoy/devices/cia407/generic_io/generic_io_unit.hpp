// Generic I/O: 32 digital and 8 analogue inputs and outputs, and errors of outputs (CiA 407, 6.24,
// 7.3, 9.2.28).
//
//     GenericIoUnit io(device, {.digital_inputs = ..., .set_digital_outputs = ...}, {});
//
// Outputs are off after an NMT reset, and stay as they are when the node leaves operational.
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/error_watch.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The inputs and outputs, as wired.
struct GenericIoHardware {
  Callback<std::uint32_t()> digital_inputs = {};  ///< bit 0 is input 1
  /// `channel` is 1 to 8: two of each group.
  Callback<std::int16_t(unsigned channel)> analogue_input = {};
  Callback<void(std::uint32_t)> set_digital_outputs = {};  ///< bit 0 is output 1
  Callback<void(unsigned channel, std::int16_t value)> set_analogue_output =
      {};  ///< channel 1 to 8
  /// True if an error of outputs exists: 2310h, 2320h, 2330h.
  Callback<bool(std::uint16_t code)> has_error = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(GenericIoHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::digital_inputs; } || requires { &Plain::analogue_input; } ||
          requires { &Plain::set_digital_outputs; } || requires { &Plain::set_analogue_output; } ||
          requires { &Plain::has_error; },
      "the class has no member function of GenericIoHardware: digital_inputs, analogue_input, "
      "set_digital_outputs, set_analogue_output or has_error");
  if constexpr (requires { &Plain::digital_inputs; })
    hardware.digital_inputs = callback<&Plain::digital_inputs>(plain);
  if constexpr (requires { &Plain::analogue_input; })
    hardware.analogue_input = callback<&Plain::analogue_input>(plain);
  if constexpr (requires { &Plain::set_digital_outputs; })
    hardware.set_digital_outputs = callback<&Plain::set_digital_outputs>(plain);
  if constexpr (requires { &Plain::set_analogue_output; })
    hardware.set_analogue_output = callback<&Plain::set_analogue_output>(plain);
  if constexpr (requires { &Plain::has_error; })
    hardware.has_error = callback<&Plain::has_error>(plain);
}

class GenericIoUnit {
 public:
  static constexpr Duration period = 20ms;  ///< of readings
  static constexpr unsigned groups = 4;     ///< of eight digital inputs or outputs
  static constexpr std::uint16_t errors[] = {0x2310, 0x2320, 0x2330};  ///< of outputs, 7.3

  /// Everything to which `hardware` refers must outlive this.
  GenericIoUnit(VirtualDevice& device, const GenericIoHardware& hardware,
                const NoSettings& /*settings*/)
      : device_(device),
        hardware_(hardware),
        errors_(device, errors, hardware.has_error),
        timer_(callback<&GenericIoUnit::look>(*this)) {
    device.on_reset = callback<&GenericIoUnit::reset>(*this);
    device.react(*this, reactions());
  }

 private:
  static std::span<const AccessHandlers> reactions();
  void reset(ResetScope scope) {
    if (scope == ResetScope::node) {
      drive_digital();
      for (unsigned group = 1; group <= groups; ++group) drive_analogue(group);
    }
    look(device_.node().now());
    errors_.look(device_.node().now());
  }
  void look(Time now) {
    device_.node().timers().arm(timer_, now + period);
    if (hardware_.digital_inputs) device_.tell(digital_inputs, hardware_.digital_inputs());
    if (!hardware_.analogue_input) return;
    for (unsigned group = 1; group <= groups; ++group) {
      device_.tell(analogue_input_1(group), hardware_.analogue_input(2 * group - 1));
      device_.tell(analogue_input_2(group), hardware_.analogue_input(2 * group));
    }
  }
  void analogue_written(const Entry& entry) { drive_analogue(entry.sub); }
  void drive_digital() {
    if (hardware_.set_digital_outputs) {
      hardware_.set_digital_outputs(device_[digital_outputs].raw());
    }
  }
  void drive_analogue(unsigned group) {
    if (!hardware_.set_analogue_output) return;
    hardware_.set_analogue_output(2 * group - 1, device_[analogue_output_1(group)].raw());
    hardware_.set_analogue_output(2 * group, device_[analogue_output_2(group)].raw());
  }

  VirtualDevice& device_;
  GenericIoHardware hardware_;
  ErrorWatch errors_;
  Timer timer_;
};

inline std::span<const AccessHandlers> GenericIoUnit::reactions() {
  static constexpr AccessHandlers rows[] = {
      after_write<&GenericIoUnit::drive_digital, digital_output_object>,
      after_write<&GenericIoUnit::analogue_written, analogue_output_object>};
  return rows;
}

/// Catalogue row of the generic inputs and outputs (6.24); bus_unit makes it a part of a device.
struct GenericIoKind : BusKind<GenericIoUnit, GenericIoHardware> {
  static constexpr DeviceInfo info = {.name = "generic-io",
                                      .title = "generic inputs and outputs of a bus",
                                      .product = "Canvoy CiA 407 generic I/O",
                                      .product_code = 40723,
                                      .node_id = 23,
                                      .hardware = "digital and analogue inputs and outputs"};
  static constexpr const VirtualDeviceInfo& provides = generic_io;
  static constexpr std::array pdos = {own_pdo<inputs_tpdo>, own_pdo<analogue_inputs_tpdo>,
                                      own_pdo<outputs_rpdo>, own_pdo<analogue_outputs_rpdo>};
};

}  // namespace canvoy::cia407
