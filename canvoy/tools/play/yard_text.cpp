#include "canvoy/tools/play/yard_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/play/charger_teller.hpp"

namespace canvoy::tools {

namespace {

using charger::ChargerSnapshot;
using charger::ChargingBay;
using charger::ChargingYard;
using charger::VehicleMoved;
using charger::VehiclePlace;
using charger::VehicleSnapshot;
using charger::YardEvent;
using charger::YardInvariantKind;
using charger::YardSnapshot;

constexpr double percent = 100;
constexpr double kilo = 1000;

/// `part` is what numbers of invariants stand for.
class YardNames : public PlanNames<charger::FaultKind> {
 public:
  explicit YardNames(const ChargingYard& yard, std::string_view part = "bay")
      : PlanNames(yard.options().bay.faults), yard_(yard), part_(part) {}

  std::string device(BusIndex bus, NodeId id) const override {
    const ChargingBay* const bay = yard_.bay_of(bus, id);
    if (bay == nullptr) return text::node_text(id);
    const bool is_charger = id == bay->options().charger_id;
    return is_charger ? "charger" : "battery";
  }
  std::string_view part() const override { return part_; }

 private:
  const ChargingYard& yard_;
  std::string_view part_;
};

bool is_of_battery(const Judged& it) {
  return it.kind == &invariant_name(YardInvariantKind::battery_goal) ||
         it.kind == &invariant_name(YardInvariantKind::equalised);
}
std::string_view part_of(const Judged& it) {
  return is_of_battery(it) ? "battery" : "bay";
}

std::string_view place_text(VehiclePlace place) {
  switch (place) {
    case VehiclePlace::waiting:
      return "waits";
    case VehiclePlace::plugged:
      return "plugged in";
    case VehiclePlace::away:
      break;
  }
  return "away";
}

std::string moved_text(const VehicleMoved& moved) {
  const double charge = moved.state_of_charge * percent;
  const std::string who = fmt::format("battery {}", moved.vehicle);
  if (moved.from == VehiclePlace::away) return fmt::format("{} comes with {:.1f} %", who, charge);
  if (moved.to == VehiclePlace::away) return fmt::format("{} leaves with {:.1f} %", who, charge);
  const std::string_view way = moved.to == VehiclePlace::plugged ? "is plugged in" : "makes room";
  return fmt::format("{} {} with {:.1f} %", who, way, charge);
}

std::string_view moved_name(const VehicleMoved& moved) {
  if (moved.from == VehiclePlace::away) return "battery-comes";
  if (moved.to == VehiclePlace::away) return "battery-leaves";
  return moved.to == VehiclePlace::plugged ? "battery-plugged" : "battery-unplugged";
}

Told reported_move(const VehicleMoved& moved) {
  const std::string text = moved_text(moved);
  return {fmt::format("bay {}: {}", moved.bay, text),
          {{"event", moved_name(moved)},
           {"bay", moved.bay},
           {"vehicle", moved.vehicle},
           {"state_of_charge_percent", moved.state_of_charge * percent},
           {"text", text}}};
}

Told reported_event(const YardEvent& event, const ChargingYard& yard) {
  if (const auto* of_bay = std::get_if<charger::ChargerEvent>(&event.what)) {
    Told told = std::visit(
        ChargerTeller(yard.bay(event.bay - 1).options(), yard.options().bay.faults, event.bay),
        of_bay->what);
    told.json()["bay"] = event.bay;
    if (told.text.find("bay ") == std::string::npos) {
      told.text = fmt::format("bay {}: {}", event.bay, told.text);
    }
    return told;
  }
  if (const auto* moved = std::get_if<VehicleMoved>(&event.what)) return reported_move(*moved);
  const Judged broken =
      judged(std::get<canvoy::InvariantBroken<YardInvariantKind>>(event.what).invariant);
  return reported_broken(YardNames(yard, part_of(broken)), broken);
}

std::string goal_text(const ChargingYard& yard) {
  const auto& goal = yard.options().goal;
  if (!goal) return "";
  return fmt::format(", goal {:.0f} % after {}", goal->state_of_charge * percent,
                     text::duration_text(goal->at - Time{}));
}

/// `1 charger, 3 batteries`
std::string size_text(const YardSnapshot& yard, std::string_view between) {
  const std::size_t bays = yard.bays.size();
  const std::size_t batteries = yard.vehicles.size();
  return fmt::format("{} charger{}{}{} batter{}", bays, bays == 1 ? "" : "s", between, batteries,
                     batteries == 1 ? "y" : "ies");
}

std::string bay_row(unsigned number, const ChargerSnapshot& bay, double mains_watt_hours) {
  return fmt::format("  {:<8}{:<44}{:>9.1f} A{:>9.2f} V{:>10.2f} kWh\n",
                     fmt::format("bay {}", number), text::stop_reason_text(bay.reason), bay.ampere,
                     bay.volt, mains_watt_hours / kilo);
}

std::string vehicle_row(unsigned number, const VehicleSnapshot& vehicle) {
  const std::string at_goal =
      vehicle.at_goal ? fmt::format("{:.1f} % at the goal", *vehicle.at_goal * percent) : "";
  return fmt::format("  {:<13}{:<7}{:<12}{:>6.1f} %{:>8.1f} °C  {}\n",
                     fmt::format("battery {}", number), fmt::format("bay {}", vehicle.bay),
                     place_text(vehicle.place), vehicle.state_of_charge * percent, vehicle.celsius,
                     at_goal);
}

std::string rows_text(const ChargingYard& yard, const YardSnapshot& now) {
  std::string text;
  for (std::size_t i = 0; i < now.bays.size(); ++i) {
    text += bay_row(static_cast<unsigned>(i + 1), now.bays[i], yard.referee().mains_watt_hours(i));
  }
  for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
    text += vehicle_row(static_cast<unsigned>(i + 1), now.vehicles[i]);
  }
  return text;
}

Json bay_json(const ChargingYard& yard, std::size_t number, const ChargerSnapshot& bay) {
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  return {{"bay", number + 1},
          {"battery_kind", charger::battery_kind_names[static_cast<std::size_t>(
                               kind_of_bay(yard.options(), static_cast<unsigned>(number + 1)))]},
          {"reason", text::stop_reason_text(bay.reason)},
          {"current_a", bay.measured_ampere},
          {"requested_current_a", optional(bay.readings.requested_current_ampere)},
          {"charge_ah", bay.counted_ampere_hours},
          {"energy_wh", bay.counted_watt_hours},
          {"mains_wh", yard.referee().mains_watt_hours(number)},
          {"plant",
           {{"current_a", bay.ampere},
            {"voltage_v", bay.volt},
            {"charge_ah", bay.ampere_hours},
            {"energy_wh", bay.watt_hours}}}};
}

Json vehicle_json(std::size_t number, const VehicleSnapshot& vehicle) {
  Json json{{"vehicle", number + 1},
            {"bay", vehicle.bay},
            {"place", place_text(vehicle.place)},
            {"state_of_charge_percent", vehicle.state_of_charge * percent},
            {"temperature_celsius", vehicle.celsius},
            {"full", vehicle.is_full}};
  if (vehicle.at_goal) json["at_goal_percent"] = *vehicle.at_goal * percent;
  return json;
}

Json look_json(ChargingYard& yard, std::string_view event) {
  const YardSnapshot now = yard.snapshot();
  const YardNames names(yard);
  Json json = line_json(now.at, event);
  json["bays"] = Json::array();
  json["vehicles"] = Json::array();
  std::vector<NodeSnapshot> nodes;
  double ampere = 0;
  for (std::size_t i = 0; i < now.bays.size(); ++i) {
    json["bays"].push_back(bay_json(yard, i, now.bays[i]));
    nodes.push_back(now.bays[i].charger);
    nodes.push_back(now.bays[i].battery);
    ampere += now.bays[i].ampere;
  }
  for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
    json["vehicles"].push_back(vehicle_json(i, now.vehicles[i]));
  }
  if (const auto& goal = yard.options().goal) {
    json["goal"] = {{"state_of_charge_percent", goal->state_of_charge * percent},
                    {"at", std::chrono::duration<double>(goal->at - Time{}).count()}};
  }
  json["current_a"] = ampere;
  json["mains_wh"] = now.mains_watt_hours;
  json["mains_w_max"] = now.mains_watt_max;
  json["buses"] = buses_json(names, now.buses);
  json["nodes"] = nodes_json(names, nodes);
  return json;
}

}  // namespace

