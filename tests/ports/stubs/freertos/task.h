// Tasks of FreeRTOS: the time.
#pragma once

inline TickType_t xTaskGetTickCount() { return static_cast<TickType_t>(fake::now_us / 1000); }
