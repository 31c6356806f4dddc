#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* display_commands[] = {&tariff_display_lamps_command_1_object,
                                                  &tariff_display_lamps_command_2_object,
                                                  &tariff_display_configuration_object};

using LampPlaces = std::array<FieldPlace, tariff_lamps_max>;

/// The first three have names, the others numbers.
constexpr LampPlaces status_places =
    []<unsigned... above>(std::integer_sequence<unsigned, above...>) -> LampPlaces {
  return {place_of(tariff_display_lamps_status_1_taxi_light),
          place_of(tariff_display_lamps_status_1_vacant_light),
          place_of(tariff_display_lamps_status_1_emcy_light),
          place_of(tariff_display_lamp_status<above + 4>)...};
}(std::make_integer_sequence<unsigned, tariff_lamps_max - 3>{});
constexpr LampPlaces command_places =
    []<unsigned... above>(std::integer_sequence<unsigned, above...>) -> LampPlaces {
  return {place_of(tariff_display_lamps_command_1_taxi_light),
          place_of(tariff_display_lamps_command_1_vacant_light),
          place_of(tariff_display_lamps_command_1_emcy_light),
          place_of(tariff_display_lamp_command<above + 4>)...};
}(std::make_integer_sequence<unsigned, tariff_lamps_max - 3>{});
constexpr LampPlaces failure_places =
    []<unsigned... above>(std::integer_sequence<unsigned, above...>) -> LampPlaces {
  return {place_of(tariff_display_lamp_failures_1_taxi_light),
          place_of(tariff_display_lamp_failures_1_vacant_light),
          place_of(tariff_display_lamp_failures_1_emcy_light),
          place_of(tariff_display_lamp_failure<above + 4>)...};
}(std::make_integer_sequence<unsigned, tariff_lamps_max - 3>{});
constexpr LampPlaces input_places =
    []<unsigned... before>(std::integer_sequence<unsigned, before...>) -> LampPlaces {
  return {place_of(tariff_display_input<before + 1>)...};
}(std::make_integer_sequence<unsigned, tariff_lamps_max>{});

/// A character that 610Ah can hold (errata Z12).
std::uint8_t reported_character(std::uint8_t character) {
  constexpr std::uint8_t not_available = 0xFF;
  const bool is_told =
      character == 0 || (character >= 0x20 && character <= 0x7E) || character >= 0xFE;
  return is_told ? character : not_available;
}

}  // namespace

constexpr AccessHandlers TariffDisplayUnit::hook_calls[] = {
    after_write<&TariffDisplayUnit::level_came, taxi_trip_tariff_level_object>};
constexpr ServiceHandlers TariffDisplayUnit::service_calls = {
    .reset = method<&TariffDisplayUnit::reset>, .hooks = hook_calls};

