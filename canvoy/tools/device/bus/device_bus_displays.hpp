// The displays of all passenger information devices of one node (CiA 407) that `canvoy device`
// runs.
//
//     DeviceBusDisplays displays(display_names(units), {.columns = 32}, "stop.png", clock, output);
//     displays.join(environment);
//     displays.look();   // often
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/devices/cia407/kit/bus_device.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/sim/plants/bus_display.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

// The display of a passenger information device that `canvoy device` runs, as seen by a passenger:
// drawn on the terminal and as a picture whenever it changes, including flashing and scrolling.
//
//     DeviceBusDisplay display("next-stop-indicator-text", {.columns = 32}, "stop.png", clock,
//     output);
//     environment.provide(Callback<DisplayHardware()>::to<&DeviceBusDisplay::hardware>(display));
//     display.look();   // often

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

/// Names of those units that have a display.
std::vector<std::string_view> display_names(std::span<const cia407::BusUnit* const> units);

class DeviceBusDisplays {
 public:
  /// All displays have one size and share one picture: `png` is a file name, or empty. What `clock`
  /// refers to, and `output`, must outlive this.
  DeviceBusDisplays(std::vector<std::string_view> names, const BusDisplay::Size& size,
                    std::string png, Callback<Time()> clock, const DeviceOutput& output)
      : names_(std::move(names)),
        size_(size),
        png_(std::move(png)),
        clock_(clock),
        output_(output) {}
  DeviceBusDisplays(const DeviceBusDisplays&) = delete;
  DeviceBusDisplays& operator=(const DeviceBusDisplays&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Draws displays that have changed. Throws Failure if the picture cannot be written.
  void look();

 private:
  cia407::DisplayHardware next();

  std::vector<std::string_view> names_;
  BusDisplay::Size size_;
  std::string png_;
  Callback<Time()> clock_;
  const DeviceOutput& output_;
  std::deque<DeviceBusDisplay> displays_;
};

}  // namespace canvoy::tools
