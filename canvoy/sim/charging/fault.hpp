// What goes wrong between a battery and its charger, when and for how long: a plain struct of
// options. With the seed it decides every failure.
//
//     FaultPlan plan{.seed = 1, .faults = {{FaultKind::heartbeat_loss, Time(20min)}}};
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/sim/fault.hpp"

namespace canvoy::charging {

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
  clock_drift,
};

inline constexpr std::size_t fault_kinds = static_cast<std::size_t>(FaultKind::clock_drift) + 1;

/// All kinds, in the order of FaultKind. They have no places: there is one of each.
FaultGrammar fault_grammar();
std::string_view fault_name(FaultKind kind);

struct ScheduledFault {
  FaultKind kind = FaultKind::heartbeat_loss;
  Time start{};
  Duration duration = for_the_rest;

  Time end() const { return end_of_fault(start, duration); }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};
ScheduledFault scheduled(const WrittenFault& fault);
WrittenFault written(const ScheduledFault& fault);

/// The schedule, and how bad the faults are.
struct FaultPlan {
  std::uint64_t seed = 1;  ///< of what is left to chance
  std::vector<ScheduledFault> faults{};
  double corrupted_share = 0.01;           ///< corrupted_frames: of all frames, 0 to 1
  std::int32_t clock_drift_ppm = 5000;     ///< clock_drift: of the battery's clock
  double hot_celsius = 55;                 ///< too_hot: what the battery's sensor shows
  double cold_celsius = -12;               ///< too_cold
  std::uint32_t wrong_bit_rate = 250'000;  ///< wrong_bit_rate: of the battery, in bit/s
};

}  // namespace canvoy::charging
