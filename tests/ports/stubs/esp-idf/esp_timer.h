// Of ESP-IDF's timer, the time.
#pragma once

#include "fake_bus.hpp"

inline std::int64_t esp_timer_get_time() { return fake::now_us; }
