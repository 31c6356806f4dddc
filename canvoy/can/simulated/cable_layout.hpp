// The layout of the cable of a simulated bus: controllers along it in the order of their numbers,
// its cuts, and the unplugged controllers. It consists of pieces, each a separate bus.
//
//     CableLayout layout;
//     layout.append(0);  layout.append(1);  layout.append(2);
//     layout.cut(0);
//     layout.pieces(storage);  // {0}, {1, 2}
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "canvoy/can/simulated/controller_set.hpp"

namespace canvoy {

class CableLayout {
 public:
  /// Memory for pieces(), in the order along the cable.
  using Pieces = std::array<ControllerSet, ControllerSet::capacity>;

  /// Adds a controller at the end, with the next number.
  void append(ControllerId id) { count_ = id + std::size_t{1}; }

  /// Cuts the cable behind a controller; behind the last one it has no effect.
  void cut(ControllerId after) { cut_after_.insert(after); }
  /// Mends all cuts; unplugged controllers stay unplugged.
  void mend() { cut_after_.clear(); }
  /// Takes a controller off the cable.
  void unplug(ControllerId id) { unplugged_.insert(id); }
  /// Puts a controller back into its place.
  void plug(ControllerId id) { unplugged_.erase(id); }

  /// Pieces from the beginning to the end, in `storage`; each unplugged controller is a separate
  /// piece.
  std::span<const ControllerSet> pieces(Pieces& storage) const;

 private:
  std::size_t count_ = 0;
  ControllerSet cut_after_{};
  ControllerSet unplugged_{};
};

}  // namespace canvoy
