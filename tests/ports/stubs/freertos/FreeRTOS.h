// Of FreeRTOS, what ports/freertos uses: names, parameters and results as in its documentation (11.1).
#pragma once

#include "fake_bus.hpp"

using BaseType_t = long;
using TickType_t = std::uint32_t;
#define pdFALSE 0
#define pdTRUE 1
#define configTICK_RATE_HZ 1000
#define portYIELD_FROM_ISR(woken) static_cast<void>(woken)
