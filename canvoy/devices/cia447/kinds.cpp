#include "canvoy/devices/cia447/kinds.hpp"

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

const DeviceKind audio_switch_kind = car_device_kind<AudioSwitchKind>();
const DeviceKind blue_light_kind = car_device_kind<BlueLightKind>();
const DeviceKind discrete_inputs_kind = car_device_kind<DiscreteInputsKind>();
const DeviceKind driver_identification_kind = car_device_kind<DriverIdentificationKind>();
const DeviceKind emergency_fresh_air_kind = car_device_kind<EmergencyFreshAirKind>();
const DeviceKind fire_extinguishing_kind = car_device_kind<FireExtinguishingKind>();
const DeviceKind gps_kind = car_device_kind<GpsKind>();
const DeviceKind hands_free_kind = car_device_kind<HandsFreeKind>();
const DeviceKind ivn_gateway_kind = car_device_kind<IvnGatewayKind>();
const DeviceKind navigation_kind = car_device_kind<NavigationKind>();
const DeviceKind power_supply_kind = car_device_kind<PowerSupplyKind>();
const DeviceKind printer_kind = car_device_kind<PrinterKind>();
const DeviceKind radio_kind = car_device_kind<RadioKind>();
const DeviceKind real_time_clock_kind = car_device_kind<RealTimeClockKind>();
const DeviceKind roof_bar_light_kind = car_device_kind<RoofBarLightKind>();
const DeviceKind roof_bar_sound_kind = car_device_kind<RoofBarSoundKind>();
const DeviceKind tariff_display_kind = car_device_kind<TariffDisplayKind>();
const DeviceKind taxi_alarm_kind = car_device_kind<TaxiAlarmKind>();
const DeviceKind taximeter_kind = car_device_kind<TaximeterKind>();
const DeviceKind terminal_kind = car_device_kind<TerminalKind>();

}  // namespace canvoy::cia447
