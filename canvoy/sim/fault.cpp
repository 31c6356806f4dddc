#include "canvoy/sim/fault.hpp"

#include <array>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy {

namespace {

constexpr std::array names{
    FaultName{FaultKind::heartbeat_loss, "heartbeat-loss",
              "the battery's heartbeat does not arrive; all else does"},
    FaultName{FaultKind::pdo_loss, "pdo-loss", "the battery's TPDOs do not arrive"},
    FaultName{FaultKind::battery_silent, "battery-silent", "the battery module has no power"},
    FaultName{FaultKind::battery_restart, "battery-restart", "the battery module boots again"},
    FaultName{FaultKind::not_ready, "not-ready", "the battery says that it is not ready"},
    FaultName{FaultKind::too_hot, "too-hot", "the battery's temperature sensor shows 55 °C"},
    FaultName{FaultKind::too_cold, "too-cold", "the battery's temperature sensor shows -12 °C"},
    FaultName{FaultKind::invalid_temperature, "invalid-temperature",
              "the battery cannot measure its temperature"},
    FaultName{FaultKind::invalid_voltage, "invalid-voltage",
              "the battery cannot measure its voltage"},
    FaultName{FaultKind::pilot_loss, "pilot-loss", "the charger's pilot signal is gone"},
    FaultName{FaultKind::cable_cut, "cable-cut",
              "the bus cable is cut between the charger and the battery"},
    FaultName{FaultKind::corrupted_frames, "corrupted-frames",
              "one frame in a hundred is disturbed, and sent again"},
    FaultName{FaultKind::babbling_node, "babbling-node",
              "a third node fills the bus with frames of the highest priority"},
    FaultName{FaultKind::duplicate_node_id, "duplicate-node-id",
              "a second module at the battery boots with the node-ID of the first"},
    FaultName{FaultKind::wrong_bit_rate, "wrong-bit-rate", "the battery is set to 250 kbit/s"},
    FaultName{FaultKind::clock_drift, "clock-drift", "the battery's clock is fast by 0.5 %"},
};

FaultParse refuse(std::string_view text, const std::string& reason) {
  return {std::nullopt, "fault '" + std::string(text) + "': " + reason};
}

const FaultName* find(std::string_view name) {
  for (const FaultName& known : names) {
    if (known.name == name) return &known;
  }
  return nullptr;
}

std::string known_names() {
  std::string list;
  for (const FaultName& known : names) {
    list += (list.empty() ? "" : ", ") + std::string(known.name);
  }
  return list;
}

}  // namespace

std::span<const FaultName> fault_names() {
  return names;
}

std::string_view fault_name(FaultKind kind) {
  return names.at(static_cast<std::size_t>(kind)).name;
}

FaultParse parse_fault(std::string_view text) {
  const std::size_t at = text.find('@');
  const std::string_view name = text.substr(0, at);
  const FaultName* known = find(name);
  if (known == nullptr) {
    return refuse(text, "no such fault; there are " + known_names());
  }
  if (at == std::string_view::npos) {
    return refuse(
        text, "when? write " + std::string(name) + "@20min or " + std::string(name) + "@20min+30s");
  }
  const FaultTimesParse parsed = parse_fault_times(text.substr(at + 1));
  if (!parsed.times) return refuse(text, parsed.error);
  return {ScheduledFault{known->kind, parsed.times->start, parsed.times->duration}, {}};
}

FaultTimesParse parse_fault_times(std::string_view text) {
  const std::size_t plus = text.find('+');
  const auto start = parse_duration(text.substr(0, plus));
  const std::string units(duration_units);
  if (!start) return {{}, "the start is a number and " + units + ", as in @20min"};
  FaultTimes times{.start = Time(*start)};
  if (plus != std::string_view::npos) {
    const auto duration = parse_duration(text.substr(plus + 1));
    if (!duration || *duration == Duration(0)) {
      return {{}, "the duration is a number above 0 and " + units + ", as in +30s"};
    }
    times.duration = *duration;
  }
  return {times, {}};
}

}  // namespace canvoy
