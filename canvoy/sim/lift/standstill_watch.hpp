// Whether a building stands still while somebody wants to go: nobody gets in or out, no car moves,
// and no door. Seen from outside, whatever its controllers say of themselves.
//
//     StandstillWatch watch;
//     for (Time at{}; at < end; at += StandstillWatch::period) {
//       network.run_until(at);
//       watch.look(network.snapshot());
//     }
//     watch.longest();
#pragma once

#include "canvoy/sim/lift/lift_snapshot.hpp"

namespace canvoy::lift {

class StandstillWatch {
 public:
  static constexpr Duration period = 100ms;

  /// Each period.
  void look(const LiftNetworkSnapshot& now);
  /// In which somebody waited or rode, and nothing moved.
  Duration longest() const { return longest_; }

 private:
  static bool moves(const LiftNetworkSnapshot& before, const LiftNetworkSnapshot& now);

  LiftNetworkSnapshot before_;
  Time moved_at_{};
  Duration longest_{0};
};

}  // namespace canvoy::lift
