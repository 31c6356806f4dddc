#include "canvoy/tools/play/charger_text.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using charger::ChargerEvent;
using charger::ChargerNetwork;
using charger::ChargerOptions;
using charger::ChargerSnapshot;
using charger::SdoConnectionChanged;

std::string_view phase_text(cia419::ChargerPhase phase) {
  switch (phase) {
    case cia419::ChargerPhase::unplugged:
      return "waits for a pilot signal";
    case cia419::ChargerPhase::searching:
      return "searches for a battery";
    case cia419::ChargerPhase::linking:
      return "asks the battery for its PDOs";
    case cia419::ChargerPhase::linked:
      return "is linked to the battery";
  }
  return "is in an unknown phase";
}

std::string name_of_node(NodeId node, const ChargerOptions& options) {
  if (node == options.charger_id) return "charger";
  if (node == options.battery_id) return "battery";
  if (node == options.manager_id && node != 0) return "SDO manager";
  return node == 0 ? "all" : text::node_text(node);
}

std::string connection_text(const SdoConnectionChanged& it, const ChargerOptions& options) {
  const std::string client = name_of_node(it.client, options);
  if (it.server == options.manager_id) {
    return fmt::format("SDO manager: the {} is {} registered", client,
                       it.is_given ? "now" : "no longer");
  }
  return fmt::format("SDO manager: the {} {} an SDO connection to the {}", client,
                     it.is_given ? "has got" : "has no longer", name_of_node(it.server, options));
}

class ChargerNames : public PlanNames<charger::FaultKind> {
 public:
  explicit ChargerNames(const ChargerOptions& options)
      : PlanNames(options.faults), options_(options) {}

  std::string device(BusIndex, NodeId id) const override { return name_of_node(id, options_); }
  const ChargerOptions& options() const { return options_; }

 private:
  const ChargerOptions& options_;
};

/// One line of the table: the name of the object and its value in both nodes.
std::string object_row(const ObjectInfo& object, Node& charger, Node& battery) {
  const auto value = [&object](Node& node) -> std::string {
    const Result<Entry> entry = node.dictionary().find(object.index, 0);
    return entry ? text::value_text(&object.entry, entry->bytes()) : "";
  };
  return fmt::format("  {:<34}{:<22}{}\n", object.name, value(charger), value(battery));
}

std::string node_rows(const ChargerSnapshot& now) {
  return fmt::format("  {:<34}{:<22}{}\n  {:<34}{:<22}{}\n  {:<34}{:<22}{}\n", "NMT state",
                     state_text(now.charger), state_text(now.battery), "CAN controller",
                     text::bus_state_text(now.charger.bus_state),
                     text::bus_state_text(now.battery.bus_state), "error register (1001h)",
                     fmt::format("{:02X}h", now.charger.error_register),
                     fmt::format("{:02X}h", now.battery.error_register));
}

class ChargerTeller : public WorldTeller<ChargerNames> {
 public:
  using WorldTeller::WorldTeller;
  using WorldTeller::operator();

  Told operator()(const charger::PhaseEntered& event) const {
    std::string text(phase_text(event.phase));
    if (event.battery != 0) text += ", " + text::node_text(event.battery);
    return charger(text, {{"event", "phase"}, {"battery", event.battery}});
  }
  Told operator()(const charger::ReasonChanged& event) const {
    const std::string_view reason = text::stop_reason_text(event.reason);
    const bool is_free = event.reason == cia419::StopReason::none;
    return charger(is_free ? "may deliver" : fmt::format("delivers no current, {}", reason),
                   {{"event", "reason"}, {"reason", reason}});
  }
  Told operator()(const charger::ChargeBegan&) const {
    return charger("a charge begins", {{"event", "charge-begins"}});
  }
  Told operator()(const charger::ChargeEnded& event) const {
    return charger(
        fmt::format("the charge ends, {:.2f} Ah delivered until now", event.ampere_hours),
        {{"event", "charge-ends"}, {"charge_ah", event.ampere_hours}});
  }
  Told operator()(const charger::TimeSeen& event) const {
    const std::string time = text::time_text(event.time);
    return charger(fmt::format("tells the time, {}", time),
                   {{"event", "time-of-day"}, {"time_of_day", time}});
  }
  Told operator()(const charger::SdoConnectionChanged& event) const {
    const std::string text = connection_text(event, names_.options());
    return {text,
            {{"event", "sdo-connection"},
             {"client", event.client},
             {"server", event.server},
             {"given", event.is_given},
             {"text", text}}};
  }

