// Hardware of a device as a plain class: its member functions are found by their names, which are
// those of the callbacks of the Hardware.
//
//     struct LoadCell {
//       std::optional<double> rope_load(unsigned rope);
//     };
//     LoadCell cell;
//     Device<cia417::LoadKind<>> load(port, 13, cell, {.tare_kg = 900});
//
//     const auto hardware = hardware_of<cia417::LoadHardware>(cell);   // the same, by hand
//
// A Hardware has a function set_by_names() for it beside it. A class without a member that a device
// needs, or without any of them, does not compile; nor does one of which a member function takes or
// returns something else. A member function with overloads is not found.
#pragma once

#include <concepts>

namespace canvoy {

/// A class that may be the hardware of a device in place of `Hardware`.
template <class Plain, class Hardware>
concept PlainHardware =
    !std::convertible_to<Plain&, const Hardware&> &&
    requires(Hardware& hardware, Plain& plain) { set_by_names(hardware, plain); };

/// Makes hardware of such a class, which must outlive its users.
template <class Hardware, PlainHardware<Hardware> Plain>
constexpr Hardware hardware_of(Plain& plain) {
  Hardware hardware{};
  set_by_names(hardware, plain);
  return hardware;
}

}  // namespace canvoy
