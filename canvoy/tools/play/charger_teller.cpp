#include "canvoy/tools/play/charger_teller.hpp"

#include <fmt/format.h>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"

namespace canvoy::tools {

namespace {

using charger::ChargerOptions;
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

std::string of_bay(unsigned bay) {
  return bay == 0 ? "" : fmt::format("bay {}: ", bay);
}

}  // namespace

std::string ChargerNames::device(BusIndex, NodeId id) const {
  return of_bay(bay_) + name_of_node(id, options_);
}

Told ChargerTeller::operator()(const charger::PhaseEntered& event) const {
  std::string text(phase_text(event.phase));
  if (event.battery != 0) text += ", " + text::node_text(event.battery);
  return charger(text, {{"event", "phase"}, {"battery", event.battery}});
}

Told ChargerTeller::operator()(const charger::ReasonChanged& event) const {
  const std::string_view reason = text::stop_reason_text(event.reason);
  const bool is_free = event.reason == cia419::StopReason::none;
  return charger(is_free ? "may deliver" : fmt::format("delivers no current, {}", reason),
                 {{"event", "reason"}, {"reason", reason}});
}

Told ChargerTeller::operator()(const charger::ChargeBegan&) const {
  return charger("a charge begins", {{"event", "charge-begins"}});
}

Told ChargerTeller::operator()(const charger::ChargeEnded& event) const {
  return charger(fmt::format("the charge ends, {:.2f} Ah delivered until now", event.ampere_hours),
                 {{"event", "charge-ends"}, {"charge_ah", event.ampere_hours}});
}

Told ChargerTeller::operator()(const charger::TimeSeen& event) const {
  const std::string time = text::time_text(event.time);
  return charger(fmt::format("tells the time, {}", time),
                 {{"event", "time-of-day"}, {"time_of_day", time}});
}

Told ChargerTeller::operator()(const charger::SdoConnectionChanged& event) const {
  const std::string text = of_bay(names_.bay()) + connection_text(event, names_.options());
  return {text,
          {{"event", "sdo-connection"},
           {"client", event.client},
           {"server", event.server},
           {"given", event.is_given},
           {"text", text}}};
}

Told ChargerTeller::charger(const std::string& text, Json json) const {
  Told told{of_bay(names_.bay()) + "charger: " + text, std::move(json)};
  told.json()["text"] = text;
  return told;
}

}  // namespace canvoy::tools
