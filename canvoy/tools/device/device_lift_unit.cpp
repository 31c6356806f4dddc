#include "canvoy/tools/device/device_lift_unit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/can/real_text.hpp"
#include "canvoy/devices/cia417/door/car_door_unit.hpp"
#include "canvoy/devices/cia417/load/load_measuring_unit.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_unit.hpp"
#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/worlds/lift/building.hpp"

namespace canvoy::tools {

void add_lift_unit_options(Verb& command, LiftUnitOptions& options) {
  command.add({
      {"--in-door", options.in_door,
       "somebody stands in the lift door, when and for how long: 20s+5s", one_each},
      {"--load", options.loads, "kg that people in the lift car weigh, and from when on: 300@10s",
       one_each},
  });
}

LiftUnits::LiftUnits(const LiftUnitOptions& options) {
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
  const auto [stop, error] = real_from_chars(text.data(), end, kilograms);
  const bool is_load =
      error == std::errc{} && stop == end && kilograms >= 0 && kilograms <= lift_load_kg_max;
  if (at == std::string::npos || !is_load) {
    throw UsageError(
        fmt::format("--load: '{}' is no load with a time: write 300@10s, in kg up to "
                    "50000",
                    text));
  }
  const Duration begin = parse_duration_argument(text.substr(at + 1));
  plan_.push_back({begin, [this, kilograms](Time) { cell_.set_load(kilograms); }});
}

void LiftUnits::join(Environment& environment) {
  using cia417::CarDoorUnit, cia417::LightBarrierUnit, cia417::LoadMeasuringUnit;
  environment.provide(callback<&lift::DoorPlant::hardware>(door_));
  environment.provide(callback<&lift::DoorPlant::light_barrier_hardware>(door_));
  environment.provide(callback<&lift::LoadCell::hardware>(cell_));
  environment.provide(callback<&LiftUnits::load_settings>(*this));
  environment.watch(callback<&LiftUnits::is_there<CarDoorUnit>>(*this));
  environment.watch(callback<&LiftUnits::is_there<LightBarrierUnit>>(*this));
  environment.watch(callback<&LiftUnits::is_there<LoadMeasuringUnit>>(*this));
}

cia417::LoadSettings LiftUnits::load_settings() {
  const lift::LiftDesign design;
  const auto kilograms = [&design](double share) {
    return static_cast<std::uint16_t>(design.car.rated_load_kg * share);
  };
  return {.tare_kg = design.car.mass_kg,
          .zero_load = kilograms(0.03),
          .norm_load = kilograms(0.5),
          .full_load = kilograms(0.8),
          .overload = kilograms(design.car.overload_share)};
}

template <class Unit>
void LiftUnits::is_there(Unit& unit, Node& /*node*/) {
  look_again_.emplace_back([&unit] { unit.hardware_changed(); });
}

void LiftUnits::step(Time now) {
  begin_ = begin_.value_or(now);
  const std::size_t before = done_;
  for (; done_ < plan_.size() && now - *begin_ >= plan_[done_].at; ++done_) {
    plan_[done_].happen(now);
  }
  if (done_ != before) look();
}

void LiftUnits::look() {
  for (const auto& unit : look_again_) unit();
}

}  // namespace canvoy::tools
