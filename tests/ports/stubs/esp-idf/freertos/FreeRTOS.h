// Of ESP-IDF's FreeRTOS, ticks of a millisecond.
#pragma once

#include "fake_bus.hpp"

using TickType_t = std::uint32_t;
#define portTICK_PERIOD_MS 1
