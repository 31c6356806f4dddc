#include "canvoy/tools/device/bus/bus_console.hpp"

#include <fmt/format.h>

#include "canvoy/tools/device/bus/bus_words.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t bit_of_key(unsigned number) {
  return std::uint32_t{1} << (number - 1);
}

std::string driver_view_words(const cia407::DriverView& view) {
  std::string text =
      fmt::format("{}, doors {}", clock_words(view.time), view.has_open_door ? "open" : "not open");
  if (view.left_released || view.right_released) {
    text += fmt::format(", released{}{}", view.left_released ? " left" : "",
                        view.right_released ? " right" : "");
  }
  if (view.ambient_celsius) text += fmt::format(", {:.1f} C outside", *view.ambient_celsius);
  if (view.coolant_celsius) text += fmt::format(", engine {:.0f} C", *view.coolant_celsius);
  if (view.fuel_rate_l_per_h) text += fmt::format(", {:.1f} l/h", *view.fuel_rate_l_per_h);
  if (view.average_economy_km_per_l) {
    text += fmt::format(", {:.1f} km/l on average", *view.average_economy_km_per_l);
  }
  if (view.engine_hours) text += fmt::format(", engine {:.1f} h", *view.engine_hours);
  if (view.is_braking) text += ", braking";
  if (view.last_error != 0) text += fmt::format(", error {:08X}h", view.last_error);
  return text;
}

}  // namespace

void BusConsole::join(Environment& environment) {
  environment.provide(callback<&BusConsole::keyboard>(*this));
  environment.provide(callback<&BusConsole::indicator>(*this));
}

void BusConsole::act(const BusPress& press) {
  if (press.what == "key") {
    const unsigned number = press.number().value_or(0);
    keys_ |= bit_of_key(number);
    release_at_[number] = clock_() + key_time;
  } else if (press.what == "reverse" || press.what == "forward") {
    is_reverse_ = press.what == "reverse";
  }
}

void BusConsole::step(Time now) {
  std::erase_if(release_at_, [&](const auto& key) {
    const bool is_over = now >= key.second;
    if (is_over) keys_ &= ~bit_of_key(key.first);
    return is_over;
  });
}

cia407::KeyboardHardware BusConsole::keyboard() {
  return {.keys = callback<&BusConsole::keys>(*this),
          .is_reverse_engaged = callback<&BusConsole::is_reverse>(*this)};
}

cia407::DriverIndicatorHardware BusConsole::indicator() {
  return {.show = callback<&BusConsole::show>(*this)};
}

void BusConsole::show(const cia407::DriverView& view) {
  const std::string text = driver_view_words(view);
  if (text == told_) return;
  told_ = text;
  output_.say("driver-display", text);
}

}  // namespace canvoy::tools
