// Controllers that only listen: they receive the frames of others, which are not affected by them.
#include <gtest/gtest.h>

#include "canvoy/can/simulated/simulated_bus_test.hpp"

namespace canvoy::simulated_listener_test {
namespace {

constexpr Frame sync = Frame::data_frame(0x080, {});
constexpr unsigned sync_bits = 47;

/// Duration of bits at 125 kbit/s.
constexpr Duration bits(unsigned count) {
  return Duration(8 * count);
}

/// Listens only, and records errors too.
struct Listener {
  explicit Listener(SimulatedBus& bus, std::uint32_t bit_rate = 125'000)
      : id(bus.attach({.listener = {.context = this,
                                    .on_frame =
                                        [](void* self, Time now, const Frame&) {
                                          static_cast<Listener*>(self)->frames.push_back(
                                              now.time_since_epoch());
                                        }},
                       .bit_rate = bit_rate,
                       .listen_only = true,
                       .on_error = [](void* self, Time now) {
                         static_cast<Listener*>(self)->errors.push_back(now.time_since_epoch());
                       }})) {}
  std::vector<Duration> frames;
  std::vector<Duration> errors;
  ControllerId id;
};

TEST(Listener, HearsWhatTwoOthersSay) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  Listener listener(bus);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.frames, std::vector<Duration>{bits(sync_bits)});
  EXPECT_TRUE(listener.errors.empty());
}

TEST(Listener, HearsErrorsOnAForeignBitRateAndHarmsNobody) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  Listener listener(bus, 250'000);
  sender.send(sync);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_TRUE(listener.frames.empty());
  EXPECT_EQ(listener.errors.size(), 2U);
  EXPECT_EQ(receiver.received.size(), 2U);
  EXPECT_EQ(bus.statistics().error_frames, 0U);
  EXPECT_EQ(bus.error_counters(listener.id).receive(), 0);
}

TEST(Listener, HearsTheErrorFrameOfADisturbance) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  Listener listener(bus);
  bus.disturb(1, 20);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(listener.errors, std::vector<Duration>{bits(20)});
  EXPECT_EQ(listener.frames.size(), 1U);
}

// ISO 11898-1: error flags are dominant up to a transmit error counter of 127, 16 attempts of 8.
TEST(Listener, HearsALoneSenderFromItsSeventeenthAttemptOn) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  Listener listener(bus);
  sender.send(sync);
  while (listener.frames.empty()) bus.advance(bus.next_event());
  EXPECT_EQ(listener.errors.size(), 16U);
  EXPECT_EQ(sender.state(), BusState::error_passive);
  EXPECT_EQ(bus.statistics(sender.id).transmit_errors, 16U);
  bus.advance(bus.now() + 1s);
  EXPECT_GT(listener.frames.size(), 100U) << "it is sent again and again";
  EXPECT_EQ(listener.errors.size(), 16U);
  EXPECT_TRUE(sender.sent.empty());
  EXPECT_EQ(sender.tec(), 128);
  EXPECT_EQ(bus.statistics().frames, 0U) << "nobody has acknowledged one";
}

TEST(Listener, HasErrorCountersThatStandStill) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  BusTestNode third(bus);
  bus.disturb(3, 20);
  sender.send(sync);
  bus.advance(Time(bits(250)));
  const int before = third.rec();
  ASSERT_GT(before, 1);
  bus.set_listen_only(third.id, true);
  sender.send(sync);
  bus.advance(Time(1s));
  EXPECT_EQ(third.rec(), before);
  bus.set_listen_only(third.id, false);
  sender.send(sync);
  bus.advance(Time(2s));
  EXPECT_EQ(third.rec(), before - 1);
}

TEST(Listener, HasErrorCountersThatStandStillWhenItIsCutOffFromAFrame) {
  SimulatedBus bus;
  BusTestNode sender(bus);
  BusTestNode receiver(bus);
  Listener listener(bus);
  BusTestNode last(bus);
  sender.send(sync);
  bus.advance(Time(bits(20)));
  bus.cut_cable(receiver.id);
  EXPECT_EQ(bus.error_counters(listener.id).receive(), 0);
  EXPECT_EQ(last.rec(), 1);
}

}  // namespace
}  // namespace canvoy::simulated_listener_test
