#include "canvoy/worlds/bus_line/on_board_computer.hpp"

#include <cmath>

#include "canvoy/devices/cia407/diagnostics/diagnostics_unit.hpp"
#include "canvoy/devices/cia407/kit/door_state.hpp"
#include "canvoy/devices/cia407/kit/motion_recognition.hpp"

namespace canvoy::bus_line {

namespace {

constexpr double pulses_a_metre = 8;

}  // namespace

void OnBoardComputer::add_nodes() {
  using namespace cia407;
  Environment& environment = nodes_.add_site();
  environment.provide(callback<&OnBoardComputer::hardware>(*this));
  environment.provide(callback<&OnBoardComputer::settings>(*this));
  environment.watch(unit_);
  environment.provide(callback<&OnBoardComputer::line_control_hardware>(*this));
  environment.provide(callback<&OnBoardComputer::line_control_settings>(*this));
  environment.watch(line_control_);
  nodes_.add(computer_id, environment);
  Environment& driver = nodes_.add_site();
  driver.provide(callback<&OnBoardComputer::identification_hardware>(*this));
  driver.watch(identification_);
  nodes_.add(identification_id, driver);
}

bool OnBoardComputer::log_in(const cia407::Assignment& assignment) {
  bool is_taken = false;
  nodes_.node(identification_id).with([&] {
    remembered_ = assignment;
    identification_->log_in(remembered_);
    is_taken = true;
  });
  return is_taken;
}

bool OnBoardComputer::press_stop_button() {
  bool is_taken = false;
  nodes_.node(computer_id).with([&] { is_taken = line_control_->press_stop_button(); });
  return is_taken;
}

unsigned OnBoardComputer::counted() const {
  const Dictionary& dictionary = nodes_.node(computer_id).node().dictionary();
  return dictionary.word(cia407::counter_passenger_sum_object.index, 0);
}

std::optional<RealMotion> OnBoardComputer::heard_motion() {
  BusNode& computer = nodes_.node(computer_id);
  if (!nodes_.is_at_work(vehicle_gateway_id) || !computer.is_operational()) return std::nullopt;
  cia407::VirtualDevice& heard = computer.device().virtual_device(1);
  const auto kmh = heard[cia407::wheel_based_vehicle_speed].value();
  if (!kmh) return std::nullopt;
  RealMotion real{.speed = *kmh / cia407::kmh_of_metres_per_second};
  const Dictionary& dictionary = computer.node().dictionary();
  for (unsigned i = 0; i < vehicle_.door_count(); ++i) {
    const cia407::DoorState door = cia407::door_state(dictionary, i + 1);
    real.known_doors |= (door.is_valid ? 1U : 0U) << i;
    real.open_doors |= (door.is_open ? 1U : 0U) << i;
  }
  return real;
}

LineControlHardware OnBoardComputer::line_control_hardware() {
  return {.computer = unit_,
          .odometer = callback<&OnBoardComputer::pulses_as_metres>(*this),
          .has_open_door = callback<&OnBoardComputer::has_open_door>(*this),
          .clock = callback<&OnBoardComputer::own_clock>(*this)};
}

LineControlSettings OnBoardComputer::line_control_settings() {
  const auto id = [this](DeviceKey key) { return nodes_.id(key); };
  const MessageIds messages = message_ids(options_.design);
  LineControlSettings settings{
      .line = &options_.line,
      .displays = {{id(front_display_id), DisplayUse::destination},
                   {id(side_display_id), DisplayUse::destination},
                   {id(next_stop_id), DisplayUse::next_stop},
                   {id(information_id), DisplayUse::information},
                   {id(train_gateway_id), DisplayUse::train}},
      .identification = id(identification_id),
      .identification_time_out = nodes_.heartbeat_time_out(identification_id),
      .positioning = id(positioning_id),
      .doors = id(vehicle_gateway_id),
      .train_stop_request_id = static_cast<std::uint16_t>(messages.train_stop_request),
      .train_gateway = id(train_gateway_id),
      .sources = {id(identification_id), id(positioning_id), id(vehicle_gateway_id),
                  id(counting_manager_id)}};
  for (const DevicePlace& place : device_places) {
    const bool is_other = place.id != computer_id && place.car == 1;
    if (is_other && nodes_.is_there(place.id)) settings.nodes.push_back(id(place.id));
  }
  for (const AddedDevice& added : options_.design.added) {
    if (added.car != 1) continue;
    settings.nodes.push_back(added.id);
    if (added.kind == cia407::DiagnosticsKind::info.name) settings.diagnostics = added.id;
  }
  return settings;
}

double OnBoardComputer::pulses_as_metres() {
  return std::floor(vehicle_.odometer() * pulses_a_metre) / pulses_a_metre;
}

/// Independent of satellites.
std::optional<cia407::CivilTime> OnBoardComputer::own_clock() {
  constexpr std::int64_t slow = 600;
  const std::int64_t wrong =
      (clock_is_wrong_ ? cia447::seconds_an_hour : 0) - (options_.sabotage.slow_clocks ? slow : 0);
  return cia447::civil_time(cia447::seconds_since_1970(clock_.local()) + wrong);
}

std::optional<cia407::CivilTime> OnBoardComputer::reported_clock() {
  return line_control_ == nullptr ? std::nullopt : line_control_->local_time();
}

cia407::MainOnBoardComputerHardware OnBoardComputer::hardware() {
  line_control_ = nullptr;  // the new device has none yet
  return {.clock = callback<&OnBoardComputer::reported_clock>(*this)};
}

cia407::MainOnBoardComputerSettings OnBoardComputer::settings() {
  return {.vehicle_id = 407, .body_id = 12, .garage_id = 1, .vehicle_id_text = "C-AN 407"};
}

cia407::IdentificationHardware OnBoardComputer::identification_hardware() {
  return {.remembered = callback<&OnBoardComputer::remembered>(*this)};
}

}  // namespace canvoy::bus_line