 private:
  static Told charger(const std::string& text, Json json) {
    Told told{"charger: " + text, std::move(json)};
    told.json()["text"] = text;
    return told;
  }
};

}  // namespace

ToldEvent WorldText<charger::ChargerNetwork>::event(const ChargerEvent& event,
                                                    const ChargerNetwork& network) {
  return told_at(event.at, std::visit(ChargerTeller(network.options()), event.what));
}

std::string WorldText<charger::ChargerNetwork>::picture(ChargerNetwork& network, double speed) {
  const ChargerSnapshot now = network.snapshot();
  const ChargerOptions& options = network.options();
  std::string text = fmt::format("Canvoy: CiA 419 charger and CiA 418 battery at {} kbit/s\n\n",
                                 options.bit_rate / 1000);
  text += fmt::format(
      "  {:<34}{:<22}{}\n",
      text::duration_text(now.at - Time{}) + (speed > 0 ? fmt::format("  (x{:g})", speed) : ""),
      "charger, " + text::node_text(options.charger_id),
      "battery, " + text::node_text(options.battery_id));
  text += node_rows(now);
  for (const ObjectInfo* object : cia419::profile.objects) {
    if (object->index >= 0x6000)
      text += object_row(*object, network.charger().node(), network.battery().node());
  }
  text += fmt::format("  {:<34}{}\n", "charger", text::stop_reason_text(now.reason));
  text += fmt::format("  {:<34}{:<22}{}\n", "current", fmt::format("{:.1f} A", now.measured_ampere),
                      fmt::format("{:.1f} A in the plant", now.ampere));
  text += fmt::format("  {:<34}{:<22}{}\n", "delivered since the start",
                      fmt::format("{:.2f} Ah", now.counted_ampere_hours),
                      fmt::format("{:.2f} Ah in the plant", now.ampere_hours));
  text += fmt::format("  {:<34}{:.1f} %, {} frames, {} error frames\n\n", "bus load",
                      now.bus.load * 100, now.bus.frames, now.bus.error_frames);
  return text + last_events(network, 8);
}

namespace {

/// Measured, counted and reported values, beside the nodes.
Json values_json(const ChargerSnapshot& now) {
  constexpr double percent = 100;
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  return {{"reason", text::stop_reason_text(now.reason)},
          {"current_a", now.measured_ampere},
          {"requested_current_a", optional(now.readings.requested_current_ampere)},
          {"voltage_v", optional(now.readings.voltage_volt)},
          {"temperature_celsius", optional(now.readings.temperature_celsius)},
          {"state_of_charge_percent", optional(now.readings.state_of_charge_percent)},
          {"charge_ah", now.counted_ampere_hours},
          {"energy_wh", now.counted_watt_hours},
          {"plant",
           {{"current_a", now.ampere},
            {"voltage_v", now.volt},
            {"temperature_celsius", now.celsius},
            {"state_of_charge_percent", now.state_of_charge * percent},
            {"charge_ah", now.ampere_hours},
            {"energy_wh", now.watt_hours}}}};
}

Json look_json(ChargerNetwork& network, std::string_view event) {
  const ChargerSnapshot now = network.snapshot();
  const ChargerNames names(network.options());
  Json json = line_json(now.at, event);
  json.update(values_json(now));
  json["buses"] = buses_json(names, std::span(&now.bus, 1));
  json["nodes"] = nodes_json(names, std::array{now.charger, now.battery});
  return json;
}

}  // namespace

Json WorldText<charger::ChargerNetwork>::snapshot(ChargerNetwork& network) {
  return look_json(network, "snapshot");
}

std::string WorldText<charger::ChargerNetwork>::summary_text(ChargerNetwork& network) {
  const ChargerSnapshot end = network.snapshot();
  std::string text = fmt::format(
      "{} simulated: battery at {:.1f} %, {:.1f} °C, {:.2f} V; {:.2f} Ah and {:.2f} kWh delivered; "
      "{} frames, {} error frames\n",
      text::duration_text(end.at - Time{}), end.state_of_charge * 100, end.celsius, end.volt,
      end.counted_ampere_hours, end.counted_watt_hours / 1000, end.bus.frames,
      end.bus.error_frames);
  const std::vector<charger::Invariant> invariants = network.invariants();
  return text + invariants_text(ChargerNames(network.options()),
                                std::span<const charger::Invariant>(invariants));
}

Json WorldText<charger::ChargerNetwork>::summary(ChargerNetwork& network) {
  Json json = look_json(network, "summary");
  add_invariants(json, ChargerNames(network.options()),
                 std::span<const charger::Invariant>(network.invariants()));
  return json;
}

}  // namespace canvoy::tools
