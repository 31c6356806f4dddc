#include "canvoy/tools/charging_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "canvoy/tools/text.hpp"
#include "canvoy/tools/time_text.hpp"
#include "canvoy/tools/value.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
// clang 16 does not deduce it by itself.
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

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

std::string_view command_text(NmtCommand command) {
  switch (command) {
    case NmtCommand::start:
      return "start";
    case NmtCommand::stop:
      return "stop";
    case NmtCommand::enter_pre_operational:
      return "enter pre-operational";
    case NmtCommand::reset_node:
      return "reset node";
    case NmtCommand::reset_communication:
      return "reset communication";
  }
  return "unknown";
}

std::string name_of_node(NodeId node, const ChargingOptions& options) {
  if (node == options.charger_id) return "charger";
  if (node == options.battery_id) return "battery";
  if (node == options.manager_id && node != 0) return "SDO manager";
  return node == 0 ? "all" : node_text(node);
}

std::string connection_text(const SdoConnectionChanged& it, const ChargingOptions& options) {
  const std::string client = name_of_node(it.client, options);
  if (it.server == options.manager_id) {
    return fmt::format("SDO manager: the {} is {} registered", client,
                       it.is_given ? "now" : "no longer");
  }
  return fmt::format("SDO manager: the {} {} an SDO connection to the {}", client,
                     it.is_given ? "has got" : "has no longer", name_of_node(it.server, options));
}

double seconds(Time at) {
  return std::chrono::duration<double>(at.time_since_epoch()).count();
}

std::string fault_text(std::size_t fault, const ChargingOptions& options) {
  const ScheduledFault& planned = options.faults.faults.at(fault);
  return fmt::format("{} at {}", fault_name(planned.kind), duration_text(planned.start - Time{}));
}

struct InvariantWords {
  std::string_view name;
  std::string_view unit;
};

InvariantWords words_of(InvariantKind kind) {
  switch (kind) {
    case InvariantKind::ampere_hours:
      return {"ampere-hours", "%"};
    case InvariantKind::energy:
      return {"energy", "%"};
    case InvariantKind::current_outside_handshake:
      return {"current outside of a handshake", "s"};
    case InvariantKind::current_before_ready:
      return {"current before ready", "times"};
    case InvariantKind::battery_left_waiting:
      return {"battery left without current", "s"};
    case InvariantKind::fault_seen:
      return {"fault seen", "s"};
  }
  return {"unknown", ""};
}

/// One line of the table: the object's name and its value in both nodes.
std::string object_row(const ObjectInfo& object, Node& charger, Node& battery) {
  const auto value = [&object](Node& node) -> std::string {
    const Result<Entry> entry = node.dictionary().find(object.index, 0);
    return entry ? value_text(&object.entry, entry->bytes()) : "";
  };
  return fmt::format("  {:<34}{:<22}{}\n", object.name, value(charger), value(battery));
}

std::string node_rows(const ChargingSnapshot& now) {
  const auto power = [](const ChargingSnapshot::NodeView& node) {
    return node.is_powered ? nmt_state_text(node.state) : std::string_view("off");
  };
  return fmt::format("  {:<34}{:<22}{}\n  {:<34}{:<22}{}\n  {:<34}{:<22}{}\n", "NMT state",
                     power(now.charger), power(now.battery), "CAN controller",
                     bus_state_text(now.charger.bus_state), bus_state_text(now.battery.bus_state),
                     "error register (1001h)", fmt::format("{:02X}h", now.charger.error_register),
                     fmt::format("{:02X}h", now.battery.error_register));
}

std::string last_events(const ChargingNetwork& network, std::size_t count) {
  std::string text;
  const auto events = network.events();
  for (const ChargingEvent& event : events.last(std::min(count, events.size()))) {
    text += fmt::format("  {:>20}  {}\n", duration_text(event.at - Time{}),
                        event_text(event, network.options()));
  }
  return text;
}

Json node_json(const ChargingSnapshot::NodeView& node) {
  return {{"node", node.id},
          {"state", node.is_powered ? nmt_state_text(node.state) : "off"},
          {"bus_state", bus_state_text(node.bus_state)},
          {"error_register", node.error_register}};
}

}  // namespace

