// The sensors and the power stage of a CiA 419 charger. The maker of a charger implements it, or a
// plant in a simulation.
//
//     struct PowerStage {
//       void deliver(double ampere);
//       double current();
//       bool pilot_signal();
//     };
//     const ChargerHardware hardware = hardware_of(stage);
#pragma once

#include <concepts>
#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::cia419 {

struct ChargerHardware {
  /// Sets the current of the power stage, in A; 0 switches it off. Called on each change, and
  /// often.
  Callback<void(double ampere)> deliver;
  /// The present current into the battery, in A.
  Callback<double()> current;
  /// The pilot signal (CiA 419, annex B): true if a battery is plugged in.
  Callback<bool()> pilot_signal;
  /// The time of day, if the charger has a clock and sends it (4.1); may be empty.
  Callback<std::optional<TimeOfDay>()> time_of_day = {};
};

/// A class with member functions that have the names of ChargerHardware; without a clock, it has no
/// time_of_day.
template <class Stage>
concept ChargerStage = requires(Stage& stage, double ampere) {
  stage.deliver(ampere);
  { stage.current() } -> std::convertible_to<double>;
  { stage.pilot_signal() } -> std::convertible_to<bool>;
};

/// Makes hardware of such a class, which must outlive its users.
template <ChargerStage Stage>
constexpr ChargerHardware hardware_of(Stage& stage) {
  ChargerHardware hardware{
      .deliver = {[](void* self, double ampere) { static_cast<Stage*>(self)->deliver(ampere); },
                  &stage},
      .current = {[](void* self) -> double { return static_cast<Stage*>(self)->current(); },
                  &stage},
      .pilot_signal = {[](void* self) -> bool { return static_cast<Stage*>(self)->pilot_signal(); },
                       &stage}};
  if constexpr (requires { stage.time_of_day(); }) {
    hardware.time_of_day = {[](void* self) -> std::optional<TimeOfDay> {
                              return static_cast<Stage*>(self)->time_of_day();
                            },
                            &stage};
  }
  return hardware;
}

/// As those of other devices: see PlainHardware.
template <ChargerStage Stage>
constexpr void set_by_names(ChargerHardware& hardware, Stage& stage) {
  hardware = hardware_of(stage);
}

}  // namespace canvoy::cia419
