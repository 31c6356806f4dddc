// Of Zephyr's kernel, what ports/zephyr uses: names, parameters and results as in its documentation (3.7).
#pragma once

#include "fake_bus.hpp"

#define CONFIG_CANVOY_RX_QUEUE 16

struct device {
  int number;
};
inline device the_can{0};
#define DT_CHOSEN(name) 0
#define DEVICE_DT_GET(node) (&the_can)
inline bool device_is_ready(const device*) { return true; }

struct k_timeout_t {
  std::int64_t ticks;
};
#define K_NO_WAIT (k_timeout_t{0})
#define K_USEC(t) (k_timeout_t{static_cast<std::int64_t>(t)})
inline std::int64_t k_uptime_ticks() { return fake::now_us; }
inline std::uint64_t k_ticks_to_us_floor64(std::uint64_t ticks) { return ticks; }

struct k_msgq {
  std::size_t size;
};
inline void k_msgq_init(k_msgq* queue, char*, std::size_t size, std::uint32_t) { queue->size = size; }
int k_msgq_get(k_msgq* queue, void* data, k_timeout_t timeout);

struct k_poll_event {
  int type;
};
#define K_POLL_TYPE_MSGQ_DATA_AVAILABLE 16
#define K_POLL_MODE_NOTIFY_ONLY 0
inline void k_poll_event_init(k_poll_event* event, std::uint32_t type, int, void*) { event->type = static_cast<int>(type); }
inline int k_poll(k_poll_event*, int, k_timeout_t timeout) {
  fake::wait(timeout.ticks);
  return 0;
}
