#include "canvoy/worlds/charger/yard_options.hpp"

#include <algorithm>

#include "canvoy/can/random.hpp"

namespace canvoy::charger {

namespace {

/// Of a flooded lead-acid battery of 400 Ah: I5 / 1.33, 2.4 V, 3 A and 2 A for each 100 Ah.
constexpr cia419::ChargeCurveSettings lead_acid_curve = {.current_ampere = 60,
                                                         .cell_voltage_volt = 2.4,
                                                         .tail_ampere = 12,
                                                         .equalising_ampere = 8,
                                                         .equalising_time = 1h};

bool has(const std::vector<unsigned>& bays, unsigned bay) {
  return std::ranges::find(bays, bay) != bays.end();
}

BatteryDesign design_of(BatteryKind kind) {
  if (kind == BatteryKind::lithium) return BatteryPlant::lithium_48v();
  BatteryDesign design = BatteryPlant::lead_acid_48v();
  design.asks = kind == BatteryKind::lead_acid;
  return design;
}

}  // namespace

bool YardOptions::plays(unsigned bay) const {
  return !has(real_chargers, bay) && !has(real_batteries, bay);
}

BatteryKind kind_of_bay(const YardOptions& yard, unsigned bay) {
  return yard.kinds.empty() ? BatteryKind::lead_acid : yard.kinds[(bay - 1) % yard.kinds.size()];
}

std::vector<std::size_t> faults_of_bay(const YardOptions& yard, unsigned bay) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < yard.bay.faults.faults.size(); ++i) {
    if (yard.bay.faults.faults[i].part == bay) found.push_back(i);
  }
  return found;
}

ChargerOptions bay_options(const YardOptions& yard, unsigned bay) {
  ChargerOptions options = yard.bay;
  options.faults.seed += bay - 1;
  options.faults.faults.clear();
  for (const std::size_t fault : faults_of_bay(yard, bay)) {
    options.faults.faults.push_back(yard.bay.faults.faults[fault]);
  }
  options.plays_charger = !has(yard.real_chargers, bay);
  options.plays_battery = !has(yard.real_batteries, bay);
  const BatteryKind kind = kind_of_bay(yard, bay);
  options.battery = design_of(kind);
  if (kind == BatteryKind::plain) options.charger.curve = lead_acid_curve;
  if (!yard.one_bus) return options;
  options.charger_id = static_cast<NodeId>(options.charger_id + bay - 1);
  options.battery_id = static_cast<NodeId>(options.battery_id + bay - 1);
  if (options.charger.bay_battery == 0) options.charger.bay_battery = options.battery_id;
  options.manager_id = 0;
  if (bay > 1) options.begin.reset();  // one producer of TIME on a bus
  return options;
}

std::vector<YardVehicle> drawn_vehicles(const YardOptions& yard) {
  Random random(yard.bay.faults.seed);
  std::vector<YardVehicle> vehicles;
  for (unsigned i = 0; i < yard.batteries; ++i) {
    YardVehicle vehicle{.bay = i % yard.chargers + 1};
    const bool is_first = i < yard.chargers;
    vehicle.arrives = Time(std::chrono::seconds(random.below(is_first ? 1800 : 7200)));
    vehicle.state_of_charge = std::min(1.0, yard.bay.state_of_charge + 0.001 * random.below(301));
    if (yard.goal) {
      vehicle.leaves = yard.goal->at + 30min + std::chrono::seconds(random.below(1800));
      vehicle.returns = vehicle.leaves + 10h;
    }
    vehicles.push_back(vehicle);
  }
  return vehicles;
}

}  // namespace canvoy::charger
