// Of the Arduino framework, what ports/platformio uses. The clock is about to overflow, as it does after 71 minutes.
#pragma once

#include "fake_bus.hpp"

inline unsigned long micros() { return static_cast<std::uint32_t>(fake::now_us + 0xFFFF'0000); }
