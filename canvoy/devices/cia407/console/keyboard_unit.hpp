// The driver's console keyboard: up to 32 keys (6760h), and whether the reverse gear is engaged
// (66C0h; CiA 407, 6.20, 9.2.24, 9.2.28.1; errata 7).
//
//     KeyboardUnit keyboard(device, {.keys = ...}, {});
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The keys, and the lever of the gear.
struct KeyboardHardware {
  /// A bit for each pressed key.
  Callback<std::uint32_t()> keys = {};
  Callback<bool()> is_reverse_engaged = {};  ///< false: not, or not known
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(KeyboardHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::keys; } || requires { &Plain::is_reverse_engaged; },
      "the class has no member function of KeyboardHardware: keys or is_reverse_engaged");
  if constexpr (requires { &Plain::keys; }) hardware.keys = callback<&Plain::keys>(plain);
  if constexpr (requires { &Plain::is_reverse_engaged; })
    hardware.is_reverse_engaged = callback<&Plain::is_reverse_engaged>(plain);
}

class KeyboardUnit {
 public:
  static constexpr Duration period = 20ms;  ///< of readings

  /// Everything to which `hardware` refers must outlive this.
  KeyboardUnit(VirtualDevice& device, const KeyboardHardware& hardware,
               const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware), timer_(callback<&KeyboardUnit::look>(*this)) {
    device.on_reset = callback<&KeyboardUnit::reset>(*this);
  }

 private:
  void reset(ResetScope /*scope*/) { look(device_.node().now()); }
  void look(Time now) {
    device_.node().timers().arm(timer_, now + period);
    if (hardware_.keys) device_.tell(digital_inputs, hardware_.keys());
    const bool is_reverse = hardware_.is_reverse_engaged && hardware_.is_reverse_engaged();
    device_.tell(flag_direction_forward_selection,
                 is_reverse ? ReverseGear::engaged : ReverseGear::not_engaged);
  }

  VirtualDevice& device_;
  KeyboardHardware hardware_;
  Timer timer_;
};

/// Catalogue row of the driver's console keyboard (6.20); bus_unit makes it a part of a device.
struct KeyboardKind : BusKind<KeyboardUnit, KeyboardHardware> {
  static constexpr DeviceInfo info = {.name = "console-keyboard",
                                      .title = "driver's console keyboard",
                                      .product = "Canvoy CiA 407 keyboard",
                                      .product_code = 40719,
                                      .node_id = 15,
                                      .hardware = "keys, the gear lever"};
  static constexpr const VirtualDeviceInfo& provides = drivers_console_keyboard;
  static constexpr std::array pdos = {own_pdo<inputs_tpdo>};
};

}  // namespace canvoy::cia407
