#include "canvoy/worlds/charger/fault_watch.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace canvoy::charger {

namespace {

using cia419::StopReason;

double seconds_of(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Allowed reactions of a charger to a fault; empty where it need not react.
std::span<const StopReason> answers_to(FaultKind kind) {
  static constexpr std::array silence{StopReason::heartbeat_lost, StopReason::battery_data_missed};
  static constexpr std::array heartbeat{StopReason::heartbeat_lost};
  static constexpr std::array data{StopReason::battery_data_missed};
  static constexpr std::array other_battery{StopReason::no_battery};
  static constexpr std::array not_ready{StopReason::battery_not_ready, StopReason::battery_full};
  // One sensor shows both: the later fault decides.
  static constexpr std::array temperatures{StopReason::too_hot, StopReason::too_cold};
  static constexpr std::array temperature{StopReason::invalid_temperature};
  static constexpr std::array voltage{StopReason::invalid_voltage};
  static constexpr std::array pilot{StopReason::no_pilot_signal};
  switch (kind) {
    case FaultKind::heartbeat_loss:
      return heartbeat;
    case FaultKind::pdo_loss:
      return data;
    case FaultKind::battery_silent:
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
    case FaultKind::wrong_bit_rate:
      return silence;
    case FaultKind::battery_restart:
    case FaultKind::duplicate_node_id:
      return other_battery;
    case FaultKind::not_ready:
      return not_ready;
    case FaultKind::too_hot:
    case FaultKind::too_cold:
      return temperatures;
    case FaultKind::invalid_temperature:
      return temperature;
    case FaultKind::invalid_voltage:
      return voltage;
    case FaultKind::pilot_loss:
      return pilot;
    case FaultKind::corrupted_frames:
    case FaultKind::clock_drift:
      break;
  }
  return {};
}

/// It reports the fault.
bool names(FaultKind kind, StopReason reason) {
  const std::span<const StopReason> answers = answers_to(kind);
  return std::find(answers.begin(), answers.end(), reason) != answers.end();
}

/// It reports the fault, or has stopped for a more serious reason.
bool is_answer(FaultKind kind, StopReason reason) {
  const std::span<const StopReason> answers = answers_to(kind);
  if (reason == StopReason::none || answers.empty()) return false;
  return reason < *std::min_element(answers.begin(), answers.end()) || names(kind, reason);
}

/// Its only sign is one boot-up message: a charger that misses it never detects it.
bool is_one_message(FaultKind kind) {
  return kind == FaultKind::battery_restart || kind == FaultKind::duplicate_node_id;
}

/// The charger detects it by the battery's process data.
bool is_value(FaultKind kind) {
  return kind == FaultKind::not_ready || kind == FaultKind::too_hot ||
         kind == FaultKind::too_cold || kind == FaultKind::invalid_temperature ||
         kind == FaultKind::invalid_voltage;
}

/// True if `by` keeps the sign of a fault of this kind from the charger.
bool is_masked(FaultKind kind, FaultKind by) {
  switch (by) {
    case FaultKind::battery_silent:
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
    case FaultKind::wrong_bit_rate:
      return is_value(kind) || is_one_message(kind);
    case FaultKind::pdo_loss:
      return is_value(kind);
    case FaultKind::heartbeat_loss:  // boot-up messages have the same CAN-ID
      return is_one_message(kind);
    default:
      return false;
  }
}

}  // namespace

std::optional<Duration> DetectionBounds::of(FaultKind kind) const {
  switch (kind) {
    case FaultKind::heartbeat_loss:
      return heartbeat_time + reaction_time;
    case FaultKind::pdo_loss:
      return data_time + reaction_time;
    case FaultKind::battery_silent:
    case FaultKind::cable_cut:
    case FaultKind::babbling_node:
    case FaultKind::wrong_bit_rate:
      return std::min(heartbeat_time, data_time) + reaction_time;
    case FaultKind::battery_restart:
    case FaultKind::duplicate_node_id:
    case FaultKind::pilot_loss:
      return reaction_time;
    case FaultKind::not_ready:
    case FaultKind::too_hot:
    case FaultKind::too_cold:
    case FaultKind::invalid_temperature:
    case FaultKind::invalid_voltage:
      return value_time + reaction_time;
    case FaultKind::corrupted_frames:
    case FaultKind::clock_drift:
      break;
  }
  return std::nullopt;
}

FaultWatch::FaultWatch(const FaultPlan& plan, const DetectionBounds& promises) {
  for (const ScheduledFault& fault : plan.faults) {
    const std::optional<Duration> bound = promises.of(fault.kind);
    Watched& watched = faults_.emplace_back();
    watched.kind = fault.kind;
    watched.must_be_seen = bound.has_value();
    watched.bound = bound.value_or(Duration(0));
  }
}

void FaultWatch::began(std::size_t fault, Time now, StopReason reason) {
  Watched& watched = faults_.at(fault);
  watched.has_begun = true;
  watched.began_at = now;
  watched.was_said_before = names(watched.kind, reason);
  for (Watched& other : faults_) {
    if (&other == &watched || !other.is_present()) continue;
    mask(other, watched);
    mask(watched, other);
  }
  note(now, reason);
  if (is_one_message(watched.kind) && reason != StopReason::none) watched.is_void = true;
}

void FaultWatch::mask(Watched& watched, const Watched& by) {
  if (!is_masked(watched.kind, by.kind) || !watched.is_open()) return;
  watched.bound += by.bound;
  if (is_one_message(watched.kind)) watched.is_void = true;
}

void FaultWatch::ended(std::size_t fault) {
  faults_.at(fault).is_over = true;
}

void FaultWatch::note(Time now, StopReason reason) {
  const bool has_second = has_second_battery();
  for (Watched& watched : faults_) {
    if (!watched.is_open()) continue;
    const bool is_masked = has_second && watched.kind != FaultKind::duplicate_node_id;
    if (is_masked) {
      watched.is_void = true;
      continue;
    }
    if (reason == StopReason::none) {
      watched.delivered_since = std::min(watched.delivered_since, now);
    }
    if (watched.delivered_since == never) {
      look_at_stopped(watched, now, reason);
      continue;
    }
    watched.watched = now - watched.delivered_since;
    watched.is_seen = is_answer(watched.kind, reason);
  }
}

/// Where nothing is delivered, what was said before the fault is no answer to it; a new one is, in
/// its time, but none is required.
void FaultWatch::look_at_stopped(Watched& watched, Time now, StopReason reason) {
  const bool is_said = names(watched.kind, reason);
  watched.was_said_before = watched.was_said_before && is_said;
  const Duration since = now - watched.began_at;
  if (!is_said || watched.was_said_before || since > watched.bound) return;
  watched.watched = since;
  watched.is_seen = true;
}

bool FaultWatch::has_second_battery() const {
  return std::any_of(faults_.begin(), faults_.end(), [](const Watched& watched) {
    return watched.kind == FaultKind::duplicate_node_id && watched.has_begun && !watched.is_over;
  });
}

std::vector<Invariant> FaultWatch::invariants() const {
  std::vector<Invariant> result;
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    if (faults_[i].counts()) result.push_back(invariant_of(i));
  }
  return result;
}

Invariant FaultWatch::invariant_of(std::size_t fault) const {
  const Watched& watched = faults_[fault];
  const bool in_time = watched.watched <= watched.bound;
  return {.kind = InvariantKind::fault_seen,
          .fault = fault,
          .worst = seconds_of(watched.watched),
          .allowed = seconds_of(watched.bound),
          .held = in_time,
          .judged = watched.is_seen || !in_time ? 1U : 0U};
}

std::vector<Invariant> FaultWatch::take_broken() {
  std::vector<Invariant> broken;
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    Watched& watched = faults_[i];
    if (!watched.counts() || watched.is_told || watched.watched <= watched.bound) continue;
    watched.is_told = true;
    broken.push_back(invariant_of(i));
  }
  return broken;
}

}  // namespace canvoy::charger
