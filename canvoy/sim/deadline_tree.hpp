// Finds the actor to be called next: the deadlines of a fixed set of actors as a winner tree.
//
//     DeadlineTree deadlines;
//     const std::size_t pump = deadlines.add(Time(5s));
//     while (deadlines.earliest() <= now) call(deadlines.winner());
#pragma once

#include <cstddef>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy {

/// Keeps the earliest deadline at hand. A change costs one comparison for each doubling of the
/// number of actors, and less where it does not reach the top. Of equal deadlines, the actor that
/// was added first wins, so that the order of a simulation does not depend on chance.
class DeadlineTree {
 public:
  /// Adds an actor and returns its number: 0, 1, 2 ... Linear in the number of actors; allocates.
  std::size_t add(Time deadline = never);
  /// `actor` must have been added.
  void set(std::size_t actor, Time deadline) {
    std::size_t place = leaf_first_ + actor;
    if (matches_[place].deadline == deadline) return;
    matches_[place].deadline = deadline;
    while (place > 1) {
      place /= 2;
      const Match& best = better(matches_[2 * place], matches_[2 * place + 1]);
      Match& match = matches_[place];
      if (match.actor == best.actor && match.deadline == best.deadline) return;
      match = best;
    }
  }

  /// Deadline of an actor that was added.
  Time deadline(std::size_t actor) const { return matches_[leaf_first_ + actor].deadline; }
  /// The earliest deadline; `never` where no actor waits.
  Time earliest() const { return matches_[1].deadline; }
  /// The actor with the earliest deadline; meaningless where that is `never`.
  std::size_t winner() const { return matches_[1].actor; }
  std::size_t size() const { return size_; }

 private:
  struct Match {
    Time deadline = never;
    std::size_t actor = 0;
  };

  /// Actors to the left have the lower numbers.
  static const Match& better(const Match& left, const Match& right) {
    return right.deadline < left.deadline ? right : left;
  }
  void grow();

  std::size_t size_ = 0;
  std::size_t leaf_first_ = 1;
  std::vector<Match> matches_{2};  // [1] is the top, the children of [n] are [2n] and [2n + 1]
};

}  // namespace canvoy
