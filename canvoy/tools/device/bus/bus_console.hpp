// The driver's console of a bus (CiA 407) that `canvoy device` runs: its keys and its gear lever,
// and what the driver's display shows.
//
//     BusConsole console(clock, output);
//     console.join(site);
//     console.act(parse_bus_press(units, "key:5@2s"));
//     console.step(now);   // often
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/console/keyboard_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

class BusConsole {
 public:
  /// A key is held for so long.
  static constexpr Duration key_time = 300ms;

  /// What `clock` refers to, and `output`, must outlive this.
  BusConsole(Callback<Time()> clock, const DeviceOutput& output) : clock_(clock), output_(output) {}
  BusConsole(const BusConsole&) = delete;
  BusConsole& operator=(const BusConsole&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);
  /// `key`, `reverse`, `forward`; others do nothing.
  void act(const BusPress& press);
  /// Lets go the keys that were held.
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
  std::map<unsigned, Time> release_at_;  ///< of the keys that are pressed
  bool is_reverse_ = false;
  std::string told_;  ///< of the display
};

}  // namespace canvoy::tools
