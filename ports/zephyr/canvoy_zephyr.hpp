// A CAN controller of Zephyr as a board of canvoy_board.hpp.
//
//     ZephyrCan can(DEVICE_DT_GET(DT_CHOSEN(zephyr_canbus)));
//     if (!can.start(125000)) return -1;
//     BoardPort port(can);
//     for (;;) can.wait(port.turn(device.node()));
#pragma once

#include <zephyr/drivers/can.h>
#include <zephyr/kernel.h>

#include <algorithm>

#include "canvoy_board.hpp"

namespace canvoy::board {

/// One board for each controller. Frames arrive through a message queue, which an interrupt fills.
class ZephyrCan {
 public:
  explicit ZephyrCan(const device* can) : can_(can) {
    k_msgq_init(&queue_, buffer_, sizeof(can_frame), CONFIG_CANVOY_RX_QUEUE);
  }
  ZephyrCan(const ZephyrCan&) = delete;
  ZephyrCan& operator=(const ZephyrCan&) = delete;

  /// Starts the controller, which receives all frames with 11-bit identifiers. False if the driver
  /// refuses a setting.
  bool start(std::uint32_t bit_rate) {
    const can_filter all{.id = 0, .mask = 0, .flags = 0};
    return device_is_ready(can_) && can_set_bitrate(can_, bit_rate) == 0 &&
           can_add_rx_filter_msgq(can_, &queue_, &all) >= 0 && can_start(can_) == 0;
  }

  bool send(const Frame& frame) {
    can_frame out{};
    out.id = frame.id;
    out.dlc = frame.length;
    out.flags = static_cast<std::uint8_t>((frame.is_extended() ? CAN_FRAME_IDE : 0) |
                                          (frame.is_remote() ? CAN_FRAME_RTR : 0));
    std::copy_n(frame.data.begin(), frame.length, out.data);
    return can_send(can_, &out, K_NO_WAIT, sent, nullptr) == 0;
  }

  bool receive(Frame& frame) {
    can_frame in;
    if (k_msgq_get(&queue_, &in, K_NO_WAIT) != 0) return false;
    frame = Frame{};
    frame.id = in.id;
    frame.length = std::min<std::uint8_t>(in.dlc, Frame::length_max);
    if ((in.flags & CAN_FRAME_IDE) != 0) frame.flags = frame.flags | FrameFlags::extended;
    if ((in.flags & CAN_FRAME_RTR) != 0) {
      frame.flags = frame.flags | FrameFlags::remote;
    } else {
      std::copy_n(in.data, frame.length, frame.data.begin());
    }
    return true;
  }

  Time now() {
    return Time(Duration(static_cast<std::int64_t>(
        k_ticks_to_us_floor64(static_cast<std::uint64_t>(k_uptime_ticks())))));
  }

  BusState bus_state() {
    can_state state = CAN_STATE_ERROR_ACTIVE;
    if (can_get_state(can_, &state, nullptr) != 0) return BusState::error_active;
    switch (state) {
      case CAN_STATE_ERROR_WARNING:
        return BusState::error_warning;
      case CAN_STATE_ERROR_PASSIVE:
        return BusState::error_passive;
      case CAN_STATE_BUS_OFF:
        return BusState::bus_off;
      default:
        return BusState::error_active;
    }
  }

  /// Waits for a frame, at most `longest`.
  void wait(Duration longest) {
    k_poll_event event;
    k_poll_event_init(&event, K_POLL_TYPE_MSGQ_DATA_AVAILABLE, K_POLL_MODE_NOTIFY_ONLY, &queue_);
    k_poll(&event, 1, K_USEC(longest.count()));
  }

 private:
  static void sent(const device*, int, void*) {}

  const device* can_;
  k_msgq queue_;
  alignas(can_frame) char buffer_[CONFIG_CANVOY_RX_QUEUE * sizeof(can_frame)];
};

}  // namespace canvoy::board
