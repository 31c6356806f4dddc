// The driver's console of a bus (CiA 407) that `canvoy device` runs: its keys, its gear lever, and
// the driver's display.
//
//     BusConsole console(clock, output);
//     console.join(environment);
//     console.act(parse_bus_press(units, "key:5@2s"));
//     console.step(now);   // often
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/console/keyboard_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

class BusConsole {
 public:
  /// Time for which a key is held.
  static constexpr Duration key_time = 300ms;

  /// What `clock` refers to, and `output`, must outlive this.
  BusConsole(Callback<Time()> clock, const DeviceOutput& output) : clock_(clock), output_(output) {}
  BusConsole(const BusConsole&) = delete;
  BusConsole& operator=(const BusConsole&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);
  /// Performs `key`, `reverse`, `forward`; ignores others.
  void act(const BusPress& press);
  /// Releases held keys when their time has come.
  void step(Time now);

  bool is_reverse() const { return is_reverse_; }

 private:
  cia407::KeyboardHardware keyboard();
  std::uint32_t keys() { return keys_; }
  cia407::DriverIndicatorHardware indicator();
  void show(const cia407::DriverView& view);

  Callback<Time()> clock_;
  const DeviceOutput& output_;
  std::uint32_t keys_ = 0;
  std::map<unsigned, Time> release_at_;  ///< of the pressed keys
  bool is_reverse_ = false;
  std::string told_;  ///< last text of the display
};

}  // namespace canvoy::tools
