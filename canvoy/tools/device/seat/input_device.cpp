#include "canvoy/tools/device/seat/input_device.hpp"

#include <fcntl.h>
#include <libevdev/libevdev.h>

#include <cerrno>
#include <cstring>

#include "canvoy/formats/plain_text.hpp"

namespace canvoy::tools {

void InputDevice::Free::operator()(libevdev* device) const {
  libevdev_free(device);
}

InputDevice::InputDevice(host::Descriptor file, libevdev* device)
    : file_(std::move(file)),
      device_(device),
      name_(formats::plain_text(libevdev_get_name(device))) {}

host::Result<InputDevice> InputDevice::open(const std::string& path) {
  constexpr int how = O_NONBLOCK | O_CLOEXEC;
  host::Descriptor file(::open(path.c_str(), O_RDWR | how));
  // Its lights then cannot be switched.
  if (!file && (errno == EACCES || errno == EPERM || errno == EROFS)) {
    file = host::Descriptor(::open(path.c_str(), O_RDONLY | how));
  }
  if (!file) {
    return host::Error{path, std::strerror(errno),
                       errno == EACCES ? "be of the group input" : "is it plugged in?"};
  }
  libevdev* device = nullptr;
  if (libevdev_new_from_fd(file.get(), &device) < 0) {
    return host::Error{path, "this is no input device of Linux", "give one as /dev/input/event5"};
  }
  return InputDevice(std::move(file), device);
}

bool InputDevice::has(HandCode code) const {
  return libevdev_has_event_code(device_.get(), code.type, code.code) != 0;
}

std::int32_t InputDevice::least(HandCode axis) const {
  return libevdev_get_abs_minimum(device_.get(), axis.code);
}
std::int32_t InputDevice::most(HandCode axis) const {
  return libevdev_get_abs_maximum(device_.get(), axis.code);
}

std::int32_t InputDevice::value(HandCode code) const {
  return libevdev_get_event_value(device_.get(), code.type, code.code);
}

std::vector<HandCode> InputDevice::buttons() const {
  std::vector<HandCode> all;
  for (unsigned code = BTN_MISC; code < KEY_OK; ++code) {
    if (has({EV_KEY, code})) all.push_back({EV_KEY, code});
  }
  for (unsigned code = BTN_TRIGGER_HAPPY; code <= BTN_TRIGGER_HAPPY40; ++code) {
    if (has({EV_KEY, code})) all.push_back({EV_KEY, code});
  }
  return all;
}

std::optional<InputEvent> InputDevice::next() {
  while (is_there_) {
    input_event event = {};
    const unsigned how = is_behind_ ? LIBEVDEV_READ_FLAG_SYNC : LIBEVDEV_READ_FLAG_NORMAL;
    const int status = libevdev_next_event(device_.get(), how, &event);
    if (status == -EAGAIN && is_behind_) {
      is_behind_ = false;
      continue;
    }
    if (status == -EAGAIN || status == -EINTR) return std::nullopt;
    if (status < 0) {
      is_there_ = false;
      return std::nullopt;
    }
    if (status == LIBEVDEV_READ_STATUS_SYNC) is_behind_ = true;
    return InputEvent{
        {event.type, event.code}, event.value, event.type == EV_SYN && event.code == SYN_REPORT};
  }
  return std::nullopt;
}

void InputDevice::light(HandCode led, bool is_on) {
  // May fail for a device that is just being removed, or is not writable.
  libevdev_kernel_set_led_value(device_.get(), led.code,
                                is_on ? LIBEVDEV_LED_ON : LIBEVDEV_LED_OFF);
}

}  // namespace canvoy::tools
