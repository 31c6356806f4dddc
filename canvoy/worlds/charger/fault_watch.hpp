// Judges whether a charger detects the faults of a plan within the time that its configuration
// sets.
//
//     FaultWatch watch(plan, promises);
//     watch.began(0, now, charger.reason());
//     watch.note(now, charger.reason());   // at each change, and each step
//     watch.ended(0);
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/devices/cia419/charge_control.hpp"
#include "canvoy/worlds/charger/fault.hpp"
#include "canvoy/worlds/charger/invariant.hpp"

namespace canvoy::charger {

/// Longest times of detection, by the configuration of a charger.
struct DetectionBounds {
  Duration heartbeat_time{};  ///< consumer heartbeat time (1016h)
  Duration data_time{};       ///< deadline of the RPDOs (1400h, sub-index 5)
  Duration value_time{};      ///< until a changed value of the battery is on the bus
  Duration reaction_time{};   ///< of the charger, after the fault is visible

  /// Time within which a charger must report why it has stopped; empty where a fault of this kind
  /// need not stop it.
  std::optional<Duration> of(FaultKind kind) const;
};

/// A fault is judged from the time when the charger delivers in spite of it. A fault that begins
/// while the charger has already stopped need not be detected, since it cannot be told from the
/// first one: an answer that was there before it decides nothing, a new one does; nor one beside a
/// second battery with the same node-ID, which replaces the first. A fault that keeps the sign of
/// another from the bus extends its time by its own time of detection; where that sign is one
/// boot-up message, it need not be detected.
class FaultWatch {
 public:
  /// `plan` must outlive this object.
  FaultWatch(const FaultPlan& plan, const DetectionBounds& promises);

  /// A fault begins, while the charger does not deliver for this reason; none: it delivers.
  void began(std::size_t fault, Time now, cia419::StopReason reason);
  /// A fault that is over need not be detected.
  void ended(std::size_t fault);
  /// `reason` is why the charger does not deliver at present.
  void note(Time now, cia419::StopReason reason);

  /// Verdicts on each fault that has begun and must be detected.
  std::vector<Invariant> invariants() const;
  /// The faults that were not detected in time, each once.
  std::vector<Invariant> take_broken();

 private:
  struct Watched {
    FaultKind kind = FaultKind::heartbeat_loss;
    bool must_be_seen = false;
    Duration bound{0};
    bool has_begun = false;
    Time began_at{};
    bool was_said_before = false;  ///< its answer, from before it began
    Time delivered_since = never;  ///< never: not in spite of this fault
    Duration watched{0};           ///< until it was detected, or judged last
    bool is_seen = false;
    bool is_over = false;  ///< mended
    bool is_void = false;  ///< nothing can be expected of it
    bool is_told = false;

    bool counts() const { return must_be_seen && has_begun; }
    bool is_present() const { return has_begun && !is_over; }
    bool is_open() const { return counts() && !is_seen && !is_over && !is_void; }
  };
  Invariant invariant_of(std::size_t fault) const;
  static void mask(Watched& watched, const Watched& by);
  static void look_at_stopped(Watched& watched, Time now, cia419::StopReason reason);
  bool has_second_battery() const;

  std::vector<Watched> faults_;
};

}  // namespace canvoy::charger
