// A port on which frames of a kind can get lost: for the node they count as sent.
//
//     LossyPort lossy(world.port(slot));
//     Node node(tables, memory, lossy.port(), 10);
//     lossy.lose(0x70A, true);
#pragma once

#include <bitset>
#include <cstdint>

#include "canvoy/can/frame.hpp"
#include "canvoy/can/port.hpp"

namespace canvoy::charger {

class LossyPort {
 public:
  /// Frames go to `inner`, which is copied.
  explicit LossyPort(const Port& inner) : inner_(inner) {}
  LossyPort(const LossyPort&) = delete;
  LossyPort& operator=(const LossyPort&) = delete;

  /// Starts or stops losing 11-bit frames with this identifier.
  void lose(std::uint32_t can_id, bool lost) { lost_.set(can_id & Frame::id_max, lost); }

  /// Port for the node; valid as long as this object.
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

}  // namespace canvoy::charger
