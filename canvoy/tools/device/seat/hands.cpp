#include "canvoy/tools/device/seat/hands.hpp"

#include <fmt/format.h>
#include <linux/input-event-codes.h>
#include <sys/epoll.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr unsigned buttons_of_joystick = 8;

bool is_pedal(const HandAxis& axis) {
  return axis.control.kind == Control::Kind::foot_pedal;
}

/// Default mapping of a joystick: x, y and twist, or z without a twist, and the first eight
/// buttons.
HandMapping joystick_mapping(const std::string& path, const InputDevice& device,
                             unsigned joystick) {
  HandMapping mapping{.device = path};
  const HandCode twist = {EV_ABS, ABS_RZ};
  const HandCode axes[] = {
      {EV_ABS, ABS_X}, {EV_ABS, ABS_Y}, device.has(twist) ? twist : HandCode{EV_ABS, ABS_Z}};
  for (unsigned i = 0; i < std::size(axes); ++i) {
    const Control control = {Control::Kind::axis, joystick, i + 1};
    if (device.has(axes[i])) mapping.axes.push_back({axes[i], control});
  }
  unsigned button = 0;
  for (const HandCode code : device.buttons()) {
    if (button == buttons_of_joystick) break;
    mapping.buttons.push_back({code, {Control::Kind::joystick_button, joystick, ++button}});
  }
  if (mapping.axes.empty() && mapping.buttons.empty()) {
    throw UsageError(fmt::format(
        "--joystick: {} has neither axes nor buttons of a joystick: give a mapping file", path));
  }
  return mapping;
}

/// The mapping with the ranges of the device, if it has all of it. Throws Failure.
HandMapping completed(const HandMapping& wanted, const InputDevice& device) {
  HandMapping mapping = wanted;
  const auto refuse = [&wanted](HandCode code, const std::string& what) {
    throw Failure(fmt::format("{}: {}: {}", wanted.device, code_text(code), what));
  };
  for (HandAxis& axis : mapping.axes) {
    if (!device.has(axis.code)) refuse(axis.code, "the device has none");
    if (axis.code.type != EV_ABS) continue;
    axis.calibration =
        axis.calibration.completed(device.least(axis.code), device.most(axis.code), is_pedal(axis));
    if (const std::string complaint = axis.calibration.complaint(); !complaint.empty()) {
      refuse(axis.code, complaint);
    }
  }
  for (const HandButton& button : mapping.buttons) {
    if (!device.has(button.code)) refuse(button.code, "the device has none");
  }
  for (const HandLight& light : mapping.lights) {
    if (!device.has(light.code)) refuse(light.code, "the device has none");
  }
  return mapping;
}

void move_axis(SeatState& seat, const HandAxis& axis, std::int32_t value) {
  if (axis.code.type == EV_REL) {
    seat.turn(axis.control, std::int64_t{value} * axis.step);
  } else if (axis.control.kind == Control::Kind::encoder) {
    seat.set(axis.control, value);
  } else {
    seat.set(axis.control, axis.calibration.position(value));
  }
}

}  // namespace

void move_seat(SeatState& seat, const HandMapping& mapping, const InputEvent& event) {
  for (const HandAxis& axis : mapping.axes) {
    if (axis.code == event.code) move_axis(seat, axis, event.value);
  }
  for (const HandButton& button : mapping.buttons) {
    if (button.code == event.code) seat.set(button.control, event.value);
  }
}

void rest_seat(SeatState& seat, const HandMapping& mapping) {
  for (const HandAxis& axis : mapping.axes) {
    if (axis.control.kind != Control::Kind::encoder) seat.set(axis.control, 0);
  }
  for (const HandButton& button : mapping.buttons) seat.set(button.control, 0);
}

