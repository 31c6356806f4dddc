#include "canvoy/devices/catalogue.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "canvoy/devices/cia401/kinds.hpp"
#include "canvoy/devices/cia407/kinds.hpp"
#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia418/kinds.hpp"
#include "canvoy/devices/cia419/kinds.hpp"
#include "canvoy/devices/cia447/kinds.hpp"
#include "canvoy/devices/cia852/kinds.hpp"

namespace canvoy {

namespace {

constexpr const DeviceKind* others[] = {&cia401::io_kind,
                                        &cia852::operator_kind,
                                        &cia419::charger_kind,
                                        &cia418::battery_kind,
                                        &cia417::lift_controller_kind,
                                        &cia417::call_controller_kind,
                                        &cia417::car_door_controller_kind,
                                        &cia417::car_drive_controller_kind,
                                        &cia417::group_controller_kind,
                                        &cia417::car_drive_kind,
                                        &cia417::car_position_kind,
                                        &cia417::position_cam_kind,
                                        &cia417::car_door_kind,
                                        &cia417::light_barrier_kind,
                                        &cia417::load_kind,
                                        &cia417::sensor_kind,
                                        &cia417::input_panel_kind,
                                        &cia417::output_panel_kind,
                                        &cia417::landing_panel_kind,
                                        &cia417::car_panel_kind};

using Kinds =
    std::array<const DeviceKind*, std::size(others) + cia447::kind_count + cia407::kind_count>;

Kinds join() {
  Kinds kinds{};
  auto next = std::copy(std::begin(others), std::end(others), kinds.begin());
  for (const DeviceKind& kind : cia447::kinds()) *next++ = &kind;
  for (const DeviceKind& kind : cia407::kinds()) *next++ = &kind;
  return kinds;
}

/// In the order of --list.
const Kinds all_kinds = join();

}  // namespace

std::span<const DeviceKind* const> device_catalogue() {
  return all_kinds;
}

const DeviceKind* find_device_kind(std::string_view name) {
  for (const DeviceKind* kind : all_kinds) {
    if (kind->info.name == name) return kind;
  }
  return nullptr;
}

}  // namespace canvoy
