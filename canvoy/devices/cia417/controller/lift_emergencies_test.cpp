// Emergencies of a lift controller when a cut cable loses all panels at once: 8130h, at intervals
// of the inhibit time (1015h; CiA 301, 7.5.2.18), so that PDOs are sent between them. On a bus of
// 250 kbit/s an emergency takes some 0.5 ms.
#include <gtest/gtest.h>

#include "canvoy/can/simulated/simulated_bus.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/lift_controller_device.hpp"

namespace canvoy::cia417::lift_emergencies_test {
namespace {

constexpr std::int32_t heights[] = {0, 4'000'000, 7'000'000, 10'000'000};
constexpr unsigned panels_first = 16;
constexpr unsigned panels_last = 115;
constexpr unsigned panels = panels_last - panels_first + 1;

LiftControllerDeviceSettings settings() {
  return {.calls = {.served = {FloorSet::between(1, 4)}}, .lift = {.floors = heights}};
}
Frame heartbeat(unsigned panel) {
  return Frame::data_frame(0x700 + panel, {0x05});
}
bool is_loss(const Frame& frame) {
  return frame.id == 0x081 && frame.data[0] == 0x30 && frame.data[1] == 0x81;
}

TEST(LiftEmergencies, OfACutCableEachIsToldTwoMillisecondsBehindTheOneBefore) {
  Cable cable;
  LiftControllerDevice<> device(cable.port(0), 1, settings());
  cable.connect(0, device.node());
  cable.start_all();
  cable.run_for(4s);
  for (unsigned panel = panels_first; panel <= panels_last; ++panel) {
    cable.send(wire_text(heartbeat(panel)));
  }
  cable.run_for(1s);
  cable.clear();
  const Time lost_at = cable.now + 2s;
  cable.run_for(2s + panels * 2ms);
  std::vector<Cable::Heard> told;
  std::ranges::copy_if(cable.heard, std::back_inserter(told),
                       [](const auto& heard) { return is_loss(heard.frame); });
  ASSERT_EQ(told.size(), panels);
  for (unsigned i = 0; i < panels; ++i) {
    EXPECT_EQ(told[i].frame.data[3], panels_first + i);
    EXPECT_EQ(told[i].at, lost_at + i * 2ms);
  }
}

TEST(LiftEmergencies, TheInhibitTimeMayBeChanged) {
  Cable cable;
  LiftControllerDevice<> device(cable.port(0), 1, settings());
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("601#40 15 10 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#4B 15 10 00 14 00 00 00") << "20 times 100 us";
  cable.send("601#2B 15 10 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x581), "581#60 15 10 00 00 00 00 00");
}

/// The controller on a bus with the time of a real one.
class LiftOnABus : public testing::Test {
 protected:
  static constexpr std::uint32_t bit_rate = 250'000;

  LiftOnABus() {
    controller_ = bus_.attach(
        {.listener = {
             .context = this, .on_frame = &LiftOnABus::deliver, .on_sent = &LiftOnABus::sent}});
    others_ = bus_.attach({.listener = {.context = this, .on_frame = &LiftOnABus::hear}});
    device.node().start(now_);
  }
  void run_for(Duration duration) {
    const Time end = now_ + duration;
    for (;;) {
      const Time next = std::min(bus_.next_event(), device.node().deadline());
      if (next > end) break;
      now_ = std::max(now_, next);
      bus_.advance(now_);
      if (device.node().deadline() <= now_) device.node().advance(now_);
    }
    now_ = end;
    bus_.advance(now_);
  }
  void send(const Frame& frame) { ASSERT_TRUE(bus_.send(others_, frame)); }

  std::size_t losses = 0;
  Time answered_at = never;
  Time now_{};

 private:
  static LiftOnABus& self(void* context) { return *static_cast<LiftOnABus*>(context); }
  static bool transmit(void* context, const Frame& frame) {
    return self(context).bus_.send(self(context).controller_, frame);
  }
  static void deliver(void* context, Time now, const Frame& frame) {
    self(context).device.node().receive(frame, now);
  }
  static void sent(void* context, Time now, const Frame&) {
    self(context).device.node().tx_ready(now);
  }
  static void hear(void* context, Time now, const Frame& frame) {
    LiftOnABus& test = self(context);
    if (is_loss(frame)) ++test.losses;
    if (wire_text(frame) == "400#02 01 01 03 10 81") test.answered_at = now;
  }

  SimulatedBus bus_{{.bit_rate = bit_rate, .transmit_queue_max = 200}};
  ControllerId controller_ = no_controller;
  ControllerId others_ = no_controller;

 protected:
  LiftControllerDevice<> device{{this, &LiftOnABus::transmit, nullptr}, 1, settings()};
};

TEST_F(LiftOnABus, WhoPressesWhileAHundredPanelsAreLostIsAnsweredInAMillisecondOrTwo) {
  run_for(4s);
  for (unsigned panel = panels_first; panel <= panels_last; ++panel) send(heartbeat(panel));
  run_for(1s);
  std::size_t before = 0;
  for (int i = 0; losses == before && i < 10'000; ++i) run_for(1ms);
  ASSERT_GT(losses, 0u);
  run_for(20ms);
  ASSERT_LT(losses, 20u);
  before = losses;
  const Time pressed_at = now_;
  send(Frame::data_frame(0x495, {0x02, 0x01, 0x01, 0x03, 0x10, 0x01}));
  run_for(50ms);
  // Its own frame and the answer take 0.5 ms each; an emergency may be before either.
  EXPECT_LT(answered_at - pressed_at, 2500us);
  EXPECT_GE(losses, before + 20) << "all the time they were told";
}

}  // namespace
}  // namespace canvoy::cia417::lift_emergencies_test
