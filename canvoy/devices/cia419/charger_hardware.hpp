// What a CiA 419 charger senses and drives: the maker of a charger implements it, or a plant in a
// simulation.
#pragma once

#include <optional>

#include "canvoy/can/callback.hpp"
#include "canvoy/canopen/sync/time_of_day.hpp"

namespace canvoy::cia419 {

struct ChargerHardware {
  /// Sets the current that the power stage is to deliver, in A; 0 switches it off. Called on each
  /// change, and often.
  Callback<void(double ampere)> deliver;
  /// The current that flows into the battery now, in A.
  Callback<double()> current;
  /// The pilot signal (CiA 419, annex B): a battery is plugged in.
  Callback<bool()> pilot_signal;
  /// The time of day, where the charger has a clock and is to tell it (4.1); may be left empty.
  Callback<std::optional<TimeOfDay>()> time_of_day = {};
};

}  // namespace canvoy::cia419
