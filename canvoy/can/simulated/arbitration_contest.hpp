// Who wants the bus, and who wins it: the controllers that have a frame to send, with their
// arbitration keys.
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

/// A knock-out tournament, kept as a binary tree, so that the winner is known at once however many
/// want the bus; entering and leaving take a step for each doubling of the number of controllers.
/// It allocates in the constructor only.
class ArbitrationContest {
 public:
  /// For `controllers_max` controllers at most, of which none is there yet.
  explicit ArbitrationContest(std::size_t controllers_max)
      : matches_(2 * std::bit_ceil(std::max<std::size_t>(controllers_max, 1)), nobody) {}

  /// From now on for controllers 0 to `controllers` - 1. None of them is a contender then.
  void resize(std::size_t controllers) {
    leaves_ = std::bit_ceil(std::max<std::size_t>(controllers, 1));
    std::fill(matches_.begin(), matches_.end(), nobody);
    contenders_.clear();
  }

  /// A controller has something to send, or something else than before.
  void enter(ControllerId id, std::uint32_t key) {
    contenders_.insert(id);
    play(id, std::uint64_t{key} << key_shift | id);
  }
  void leave(ControllerId id) {
    contenders_.erase(id);
    play(id, nobody);
  }

  const ControllerSet& contenders() const { return contenders_; }

  /// Those with the lowest key: one, unless several send the same identifier; none where nobody
  /// wants the bus.
  ControllerSet winners() const {
    const std::uint64_t winner = matches_[1];
    if ((winner & tied) != 0) return winners_among(contenders_);  // of nobody too
    ControllerSet winners;
    winners.insert(static_cast<ControllerId>(winner & 0xFF));
    return winners;
  }

  /// The same among some of the contenders; linear in their number.
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
