// Of ESP-IDF's TWAI driver, what ports/esp-idf uses (5.3).
#pragma once

#include <freertos/FreeRTOS.h>

using esp_err_t = int;
#define ESP_OK 0
#define ESP_FAIL -1
enum gpio_num_t { GPIO_NUM_21 = 21, GPIO_NUM_22 = 22 };
enum twai_mode_t { TWAI_MODE_NORMAL };
enum twai_state_t { TWAI_STATE_STOPPED, TWAI_STATE_RUNNING, TWAI_STATE_BUS_OFF, TWAI_STATE_RECOVERING };
struct twai_general_config_t {
  twai_mode_t mode;
  gpio_num_t tx_io, rx_io;
};
struct twai_timing_config_t {
  std::uint32_t brp;
};
struct twai_filter_config_t {
  std::uint32_t acceptance_code, acceptance_mask;
};
struct twai_message_t {
  union {
    struct {
      std::uint32_t extd : 1;
      std::uint32_t rtr : 1;
      std::uint32_t ss : 1;
      std::uint32_t self : 1;
      std::uint32_t dlc_non_comp : 1;
      std::uint32_t reserved : 27;
    };
    std::uint32_t flags;
  };
  std::uint32_t identifier;
  std::uint8_t data_length_code;
  std::uint8_t data[8];
};
struct twai_status_info_t {
  twai_state_t state;
  std::uint32_t msgs_to_tx, msgs_to_rx, tx_error_counter, rx_error_counter;
};
#define TWAI_GENERAL_CONFIG_DEFAULT(tx, rx, mode) {mode, tx, rx}
#define TWAI_TIMING_CONFIG_125KBITS() {32}
#define TWAI_FILTER_CONFIG_ACCEPT_ALL() {0, 0xFFFFFFFF}

inline esp_err_t twai_driver_install(const twai_general_config_t*, const twai_timing_config_t*, const twai_filter_config_t*) { return ESP_OK; }
inline esp_err_t twai_start() { return ESP_OK; }
inline esp_err_t twai_initiate_recovery() { return ESP_OK; }
inline esp_err_t twai_get_status_info(twai_status_info_t* info) {
  *info = {TWAI_STATE_RUNNING, 0, 0, 0, 0};
  return ESP_OK;
}
inline esp_err_t twai_transmit(const twai_message_t* message, TickType_t) {
  return fake::transmit(message->identifier, message->data_length_code, message->data) ? ESP_OK : ESP_FAIL;
}
inline esp_err_t twai_receive(twai_message_t* message, TickType_t ticks) {
  if (ticks != 0) fake::wait(std::int64_t{ticks} * 1000);
  const fake::Message* next = fake::take();
  if (next == nullptr) return ESP_FAIL;
  *message = {};
  message->identifier = next->id;
  message->data_length_code = next->length;
  std::memcpy(message->data, next->data, 8);
  return ESP_OK;
}
