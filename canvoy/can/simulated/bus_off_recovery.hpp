// The recovery from bus-off: a controller must see 128 sequences of 11 recessive bits before it
// takes part again (ISO 11898-1, fault confinement).
//
//     BusOffRecovery recovery;
//     recovery.begin(node, now_ns);
//     recovery.interrupt(members, wire.recessive_since_ns(), now_ns, bit_times);  // a frame begins
//     recovery.take_completed(members, wire.recessive_since_ns(), now_ns, bit_times);
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/can/simulated/bit_times.hpp"
#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

/// Recovery of all controllers of a bus. `members` are those on one wire, which has been recessive
/// since `recessive_since_ns`, or will be from then on.
class BusOffRecovery {
 public:
  void begin(ControllerId id, std::int64_t now_ns) {
    recovering_.insert(id);
    progress_[id] = {.sequences_left = sequences, .counted_to_ns = now_ns};
  }
  /// Cancels the recovery of a controller without power, which starts from reset later.
  void cancel(ControllerId id) { recovering_.erase(id); }

  /// True from begin() until a controller is taken, or its recovery is cancelled.
  bool is_under_way(ControllerId id) const { return recovering_.contains(id); }
  /// True if no controller is recovering.
  bool is_empty() const { return recovering_.empty(); }

  /// Time at which the first of the members is back if no frame comes between; never_ns for none.
  std::int64_t next_ns(const ControllerSet& members, std::int64_t recessive_since_ns,
                       const BitTimes& bit_times) const;
  /// Notes the begin of a frame: an incomplete sequence of eleven recessive bits does not count.
  void interrupt(const ControllerSet& members, std::int64_t recessive_since_ns, std::int64_t now_ns,
                 const BitTimes& bit_times);
  /// Removes and returns the controllers that have recovered.
  ControllerSet take_completed(const ControllerSet& members, std::int64_t recessive_since_ns,
                               std::int64_t now_ns, const BitTimes& bit_times);

 private:
  static constexpr std::uint32_t sequences = 128;
  static constexpr unsigned sequence_bits = 11;

  struct Progress {
    std::uint32_t sequences_left = 0;
    std::int64_t counted_to_ns = 0;
  };

  std::int64_t end_ns(ControllerId id, std::int64_t recessive_since_ns,
                      const BitTimes& bit_times) const;

  ControllerSet recovering_{};
  std::array<Progress, ControllerSet::capacity> progress_{};
};

}  // namespace canvoy
