// The faults between a battery and its charger. A plan of faults with its seed decides every
// failure.
//
//     FaultPlan plan{.seed = 1, .faults = {{FaultKind::heartbeat_loss, Time(20min)}}};
#pragma once

#include "canvoy/sim/fault.hpp"

namespace canvoy::charger {

/// What can break; fault_rows says what each kind does, and where by default.
enum class FaultKind : std::uint8_t {
  heartbeat_loss,
  pdo_loss,
  battery_silent,
  battery_restart,
  not_ready,
  too_hot,
  too_cold,
  invalid_temperature,
  invalid_voltage,
  pilot_loss,
  cable_cut,
  corrupted_frames,
  babbling_node,
  duplicate_node_id,
  wrong_bit_rate,
  clock_drift
};

/// Name in a file, and text of each kind, in the order of FaultKind.
inline constexpr FaultRow fault_rows[] = {
    {"heartbeat-loss", "the battery's heartbeat does not arrive; all else does"},
    {"pdo-loss", "the battery's TPDOs do not arrive"},
    {"battery-silent", "the battery module has no power"},
    {"battery-restart", "the battery module boots again"},
    {"not-ready", "the battery says that it is not ready"},
    {"too-hot", "the battery's temperature sensor shows 55 °C"},
    {"too-cold", "the battery's temperature sensor shows -12 °C"},
    {"invalid-temperature", "the battery cannot measure its temperature"},
    {"invalid-voltage", "the battery cannot measure its voltage"},
    {"pilot-loss", "the charger's pilot signal is gone"},
    {"cable-cut", "the bus cable is cut between the charger and the battery"},
    {"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    {"babbling-node", "a third node fills the bus with frames of the highest priority"},
    {"duplicate-node-id", "a second module at the battery boots with the node-ID of the first"},
    {"wrong-bit-rate", "the battery is set to 250 kbit/s"},
    {"clock-drift", "the battery's clock is fast by 0.5 %"},
};
/// Number of kinds of faults.
inline constexpr std::size_t fault_kinds = std::size(fault_rows);
static_assert(fault_kinds == static_cast<std::size_t>(FaultKind::clock_drift) + 1);
/// The bay of a charging yard; a network of one charger has the first one.
inline constexpr FaultPlaceName bay_place[] = {{"bay", 16, &AnyFault::part}};
/// How a plan of these faults is written and read; found by the type of its argument.
constexpr FaultGrammar grammar_of(FaultKind) {
  return {fault_rows, bay_place};
}

/// A fault of a plan: kind, place, begin and end.
using ScheduledFault = canvoy::ScheduledFault<FaultKind>;
/// The faults of a run, and the seed of all chance.
using FaultPlan = canvoy::FaultPlan<FaultKind>;

}  // namespace canvoy::charger
