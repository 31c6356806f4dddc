#include "canvoy/tools/player/world_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

namespace {

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

/// Three digits, or as many as an integer has; rounding noise is removed.
std::string measure_text(double value, std::string_view unit) {
  constexpr double three_digits = 1000;
  constexpr double least = 1e-6;
  if (std::abs(value) < least) value = 0;
  std::string text =
      value < three_digits ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
  if (!unit.empty()) text.append(" ").append(unit);
  return text;
}

template <class Event>
Json json_of(const WorldNames& names, std::string_view name, const Event& event) {
  return {{"event", name}, {"bus", names.bus(event.bus)}, {"node", event.node}};
}

/// With the text at the end.
Told reported_of(const std::string& who, const std::string& what, Json json) {
  Told told{fmt::format("{}: {}", who, what), std::move(json)};
  told.json()["text"] = what;
  return told;
}

}  // namespace

std::string_view WorldNames::emergency(std::uint16_t code) const {
  return text::emergency_text(code);
}

Told::Told(std::string told, Json json)
    : text(std::move(told)), json_(std::make_unique<Json>(std::move(json))) {}
Told::Told(Told&& other) noexcept = default;
Told& Told::operator=(Told&& other) noexcept = default;
Told::~Told() = default;

std::string ReportedEvent::line() const {
  return fmt::format("{:>20}  {}\n", text::duration_text(at - Time{}), text);
}

