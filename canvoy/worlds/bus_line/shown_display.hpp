// A display of a bus as passengers read it, reported when it changes; and faults between the device
// and its lamps.
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/plants/bus_display.hpp"

namespace canvoy::bus_line {

class ShownDisplay {
 public:
  /// Faults of wires and memory, for tests of referees.
  struct Sabotage {
    bool is_cut = false;            ///< nothing is lit
    bool is_frozen = false;         ///< the first text stays for ever
    bool has_no_sign = false;       ///< the lamp of the stop sign is broken
    bool has_stuck_sign = false;    ///< the lamp is always lit
    std::size_t octets_max = 1000;  ///< longest text
  };

  /// `changed` is called when the text on it changes. What both callbacks refer to must outlive
  /// this object.
  ShownDisplay(const BusDisplay::Size& size, Callback<Time()> clock, Callback<void()> changed,
               const Sabotage& sabotage)
      : display_(size, clock), changed_(changed), sabotage_(sabotage) {}
  ShownDisplay(const ShownDisplay&) = delete;
  ShownDisplay& operator=(const ShownDisplay&) = delete;

  /// Hardware of the display unit; valid as long as this object.
  cia407::DisplayHardware hardware();
  /// Its device has no power: it is dark.
  void power_off();

  /// Text that the display was told to show, where it reaches the lamps: UTF-8, elements one after
  /// another, each in a line; empty: it is dark.
  const std::string& text() const { return text_; }
  /// Text that its dots show in all turns, one line after another.
  const std::u32string& reading() const { return reading_; }
  /// True if passengers see the sign "stop requested".
  bool is_sign_lit() const {
    return sabotage_.has_stuck_sign || (!sabotage_.has_no_sign && display_.is_stop_requested());
  }
  /// The dots of the display.
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

}  // namespace canvoy::bus_line
