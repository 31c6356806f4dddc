// A display of a bus as it hangs there: what passengers read on it, learnt when it changes; and
// what may be wrong between the device and its lamps.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/plants/bus_display.hpp"

namespace canvoy::bus {

class ShownDisplay {
 public:
  /// Wires and memory, for tests of referees.
  struct Sabotage {
    bool is_cut = false;            ///< nothing is lit
    bool is_frozen = false;         ///< what it shows first, it shows for ever
    bool has_no_sign = false;       ///< the lamp of the stop sign is broken
    bool has_stuck_sign = false;    ///< it is lit for ever
    std::size_t octets_max = 1000;  ///< of a text
  };

  /// `changed` is called when something else is to be read; what both refer to must outlive this.
  ShownDisplay(Callback<Time()> clock, Callback<void()> changed, const Sabotage& sabotage)
      : display_({.columns = columns, .lines = lines}, clock),
        changed_(changed),
        sabotage_(sabotage) {}
  ShownDisplay(const ShownDisplay&) = delete;
  ShownDisplay& operator=(const ShownDisplay&) = delete;

  cia407::DisplayHardware hardware();
  void power_off();

  /// UTF-8, lines after each other; empty: it is dark.
  const std::string& text() const { return text_; }
  bool is_sign_lit() const {
    return sabotage_.has_stuck_sign || (!sabotage_.has_no_sign && display_.is_stop_requested());
  }
  const BusDisplay& display() const { return display_; }

 private:
  /// Room for all of a text of 128 octets.
  static constexpr std::size_t columns = 128;
  static constexpr std::size_t lines = 4;

  void show(std::span<const cia407::ShownElement> elements);
  void show_stop_request(bool is_on);

  BusDisplay display_;
  Callback<void()> changed_;
  Sabotage sabotage_;
  std::string text_;
};

}  // namespace canvoy::bus
