// Tells a unit on a simulated bus that what its hardware senses has changed, so that it looks at
// once and not in its next period.
//
//     ChangeSignal signal(world, slot, [&] { device.unit().hardware_changed(); });
//     door.stand_in_way(now, true);
//     signal.tell();
#pragma once

#include <functional>
#include <utility>

#include "canvoy/sim/world.hpp"

namespace canvoy::lift {

class ChangeSignal {
 public:
  /// There is no unit: nobody is told.
  ChangeSignal() = default;
  /// `world` must outlive this.
  ChangeSignal(World& world, SlotIndex slot, std::function<void()> changed)
      : world_(&world), slot_(slot), changed_(std::move(changed)) {}

  /// A unit without power finds out when it boots.
  void tell() const {
    if (world_ == nullptr || !world_->is_running(slot_)) return;
    changed_();
    world_->touched(slot_);
  }

 private:
  World* world_ = nullptr;
  SlotIndex slot_ = 0;
  std::function<void()> changed_{};
};

}  // namespace canvoy::lift
