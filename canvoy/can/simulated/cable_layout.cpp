#include "canvoy/can/simulated/cable_layout.hpp"

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

std::span<const ControllerSet> CableLayout::pieces(Pieces& storage) const {
  storage = {};
  std::size_t found = 0;
  ControllerSet piece;
  for (std::size_t i = 0; i < count_; ++i) {
    const ControllerId id = static_cast<ControllerId>(i);
    if (unplugged_.contains(id)) {
      storage[found++].insert(id);
    } else {
      piece.insert(id);
    }
    const bool ends_here = i + 1 == count_ || cut_after_.contains(id);
    if (!ends_here || piece.empty()) continue;
    storage[found++] = piece;
    piece.clear();
  }
  check_invariant(found <= count_);
  return std::span(storage).first(found);
}

}  // namespace canvoy
