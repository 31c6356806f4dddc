// Whether a charger sees the faults of a plan within the time that its configuration promises.
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
#include "canvoy/sim/charging/fault.hpp"
#include "canvoy/sim/charging/invariant.hpp"

namespace canvoy::charging {

/// How long what a charger watches may take, as it is configured.
struct Promises {
  Duration heartbeat_time{};  ///< consumer heartbeat time (1016h)
  Duration data_time{};       ///< deadline of the RPDOs (1400h, sub-index 5)
  Duration value_time{};      ///< until a changed value of the battery is on the bus
  Duration reaction_time{};   ///< of the charger, when it could know

  /// Until a charger says why it has stopped; empty where a fault of this kind need not stop it.
  std::optional<Duration> of(FaultKind kind) const;
};

/// A fault is judged from when the charger delivers in spite of it. One that begins while the
/// charger has stopped already need not be seen, for nobody could tell it from the other; nor
/// one beside a second battery with the same node-ID, which stands in for the first. A fault
/// that keeps the sign of another from the bus gives it as much time more as it may take to be seen
/// itself; where the sign is one boot-up message, it need not be seen.
class FaultWatch {
 public:
  FaultWatch(const FaultPlan& plan, const Promises& promises);

  void began(std::size_t fault, Time now, cia419::StopReason reason);
  /// A fault that is over need not be seen any more.
  void ended(std::size_t fault);
  /// `reason` is why the charger does not deliver now.
  void note(Time now, cia419::StopReason reason);

  /// Of each fault that began and has to be seen.
  std::vector<Invariant> invariants() const;
  /// The faults that were not seen in time, each once.
  std::vector<Invariant> take_broken();

 private:
  struct Watched {
    FaultKind kind = FaultKind::heartbeat_loss;
    bool must_be_seen = false;
    Duration bound{0};
    bool has_begun = false;
    Time delivered_since = never;  ///< never: not in spite of this fault
    Duration watched{0};           ///< until it was seen, or was looked for last
    bool is_seen = false;
    bool is_over = false;  ///< mended
    bool is_void = false;  ///< nothing can be expected
    bool is_told = false;

    bool counts() const { return must_be_seen && has_begun; }
    bool is_present() const { return has_begun && !is_over; }
    bool is_open() const { return counts() && !is_seen && !is_over && !is_void; }
  };
  Invariant invariant_of(std::size_t fault) const;
  static void mask(Watched& watched, const Watched& by);
  bool has_second_battery() const;

  std::vector<Watched> faults_;
};

}  // namespace canvoy::charging
