#include "canvoy/devices/cia447/kinds.hpp"

#include <array>

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

namespace canvoy::cia447 {

namespace {

const std::array<DeviceKind, kind_count> all = {
    car_device_kind<IvnGatewayKind>(),
    car_device_kind<FireExtinguishingKind>(),
    car_device_kind<EmergencyFreshAirKind>(),
    car_device_kind<PowerSupplyKind>(),
    car_device_kind<DiscreteInputsKind>(),
    car_device_kind<TerminalKind>(),
    car_device_kind<GpsKind>(),
    car_device_kind<NavigationKind>(),
    car_device_kind<TaximeterKind>(),
    car_device_kind<PrinterKind>(),
    car_device_kind<RealTimeClockKind>(),
    car_device_kind<DriverIdentificationKind>(),
    car_device_kind<TariffDisplayKind>(),
    car_device_kind<TaxiAlarmKind>(),
    car_device_kind<RadioKind>(),
    car_device_kind<AudioSwitchKind>(),
    car_device_kind<RoofBarLightKind>(),
    car_device_kind<RoofBarSoundKind>(),
    car_device_kind<BlueLightKind>(),
    car_device_kind<HandsFreeKind>(),
};

}  // namespace

std::span<const DeviceKind> kinds() {
  return all;
}

}  // namespace canvoy::cia447
