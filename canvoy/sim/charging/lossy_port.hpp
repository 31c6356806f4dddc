// A node's way to the bus on which frames of a kind can get lost: the node believes that they are
// sent.
//
//     LossyPort lossy(world.port(slot));
//     Node node(tables, memory, lossy.port(), 10);
//     lossy.lose(0x70A, true);
#pragma once

#include <bitset>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy::charging {

class LossyPort {
 public:
  explicit LossyPort(const Port& inner) : inner_(inner) {}
  LossyPort(const LossyPort&) = delete;
  LossyPort& operator=(const LossyPort&) = delete;

  /// From now on 11-bit frames with this identifier are lost, or not.
  void lose(std::uint32_t can_id, bool lost) { lost_.set(can_id & Frame::id_max, lost); }

  /// For the node; valid as long as this is.
  Port port() {
    return {.context = this,
            .send = [](void* context, const Frame& frame) -> bool {
              const LossyPort& self = *static_cast<LossyPort*>(context);
              if (!frame.is_extended() && self.lost_.test(frame.id)) return true;
              return self.inner_.send(self.inner_.context, frame);
            },
            .accept =
                [](void* context, std::uint16_t id, bool wanted) {
                  const LossyPort& self = *static_cast<LossyPort*>(context);
                  if (self.inner_.accept == nullptr) return;
                  self.inner_.accept(self.inner_.context, id, wanted);
                }};
  }

 private:
  Port inner_;
  std::bitset<Frame::id_max + 1> lost_;
};

}  // namespace canvoy::charging
