// What goes wrong in a simulated network, when and for how long: a plain struct of options. With
// the seed it decides every failure.
//
//     FaultPlan plan{.seed = 1, .faults = {{FaultKind::heartbeat_loss, Time(20min)}}};
//     FaultParse parsed = parse_fault("heartbeat-loss@20min+30s");
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// All in the network of a battery and its charger.
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

struct FaultName {
  FaultKind kind;
  std::string_view name;         ///< as it is written: `heartbeat-loss`
  std::string_view description;  ///< one line for a help text
};

/// All kinds, in the order of FaultKind.
std::span<const FaultName> fault_names();
std::string_view fault_name(FaultKind kind);

/// The duration of a fault that is not mended.
inline constexpr Duration for_the_rest = Duration::max();

struct ScheduledFault {
  FaultKind kind = FaultKind::heartbeat_loss;
  Time start{};
  Duration duration = for_the_rest;

  Time end() const { return duration == for_the_rest ? never : start + duration; }
  friend bool operator==(const ScheduledFault&, const ScheduledFault&) = default;
};

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

/// When something begins, and for how long it lasts.
struct FaultTimes {
  Time start{};
  Duration duration = for_the_rest;
};
/// Reads what stands behind the name of a fault: `20min` or `20min+30s`. Else in one line what is
/// wrong.
struct FaultTimesParse {
  std::optional<FaultTimes> times;
  std::string error;
};
FaultTimesParse parse_fault_times(std::string_view text);

/// A fault, or in one line what is wrong with the text and what would be right.
struct FaultParse {
  std::optional<ScheduledFault> fault;
  std::string error;
};

/// `NAME@START` or `NAME@START+DURATION`, as in `heartbeat-loss@20min+30s`.
FaultParse parse_fault(std::string_view text);

}  // namespace canvoy