std::string event_text(const ChargingEvent& event, const ChargingOptions& options) {
  const auto name = [&options](NodeId node) { return name_of_node(node, options); };
  return std::visit(
      Overload{
          [&](const BootedUp& it) { return fmt::format("{}: boot-up", name(it.node)); },
          [&](const NmtStateSeen& it) {
            return fmt::format("{}: NMT state {}", name(it.node), nmt_state_text(it.state));
          },
          [&](const NmtCommandSeen& it) {
            return fmt::format("NMT command to {}: {}", name(it.node), command_text(it.command));
          },
          [&](const EmergencySeen& it) {
            return fmt::format("{}: emergency {:04X}h, {} (error register {:02X}h)", name(it.node),
                               it.code, emergency_text(it.code), it.error_register);
          },
          [&](const BusStateChanged& it) {
            return fmt::format("{}: CAN controller {}", name(it.node), bus_state_text(it.state));
          },
          [&](const PhaseEntered& it) {
            return it.battery == 0 ? fmt::format("charger: {}", phase_text(it.phase))
                                   : fmt::format("charger: {}, {}", phase_text(it.phase),
                                                 node_text(it.battery));
          },
          [](const ReasonChanged& it) {
            return it.reason == cia419::StopReason::none
                       ? std::string("charger: may deliver")
                       : fmt::format("charger: delivers no current, {}",
                                     stop_reason_text(it.reason));
          },
          [](const ChargeBegan&) { return std::string("charger: a charge begins"); },
          [](const ChargeEnded& it) {
            return fmt::format("charger: the charge ends, {:.2f} Ah delivered until now",
                               it.ampere_hours);
          },
          [&](const FaultBegan& it) {
            return fmt::format("FAULT begins: {}", fault_text(it.fault, options));
          },
          [&](const FaultEnded& it) {
            return fmt::format("fault ends: {}", fault_text(it.fault, options));
          },
          [&](const InvariantBroken& it) {
            return fmt::format("INVARIANT BROKEN: {}", invariant_text(it.invariant, options));
          },
          [](const TimeSeen& it) {
            return fmt::format("charger: tells the time, {}", time_text(it.time));
          },
          [&](const SdoConnectionChanged& it) { return connection_text(it, options); },
      },
      event.what);
}

nlohmann::ordered_json event_json(const ChargingEvent& event) {
  Json json = {{"at", seconds(event.at)}};
  std::visit(
      Overload{
          [&](const BootedUp& it) {
            json.update({{"event", "boot-up"}, {"node", it.node}});
          },
          [&](const NmtStateSeen& it) {
            json.update(
                {{"event", "nmt-state"}, {"node", it.node}, {"state", nmt_state_text(it.state)}});
          },
          [&](const NmtCommandSeen& it) {
            json.update({{"event", "nmt-command"},
                         {"node", it.node},
                         {"command", command_text(it.command)}});
          },
          [&](const EmergencySeen& it) {
            json.update({{"event", "emergency"},
                         {"node", it.node},
                         {"code", it.code},
                         {"error_register", it.error_register},
                         {"text", emergency_text(it.code)}});
          },
          [&](const BusStateChanged& it) {
            json.update(
                {{"event", "bus-state"}, {"node", it.node}, {"state", bus_state_text(it.state)}});
          },
          [&](const PhaseEntered& it) {
            json.update(
                {{"event", "phase"}, {"text", phase_text(it.phase)}, {"battery", it.battery}});
          },
          [&](const ReasonChanged& it) {
            json.update({{"event", "reason"}, {"text", stop_reason_text(it.reason)}});
          },
          [&](const ChargeBegan&) {
            json.update({{"event", "charge-began"}});
          },
          [&](const ChargeEnded& it) {
            json.update({{"event", "charge-ended"}, {"ampere_hours", it.ampere_hours}});
          },
          [&](const FaultBegan& it) {
            json.update({{"event", "fault-began"}, {"fault", fault_name(it.kind)}});
          },
          [&](const FaultEnded& it) {
            json.update({{"event", "fault-ended"}, {"fault", fault_name(it.kind)}});
          },
          [&](const InvariantBroken& it) {
            json.update(
                {{"event", "invariant-broken"}, {"invariant", words_of(it.invariant.kind).name}});
          },
          [&](const TimeSeen& it) {
            json.update({{"event", "time"}, {"time", time_text(it.time)}});
          },
          [&](const SdoConnectionChanged& it) {
            json.update({{"event", "sdo-connection"},
                         {"client", it.client},
                         {"server", it.server},
                         {"given", it.is_given}});
          },
      },
      event.what);
  return json;
}

std::string invariant_text(const Invariant& invariant, const ChargingOptions& options) {
  const InvariantWords words = words_of(invariant.kind);
  std::string what(words.name);
  switch (invariant.kind) {
    case InvariantKind::ampere_hours:
    case InvariantKind::energy:
      what += ": charger and plant differ by";
      break;
    case InvariantKind::current_outside_handshake:
    case InvariantKind::battery_left_waiting:
      what += ": at most";
      break;
    case InvariantKind::current_before_ready:
      return fmt::format("{}: {:g} {}, none allowed", what, invariant.value, words.unit);
    case InvariantKind::fault_seen:
      what = fault_text(invariant.fault, options) + " seen after";
      break;
  }
  if (!invariant.decided) return fmt::format("{}: not decided, it ended too soon", what);
  return fmt::format("{} {:.3f} {}, {:g} {} allowed", what, invariant.value, words.unit,
                     invariant.bound, words.unit);
}

