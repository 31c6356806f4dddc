// A car position unit of four encoders on its wire, node 4. By default a count is 0.1 mm, 1 mm/s,
// 1 mm/s2.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/devices/cia417/position/car_position_device.hpp"

namespace canvoy::cia417 {

/// Simulated encoders.
struct Encoders {
  std::array<PositionReadings, 4> readings;
  PositionReadings sense(unsigned unit) { return readings[unit - 1]; }
  CarPositionHardware hardware() { return {.sense = callback<&Encoders::sense>(*this)}; }
};

inline constexpr auto four_units_layout = layout_of<CarPositionKind<LiftDeviceOptions{}, 4, 2>>;
inline constexpr Cam bench_cams[] = {
    {.channel = 1, .number = 1, .unit = 1, .low = -100, .high = 100},
    {.channel = 1, .number = 2, .unit = 1, .low = 2900, .high = 3100, .hysteresis = 10},
    {.channel = 2, .number = 8, .unit = 2, .low = 0, .high = 500}};

class CarPositionTest : public testing::Test {
 protected:
  CarPositionTest() { start(device.node()); }
  void start(Node& node) {
    node_ = &node;
    node.start(now);
    send("000#01 00");
    sent.clear();
  }
  void send(std::string_view frame) {
    node_->receive(wire_frame(frame), now);
    settle();
  }
  void settle() {
    while (node_->deadline() <= now) node_->advance(now);
  }
  void run_for(Duration time) {
    const Time until = now + time;
    while (node_->deadline() <= until) {
      now = std::max(now, node_->deadline());
      settle();
    }
    now = until;
  }
  std::uint32_t ask(std::string_view request) {
    sent.clear();
    send("604#" + std::string(request));
    for (const Frame& frame : sent) {
      if (frame.id == 0x584) return load<std::uint32_t>(frame.data.data() + 4);
    }
    return 0xDEAD'BEEF;
  }
  std::uint32_t read(unsigned index, unsigned sub) {
    char request[32];
    std::snprintf(request, sizeof request, "40 %02X %02X %02X 00 00 00 00", index & 0xFF,
                  index >> 8, sub);
    return ask(request);
  }
  bool has_sent(std::string_view frame) const {
    for (const Frame& f : sent) {
      if (wire_text(f) == frame) return true;
    }
    return false;
  }
  Port port() {
    return {this,
            [](void* self, const Frame& frame) {
              static_cast<CarPositionTest*>(self)->sent.push_back(frame);
              return true;
            },
            nullptr};
  }

  Time now{};
  std::vector<Frame> sent;
  Node* node_ = nullptr;
  Encoders encoders;
  CarPositionDevice<four_units_layout> device{
      port(),
      4,
      encoders.hardware(),
      {.overspeed_millimetre_per_second = 1840, .cams = bench_cams}};
};

}  // namespace canvoy::cia417
