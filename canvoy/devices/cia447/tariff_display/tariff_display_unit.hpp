// The tariff display on the roof of a taxi: up to 16 lamps that are set over the bus or by discrete
// inputs, their failures, and the tariff level in up to two characters (6100h to 610Ah; CiA 447-3,
// 4.2.16).
//
//     TariffDisplayUnit display(network, {.drive = ...}, {.lamps = 3, .level_characters = 2});
//     display.lamp_failed(2, LampFailure::open_load);
//     display.set_input(1, true);
//
// The level is that of a taximeter, which writes it to 60D3h here, or that of show_level().
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::cia447 {

inline constexpr unsigned tariff_lamps_max = 16;  ///< of one display

/// The lamps.
struct TariffDisplayHardware {
  /// Lamp 1 (taxi light), 2 (vacant light), 3 (emergency light) to 16: off, on, dimmed or blinking.
  Callback<void(unsigned lamp, Lamp wanted)> drive = {};
  /// Called when the two characters of the tariff level change, with those of 610Ah.
  Callback<void(const std::array<std::uint8_t, 2>&)> show_level = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(TariffDisplayHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::drive; },
      "the class has no member function of TariffDisplayHardware: drive");
  if constexpr (requires { &Plain::drive; }) hardware.drive = callback<&Plain::drive>(plain);
}

/// Size of the display.
struct TariffDisplaySettings {
  unsigned lamps = 3;             ///< 1 to 16
  unsigned level_characters = 2;  ///< 0 to 2
  /// Has inputs that may drive the lamps of the same number.
  bool has_inputs = true;
};

class TariffDisplayUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  TariffDisplayUnit(CarNetwork& network, const TariffDisplayHardware& hardware,
                    const TariffDisplaySettings& settings);

  /// Sets an input, 1 to 16, to active or not, or to a Signal that says why it is not known.
  void set_input(unsigned input, Signal state);
  /// Reports a discrete input, counted from 1.
  void set_input(unsigned input, bool is_active) {
    set_input(input, is_active ? Signal::yes : Signal::no);
  }
  /// Reports a failure of a lamp, 1 to 16, from its driver. A broken lamp is a failure in its
  /// status.
  void lamp_failed(unsigned lamp, LampFailure failure);
  /// Shows these characters to the outside; 0 is no character.
  void show_level(std::array<char, 2> characters);

  /// State of a lamp, 1 to 16.
  Lamp lamp(unsigned number) const;

 private:
  struct OneLamp {
    Lamp commanded = Lamp::off;
    Lamp driven = Lamp::off;
    LampFailure failure = LampFailure::none;
    Signal input = Signal::no;
  };

  void reset(ResetScope scope);
  AbortCode refuses(const Commanded& wanted);
  void commanded(const Commanded& wanted);
  void level_came();
  Lamp wanted_of(const OneLamp& lamp) const;
  void follow();
  std::array<std::uint8_t, 2> shown_level() const;
  void set_level(const std::array<std::uint8_t, 2>& level);
  void tell();

  CarNetwork& network_;
  TariffDisplayHardware hardware_;
  TariffDisplaySettings settings_;
  std::array<OneLamp, tariff_lamps_max> lamps_{};
  bool by_inputs_ = false;
  bool is_powered_down_ = false;
  std::array<std::uint8_t, 2> level_ = {0xFF, 0xFF};
  Commands commands_;
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
};

/// Catalogue row of the tariff display on the roof (4.2.16); car_unit makes it a part of a device.
struct TariffDisplayKind
    : CarKind<TariffDisplayUnit, TariffDisplayHardware, TariffDisplaySettings> {
  static constexpr DeviceInfo info = {.name = "tariff-display",
                                      .title = "tariff display on the roof",
                                      .product = "Canvoy CiA 447 tariff display",
                                      .product_code = 44713,
                                      .node_id = 9,
                                      .hardware = "lamps, their drivers and inputs"};
  static constexpr const VirtualDeviceInfo& provides = tariff_display_device;
  static constexpr const ObjectInfo* consumes[] = {&taxi_trip_tariff_level_object};
};

}  // namespace canvoy::cia447
