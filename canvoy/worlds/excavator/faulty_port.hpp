// A port that loses a share of the frames of a node, or delays each of them: for the node they
// count as sent.
//
//     FaultyPort port(world, world.port(slot), seed);
//     port.lose(Probability(0.05));
//     Node node(tables, memory, port.port(), 10);
#pragma once

#include "canvoy/can/random.hpp"
#include "canvoy/sim/world.hpp"

namespace canvoy::excavator {

class FaultyPort {
 public:
  /// `world` must outlive this object.
  FaultyPort(World& world, const Port& inner, std::uint64_t seed)
      : world_(world), inner_(inner), random_(seed) {}
  FaultyPort(const FaultyPort&) = delete;
  FaultyPort& operator=(const FaultyPort&) = delete;

  /// Sets the share of frames to lose; 0: none.
  void lose(Probability share) { lost_ = share; }
  /// Each frame leaves this much later; 0: at once.
  void delay(Duration delay) { delay_ = delay; }

  /// Port for the node; valid as long as this object.
  Port port() {
    return {.context = this,
            .send = [](void* self, const Frame& frame) -> bool {
              return static_cast<FaultyPort*>(self)->send(frame);
            },
            .accept =
                [](void* self, std::uint16_t id, bool wanted) {
                  const Port& inner = static_cast<FaultyPort*>(self)->inner_;
                  if (inner.accept != nullptr) inner.accept(inner.context, id, wanted);
                }};
  }

 private:
  bool send(const Frame& frame) {
    if (random_.happens(lost_)) return true;
    if (delay_ == Duration::zero() && world_.now() >= last_) {
      return inner_.send(inner_.context, frame);
    }
    // No frame overtakes another one.
    last_ = std::max(last_, world_.now() + delay_);
    world_.at(last_, [this, frame](Time) { inner_.send(inner_.context, frame); });
    return true;
  }

  World& world_;
  Port inner_;
  Random random_;
  Probability lost_;
  Duration delay_{};
  Time last_{};
};

}  // namespace canvoy::excavator