ReportedEvent reported_at(Time at, Told told) {
  Json json{{"time", in_seconds(at - Time{})}};
  json.update(told.json());
  return {at, std::move(told.text), json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

Told told(const WorldNames& names, const BootedUp& event) {
  return reported_of(names.device(event.bus, event.node), "boot-up",
                     json_of(names, "boot-up", event));
}

Told told(const WorldNames& names, const NmtStateSeen& event) {
  const std::string_view state = text::nmt_state_text(event.state);
  Json json = json_of(names, "nmt-state", event);
  json["state"] = state;
  return reported_of(names.device(event.bus, event.node), fmt::format("NMT state {}", state),
                     std::move(json));
}

Told told(const WorldNames& names, const NmtCommandSeen& event) {
  const std::string_view command = command_text(event.command);
  const std::string who = event.node == 0 ? "all" : names.device(event.bus, event.node);
  Json json = json_of(names, "nmt-command", event);
  json["command"] = command;
  return reported_of("NMT command to " + who, std::string(command), std::move(json));
}

Told told(const WorldNames& names, const EmergencySeen& event) {
  Json json = json_of(names, "emergency", event);
  json["code"] = fmt::format("{:04X}", event.code);
  json["error_register"] = fmt::format("{:02X}", event.error_register);
  std::string text = fmt::format("EMERGENCY {:04X}h: {}", event.code, names.emergency(event.code));
  if (event.code == 0) {
    text =
        event.error_register == 0 ? "emergency: no error any more" : "emergency: an error is gone";
  }
  return reported_of(names.device(event.bus, event.node), text, std::move(json));
}

Told told(const WorldNames& names, const BusStateChanged& event) {
  const std::string_view state = text::bus_state_text(event.state);
  Json json = json_of(names, "can-state", event);
  json["state"] = state;
  return reported_of(names.device(event.bus, event.node), fmt::format("CAN controller {}", state),
                     std::move(json));
}

Told told(const WorldNames& names, const HandActed& event) {
  const std::string refused = event.refused.empty() ? "" : ": " + event.refused;
  Told told{fmt::format("hand: {}: {}{}", names.device(event.bus, event.node), event.what, refused),
            {{"event", "hand"}, {"node", event.node}, {"hand", event.what}}};
  if (!refused.empty()) told.json()["refused"] = event.refused;
  return told;
}

Told reported_fault(const WorldNames& names, bool begins, std::string_view fault,
                    const FaultPlace& place, std::string_view where) {
  Told told{fmt::format("{}: {}{}{}", begins ? "FAULT begins" : "fault ends", fault,
                        where.empty() ? "" : " ", where),
            {{"event", begins ? "fault-begins" : "fault-ends"}, {"fault", fault}}};
  if (!names.part().empty()) told.json()[std::string(names.part())] = place.part;
  if (place.node != 0) {
    told.json()["bus"] = names.bus(place.bus);
    told.json()["node"] = place.node;
  }
  told.json()["text"] = told.text;
  return told;
}

std::string invariant_text(const WorldNames& names, const Judged& invariant) {
  const InvariantRow& words = *invariant.kind;
  std::string text =
      invariant.part == 0 ? "" : fmt::format("{} {}: ", names.part(), invariant.part);
  if (invariant.fault != no_fault) text += names.fault(invariant.fault) + ": ";
  if (!invariant.is_decided()) return text + fmt::format("not decided: {}", words.text);
  return text + fmt::format("{} {}, {} allowed", words.text,
                            measure_text(invariant.worst, words.unit),
                            measure_text(invariant.allowed, words.unit));
}

Json invariant_json(const WorldNames& names, const Judged& invariant) {
  Json json{{"invariant", invariant.kind->name}};
  if (!names.part().empty()) json[std::string(names.part())] = invariant.part;
  if (invariant.fault != no_fault) json["fault"] = names.fault(invariant.fault);
  json["worst"] = invariant.worst;
  json["allowed"] = invariant.allowed;
  if (!invariant.kind->unit.empty()) json["unit"] = invariant.kind->unit;
  json["bound"] = invariant.kind->bound;
  json["judged"] = invariant.judged;
  json["decided"] = invariant.is_decided();
  json["held"] = invariant.held;
  return json;
}

Told reported_broken(const WorldNames& names, const Judged& invariant) {
  Told told{"FAIL: " + invariant_text(names, invariant), {{"event", "broken"}}};
  told.json().update(invariant_json(names, invariant));
  told.json()["text"] = told.text;
  return told;
}

void add_judged(Json& json, const WorldNames& names, std::span<const Judged> all) {
  Json invariants = Json::array();
  for (const Judged& each : all) invariants.push_back(invariant_json(names, each));
  json["invariants"] = std::move(invariants);
  json["all_held"] = std::ranges::all_of(all, &Judged::held);
  json["all_decided"] = std::ranges::all_of(all, &Judged::is_decided);
  if (!json.contains("time")) return;
  const double now = json["time"].get<double>();
  const auto at = Time(std::chrono::round<Duration>(std::chrono::duration<double>(now)));
  Json left = Json::array();
  for (const PresentFault& fault : names.faults_at(at)) {
    const double since = in_seconds(fault.since - Time{});
    left.push_back({{"fault", fault.text},
                    {"since", since},
                    {"lasted", now - since},
                    {"excused", fault.is_excuse}});
  }
  json["faults_left"] = std::move(left);
}

std::string faults_left_text(const Json& summary) {
  std::string text;
  for (const Json& fault : summary.value("faults_left", Json::array())) {
    const std::chrono::duration<double> lasted(fault.at("lasted").get<double>());
    text += fmt::format("  NOTE  {} was not mended, and is there for {}{}\n",
                        fault.at("fault").get<std::string>(),
                        text::duration_text(std::chrono::round<Duration>(lasted)),
                        fault.at("excused").get<bool>() ? ": what it can cause is excused" : "");
  }
  return text;
}

std::string invariant_line(const WorldNames& names, const Judged& invariant) {
  const std::string_view verdict = !invariant.is_decided() ? "----"
                                   : invariant.held        ? "PASS"
                                                           : "FAIL";
  return fmt::format("  {}  {}\n", verdict, invariant_text(names, invariant));
}

Json line_json(Time at, std::string_view event) {
  return {{"time", in_seconds(at - Time{})}, {"event", event}};
}

Json buses_json(const WorldNames& names, std::span<const BusSnapshot> buses) {
  constexpr double percent = 100;
  Json all = Json::array();
  for (const BusSnapshot& bus : buses) {
    all.push_back({{"bus", names.bus(all.size())},
                   {"load_percent", bus.load * percent},
                   {"frames", bus.frames},
                   {"error_frames", bus.error_frames}});
  }
  return all;
}

Json nodes_json(const WorldNames& names, std::span<const NodeSnapshot> nodes) {
  Json all = Json::array();
  for (const NodeSnapshot& node : nodes) {
    all.push_back({{"bus", names.bus(node.bus)},
                   {"node", node.id},
                   {"device", names.device(node.bus, node.id)},
                   {"state", state_text(node)},
                   {"can_state", text::bus_state_text(node.bus_state)},
                   {"error_register", fmt::format("{:02X}", node.error_register)}});
  }
  return all;
}

std::string_view state_text(const NodeSnapshot& node) {
  return node.is_powered ? text::nmt_state_text(node.state) : std::string_view("off");
}

}  // namespace canvoy::tools
