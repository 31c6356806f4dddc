#include "canvoy/worlds/police/navigation_control.hpp"

#include <cstdio>

#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

constexpr std::size_t digits_max = 3;

}  // namespace

constexpr ServiceHandlers NavigationControl::service_calls = {
    .reset = method<&NavigationControl::reset>};
constexpr AccessHandlers NavigationControl::greedy_hooks[] = {
    after_write<&NavigationControl::key_written, number_pad_user_interaction_object>};
constexpr ServiceHandlers NavigationControl::greedy_calls = {.hooks = greedy_hooks};

NavigationControl::NavigationControl(CarNetwork& network, const NavigationControlHardware& hardware,
                                     const NavigationControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      terminal_(network, {.terminal = settings.terminal}),
      menu_(network, terminal_, title_of(Client::navigation)) {
  terminal_.on_number_key(
      Callback<void(NumberPadKey)>::to<&NavigationControl::number_pressed>(*this));
  network.node().attach(service_);
  if (settings.is_greedy) network.node().attach(greed_);
}

void NavigationControl::reset(ResetScope) {
  menu_.close();
  typed_.clear();
}

void NavigationControl::press_button() {
  if (menu_.is_open()) return;
  typed_.clear();
  menu_.open("to ?");
}

void NavigationControl::number_pressed(NumberPadKey key) {
  if (hardware_.acted) {
    hardware_.acted({.client = Client::navigation, .key = static_cast<std::uint8_t>(key)});
  }
  if (!menu_.is_open()) return;
  const int digit = digit_of(key);
  if (key == NumberPadKey::star) {
    typed_.clear();
  } else if (digit >= 0 && typed_.size() < digits_max) {
    typed_ += static_cast<char>('0' + digit);
  } else if (key == NumberPadKey::hash && !typed_.empty()) {
    const auto destination = static_cast<unsigned>(std::stoul(typed_));
    const double metres = hardware_.guide ? hardware_.guide(destination) : 0;
    char distance[16];
    std::snprintf(distance, sizeof distance, "%.1f km", metres / 1000);
    return menu_.finish("to " + typed_ + ": " + distance, 3s);
  }
  menu_.show("to " + (typed_.empty() ? "?" : typed_));
}

void NavigationControl::key_written(const Entry&, Source) {
  const auto key = static_cast<NumberPadKey>(
      read_field(network_.node().dictionary(), place_of(number_pad_user_interaction)));
  if (key != NumberPadKey::none && !menu_.is_open()) number_pressed(key);
}

}  // namespace canvoy::police
