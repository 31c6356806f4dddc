#include "canvoy/worlds/police/signal_control.hpp"

#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::police {

namespace {

using namespace cia447;

/// Leaves each function of two bits unchanged.
constexpr std::uint32_t nothing = 0xFFFF'FFFF;
constexpr std::uint32_t with(std::uint32_t command, const FieldPlace& place, std::uint32_t code) {
  const std::uint32_t mask = ((1U << place.bits) - 1) << place.first_bit;
  return (command & ~mask) | code << place.first_bit;
}

constexpr unsigned flashers = 10;
/// All flashers of the module alike.
constexpr std::uint32_t all_flashers(Order order) {
  std::uint32_t command = nothing;
  for (unsigned i = 0; i < flashers; ++i) {
    command = with(command, {0, 0, static_cast<std::uint8_t>(2 * i), 2},
                   static_cast<std::uint32_t>(order));
  }
  return command;
}

/// Sounds for the digits 1 to 4 of the pad.
constexpr AdditionalSound sounds[] = {AdditionalSound::country_specific, AdditionalSound::us_yelp,
                                      AdditionalSound::wail, AdditionalSound::us_hi_lo};

}  // namespace

constexpr AccessHandlers SignalControl::hook_calls[] = {
    after_write<&SignalControl::lamps_written, blue_light_flasher_status_object>};
constexpr ServiceHandlers SignalControl::service_calls = {.reset = method<&SignalControl::reset>,
                                                          .hooks = hook_calls};

SignalControl::SignalControl(CarNetwork& network, const SignalControlHardware& hardware,
                             const SignalControlSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      terminal_(network, {.terminal = settings.terminal}),
      menu_(network, terminal_, title_of(Client::signals)),
      roof_light_(network, {.server = settings.roof_light}),
      blue_light_(network, {.server = settings.blue_light}),
      gateway_(network, {.server = settings.gateway}),
      siren_(callback<&SignalControl::sound_siren>(*this)) {
  terminal_.on_number_key(callback<&SignalControl::number_pressed>(*this));
  terminal_.on_function_key(callback<&SignalControl::function_pressed>(*this));
  network.node().attach(service_);
}

void SignalControl::reset(ResetScope) {
  menu_.close();
  is_blue_ = has_siren_ = has_work_light_ = siren_sounds_ = false;
  terminal_.want(TerminalPart::function_pad, true);
  terminal_.want(TerminalPart::display_2, true);
  if (hardware_.sound != nullptr) {
    hardware_.sound->switching().command(country_specific_sound_command, CountrySound::din);
  }
  drive();
}

void SignalControl::function_pressed(FunctionKey key) {
  if (hardware_.acted) {
    hardware_.acted({Client::signals, true, static_cast<std::uint8_t>(key)});
  }
  if (key == lock_key) return lock(Locking::external);
  if (key == unlock_key) return lock(Locking::unlocked);
  if (key == sound_key && !menu_.is_open()) menu_.open("sound?");
  if (key == blue_key || key == siren_key || key == off_key) {
    is_blue_ = key != off_key;
    has_siren_ = key == siren_key;
  }
  if (key == work_key) has_work_light_ = !has_work_light_;
  drive();
}

void SignalControl::number_pressed(NumberPadKey key) {
  if (hardware_.acted) {
    hardware_.acted({.client = Client::signals, .key = static_cast<std::uint8_t>(key)});
  }
  const int digit = digit_of(key);
  if (!menu_.is_open() || digit < 1 || digit > static_cast<int>(std::size(sounds))) return;
  sound_ = sounds[digit - 1];
  const Duration shown = settings_.hogs_terminal ? Duration(24h) : Duration(1500ms);
  menu_.finish("sound " + std::to_string(digit), shown);
  drive();
}

void SignalControl::lamps_written(const Entry& entry) {
  const std::uint32_t lamps = read_field(network_.node().dictionary(), {entry.index, 0, 0, 32});
  has_broken_lamp_ = false;
  for (unsigned i = 0; i < flashers; ++i) {
    constexpr std::uint32_t mask = 3;
    has_broken_lamp_ = has_broken_lamp_ ||
                       (lamps >> (2 * i) & mask) == static_cast<std::uint32_t>(Signal::failure);
  }
  show();
}

void SignalControl::drive() {
  const auto blue = static_cast<std::uint32_t>(is_blue_ ? Order::on : Order::off);
  const auto work = static_cast<std::uint32_t>(has_work_light_ ? Order::on : Order::off);
  std::uint32_t beacons = nothing;
  for (const FieldPlace& place :
       {place_of(roof_bar_light_command<"mlb1">), place_of(roof_bar_light_command<"mlb2">)}) {
    beacons = with(beacons, place, blue);
  }
  for (const FieldPlace& place :
       {place_of(roof_bar_light_command<"alr1">), place_of(roof_bar_light_command<"all1">)}) {
    beacons = with(beacons, place, work);
  }
  constexpr auto lamp = place_of(light_commands_roof_bar_search_lamp);
  roof_light_.want(1, {lamp.index, lamp.sub, with(nothing, lamp, work), 4});
  constexpr auto first = place_of(roof_bar_light_command<"mlb1">);
  roof_light_.want(0, {first.index, first.sub, beacons, 4});
  blue_light_.want(0, {blue_light_flasher_command_object.index, 0,
                       all_flashers(is_blue_ ? Order::on : Order::off), 4});
  if (!has_siren_) siren_sounds_ = false;
  sound_siren(network_.node().now());
  show();
}

/// Checks again and again until there is blue light.
void SignalControl::sound_siren(Time now) {
  constexpr Duration look_again = 50ms;
  const bool has_blue_light = roof_light_.is_done() || blue_light_.is_done();
  siren_sounds_ = has_siren_ && (siren_sounds_ || has_blue_light);
  if (has_siren_ && !siren_sounds_) network_.node().timers().arm(siren_, now + look_again);
  if (hardware_.sound == nullptr) return;
  hardware_.sound->switching().command(sound_command_roof_bar_additional_sound,
                                       siren_sounds_ ? sound_ : AdditionalSound::none);
  hardware_.sound->switching().command(sound_command_roof_bar_audio_active,
                                       siren_sounds_ ? Order::on : Order::off);
}

/// Sends the command once: a person who unlocks the car with a key must not be locked in.
void SignalControl::lock(Locking wanted) {
  constexpr std::uint32_t do_not_care = 0xFF;
  constexpr auto place = place_of(central_locking_system_command);
  gateway_.want(
      0, {place.index, 0, with(do_not_care, place, static_cast<std::uint32_t>(wanted)), 1, true});
}

void SignalControl::show() {
  std::string text = is_blue_ ? "BLUE" : "READY";
  if (has_siren_) text += " SIREN";
  if (has_broken_lamp_) text += "\nLAMP BROKEN";
  terminal_.show(TerminalText::text_2, text);
}

}  // namespace canvoy::police
