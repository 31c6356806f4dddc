#include "canvoy/tools/device_lift_unit.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/devices/cia417/car_door_device.hpp"
#include "canvoy/devices/cia417/lift_units.hpp"
#include "canvoy/devices/cia417/light_barrier_device.hpp"
#include "canvoy/devices/cia417/load_measuring_device.hpp"
#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/lift/shaft_controller.hpp"
#include "canvoy/tools/duration_argument.hpp"
#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::string_view door_kind = "lift-door";
constexpr std::string_view light_barrier_kind = "lift-light-barrier";
constexpr std::string_view load_kind = "lift-load";
constexpr double floor_height_m = 3.5;
constexpr double load_kg_max = 50'000;

constexpr cia417::LiftDeviceOptions of_door(unsigned door) {
  return {.doors = 1U << (door - 1)};
}

template <unsigned door>
auto make_door(NodeId id, const Port& port, lift::DoorPlant& plant) {
  constexpr auto options = of_door(door);
  return std::make_shared<
      cia417::CarDoorDevice<options, cia417::full_car_door_layout<options>, LssSlave::routes>>(
      port, id, std::array{plant.hardware()});
}

template <unsigned door>
auto make_light_barrier(NodeId id, const Port& port, lift::DoorPlant& plant) {
  constexpr auto options = of_door(door);
  return std::make_shared<cia417::LightBarrierDevice<
      options, cia417::full_light_barrier_layout<options>, LssSlave::routes>>(
      port, id, plant.light_barrier_hardware());
}

auto make_load(NodeId id, const Port& port, lift::LoadCell& cell) {
  constexpr cia417::LiftDeviceOptions options{};
  using Device = cia417::LoadMeasuringDevice<options, 1, cia417::full_load_unit_layout<options, 1>,
                                             LssSlave::routes>;
  const lift::LiftDesign design;
  const auto kilograms = [&design](double share) {
    return static_cast<std::uint16_t>(design.car.rated_load_kg * share);
  };
  return std::make_shared<Device>(
      port, id, cell.hardware(),
      cia417::LoadSettings{.tare_kg = design.car.mass_kg,
                           .zero_load = kilograms(0.03),
                           .norm_load = kilograms(0.5),
                           .full_load = kilograms(0.8),
                           .overload = kilograms(design.car.overload_share)});
}

/// A controller of a lift with one door, as those of `canvoy run lift`.
LiftDevice make_controller(NodeId id, const Port& port, const LiftUnitOptions& options) {
  lift::ShaftControllerOptions wanted{
      .id = id,
      .door_units = {lift::node_id::first_door},
      .light_barriers = {lift::node_id::first_light_barrier},
      .others = {cia417::recommended_others.begin(), cia417::recommended_others.end()}};
  for (unsigned floor = 0; floor < options.floors; ++floor) {
    wanted.heights_m.push_back(floor * floor_height_m);
  }
  const auto device = std::make_shared<lift::ShaftController>(port, wanted);
  return {.device = device, .node = &device->node(), .emergencies = &device->emergency_producer()};
}

/// Calls `made` with the device of this door.
template <class Make, class Held>
LiftDevice for_door(unsigned door, const Make& make, const Held& made) {
  switch (door) {
    case 1:
      return made(make.template operator()<1>());
    case 2:
      return made(make.template operator()<2>());
    case 3:
      return made(make.template operator()<3>());
    default:
      return made(make.template operator()<4>());
  }
}

}  // namespace

NodeId lift_unit_node_id(std::string_view kind, unsigned door) {
  if (kind == lift_controller_kind) return lift::node_id::lift_controller;
  if (kind == load_kind) return lift::node_id::load;
  if (kind == light_barrier_kind) return lift::node_id::first_light_barrier;
  if (kind != door_kind) return 0;
  // A fourth door has no recommended node-ID.
  return static_cast<NodeId>(door <= 3 ? lift::node_id::first_door + door - 1 : 12);
}

void add_lift_unit_options(CLI::App& command, LiftUnitOptions& options) {
  command.add_option("--door", options.door,
                     "of a lift door, and of a light barrier: 1 to 4 (default 1)");
  command
      .add_option("--in-door", options.in_door,
                  "somebody stands in the lift door, when and for how long: 20s+5s")
      ->allow_extra_args(false);
  command
      .add_option("--load", options.loads,
                  "kg that people in the lift car weigh, and from when on: 300@10s")
      ->allow_extra_args(false);
}

LiftUnits::LiftUnits(const LiftUnitOptions& options) : options_(options) {
  if (options.door < 1 || options.door > lift::doors_max) throw UsageError("--door: 1 to 4");
  if (options.floors < 2 || options.floors > lift::floors_max) {
    throw UsageError("--floors: 2 to 254");
  }
  for (const std::string& text : options.in_door) plan_in_door(text);
  for (const std::string& text : options.loads) plan_load(text);
  std::ranges::stable_sort(plan_, {}, &Happening::at);
}

void LiftUnits::plan_in_door(const std::string& text) {
  const std::size_t plus = text.find('+');
  if (plus == std::string::npos) {
    throw UsageError(fmt::format("--in-door: '{}' has no end: write 20s+5s", text));
  }
  const Duration begin = parse_duration_argument(text.substr(0, plus));
  const Duration length = parse_duration_argument(text.substr(plus + 1));
  plan_.push_back({begin, [this](Time now) { door_.stand_in_way(now, true); }});
  plan_.push_back({begin + length, [this](Time now) { door_.stand_in_way(now, false); }});
}

void LiftUnits::plan_load(const std::string& text) {
  const std::size_t at = text.find('@');
  double kilograms = 0;
  const char* const end = text.data() + std::min(at, text.size());
  const auto [stop, error] = std::from_chars(text.data(), end, kilograms);
  const bool is_load =
      error == std::errc{} && stop == end && kilograms >= 0 && kilograms <= load_kg_max;
  if (at == std::string::npos || !is_load) {
    throw UsageError(
        fmt::format("--load: '{}' is no load with a time: write 300@10s, in kg up to "
                    "50000",
                    text));
  }
  const Duration begin = parse_duration_argument(text.substr(at + 1));
  plan_.push_back({begin, [this, kilograms](Time) { cell_.set_load(kilograms); }});
}

LiftDevice LiftUnits::make(std::string_view kind, NodeId id, const Port& port) {
  if (kind == lift_controller_kind) return make_controller(id, port, options_);
  if (kind == load_kind) {
    const auto device = make_load(id, port, cell_);
    look_again_.emplace_back([unit = device.get()] { unit->unit().hardware_changed(); });
    return held(device);
  }
  if (kind == light_barrier_kind) {
    return for_door(
        options_.door, [&]<unsigned door>() { return make_light_barrier<door>(id, port, door_); },
        [this](const auto& device) {
          look_again_.emplace_back([unit = device.get()] { unit->barrier().hardware_changed(); });
          return held(device);
        });
  }
  return for_door(
      options_.door, [&]<unsigned door>() { return make_door<door>(id, port, door_); },
      [this](const auto& device) {
        look_again_.emplace_back([unit = device.get()] { unit->door().hardware_changed(); });
        return held(device);
      });
}

void LiftUnits::step(Time now) {
  begin_ = begin_.value_or(now);
  const std::size_t before = done_;
  for (; done_ < plan_.size() && now - *begin_ >= plan_[done_].at; ++done_) {
    plan_[done_].happen(now);
  }
  if (done_ == before) return;
  for (const auto& look : look_again_) look();
}

}  // namespace canvoy::tools
