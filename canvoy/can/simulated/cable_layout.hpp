// The cable of a simulated bus as it lies: controllers along it in the order of their numbers,
// where it is cut, and who is unplugged. It falls into pieces, each a bus of its own.
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
  using Pieces = std::array<ControllerSet, ControllerSet::capacity>;

  /// A further controller at the end; the next number.
  void append(ControllerId id) { count_ = id + std::size_t{1}; }

  void cut(ControllerId after) { cut_after_.insert(after); }
  /// All cuts; who is unplugged stays so.
  void mend() { cut_after_.clear(); }
  void unplug(ControllerId id) { unplugged_.insert(id); }
  void plug(ControllerId id) { unplugged_.erase(id); }

  /// From the beginning to the end, in `storage`; each controller that is unplugged is a piece of
  /// its own.
  std::span<const ControllerSet> pieces(Pieces& storage) const;

 private:
  std::size_t count_ = 0;
  ControllerSet cut_after_{};
  ControllerSet unplugged_{};
};

}  // namespace canvoy