Hands::Hands(const std::vector<std::string>& inputs, const cia852::OperatorEnvironment& elements,
             SeatState& seat, const DeviceOutput& output)
    : seat_(seat), output_(output), poll_(::epoll_create1(EPOLL_CLOEXEC)) {
  std::vector<HandMapping> mappings;
  std::vector<InputDevice> devices;
  unsigned joystick = 0;
  for (const std::string& input : inputs) {
    const bool is_file = input.ends_with(".toml");
    HandMapping mapping;
    if (is_file) {
      TomlFile file(input);
      mapping = read_hand_mapping(file, elements);
    }
    const std::string& path = is_file ? mapping.device : input;
    devices.push_back(value_or_throw(InputDevice::open(path)));
    if (!is_file && ++joystick > elements.joysticks) {
      throw UsageError(fmt::format("--joystick: {} would be joystick {} of {}", input, joystick,
                                   elements.joysticks));
    }
    if (!is_file) mapping = joystick_mapping(path, devices.back(), joystick);
    mappings.push_back(std::move(mapping));
  }
  check_hand_mappings(mappings);
  for (std::size_t i = 0; i < mappings.size(); ++i) hands_.push_back({.wanted = mappings[i]});
  for (std::size_t i = 0; i < mappings.size(); ++i) {
    take_device(hands_[i], std::move(devices[i]));
    learn(hands_[i]);
  }
}

void Hands::take_device(Hand& hand, InputDevice device) {
  hand.mapping = completed(hand.wanted, device);
  hand.device = std::make_unique<InputDevice>(std::move(device));
  epoll_event event = {};
  event.events = EPOLLIN;
  if (::epoll_ctl(poll_.get(), EPOLL_CTL_ADD, hand.device->descriptor(), &event) == 0) return;
  throw Failure(fmt::format("{}: {}", hand.wanted.device, std::strerror(errno)));
}

/// Reads all present values.
void Hands::learn(Hand& hand) {
  for (const HandAxis& axis : hand.mapping.axes) {
    if (axis.code.type == EV_ABS) move_axis(seat_, axis, hand.device->value(axis.code));
  }
  for (const HandButton& button : hand.mapping.buttons) {
    seat_.set(button.control, hand.device->value(button.code));
  }
  for (const HandLight& light : hand.mapping.lights) hand.device->light(light.code, is_lit(light));
}

void Hands::serve(Time now) {
  for (Hand& hand : hands_) {
    if (!hand.is_announced) {
      hand.is_announced = true;
      output_.say("operator", fmt::format("{} is '{}'", hand.wanted.device, hand.device->name()));
    }
    if (hand.device) read(hand, now);
    if (!hand.device) look_for(hand, now);
  }
}

void Hands::read(Hand& hand, Time now) {
  while (true) {
    const std::optional<InputEvent> event = hand.device->next();
    if (!event) break;
    if (event->is_report) {
      changed_();
    } else {
      move_seat(seat_, hand.mapping, *event);
    }
  }
  if (!hand.device->is_there()) lose(hand, now);
}

void Hands::lose(Hand& hand, Time now) {
  hand.device.reset();
  hand.next_look = now + look_time;
  rest_seat(seat_, hand.mapping);
  output_.say("operator", fmt::format("{} is gone: what it moves is at rest", hand.wanted.device));
  changed_();
  lost_(number(hand), true);
}

void Hands::look_for(Hand& hand, Time now) {
  if (now < hand.next_look) return;
  hand.next_look = now + look_time;
  host::Result<InputDevice> device = InputDevice::open(hand.wanted.device);
  if (!device) return;
  try {
    take_device(hand, std::move(*device));
  } catch (const Failure&) {
    hand.device.reset();  // another device has taken its name
    return;
  }
  learn(hand);
  output_.say("operator", fmt::format("{} is back", hand.wanted.device));
  changed_();
  lost_(number(hand), false);
}

bool Hands::is_lit(const HandLight& light) const {
  return (lit_[light.cluster - 1] >> (light.indicator - 1) & 1) != 0;
}

void Hands::show(unsigned cluster, unsigned indicator, bool is_on) {
  const std::uint64_t bit = std::uint64_t{1} << (indicator - 1);
  std::uint64_t& lit = lit_[cluster - 1];
  lit = is_on ? lit | bit : lit & ~bit;
  for (const Hand& hand : hands_) {
    for (const HandLight& light : hand.mapping.lights) {
      const bool is_it = light.cluster == cluster && light.indicator == indicator;
      if (is_it && hand.device) hand.device->light(light.code, is_on);
    }
  }
}

}  // namespace canvoy::tools
