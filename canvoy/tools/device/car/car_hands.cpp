#include "canvoy/tools/device/car/car_hands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "canvoy/devices/cia447/audio_switch/audio_switch_unit.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/emergency_fresh_air/emergency_fresh_air_unit.hpp"
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/hands_free/hands_free_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"
#include "canvoy/devices/cia447/power_supply/power_supply_unit.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/radio/radio_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_light/roof_bar_light_unit.hpp"
#include "canvoy/devices/cia447/roof_bar_sound/roof_bar_sound_unit.hpp"
#include "canvoy/devices/cia447/tariff_display/tariff_display_unit.hpp"
#include "canvoy/devices/cia447/taxi_alarm/taxi_alarm_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/device_car.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/spelling.hpp"

namespace canvoy::tools {

namespace {

using Units = std::span<const cia447::CarUnit* const>;

/// `taxi-alarm.reset=...@2s` in its parts.
struct OrderText {
  std::string_view device{};  ///< empty: not said
  std::string_view name;
  std::optional<std::string_view> value{};
  std::optional<std::string_view> at{};
};

OrderText split_order(std::string_view text) {
  OrderText parts;
  if (const std::size_t at = text.rfind('@'); at != std::string_view::npos) {
    parts.at = text.substr(at + 1);
    text = text.substr(0, at);
  }
  if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
    parts.value = text.substr(equals + 1);
    text = text.substr(0, equals);
  }
  if (const std::size_t dot = text.find('.'); dot != std::string_view::npos) {
    parts.device = text.substr(0, dot);
    text = text.substr(dot + 1);
  }
  parts.name = text;
  return parts;
}

bool is_called(const CarHand& hand, std::string_view name) {
  constexpr std::string_view usual = "key-";
  if (hand.name == name) return true;
  // The keys of a terminal by what is on them.
  return hand.form == HandForm::key && hand.name.starts_with(usual) &&
         std::string_view(hand.name).substr(usual.size()) == name;
}

std::vector<HandOrder> found_hands(Units units, const OrderText& text) {
  std::vector<HandOrder> found;
  for (const cia447::CarUnit* unit : units) {
    if (!text.device.empty() && text.device != unit->info.name) continue;
    for (const CarHand& hand : car_hands(*unit)) {
      if (!is_called(hand, text.name)) continue;
      found.push_back({.unit = unit, .hand = &hand});
      break;
    }
  }
  return found;
}

[[noreturn]] void refuse_hand(Units units, std::string_view text, const OrderText& parts) {
  std::vector<std::string> names;
  std::string list;
  for (const cia447::CarUnit* unit : units) {
    for (const CarHand& hand : car_hands(*unit)) {
      names.push_back(hand.name);
      list += fmt::format("{}{}{}", list.empty() ? "" : ", ", hand.name,
                          hand.form == HandForm::action ? "" : "=");
    }
  }
  throw UsageError(fmt::format("'{}': nothing here is '{}'{}: there is {}", text, parts.name,
                               did_you_mean(parts.name, names), list));
}

std::string example_value(const CarHand& hand) {
  if (hand.form == HandForm::text) return std::string(hand.example);
  return hand.form == HandForm::number ? fmt::format("{}", hand.most) : hand.words.front().word;
}

}  // namespace

bool has_hand(Units units, std::string_view text) {
  return !found_hands(units, split_order(text)).empty();
}

HandOrder parse_hand_order(Units units, std::string_view text) {
  const OrderText parts = split_order(text);
  const std::vector<HandOrder> found = found_hands(units, parts);
  if (found.empty()) refuse_hand(units, text, parts);
  HandOrder order = found.front();
  const CarHand& hand = *order.hand;
  if (found.size() > 1) {
    throw UsageError(fmt::format("'{}': several devices have it: write {}.{} or {}.{}", text,
                                 found[0].unit->info.name, parts.name, found[1].unit->info.name,
                                 parts.name));
  }
  if (!parts.at) throw UsageError(fmt::format("'{}' has no time: write {}@2s", text, text));
  order.at = parse_moment_argument(*parts.at);
  if (parts.value && hand.form == HandForm::action) {
    throw UsageError(
        fmt::format("'{}': {} takes no value: write {}@2s", text, hand.name, hand.name));
  }
  if (parts.value) {
    order.value = parse_hand_value(hand, *parts.value);
  } else if (hand.form == HandForm::key) {
    order.value = hand_key_value(true);
    order.is_press = true;
  } else if (hand.form != HandForm::action) {
    throw UsageError(fmt::format("'{}': {} takes {}: write {}={}@2s", text, hand.name,
                                 hand_values_text(hand), hand.name, example_value(hand)));
  }
  return order;
}