TariffDisplayUnit::TariffDisplayUnit(CarNetwork& network, const TariffDisplayHardware& hardware,
                                     const TariffDisplaySettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      commands_(network, display_commands,
                {.commanded = callback<&TariffDisplayUnit::commanded>(*this),
                 .refuses = callback<&TariffDisplayUnit::refuses>(*this),
                 .lacking = std::span(command_places)
                                .subspan(std::clamp(settings.lamps, 1U, tariff_lamps_max))}) {
  settings_.lamps = std::clamp(settings.lamps, 1U, tariff_lamps_max);
  network.node().attach(service_);
}

/// An NMT reset changes no lamp.
void TariffDisplayUnit::reset(ResetScope /*scope*/) {
  tell();
}

AbortCode TariffDisplayUnit::refuses(const Commanded& wanted) {
  if (wanted.is_for(tariff_display_configuration_configure)) {
    const bool wants_inputs =
        wanted.as<DisplayConfiguration>() == DisplayConfiguration::discrete_inputs;
    return wants_inputs && !settings_.has_inputs ? AbortCode::device_state : AbortCode::none;
  }
  const bool is_lamp = wanted.place.index != tariff_display_configuration_configure.index();
  return is_lamp && by_inputs_ ? AbortCode::device_state : AbortCode::none;
}

void TariffDisplayUnit::commanded(const Commanded& wanted) {
  if (wanted.is_for(tariff_display_configuration_enter_power_down_mode)) {
    is_powered_down_ = wanted.as<Order>() == Order::on;
  } else if (wanted.is_for(tariff_display_configuration_configure)) {
    const auto configuration = wanted.as<DisplayConfiguration>();
    if (configuration != DisplayConfiguration::no_command) {
      by_inputs_ = configuration == DisplayConfiguration::discrete_inputs;
    }
  } else {
    const auto* const place = std::ranges::find(command_places, wanted.place);
    if (place == command_places.end()) return;
    lamps_[static_cast<std::size_t>(place - command_places.begin())].commanded = wanted.as<Lamp>();
  }
  follow();
}

Lamp TariffDisplayUnit::wanted_of(const OneLamp& lamp) const {
  if (is_powered_down_) return Lamp::off;
  if (!by_inputs_) return lamp.commanded;
  return lamp.input == Signal::yes ? Lamp::on : Lamp::off;
}

void TariffDisplayUnit::follow() {
  for (unsigned number = 1; number <= settings_.lamps; ++number) {
    OneLamp& lamp = lamps_[number - 1];
    const Lamp wanted = wanted_of(lamp);
    if (wanted == lamp.driven) continue;
    lamp.driven = wanted;
    hardware_.drive(number, wanted);
  }
  tell();
}

Lamp TariffDisplayUnit::lamp(unsigned number) const {
  if (number < 1 || number > settings_.lamps) return Lamp::not_available;
  const OneLamp& lamp = lamps_[number - 1];
  return lamp.failure == LampFailure::none ? lamp.driven : Lamp::failure;
}

void TariffDisplayUnit::set_input(unsigned input, Signal state) {
  if (input < 1 || input > tariff_lamps_max) return;
  lamps_[input - 1].input = state;
  follow();
}

void TariffDisplayUnit::lamp_failed(unsigned lamp, LampFailure failure) {
  if (lamp < 1 || lamp > settings_.lamps) return;
  lamps_[lamp - 1].failure = failure;
  tell();
}

void TariffDisplayUnit::show_level(std::array<char, 2> characters) {
  set_level({static_cast<std::uint8_t>(characters[0]), static_cast<std::uint8_t>(characters[1])});
}

void TariffDisplayUnit::level_came() {
  const Values values(network_.node().dictionary());
  set_level({values[taxi_trip_tariff_level_character_1].raw(),
             values[taxi_trip_tariff_level_character_2].raw()});
}

void TariffDisplayUnit::set_level(const std::array<std::uint8_t, 2>& level) {
  const std::array<std::uint8_t, 2> before = shown_level();
  level_ = level;
  if (shown_level() != before) hardware_.show_level(shown_level());
  tell();
}

/// A character for which there is no room is not available.
std::array<std::uint8_t, 2> TariffDisplayUnit::shown_level() const {
  std::array<std::uint8_t, 2> shown = {0xFF, 0xFF};
  const std::size_t room = std::min<std::size_t>(settings_.level_characters, shown.size());
  for (std::size_t i = 0; i < room; ++i) shown.at(i) = reported_character(level_.at(i));
  return shown;
}

void TariffDisplayUnit::tell() {
  Dictionary& dictionary = network_.node().dictionary();
  const Values display(dictionary);
  display[tariff_display_information_and_status_power_down] =
      is_powered_down_ ? Signal::yes : Signal::no;
  display[tariff_display_information_and_status_input] =
      by_inputs_ ? LampInput::discrete_inputs : LampInput::can;
  display[tariff_display_information_and_status_lamp_driver_input] =
      settings_.has_inputs ? Signal::yes : Signal::no;
  display[tariff_display_information_and_status_lamps] = settings_.lamps;
  display[tariff_display_information_and_status_level_characters] =
      std::min(settings_.level_characters, 2U);
  for (unsigned number = 1; number <= tariff_lamps_max; ++number) {
    const OneLamp& one = lamps_[number - 1];
    const bool is_there = number <= settings_.lamps;
    const LampFailure failure = is_there ? one.failure : LampFailure::not_available;
    const Signal input = settings_.has_inputs ? one.input : Signal::not_available;
    write_field(dictionary, status_places[number - 1], static_cast<std::uint32_t>(lamp(number)));
    write_field(dictionary, failure_places[number - 1], static_cast<std::uint32_t>(failure));
    write_field(dictionary, input_places[number - 1], static_cast<std::uint32_t>(input));
  }
  const std::array<std::uint8_t, 2> level = shown_level();
  display[tariff_display_tariff_level_character_1].set_raw(level[0]);
  display[tariff_display_tariff_level_character_2].set_raw(level[1]);
}

}  // namespace canvoy::cia447
