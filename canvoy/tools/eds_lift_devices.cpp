#include "canvoy/tools/eds_lift_devices.hpp"

#include "canvoy/devices/cia417/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/car_door_device.hpp"
#include "canvoy/devices/cia417/car_drive_controller_device.hpp"
#include "canvoy/devices/cia417/car_drive_device.hpp"
#include "canvoy/devices/cia417/car_position_device.hpp"
#include "canvoy/devices/cia417/lift_panel_device.hpp"
#include "canvoy/devices/cia417/light_barrier_device.hpp"
#include "canvoy/devices/cia417/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor_unit_device.hpp"

namespace canvoy::tools {

namespace {

using formats::SheetMaker;

constexpr LiftDeviceKind kinds[] = {
    {"car-door-controller", "Canvoy CiA 417 door controller",
     [](SheetMaker& maker) { maker.add(cia417::full_car_door_controller<>); }},
    {"car-door", "Canvoy CiA 417 car door unit",
     [](SheetMaker& maker) { maker.add(cia417::full_car_door<>); }},
    {"car-panel", "Canvoy CiA 417 panel",
     [](SheetMaker& maker) { maker.add(cia417::full_lift_panel<cia417::CarPanelOptions{}>); }},
    {"landing-panel", "Canvoy CiA 417 panel",
     [](SheetMaker& maker) { maker.add(cia417::full_lift_panel<cia417::LandingPanelOptions{}>); }},
    {"car-drive-controller", "Canvoy CiA 417 drive controller",
     [](SheetMaker& maker) { maker.add(cia417::full_car_drive_controller<>); }},
    {"car-drive", "Canvoy CiA 417 car drive unit",
     [](SheetMaker& maker) { maker.add(cia417::full_drive<>); }},
    {"car-position", "Canvoy CiA 417 car position unit",
     [](SheetMaker& maker) { maker.add(cia417::full_car_position<>); }},
    {"light-barrier", "Canvoy CiA 417 light barrier",
     [](SheetMaker& maker) { maker.add(cia417::full_light_barrier<>); }},
    {"load-measuring", "Canvoy CiA 417 load measuring",
     [](SheetMaker& maker) { maker.add(cia417::full_load_unit<>); }},
    {"sensor-unit", "Canvoy CiA 417 sensor unit",
     [](SheetMaker& maker) { maker.add(cia417::full_sensor_unit<8>); }},
};

}  // namespace

const LiftDeviceKind* find_lift_device(std::string_view name) {
  for (const LiftDeviceKind& kind : kinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

}  // namespace canvoy::tools
