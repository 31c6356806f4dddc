// The display of a passenger information device that `canvoy device` runs, as seen by a passenger:
// drawn on the terminal and as a picture whenever it changes, including flashing and scrolling.
//
//     DeviceBusDisplay display("next-stop-indicator-text", {.columns = 32}, "stop.png", clock,
//     output);
//     environment.provide(Callback<DisplayHardware()>::to<&DeviceBusDisplay::hardware>(display));
//     display.look();   // often
#pragma once

#include <string>
#include <vector>

#include "canvoy/sim/plants/bus_display.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

/// Reads `32x4`. Throws UsageError.
BusDisplay::Size parse_display_size(const std::string& text);

class DeviceBusDisplay {
 public:
  /// `png` is a file name, or empty; what `clock` refers to, and `output`, must outlive this.
  DeviceBusDisplay(std::string name, const BusDisplay::Size& size, std::string png,
                   Callback<Time()> clock, const DeviceOutput& output);
  DeviceBusDisplay(const DeviceBusDisplay&) = delete;
  DeviceBusDisplay& operator=(const DeviceBusDisplay&) = delete;

  cia407::DisplayHardware hardware() { return display_.hardware(); }
  /// Draws the display if it has changed. Throws Failure if the picture cannot be written.
  void look();

 private:
  std::string name_;
  BusDisplay display_;
  std::string png_;
  const DeviceOutput& output_;
  std::size_t columns_;
  std::vector<std::string> drawn_;
  bool has_sign_ = false;
};

}  // namespace canvoy::tools
