// A board with FreeRTOS. FreeRTOS has no CAN: the driver sends frames, and puts received frames
// into a queue from its interrupt.
//
//     bool can_transmit(const canvoy::Frame& frame);  // yours; false: no room
//     FreeRtosCan can(can_transmit);
//     can.received_from_isr(frame);                 // in the interrupt of the driver
//     BoardPort port(can);
//     for (;;) can.wait(port.turn(device.node()));  // in a task
#pragma once

#include <FreeRTOS.h>
#include <queue.h>
#include <task.h>

#include <algorithm>

#include "canvoy_board.hpp"

namespace canvoy::board {

/// A board. `frames_max` received frames wait for the node. Time has the resolution of a tick: set
/// configTICK_RATE_HZ to 1000.
template <unsigned frames_max = 16>
class FreeRtosCan {
 public:
  explicit FreeRtosCan(bool (*transmit)(const Frame&))
      : transmit_(transmit),
        queue_(xQueueCreateStatic(frames_max, sizeof(Frame), buffer_, &control_)) {}
  FreeRtosCan(const FreeRtosCan&) = delete;
  FreeRtosCan& operator=(const FreeRtosCan&) = delete;

  /// Queues a received frame; called by the driver's interrupt. False if the queue is full: call
  /// Node::overrun().
  bool received_from_isr(const Frame& frame) {
    BaseType_t has_woken = pdFALSE;
    const bool has_room = xQueueSendFromISR(queue_, &frame, &has_woken) == pdTRUE;
    portYIELD_FROM_ISR(has_woken);
    return has_room;
  }

  bool send(const Frame& frame) { return transmit_(frame); }
  bool receive(Frame& frame) { return xQueueReceive(queue_, &frame, 0) == pdTRUE; }

  /// Time since the start. Ticks have 32 bits in most ports and overflow after 49 days: this
  /// extends them if it is called at least once in that time, as turn() does.
  Time now() {
    const TickType_t ticks = xTaskGetTickCount();
    ticks_ += static_cast<TickType_t>(ticks - last_);
    last_ = ticks;
    return Time(Duration(static_cast<std::int64_t>(ticks_) * (1'000'000 / configTICK_RATE_HZ)));
  }

  /// Waits for a frame, at most `longest`.
  void wait(Duration longest) {
    Frame next;
    const auto ticks = static_cast<TickType_t>(longest.count() * configTICK_RATE_HZ / 1'000'000);
    if (longest.count() != 0) xQueuePeek(queue_, &next, std::max<TickType_t>(ticks, 1));
  }

 private:
  bool (*transmit_)(const Frame&);
  std::uint64_t ticks_ = 0;
  TickType_t last_ = 0;
  StaticQueue_t control_{};
  std::uint8_t buffer_[frames_max * sizeof(Frame)];
  QueueHandle_t queue_;
};

}  // namespace canvoy::board
