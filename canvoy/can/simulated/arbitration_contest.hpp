// Finds the winner of the bus among the controllers that have a frame to send, by their arbitration
// keys.
//
//     ArbitrationContest contest(127);
//     contest.enter(node, arbitration_key(frame));
//     ControllerSet winners = contest.winners();
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvoy/can/simulated/arbitration.hpp"
#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

/// A knock-out tournament, kept as a binary tree, so that the winner is available at once for any
/// number of contenders; entering and leaving take a step for each doubling of the number of
/// controllers. Allocates in the constructor only.
class ArbitrationContest {
 public:
  /// Makes a contest for `controllers_max` controllers at most, without any yet.
  explicit ArbitrationContest(std::size_t controllers_max)
      : matches_(2 * std::bit_ceil(std::max<std::size_t>(controllers_max, 1)), nobody) {}

  /// Sets the number of controllers: 0 to `controllers` - 1. None of them is a contender
  /// afterwards.
  void resize(std::size_t controllers) {
    leaves_ = std::bit_ceil(std::max<std::size_t>(controllers, 1));
    std::fill(matches_.begin(), matches_.end(), nobody);
    contenders_.clear();
  }

  /// Enters a controller with a frame to send, or with a different one.
  void enter(ControllerId id, std::uint32_t key) {
    contenders_.insert(id);
    play(id, std::uint64_t{key} << key_shift | id);
  }
  /// Removes a controller that has nothing to send.
  void leave(ControllerId id) {
    contenders_.erase(id);
    play(id, nobody);
  }

  /// Controllers with a frame to send.
  const ControllerSet& contenders() const { return contenders_; }

  /// Controllers with the lowest key: one, unless several send the same identifier; none if there
  /// is no contender.
  ControllerSet winners() const {
    const std::uint64_t winner = matches_[1];
    if ((winner & tied) != 0) return winners_among(contenders_);  // also without contenders
    ControllerSet winners;
    winners.insert(static_cast<ControllerId>(winner & 0xFF));
    return winners;
  }

  /// Like winners(), but among some of the contenders; linear in their number.
  ControllerSet winners_among(const ControllerSet& some) const {
    ControllerSet winners;
    std::uint64_t lowest = nobody >> key_shift;
    some.for_each([&](ControllerId id) {
      const std::uint64_t key = matches_[leaves_ + id] >> key_shift;
      if (key > lowest) return;
      if (key < lowest) winners.clear();
      lowest = key;
      winners.insert(id);
    });
    return winners;
  }

 private:
  // A match is the key, a bit for "several with this key", and the number of the controller: the
  // lowest wins.
  static constexpr unsigned key_shift = 9;
  static constexpr std::uint64_t tied = std::uint64_t{1} << 8;
  static constexpr std::uint64_t nobody = ~std::uint64_t{0};

  void play(ControllerId id, std::uint64_t entry) {
    std::size_t match = leaves_ + id;
    if (matches_[match] == entry) return;
    matches_[match] = entry;
    while (match > 1) {
      match /= 2;
      const std::uint64_t left = matches_[2 * match];
      const std::uint64_t right = matches_[2 * match + 1];
      const bool is_tie = (left ^ right) >> key_shift == 0;
      const std::uint64_t winner = std::min(left, right) | (is_tie ? tied : 0);
      if (matches_[match] == winner) return;
      matches_[match] = winner;
    }
  }

  std::size_t leaves_ = 1;
  std::vector<std::uint64_t> matches_;  // number 1 is the final, 2n and 2n + 1 lead to n
  ControllerSet contenders_{};
};

}  // namespace canvoy