std::vector<Judged> judged_of(const ChargingYard& yard) {
  std::vector<Judged> all;
  for (const charger::YardInvariant& each : yard.goals()) all.push_back(judged(each));
  for (const charger::Invariant& each : yard.invariants()) all.push_back(judged(each));
  return all;
}

ReportedEvent WorldText<ChargingYard>::event(const YardEvent& event, const ChargingYard& yard) {
  return reported_at(event.at, reported_event(event, yard));
}

std::string WorldText<ChargingYard>::picture(ChargingYard& yard, double speed) {
  const YardSnapshot now = yard.snapshot();
  std::string text =
      fmt::format("Canvoy: a charging yard, {}{}\n\n", size_text(now, " and "), goal_text(yard));
  text += fmt::format("  {}{}, {:.2f} kWh from the mains, {:.1f} kW at most\n\n",
                      text::duration_text(now.at - Time{}),
                      speed > 0 ? fmt::format("  (x{:g})", speed) : "", now.mains_watt_hours / kilo,
                      now.mains_watt_max / kilo);
  text += rows_text(yard, now);
  return text + "\n" + last_events(yard, 8);
}

nlohmann::ordered_json WorldText<ChargingYard>::snapshot(ChargingYard& yard) {
  return look_json(yard, "snapshot");
}

std::string WorldText<ChargingYard>::summary_text(ChargingYard& yard) {
  const YardSnapshot end = yard.snapshot();
  std::uint64_t frames = 0;
  std::uint64_t error_frames = 0;
  for (const BusSnapshot& bus : end.buses) {
    frames += bus.frames;
    error_frames += bus.error_frames;
  }
  std::string text = fmt::format(
      "{} simulated: {}{}; {:.2f} kWh from the mains, {:.1f} kW at most; "
      "{} frames, {} error frames\n",
      text::duration_text(end.at - Time{}), size_text(end, ", "), goal_text(yard),
      end.mains_watt_hours / kilo, end.mains_watt_max / kilo, frames, error_frames);
  text += rows_text(yard, end);
  for (const Judged& each : judged_of(yard)) {
    text += invariant_line(YardNames(yard, part_of(each)), each);
  }
  return text;
}

nlohmann::ordered_json WorldText<ChargingYard>::summary(ChargingYard& yard) {
  Json json = look_json(yard, "summary");
  const std::vector<Judged> all = judged_of(yard);
  add_judged(json, YardNames(yard), all);
  // Goals are of batteries, and all else of bays.
  for (std::size_t i = 0; i < all.size(); ++i) {
    json["invariants"][i] = invariant_json(YardNames(yard, part_of(all[i])), all[i]);
  }
  return json;
}

}  // namespace canvoy::tools
