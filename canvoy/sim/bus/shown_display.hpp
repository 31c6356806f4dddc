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
  ShownDisplay(const BusDisplay::Size& size, Callback<Time()> clock, Callback<void()> changed,
               const Sabotage& sabotage)
      : display_(size, clock), changed_(changed), sabotage_(sabotage) {}
  ShownDisplay(const ShownDisplay&) = delete;
  ShownDisplay& operator=(const ShownDisplay&) = delete;

  cia407::DisplayHardware hardware();
  void power_off();

  /// What it was told to show, where that reaches its lamps: UTF-8, elements after each other, each
  /// in a line; empty: it is dark.
  const std::string& text() const { return text_; }
  /// What is read on it by its dots, in all turns, lines after each other.
  const std::u32string& reading() const { return reading_; }
  bool is_sign_lit() const {
    return sabotage_.has_stuck_sign || (!sabotage_.has_no_sign && display_.is_stop_requested());
  }
  const BusDisplay& display() const { return display_; }

 private:
  void show(std::span<const cia407::ShownElement> elements);
  void show_stop_request(bool is_on);
  void test(bool is_on);
  void look();

  BusDisplay display_;
  Callback<void()> changed_;
  Sabotage sabotage_;
  std::string text_;
  std::u32string reading_;
};

}  // namespace canvoy::bus
