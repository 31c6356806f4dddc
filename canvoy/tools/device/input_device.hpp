// An input device of Linux (evdev): a joystick, pedals, a keypad. It is read without waiting.
//
//     host::Result<InputDevice> stick = InputDevice::open("/dev/input/event5");
//     while (const auto event = stick->next()) take(*event);
//     if (!stick->is_there()) ...   // it was unplugged
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "canvoy/can/host/descriptor.hpp"
#include "canvoy/can/host/result.hpp"
#include "canvoy/tools/device/hand_mapping.hpp"

struct libevdev;

namespace canvoy::tools {

struct InputEvent {
  HandCode code;
  std::int32_t value = 0;
  bool is_report = false;  ///< all that happened at one time has been told
};

class InputDevice {
 public:
  static host::Result<InputDevice> open(const std::string& path);

  const std::string& name() const { return name_; }
  int descriptor() const { return file_.get(); }
  bool is_there() const { return is_there_; }
  bool has(HandCode code) const;
  /// Of an absolute axis, as the device says.
  std::int32_t least(HandCode axis) const;
  std::int32_t most(HandCode axis) const;
  /// Where an axis, button or key stands.
  std::int32_t value(HandCode code) const;
  /// Its buttons, in the order of their codes; keys of a keyboard are none.
  std::vector<HandCode> buttons() const;

  /// Nothing where nothing has happened, or the device is gone. What the kernel had no room for is
  /// made up for: the state is right again, a press in between is lost.
  std::optional<InputEvent> next();
  /// Where the device may not be written, nothing is shown.
  void light(HandCode led, bool is_on);

 private:
  struct Free {
    void operator()(libevdev* device) const;
  };

  InputDevice(host::Descriptor file, libevdev* device);

  host::Descriptor file_;
  std::unique_ptr<libevdev, Free> device_;
  std::string name_;
  bool is_there_ = true;
  bool is_behind_ = false;  ///< the kernel dropped events
};

}  // namespace canvoy::tools
