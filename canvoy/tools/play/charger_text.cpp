#include "canvoy/tools/play/charger_text.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/play/charger_teller.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using charger::ChargerEvent;
using charger::ChargerNetwork;
using charger::ChargerOptions;
using charger::ChargerSnapshot;

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

}  // namespace

ReportedEvent WorldText<charger::ChargerNetwork>::event(const ChargerEvent& event,
                                                        const ChargerNetwork& network) {
  return reported_at(
      event.at, std::visit(ChargerTeller(network.options(), network.options().faults), event.what));
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
  const ChargerNames names(network.options(), network.options().faults);
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
  return text + invariants_text(ChargerNames(network.options(), network.options().faults),
                                std::span<const charger::Invariant>(invariants));
}

Json WorldText<charger::ChargerNetwork>::summary(ChargerNetwork& network) {
  Json json = look_json(network, "summary");
  add_invariants(json, ChargerNames(network.options(), network.options().faults),
                 std::span<const charger::Invariant>(network.invariants()));
  return json;
}

}  // namespace canvoy::tools
