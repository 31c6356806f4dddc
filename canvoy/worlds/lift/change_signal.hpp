// Notifies a unit on a simulated bus that the inputs of its hardware have changed, so that it reads
// them at once and not in its next period.
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
  /// A signal without a unit: tell() does nothing.
  ChangeSignal() = default;
  /// `world` must outlive this object.
  ChangeSignal(World& world, SlotIndex slot, std::function<void()> changed)
      : world_(&world), slot_(slot), changed_(std::move(changed)) {}

  /// A unit without power reads the inputs when it boots.
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
