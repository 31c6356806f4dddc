// The acoustic control manager: switches microphones and radio to loudspeakers on the events for it
// (6002h), and reports the switched paths (6001h; CiA 407, 6.9, 9.2.4; errata 19, 20).
//
//     AcousticControlManagerUnit manager(device, {.switch_paths = ...}, {});
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// Bits 1 to 5 of the event flags.
struct AudioPaths {
  bool driver_to_indoor = false;     ///< bit 1
  bool driver_to_outdoor = false;    ///< bit 2
  bool driver_to_radio = false;      ///< bit 3
  bool attendant_to_indoor = false;  ///< bit 4
  bool radio_to_indoor = false;      ///< bit 5

  /// Takes event flags apart; bits 0, 6 and 7 do not count.
  constexpr static AudioPaths of(std::uint8_t flags) {
    const auto has = [flags](unsigned bit) { return (flags >> bit & 1) != 0; };
    return {has(1), has(2), has(3), has(4), has(5)};
  }
  /// The event flags, with bits 0, 6 and 7 not set.
  constexpr std::uint8_t flags() const {
    return static_cast<std::uint8_t>(driver_to_indoor << 1 | driver_to_outdoor << 2 |
                                     driver_to_radio << 3 | attendant_to_indoor << 4 |
                                     radio_to_indoor << 5);
  }
  friend constexpr bool operator==(const AudioPaths&, const AudioPaths&) = default;
};

/// The switches of the paths.
struct AcousticControlManagerHardware {
  /// Switches, and returns the resulting paths: a path that cannot be switched stays as it was.
  Callback<AudioPaths(const AudioPaths&)> switch_paths = {};
  /// Returns the device's own state information on request.
  Callback<std::uint16_t()> state = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(AcousticControlManagerHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::switch_paths; } || requires { &Plain::state; },
      "the class has no member function of AcousticControlManagerHardware: switch_paths or state");
  if constexpr (requires { &Plain::switch_paths; })
    hardware.switch_paths = callback<&Plain::switch_paths>(plain);
  if constexpr (requires { &Plain::state; }) hardware.state = callback<&Plain::state>(plain);
}

class AcousticControlManagerUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  AcousticControlManagerUnit(VirtualDevice& device, const AcousticControlManagerHardware& hardware,
                             const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware) {
    device.on_reset = callback<&AcousticControlManagerUnit::reset>(*this);
    device.on_event = callback<&AcousticControlManagerUnit::take_event>(*this);
  }
  AcousticControlManagerUnit(const AcousticControlManagerUnit&) = delete;
  AcousticControlManagerUnit& operator=(const AcousticControlManagerUnit&) = delete;

 private:
  static constexpr std::uint8_t paths = 0b0011'1110;
  static constexpr std::uint8_t flag_state = 0b0100'0000;

  /// Disconnects all paths after a reset.
  void reset(ResetScope scope) {
    if (scope == ResetScope::node) take_event(0, 0);
  }
  void take_event(std::uint8_t flags, std::uint16_t /*information*/) {
    const AudioPaths wanted = AudioPaths::of(flags);
    const AudioPaths made = hardware_.switch_paths ? hardware_.switch_paths(wanted) : wanted;
    const bool is_asked = (flags & flag_state) != 0;
    device_.inform(is_asked && hardware_.state ? hardware_.state() : std::uint16_t{0});
    device_.signal(paths & ~made.flags(), false);
    device_.signal(made.flags(), true);
    device_.signal(flag_state, is_asked);
  }

  VirtualDevice& device_;
  AcousticControlManagerHardware hardware_;
};

/// Catalogue row of the acoustic control manager (6.9); bus_unit makes it a part of a device.
struct AcousticControlManagerKind
    : BusKind<AcousticControlManagerUnit, AcousticControlManagerHardware> {
  static constexpr DeviceInfo info = {.name = "acoustic-control-manager",
                                      .title = "acoustic control manager",
                                      .product = "Canvoy CiA 407 acoustic control",
                                      .product_code = 40708,
                                      .node_id = 10,
                                      .hardware = "switches between microphones and loudspeakers"};
  static constexpr const VirtualDeviceInfo& provides = acoustic_control_manager;
  static constexpr auto pdos = event_pdos;
};

}  // namespace canvoy::cia407
