// The TWAI controller of an ESP32 as a board of canvoy_board.hpp.
//
//     EspCan can;
//     if (!can.start(GPIO_NUM_21, GPIO_NUM_22, TWAI_TIMING_CONFIG_125KBITS())) return;
//     BoardPort port(can);
//     for (;;) can.wait(port.turn(device.node()));
#pragma once

#include <driver/twai.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>

#include <algorithm>

#include "canvoy_board.hpp"

namespace canvoy::board {

/// The only TWAI controller of the chip. After bus-off it starts the recovery of the controller by
/// itself.
class EspCan {
 public:
  /// Starts the controller. False if the driver refuses a setting.
  bool start(gpio_num_t tx, gpio_num_t rx, const twai_timing_config_t& timing) {
    const twai_general_config_t general = TWAI_GENERAL_CONFIG_DEFAULT(tx, rx, TWAI_MODE_NORMAL);
    const twai_filter_config_t all = TWAI_FILTER_CONFIG_ACCEPT_ALL();
    return twai_driver_install(&general, &timing, &all) == ESP_OK && twai_start() == ESP_OK;
  }

  bool send(const Frame& frame) {
    twai_message_t out{};
    out.identifier = frame.id;
    out.data_length_code = frame.length;
    out.extd = frame.is_extended() ? 1 : 0;
    out.rtr = frame.is_remote() ? 1 : 0;
    std::copy_n(frame.data.begin(), frame.length, out.data);
    return twai_transmit(&out, 0) == ESP_OK;
  }

  bool receive(Frame& frame) {
    if (!has_next_ && twai_receive(&next_, 0) != ESP_OK) return false;
    has_next_ = false;
    frame = Frame{};
    frame.id = next_.identifier;
    frame.length = std::min<std::uint8_t>(next_.data_length_code, Frame::length_max);
    if (next_.extd != 0) frame.flags = frame.flags | FrameFlags::extended;
    if (next_.rtr != 0) {
      frame.flags = frame.flags | FrameFlags::remote;
    } else {
      std::copy_n(next_.data, frame.length, frame.data.begin());
    }
    return true;
  }

  Time now() { return Time(Duration(esp_timer_get_time())); }

  BusState bus_state() {
    twai_status_info_t status{};
    if (twai_get_status_info(&status) != ESP_OK) return BusState::error_active;
    if (status.state == TWAI_STATE_BUS_OFF) twai_initiate_recovery();
    if (status.state == TWAI_STATE_STOPPED) twai_start();
    if (status.state != TWAI_STATE_RUNNING) return BusState::bus_off;
    const std::uint32_t errors = std::max(status.tx_error_counter, status.rx_error_counter);
    if (errors >= 128) return BusState::error_passive;
    return errors >= 96 ? BusState::error_warning : BusState::error_active;
  }

  /// Waits for a frame, at most `longest`, but at least a tick, so that other tasks run.
  void wait(Duration longest) {
    if (has_next_) return;
    const auto ticks = static_cast<TickType_t>(longest.count() / 1000 / portTICK_PERIOD_MS);
    has_next_ = twai_receive(&next_, std::max<TickType_t>(ticks, 1)) == ESP_OK;
  }

 private:
  twai_message_t next_{};
  bool has_next_ = false;
};

}  // namespace canvoy::board