nlohmann::ordered_json invariant_json(const Invariant& invariant, const ChargingOptions& options) {
  const InvariantWords words = words_of(invariant.kind);
  Json json = {{"name", words.name}, {"value", invariant.value}, {"bound", invariant.bound},
               {"unit", words.unit}, {"held", invariant.held},   {"decided", invariant.decided}};
  if (invariant.kind == InvariantKind::fault_seen)
    json["fault"] = fault_text(invariant.fault, options);
  return json;
}

std::string table_text(ChargingNetwork& network, double speed) {
  const ChargingSnapshot now = network.snapshot();
  const ChargingOptions& options = network.options();
  std::string text = fmt::format("Canvoy: CiA 419 charger and CiA 418 battery at {} kbit/s\n\n",
                                 options.bit_rate / 1000);
  text += fmt::format(
      "  {:<34}{:<22}{}\n",
      duration_text(now.at - Time{}) + (speed > 0 ? fmt::format("  (x{:g})", speed) : ""),
      "charger, " + node_text(options.charger_id), "battery, " + node_text(options.battery_id));
  text += node_rows(now);
  for (const ObjectInfo* object : cia419::profile.objects) {
    if (object->index >= 0x6000)
      text += object_row(*object, network.charger().node(), network.battery().node());
  }
  text += fmt::format("  {:<34}{}\n", "charger", stop_reason_text(now.reason));
  text += fmt::format("  {:<34}{:<22}{}\n", "current", fmt::format("{:.1f} A", now.measured_ampere),
                      fmt::format("{:.1f} A in the plant", now.ampere));
  text += fmt::format("  {:<34}{:<22}{}\n", "delivered since the start",
                      fmt::format("{:.2f} Ah", now.counted_ampere_hours),
                      fmt::format("{:.2f} Ah in the plant", now.ampere_hours));
  text += fmt::format("  {:<34}{:.1f} %, {} frames, {} error frames\n\n", "bus load",
                      now.bus_load * 100, now.frames, now.error_frames);
  return text + last_events(network, 8);
}

nlohmann::ordered_json snapshot_json(const ChargingSnapshot& now) {
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  return {{"at", seconds(now.at)},
          {"charger", node_json(now.charger)},
          {"battery", node_json(now.battery)},
          {"reason", stop_reason_text(now.reason)},
          {"current_ampere", now.measured_ampere},
          {"requested_ampere", optional(now.readings.requested_current_ampere)},
          {"voltage_volt", optional(now.readings.voltage_volt)},
          {"temperature_celsius", optional(now.readings.temperature_celsius)},
          {"state_of_charge_percent", optional(now.readings.state_of_charge_percent)},
          {"ampere_hours", now.counted_ampere_hours},
          {"watt_hours", now.counted_watt_hours},
          {"bus_load_percent", now.bus_load * 100}};
}

std::string summary_text(ChargingNetwork& network) {
  const ChargingSnapshot end = network.snapshot();
  std::string text = fmt::format(
      "{} simulated: battery at {:.1f} %, {:.1f} °C, {:.2f} V; {:.2f} Ah and {:.2f} kWh delivered; "
      "{} frames, {} error frames\n",
      duration_text(end.at - Time{}), end.state_of_charge * 100, end.celsius, end.volt,
      end.counted_ampere_hours, end.counted_watt_hours / 1000, end.frames, end.error_frames);
  for (const Invariant& invariant : network.invariants()) {
    text += fmt::format("  {}  {}\n",
                        !invariant.decided ? "open  "
                        : invariant.held   ? "held  "
                                           : "BROKEN",
                        invariant_text(invariant, network.options()));
  }
  return text;
}

nlohmann::ordered_json summary_json(ChargingNetwork& network) {
  const ChargingSnapshot end = network.snapshot();
  Json invariants = Json::array();
  for (const Invariant& invariant : network.invariants()) {
    invariants.push_back(invariant_json(invariant, network.options()));
  }
  return {{"summary", snapshot_json(end)},
          {"plant",
           {{"ampere_hours", end.ampere_hours},
            {"watt_hours", end.watt_hours},
            {"state_of_charge_percent", end.state_of_charge * 100}}},
          {"frames", end.frames},
          {"error_frames", end.error_frames},
          {"invariants", invariants},
          {"all_held", network.all_hold()}};
}

}  // namespace canvoy::tools
