// State of an output for the hardware of an output panel unit (CiA 417-4, 4.4.1 and 4.5.4): one
// lamp, display or loudspeaker.
//
//     struct LampDriver {
//       void show(std::uint32_t output, const OutputView& view) { pins.set(output, view.level()); }
//     };
#pragma once

#include <cstdint>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

struct OutputView {
  bool on = false;        ///< data is indicated
  bool inverted = false;  ///< see level()
  bool affirmed = false;  ///< the acknowledged request is affirmed
  /// Contents: a floor (0: none), arrows, a special indication; for acknowledgements, the
  /// acknowledged function.
  std::uint8_t sub_function = 0;
  std::uint16_t flash_millihertz = 0;  ///< 0: continuous
  /// In sevenths of the height of a character per second; nothing: the display selects it.
  std::optional<std::uint8_t> scroll_rate{};
  /// See Color; nothing: the output's own colour. Other numbers are the maker's.
  std::optional<std::uint8_t> color{};
  /// Volume or intensity from 1 to 254; nothing: that of the hardware.
  std::optional<std::uint8_t> intensity{};

  /// Level of the contact if it does not flash: high or low.
  constexpr bool level() const { return on != inverted; }
  constexpr bool operator==(const OutputView&) const = default;
};

/// `output` counts from 0, in the order of the groups.
struct OutputHardware {
  /// On each change of an output.
  Callback<void(std::uint32_t output, const OutputView& view)> show;
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(OutputHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::show; }, "OutputHardware needs a member function show");
  hardware.show = callback<&Plain::show>(plain);
}

/// The times of property impulse in milliseconds, by its parameter.
inline constexpr std::uint16_t impulse_milliseconds[] = {500,  1000, 1500,   2000,
                                                         3000, 5000, 10'000, 15'000};
/// The frequencies of property flashing, by its parameter.
inline constexpr std::uint16_t flash_millihertz[] = {10'000, 7500, 5000, 2000,
                                                     1500,   1000, 500,  250};

/// Parameter 4 of an output: its basic setting.
struct BasicSetting {
  std::uint8_t flash_rate = 0xFF;   ///< in tenths of a hertz; 0 and FFh: none
  std::uint8_t scroll_rate = 0xFF;  ///< FFh: not used; also for the following
  std::uint8_t color = 0xFF;        ///< code of the profile; FFh: not used
  std::uint8_t intensity = 0xFF;    ///< 0 is reserved
};

/// How to show function data, on top of the basic setting. Property default leaves the basic
/// setting as it is; continuous is without flashing. The reserved property is taken as default.
constexpr OutputView view_of(OutputData data, const BasicSetting& basic) {
  constexpr std::uint8_t not_used = 0xFF;
  OutputView view{.on = data.status(), .affirmed = data.predicate()};
  if (basic.flash_rate != not_used) {
    view.flash_millihertz = static_cast<std::uint16_t>(basic.flash_rate * 100U);
  }
  if (basic.scroll_rate != not_used) view.scroll_rate = basic.scroll_rate;
  if (basic.color != not_used) view.color = basic.color;
  if (basic.intensity != not_used && basic.intensity != 0) view.intensity = basic.intensity;
  const std::uint8_t parameter = data.parameter();
  switch (data.property()) {
    case Property::continuous:
      view.flash_millihertz = 0;
      break;
    case Property::flashing:
      view.flash_millihertz = flash_millihertz[parameter];
      break;
    case Property::color:
      view.color = parameter;
      break;
    case Property::volume:
      // Steps 0 (lowest) to 7 (highest) of 1 to 254.
      view.intensity = static_cast<std::uint8_t>(1 + parameter * 253U / 7);
      break;
    case Property::scroll_rate:
      view.scroll_rate.reset();
      if (parameter != 0) view.scroll_rate = parameter;
      break;
    case Property::standard:
    case Property::impulse:
      break;
  }
  return view;
}

}  // namespace canvoy::cia417
