#include "canvoy/worlds/charger/yard_vehicles.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::charger {

YardVehicles::YardVehicles(const YardOptions& yard, Bays& bays, Note note)
    : yard_(&yard),
      options_(yard.vehicles),
      bays_(&bays),
      note_(std::move(note)),
      cables_(bays.size()) {
  for (const YardVehicle& vehicle : options_) {
    const ChargerOptions& of_bay = bays[vehicle.bay - 1]->options();
    vehicles_.push_back(
        {BatteryPlant(of_bay.battery, vehicle.state_of_charge, of_bay.ambience_celsius)});
  }
  for (const auto& bay : bays) bay->devices().plug(false);
}

const BatteryPlant& YardVehicles::cells(std::size_t vehicle) const {
  const Vehicle& it = vehicles_[vehicle];
  return it.place == VehiclePlace::plugged ? (*bays_)[bay(vehicle) - 1]->devices().plant().battery
                                           : it.battery;
}

void YardVehicles::step(Time now) {
  for (std::size_t vehicle = 0; vehicle < size(); ++vehicle) come_and_go(now, vehicle);
  for (std::size_t bay = 0; bay < cables_.size(); ++bay) serve(now, bay);
  if (now < rested_at_ + rest_step) return;
  for (Vehicle& vehicle : vehicles_) {
    if (vehicle.place == VehiclePlace::waiting) vehicle.battery.step(0, now - rested_at_);
  }
  rested_at_ = now;
}

void YardVehicles::come_and_go(Time now, std::size_t vehicle) {
  const YardVehicle& plan = options_[vehicle];
  Vehicle& it = vehicles_[vehicle];
  if (now >= plan.arrives && !std::exchange(it.has_come, true)) arrive(now, vehicle);
  if (now >= plan.leaves && !std::exchange(it.has_left, true)) leave(now, vehicle);
  if (now < plan.returns || std::exchange(it.has_returned, true)) return;
  drive(vehicle);
  arrive(now, vehicle);
}

void YardVehicles::arrive(Time now, std::size_t vehicle) {
  move(now, vehicle, VehiclePlace::waiting);
  cables_[bay(vehicle) - 1].waiting.push_back(vehicle);
}

void YardVehicles::leave(Time now, std::size_t vehicle) {
  const std::size_t bay = this->bay(vehicle) - 1;
  std::erase(cables_[bay].waiting, vehicle);
  if (cables_[bay].vehicle == vehicle) return unplug(now, bay, VehiclePlace::away);
  move(now, vehicle, VehiclePlace::away);
}

/// With an even current, in steps in which the cells warm up.
void YardVehicles::drive(std::size_t vehicle) {
  const YardVehicle& plan = options_[vehicle];
  BatteryPlant& battery = vehicles_[vehicle].battery;
  const Duration length = plan.returns - plan.leaves;
  const double hours = std::chrono::duration<double, std::ratio<3600>>(length).count();
  const double ampere = plan.used * battery.design().capacity_ampere_hour / hours;
  for (Duration driven{}; driven < length; driven += rest_step) {
    battery.step(-ampere, std::min(rest_step, length - driven));
  }
}

bool YardVehicles::is_served(std::size_t vehicle) const {
  const BatteryPlant& battery = cells(vehicle);
  const bool has_goal = yard_->goal && battery.state_of_charge() >= yard_->goal->state_of_charge;
  return has_goal || battery.is_full();
}

void YardVehicles::serve(Time now, std::size_t bay) {
  Cable& cable = cables_[bay];
  if (cable.waiting.empty()) return;
  if (cable.vehicle != nobody) {
    const bool is_needed = std::ranges::any_of(
        cable.waiting, [this](std::size_t vehicle) { return !is_served(vehicle); });
    if (!is_needed || !is_served(cable.vehicle)) return;
    cable.waiting.push_back(cable.vehicle);
    return unplug(now, bay, VehiclePlace::waiting);
  }
  if (now < cable.free_at) return;
  // One that is served already comes last.
  const auto next = std::ranges::find_if(
      cable.waiting, [this](std::size_t vehicle) { return !is_served(vehicle); });
  const std::size_t vehicle = next == cable.waiting.end() ? cable.waiting.front() : *next;
  std::erase(cable.waiting, vehicle);
  plug(now, vehicle);
}

void YardVehicles::plug(Time now, std::size_t vehicle) {
  const std::size_t bay = this->bay(vehicle) - 1;
  cables_[bay].vehicle = vehicle;
  devices(bay).plant().exchange(vehicles_[vehicle].battery);
  move(now, vehicle, VehiclePlace::plugged);
  devices(bay).plug(true);
}

void YardVehicles::unplug(Time now, std::size_t bay, VehiclePlace to) {
  const std::size_t vehicle = std::exchange(cables_[bay].vehicle, nobody);
  cables_[bay].free_at = now + yard_->change_time;
  BatteryPlant& battery = vehicles_[vehicle].battery;
  battery = devices(bay).plant().battery;
  battery.faults = {};
  devices(bay).plug(false);
  move(now, vehicle, to);
}

void YardVehicles::move(Time now, std::size_t vehicle, VehiclePlace to) {
  const VehiclePlace from = std::exchange(vehicles_[vehicle].place, to);
  note_(now, {.vehicle = static_cast<unsigned>(vehicle + 1),
              .bay = bay(vehicle),
              .from = from,
              .to = to,
              .state_of_charge = cells(vehicle).state_of_charge()});
}

}  // namespace canvoy::charger
