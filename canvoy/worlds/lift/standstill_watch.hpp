// Detects whether a building stands still while people want to go: no person gets in or out, and no
// car and no door moves. It looks from outside, whatever the controllers report of themselves.
//
//     StandstillWatch watch;
//     for (Time at{}; at < end; at += StandstillWatch::period) {
//       network.run_until(at);
//       watch.look(network.snapshot());
//     }
//     watch.longest();
#pragma once

#include "canvoy/worlds/lift/lift_snapshot.hpp"

namespace canvoy::lift {

class StandstillWatch {
 public:
  static constexpr Duration period = 100ms;  ///< between two looks

  /// Call it in each period.
  void look(const LiftNetworkSnapshot& now);
  /// Longest time in which people waited or rode, and nothing moved.
  Duration longest() const { return longest_; }

 private:
  static bool moves(const LiftNetworkSnapshot& before, const LiftNetworkSnapshot& now);

  LiftNetworkSnapshot before_;
  Time moved_at_{};
  Duration longest_{0};
};

}  // namespace canvoy::lift
