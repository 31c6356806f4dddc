#include "canvoy/sim/deadline_tree.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

std::size_t DeadlineTree::add(Time deadline) {
  if (size_ == leaf_first_) grow();
  check_invariant(size_ < leaf_first_);
  const std::size_t actor = size_++;
  matches_[leaf_first_ + actor].actor = actor;
  set(actor, deadline);
  check_invariant(earliest() <= deadline);
  return actor;
}

void DeadlineTree::grow() {
  const std::size_t leaves = leaf_first_ * 2;
  std::vector<Match> wider(leaves * 2);
  for (std::size_t actor = 0; actor < leaves; ++actor) {
    wider[leaves + actor].actor = actor;
    if (actor < size_) wider[leaves + actor].deadline = deadline(actor);
  }
  for (std::size_t place = leaves - 1; place > 0; --place) {
    wider[place] = better(wider[2 * place], wider[2 * place + 1]);
  }
  matches_ = std::move(wider);
  leaf_first_ = leaves;
}

}  // namespace canvoy
