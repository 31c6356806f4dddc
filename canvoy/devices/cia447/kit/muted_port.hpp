// The access of a device to the bus, which can be closed: a device that sleeps sends nothing.
//
//     MutedPort muted(port);
//     Node node(tables, memory, muted.port(), 5);
//     muted.mute(true);
#pragma once

#include "canvoy/can/port.hpp"

namespace canvoy::cia447 {

class MutedPort {
 public:
  /// Makes an open access; the context of `port` must outlive it.
  explicit MutedPort(const Port& port) : port_(port) {}
  MutedPort(const MutedPort&) = delete;
  MutedPort& operator=(const MutedPort&) = delete;

  /// Must not outlive this.
  Port port() {
    return {.context = this,
            .send =
                [](void* self, const Frame& frame) {
                  return static_cast<MutedPort*>(self)->send(frame);
                },
            .accept = port_.accept == nullptr ? nullptr
                                              : +[](void* self, std::uint16_t id, bool wanted) {
                                                  const Port& port =
                                                      static_cast<MutedPort*>(self)->port_;
                                                  port.accept(port.context, id, wanted);
                                                }};
  }
  /// Frames that are sent meanwhile are lost.
  void mute(bool is_muted) { is_muted_ = is_muted; }
  /// True while nothing is sent.
  bool is_muted() const { return is_muted_; }

 private:
  bool send(const Frame& frame) { return is_muted_ || port_.send(port_.context, frame); }

  Port port_;
  bool is_muted_ = false;
};

}  // namespace canvoy::cia447
