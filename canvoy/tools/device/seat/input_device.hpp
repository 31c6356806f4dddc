// An input device of Linux (evdev): a joystick, pedals, a keypad. Reading does not block.
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
#include "canvoy/tools/device/seat/hand_mapping.hpp"

struct libevdev;

namespace canvoy::tools {

struct InputEvent {
  HandCode code;
  std::int32_t value = 0;
  bool is_report = false;  ///< end of the events of one time
};

class InputDevice {
 public:
  static host::Result<InputDevice> open(const std::string& path);

  const std::string& name() const { return name_; }
  int descriptor() const { return file_.get(); }
  bool is_there() const { return is_there_; }
  bool has(HandCode code) const;
  /// Range of an absolute axis, as reported by the device.
  std::int32_t least(HandCode axis) const;
  std::int32_t most(HandCode axis) const;
  /// Present value of an axis, button or key.
  std::int32_t value(HandCode code) const;
  /// The buttons in order of their codes, without keys of a keyboard.
  std::vector<HandCode> buttons() const;

  /// The next event; nothing if there is none, or the device is gone. After an overflow in the
  /// kernel the state is read again; a press in between is lost.
  std::optional<InputEvent> next();
  /// Sets a light; no effect if the device is not writable.
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