std::vector<std::string> hand_completions(Units units, bool sets) {
  std::vector<std::string> all;
  for (const cia447::CarUnit* unit : units) {
    for (const CarHand& hand : car_hands(*unit)) {
      const bool is_pressed = hand.form == HandForm::action || hand.form == HandForm::key;
      if (!sets && is_pressed) all.push_back(hand.name + "@");
      if (!sets || hand.form == HandForm::action) continue;
      if (hand.words.empty()) all.push_back(hand.name + "=");
      for (const HandWord& word : hand.words) {
        all.push_back(fmt::format("{}={}@", hand.name, word.word));
      }
    }
  }
  return all;
}

CarHands::CarHands(Units units, const HandTarget& around, const DeviceOutput& output)
    : units_(units.begin(), units.end()), around_(around), output_(output) {}

template <class Kind>
void CarHands::has(typename Kind::Unit& unit, Node& /*node*/) {
  made_[Kind::info.name] = &unit;
  if constexpr (std::is_same_v<Kind, cia447::IvnGatewayKind>) around_.car->take(unit);
}

template <class Kind>
void CarHands::watch(Site& site) {
  for (const cia447::CarUnit* unit : units_) {
    if (unit->info.name != Kind::info.name) continue;
    site.watch(
        Callback<void(typename Kind::Unit&, Node&)>::template to<&CarHands::has<Kind>>(*this));
  }
}

void CarHands::join(Site& site) {
  using namespace cia447;
  watch<AudioSwitchKind>(site);
  watch<BlueLightKind>(site);
  watch<DiscreteInputsKind>(site);
  watch<DriverIdentificationKind>(site);
  watch<EmergencyFreshAirKind>(site);
  watch<FireExtinguishingKind>(site);
  watch<GpsKind>(site);
  watch<HandsFreeKind>(site);
  watch<IvnGatewayKind>(site);
  watch<NavigationKind>(site);
  watch<PowerSupplyKind>(site);
  watch<PrinterKind>(site);
  watch<RadioKind>(site);
  watch<RealTimeClockKind>(site);
  watch<RoofBarLightKind>(site);
  watch<RoofBarSoundKind>(site);
  watch<TariffDisplayKind>(site);
  watch<TaxiAlarmKind>(site);
  watch<TaximeterKind>(site);
  watch<TerminalKind>(site);
}

void CarHands::take(const HandOrder& order) {
  constexpr std::size_t orders_max = 10'000;
  if (orders_.size() >= orders_max) {
    throw UsageError(fmt::format("{} hands wait for their time: no more", orders_max));
  }
  const auto behind = std::ranges::upper_bound(orders_, order.at, {}, &HandOrder::at);
  orders_.insert(behind, order);
}

void CarHands::step(Node& node, Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  while (!orders_.empty() && now - begin >= orders_.front().at) {
    HandOrder order = orders_.front();
    orders_.erase(orders_.begin());
    // Somebody outside of the node does something: it is brought up to the present.
    node.advance(now);
    act(order);
    if (!order.is_press) continue;
    order.value = hand_key_value(false);
    order.is_press = false;
    order.at = now - begin + hand_key_time;
    take(order);
  }
}

void CarHands::act(const HandOrder& order) {
  const auto found = made_.find(order.unit->info.name);
  if (found == made_.end()) return;
  HandTarget target = around_;
  target.unit = found->second;
  if (order.hand->act(target, order.value)) return;
  output_.say(order.unit->info.name, fmt::format("{}: not in this state", order.hand->name));
}

}  // namespace canvoy::tools
