// Hands of terminal, positions, radio, roof bar, and of devices that only report their states.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "canvoy/can/real_text.hpp"
#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/devices/cia447/radio/radio_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/car/gps_hands.hpp"
#include "canvoy/tools/device/car/switched_hands.hpp"
#include "canvoy/tools/device/hand/hand_rows.hpp"

namespace canvoy::tools {

namespace add_on_hand_rows {
namespace {

using namespace hand_rows;
using namespace cia447;

constexpr WithoutHand terminal_without[] = {
    {0x6096, WithoutHand::all, WithoutHand::all, "the maker's: how much display 1 shows"},
    {0x609B, WithoutHand::all, WithoutHand::all, "the maker's: how much display 2 shows"},
    {0x60A1, WithoutHand::all, WithoutHand::all, "follows 60A2h; warnings= is the part"}};
constexpr WithoutHand navigation_without[] = {
    {0x60C0, WithoutHand::all, WithoutHand::all,
     "follows destination, and the position that the network's GPS tells"},
    {0x60C2, WithoutHand::all, WithoutHand::all, "answers 60C1h"},
    {0x60C5, WithoutHand::all, WithoutHand::all, "follows the position that 60B0h tells"}};
constexpr WithoutHand audio_without[] = {
    {0x6122, WithoutHand::all, WithoutHand::all, "answers 6121h; amplifier= is its failure"}};

/// The keys of a pad, named from its clause: `Key "up" pressed` is `key-up`.
template <class Key, class Handle>
void add_keys(std::vector<DeviceHand>& rows, const Handle& handle) {
  const FieldPlace place = place_of(handle);
  for (const NamedValue& named : find_value_info(place)->names) {
    const auto code = static_cast<std::uint32_t>(named.first);
    if (named.meaning != Meaning::state || code == 0) continue;
    if (code >= static_cast<std::uint32_t>(Key::several)) continue;
    std::string name = hand_word(named.name);
    name.erase(name.size() - std::string_view("-pressed").size());
    if (named.name == "Key # pressed") name = "key-hash";
    if (named.name == "Key * pressed") name = "key-star";
    const auto pressed = static_cast<Key>(code);
    rows.push_back(key<TerminalUnit>(
        std::move(name), place, [pressed](TerminalUnit& unit, const HandValue& value) {
          value.code != 0 ? unit.press(pressed) : unit.release(pressed);
        }));
  }
}

CarHandTable terminal_hands() {
  CarHandTable table{.device = TerminalKind::info.name, .without = terminal_without};
  add_keys<NumberPadKey>(table.rows, number_pad_user_interaction);
  add_keys<FunctionKey>(table.rows, function_keys_user_interaction_key);
  add_keys<ControlKey>(table.rows, control_keys_user_interaction_key);
  add_keys<TipSwitch>(table.rows, steering_wheel_switch_pad_user_interaction);
  table.rows.push_back(key<TerminalUnit>("emergency-key", place_of(emergency_key_user_interaction),
                                         [](TerminalUnit& unit, const HandValue& value) {
                                           unit.press_emergency_key(value.code != 0);
                                         }));
  struct Part {
    std::string_view name;
    TerminalPart part;
    std::vector<FieldPlace> changes;
  };
  const auto icons = [](const ObjectInfo& object) {
    return std::vector{whole(object, 1), whole(object, 2), whole(object, 3), whole(object, 4)};
  };
  const Part parts[] = {
      {"number-pad", TerminalPart::number_pad, {whole(number_pad_status_object)}},
      {"function-keys", TerminalPart::function_pad, {whole(function_keys_status_object)}},
      {"control-keys", TerminalPart::control_pad, {whole(control_keys_status_object)}},
      {"switch-pad", TerminalPart::switch_pad, {whole(steering_wheel_switch_pad_status_object)}},
      {"emergency-pad", TerminalPart::emergency_key, {whole(emergency_key_status_object)}},
      {"display-1", TerminalPart::display_1, {whole(display_1_status_object)}},
      {"display-2", TerminalPart::display_2, {whole(display_2_status_object)}},
      {"warnings", TerminalPart::warnings, {whole(functional_warnings_status_object)}},
      {"icon-display-1", TerminalPart::icon_display_1, icons(icon_display_1_status_object)},
      {"icon-display-2", TerminalPart::icon_display_2, icons(icon_display_2_status_object)}};
  for (const Part& each : parts) {
    DeviceHand hand = choice<TerminalUnit>(
        std::string(each.name), each.changes.front(), {"working", "off", "failure"},
        [part = each.part](TerminalUnit& unit, const HandValue& value) {
          unit.sense(part, static_cast<PartState>(value.code));
        });
    hand.changes = each.changes;
    table.rows.push_back(std::move(hand));
  }
  return table;
}

/// `48.137,11.575`
GeoPosition position_of(const HandValue& value) {
  GeoPosition position;
  const std::string& text = value.text;
  const char* const end = text.data() + text.size();
  const auto latitude = real_from_chars(text.data(), end, position.latitude);
  const bool has_comma = latitude.ec == std::errc{} && latitude.ptr != end && *latitude.ptr == ',';
  if (has_comma) {
    const auto longitude = real_from_chars(latitude.ptr + 1, end, position.longitude);
    const bool is_there = longitude.ec == std::errc{} && longitude.ptr == end &&
                          std::abs(position.latitude) <= 90 && std::abs(position.longitude) <= 180;
    if (is_there) return position;
  }
  throw UsageError(
      fmt::format("'{}' is no position: write degrees north and east, as 48.137,11.575", text));
}

CarHandTable navigation_hands() {
  CarHandTable table{.device = NavigationKind::info.name, .without = navigation_without};
  const FieldPlace distance = whole(distance_to_selected_destination_object);
  table.rows = {
      text<NavigationUnit>(
          "destination", {distance}, "48.137,11.575",
          [](const HandValue& value) { position_of(value); },
          [](NavigationUnit& unit, const HandValue& value) { unit.select(position_of(value)); }),
      action<NavigationUnit>("cancel", distance, [](NavigationUnit& unit) { unit.cancel(); })};
  return table;
}

CarHandTable power_supply_hands() {
  const auto overload = [](const char* name, Supply supply, const FieldPlace& place) {
    return status<PowerSupplyUnit>(
        name, place, [supply, place](PowerSupplyUnit& unit, const HandValue& value) {
          const bool is_known = value.meaning == Meaning::state;
          report_status(unit.switching(), place,
                        is_known ? HandValue{.meaning = Meaning::padding} : value);
          if (is_known) unit.report_overload(supply, value.code == 1);
        });
  };
  CarHandTable table{.device = PowerSupplyKind::info.name};
  table.rows = {
      overload("radio-overload", Supply::radio, place_of(radio_power_supply_status_overload)),
      overload("periphery-overload", Supply::periphery,
               place_of(periphery_power_supply_status_overload))};
  table.tell = report_switched<PowerSupplyUnit>;
  // Ignition, time and commands determine their own values.
  table.sensed_only = {whole(radio_power_supply_status_object),
                       whole(periphery_power_supply_status_object)};
  table.name = [](const FieldPlace& place) {
    constexpr const char* names[] = {"power-on", "after-run", "cut-off-in-5-minutes", "overload"};
    const bool is_radio = place.index == radio_power_supply_status_object.index;
    return fmt::format("{}-{}", is_radio ? "radio" : "periphery", names[place.first_bit / 2U]);
  };
  return table;
}

CarHandTable hands_free_hands() {
  CarHandTable table{.device = HandsFreeKind::info.name};
  const FieldPlace place = place_of(radio_hand_free_status_key);
  DeviceHand pressed =
      key<HandsFreeUnit>("key", place, [place](HandsFreeUnit& unit, const HandValue& value) {
        report_status(unit.switching(), place, value);
      });
  for (const HandWord& word : words_of(place)) {
    const bool is_sensor = word.word == "failure" || word.word == "not-available";
    if (is_sensor) pressed.words.push_back(word);
  }
  table.rows = {std::move(pressed)};
  return table;
}

CarHandTable audio_switch_hands() {
  CarHandTable table{.device = AudioSwitchKind::info.name, .without = audio_without};
  table.rows = {choice<AudioSwitchUnit>(
      "amplifier", whole(audio_switch_status_response_object), {"working", "failure"},
      [](AudioSwitchUnit& unit, const HandValue& value) { unit.report_failure(value.code == 1); })};
  return table;
}

template <class Kind>
CarHandTable switched_table() {
  return {.device = Kind::info.name, .tell = report_switched<typename Kind::Unit>};
}

std::vector<CarHandTable> all_tables() {
  return {terminal_hands(),
          gps_hands(),
          navigation_hands(),
          power_supply_hands(),
          hands_free_hands(),
          audio_switch_hands(),
          switched_table<FireExtinguishingKind>(),
          switched_table<EmergencyFreshAirKind>(),
          switched_table<DiscreteInputsKind>(),
          switched_table<RadioKind>(),
          switched_table<RoofBarLightKind>(),
          switched_table<RoofBarSoundKind>(),
          switched_table<BlueLightKind>()};
}

}  // namespace
}  // namespace add_on_hand_rows

std::vector<CarHandTable> add_on_hands() {
  return add_on_hand_rows::all_tables();
}

}  // namespace canvoy::tools
