#include "canvoy/tools/device/car/car_hands.hpp"

#include <fmt/format.h>

#include <algorithm>
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
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/car/device_car.hpp"

namespace canvoy::tools {

std::vector<HandTable> hand_tables(std::span<const cia447::CarUnit* const> units) {
  std::vector<HandTable> tables;
  for (const cia447::CarUnit* unit : units) tables.push_back({unit->info.name, car_hands(*unit)});
  return tables;
}

CarHands::CarHands(std::span<const cia447::CarUnit* const> units, const HandTarget& around,
                   const DeviceOutput& output)
    : units_(units.begin(), units.end()),
      around_(around),
      output_(output),
      orders_(hand_tables(units)) {}

template <class Kind>
void CarHands::has(typename Kind::Unit& unit, Node& /*node*/) {
  made_[Kind::info.name] = &unit;
  if constexpr (std::is_same_v<Kind, cia447::IvnGatewayKind>) around_.car->take(unit);
}

template <class Kind>
void CarHands::watch(Environment& environment) {
  for (const cia447::CarUnit* unit : units_) {
    if (unit->info.name != Kind::info.name) continue;
    environment.watch(callback<&CarHands::has<Kind>>(*this));
  }
}

void CarHands::join(Environment& environment) {
  using namespace cia447;
  watch<AudioSwitchKind>(environment);
  watch<BlueLightKind>(environment);
  watch<DiscreteInputsKind>(environment);
  watch<DriverIdentificationKind>(environment);
  watch<EmergencyFreshAirKind>(environment);
  watch<FireExtinguishingKind>(environment);
  watch<GpsKind>(environment);
  watch<HandsFreeKind>(environment);
  watch<IvnGatewayKind>(environment);
  watch<NavigationKind>(environment);
  watch<PowerSupplyKind>(environment);
  watch<PrinterKind>(environment);
  watch<RadioKind>(environment);
  watch<RealTimeClockKind>(environment);
  watch<RoofBarLightKind>(environment);
  watch<RoofBarSoundKind>(environment);
  watch<TariffDisplayKind>(environment);
  watch<TaxiAlarmKind>(environment);
  watch<TaximeterKind>(environment);
  watch<TerminalKind>(environment);
}

void CarHands::step(Node& node, Time now) {
  orders_.step(node, now, [this, now](const HandOrder& order) { act(order, now); });
}

void CarHands::act(const HandOrder& order, Time now) {
  const auto found = made_.find(order.device);
  if (found == made_.end()) return;
  HandTarget target = around_;
  target.unit = found->second;
  target.number = order.number;
  target.now = now;
  if (order.hand->act(target, order.value)) return;
  output_.say(order.device,
              fmt::format("{}: {}", order.hand->name, why_refused(*order.hand, target)));
}

}  // namespace canvoy::tools
