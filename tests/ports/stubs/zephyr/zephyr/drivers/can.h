// Of Zephyr's CAN controller API, what ports/zephyr uses (3.7).
#pragma once

#include <zephyr/kernel.h>

#define CAN_FRAME_IDE 1
#define CAN_FRAME_RTR 2

struct can_frame {
  std::uint32_t id;
  std::uint8_t dlc;
  std::uint8_t flags;
  std::uint16_t timestamp;
  std::uint8_t data[8];
};
struct can_filter {
  std::uint32_t id;
  std::uint32_t mask;
  std::uint8_t flags;
};
enum can_state { CAN_STATE_ERROR_ACTIVE, CAN_STATE_ERROR_WARNING, CAN_STATE_ERROR_PASSIVE, CAN_STATE_BUS_OFF, CAN_STATE_STOPPED };
struct can_bus_err_cnt {
  std::uint8_t tx_err_cnt;
  std::uint8_t rx_err_cnt;
};
using can_tx_callback_t = void (*)(const device*, int error, void* user_data);

inline int can_set_bitrate(const device*, std::uint32_t) { return 0; }
inline int can_add_rx_filter_msgq(const device*, k_msgq*, const can_filter*) { return 0; }
inline int can_start(const device*) { return 0; }
inline int can_get_state(const device*, can_state* state, can_bus_err_cnt*) {
  *state = CAN_STATE_ERROR_ACTIVE;
  return 0;
}
inline int can_send(const device*, const can_frame* frame, k_timeout_t, can_tx_callback_t, void*) {
  return fake::transmit(frame->id, frame->dlc, frame->data) ? 0 : -11;
}
inline int k_msgq_get(k_msgq*, void* data, k_timeout_t) {
  const fake::Message* message = fake::take();
  if (message == nullptr) return -42;
  can_frame frame{};
  frame.id = message->id;
  frame.dlc = message->length;
  std::memcpy(frame.data, message->data, 8);
  std::memcpy(data, &frame, sizeof frame);
  return 0;
}
