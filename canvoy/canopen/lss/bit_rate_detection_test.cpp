// Automatic bit-rate detection, alone and on the simulated bus.
#include "canvoy/canopen/lss/bit_rate_detection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "canvoy/can/simulated/simulated_bus.hpp"

namespace canvoy::bit_rate_detection_test {
namespace {

using State = BitRateDetection::State;
using Texts = std::vector<std::string>;

constexpr Frame heartbeat = Frame::data_frame(0x705, {0x05});
constexpr std::uint32_t three_rates[] = {500'000, 250'000, 125'000};

/// A controller that records its calls.
struct Controller {
  explicit Controller(const BitRateDetection::Options& options)
      : detection(BitRateDetection::Restart::to<&Controller::restart>(*this), options) {
    detection.on_found(callback<&Controller::found>(*this));
  }
  bool restart(std::uint32_t bit_rate, bool listen_only) {
    log.push_back((listen_only ? "listen " : "active ") + std::to_string(bit_rate));
    return bit_rate != refused && (listen_only || bit_rate != refused_active);
  }
  void found(std::uint32_t bit_rate) { log.push_back("found " + std::to_string(bit_rate)); }
  /// Calls the detection at its deadlines.
  void run_until(Time until) {
    while (detection.deadline() <= until) {
      log.push_back("@" + std::to_string(detection.deadline().time_since_epoch().count()));
      detection.advance(detection.deadline());
    }
  }
  Texts take() { return std::exchange(log, {}); }

  std::uint32_t refused = 0;
  std::uint32_t refused_active = 0;
  Texts log;
  BitRateDetection detection;
};

TEST(BitRateDetection, TakesTheBitRateOfTheFirstFrameAndTakesPart) {
  Controller sut({.bit_rates = three_rates});
  EXPECT_EQ(sut.detection.deadline(), never);
  sut.detection.start(Time(0s));
  EXPECT_EQ(sut.detection.state(), State::listening);
  sut.detection.receive(heartbeat, Time(3ms));
  EXPECT_EQ(sut.take(), Texts({"listen 500000", "active 500000", "found 500000"}));
  EXPECT_EQ(sut.detection.state(), State::found);
  EXPECT_EQ(sut.detection.bit_rate(), 500'000U);
  EXPECT_EQ(sut.detection.deadline(), never);
}

TEST(BitRateDetection, TellsAnIndicatorWhenItBeginsAndEnds) {
  std::vector<bool> told;
  auto tell = [&](bool under_way) { told.push_back(under_way); };
  Controller sut({.bit_rates = three_rates, .rounds_max = 1});
  sut.detection.on_under_way(Callback<void(bool)>::of(tell));
  sut.detection.start(Time(0s));
  EXPECT_EQ(told, std::vector<bool>({true}));
  sut.detection.receive(heartbeat, Time(3ms));
  EXPECT_EQ(told, std::vector<bool>({true, false})) << "found";
  sut.detection.start(Time(1s));
  sut.run_until(Time(10s));
  EXPECT_EQ(told, std::vector<bool>({true, false, true, false})) << "not found";
  sut.detection.start(Time(20s));
  sut.detection.stop();
  sut.detection.stop();
  EXPECT_EQ(told, std::vector<bool>({true, false, true, false, true, false})) << "stopped";
}

TEST(BitRateDetection, GoesOnAtAnError) {
  Controller sut({.bit_rates = three_rates});
  sut.detection.start(Time(0s));
  sut.detection.bus_error(Time(1ms));
  Frame error = heartbeat;
  error.flags = FrameFlags::error;
  sut.detection.receive(error, Time(2ms));
  EXPECT_EQ(sut.take(), Texts({"listen 500000", "listen 250000", "listen 125000"}));
  sut.detection.receive(heartbeat, Time(3ms));
  EXPECT_EQ(sut.take(), Texts({"active 125000", "found 125000"}));
}

TEST(BitRateDetection, MayNeedSeveralErrorsOfOneVisit) {
  Controller sut({.bit_rates = three_rates, .dwell = 1s, .errors_max = 3});
  sut.detection.start(Time(0s));
  sut.detection.bus_error(Time(0s));
  sut.detection.bus_error(Time(0s));
  EXPECT_EQ(sut.detection.bit_rate(), 500'000U);
  sut.run_until(Time(1s));
  EXPECT_EQ(sut.detection.bit_rate(), 250'000U);
  sut.detection.bus_error(Time(1s));
  sut.detection.bus_error(Time(1s));
  EXPECT_EQ(sut.detection.bit_rate(), 250'000U) << "those before do not count";
  sut.detection.bus_error(Time(1s));
  EXPECT_EQ(sut.detection.bit_rate(), 125'000U);
}

TEST(BitRateDetection, GoesOnAfterADwellOfSilenceRoundAndRound) {
  Controller sut({.bit_rates = three_rates, .dwell = 200ms});
  sut.detection.start(Time(0s));
  sut.run_until(Time(800ms));
  EXPECT_EQ(sut.take(),
            Texts({"listen 500000", "@200000", "listen 250000", "@400000", "listen 125000",
                   "@600000", "listen 500000", "@800000", "listen 250000"}));
}

TEST(BitRateDetection, GivesUpAfterItsRounds) {
  Controller sut({.bit_rates = three_rates, .dwell = 100ms, .rounds_max = 2});
  sut.detection.start(Time(0s));
  sut.run_until(Time(1h));
  EXPECT_EQ(sut.detection.state(), State::failed);
  const Texts log = sut.take();
  EXPECT_EQ(log.back(), "found 0");
  EXPECT_EQ(log[log.size() - 2], "@600000");
  sut.detection.receive(heartbeat, Time(1h));
  sut.detection.bus_error(Time(1h));
  EXPECT_EQ(sut.take(), Texts{}) << "it is over";
  sut.detection.start(Time(1h));
  EXPECT_EQ(sut.take(), Texts{"listen 500000"});
}

TEST(BitRateDetection, StepsOverWhatTheControllerCannotHave) {
  Controller sut({.bit_rates = three_rates, .dwell = 100ms});
  sut.refused = 250'000;
  sut.detection.start(Time(0s));
  sut.run_until(Time(110ms));
  EXPECT_EQ(sut.take(),
            Texts({"listen 500000", "@100000", "listen 250000", "@110000", "listen 125000"}));
}

TEST(BitRateDetection, GoesOnWhereTheControllerCannotTakePart) {
  Controller sut({.bit_rates = three_rates, .dwell = 100ms});
  sut.refused_active = 500'000;
  sut.detection.start(Time(0s));
  sut.detection.receive(heartbeat, Time(3ms));
  EXPECT_EQ(sut.detection.state(), State::listening);
  EXPECT_EQ(sut.detection.deadline(), Time(103ms));
  EXPECT_EQ(sut.take(), Texts({"listen 500000", "active 500000", "listen 250000"}));
  sut.detection.receive(heartbeat, Time(4ms));
  EXPECT_EQ(sut.take(), Texts({"active 250000", "found 250000"}));
  Controller once({.bit_rates = std::span(three_rates).first(1), .rounds_max = 1});
  once.refused_active = 500'000;
  once.detection.start(Time(0s));
  once.detection.receive(heartbeat, Time(3ms));
  EXPECT_EQ(once.detection.state(), State::failed);
  EXPECT_EQ(once.take(), Texts({"listen 500000", "active 500000", "found 0"}));
}

TEST(BitRateDetection, IsStoppedAndHasNothingToDoWithoutBitRates) {
  Controller sut({.bit_rates = three_rates});
  sut.detection.start(Time(0s));
  sut.take();
  sut.detection.stop();
  sut.detection.receive(heartbeat, Time(1ms));
  EXPECT_EQ(sut.detection.deadline(), never);
  EXPECT_EQ(sut.take(), Texts{});
  Controller none({.bit_rates = {}});
  none.detection.start(Time(0s));
  EXPECT_EQ(none.detection.state(), State::failed);
  EXPECT_EQ(none.take(), Texts{});
}

// On the simulated bus

/// A device that detects the bit rate, at the end of a bus.
struct Device {
  Device(SimulatedBus& owner, const BitRateDetection::Options& options)
      : bus(owner),
        id(owner.attach({.listener = {.context = this, .on_frame = &Device::heard},
                         .bit_rate = 10'000,
                         .listen_only = true,
                         .on_error = &Device::error})),
        detection(BitRateDetection::Restart::to<&Device::restart>(*this), options) {}

  static void heard(void* self, Time now, const Frame& frame) {
    static_cast<Device*>(self)->detection.receive(frame, now);
  }
  static void error(void* self, Time now) { static_cast<Device*>(self)->detection.bus_error(now); }
  bool restart(std::uint32_t bit_rate, bool listen_only) {
    bus.set_listen_only(id, listen_only);
    bus.set_bit_rate(id, bit_rate);
    ++visits;
    return true;
  }
  /// Advances until the bit rate is found, while `sender` sends each period; false if it is not
  /// found before `until`.
  bool run_until(Time until, ControllerId sender, Duration period) {
    detection.start(bus.now());
    Time heartbeat_at = bus.now() + period;
    while (detection.state() != State::found) {
      const Time next = std::min({bus.next_event(), detection.deadline(), heartbeat_at});
      if (next > until) return false;
      bus.advance(next);
      detection.advance(next);
      if (next < heartbeat_at) continue;
      bus.send(sender, heartbeat);
      heartbeat_at += period;
    }
    return true;
  }

  SimulatedBus& bus;
  ControllerId id;
  int visits = 0;
  BitRateDetection detection;
};

TEST(BitRateDetectionOnABus, FindsEachBitRateOfTwoOthersThatTalkAndDisturbsNothing) {
  for (const std::uint32_t bit_rate : BitRateDetection::usual_bit_rates) {
    SimulatedBus bus({.bit_rate = bit_rate});
    const ControllerId sender = bus.attach({});
    bus.attach({});
    Device device(bus, {});
    EXPECT_TRUE(device.run_until(Time(2min), sender, 1s)) << bit_rate;
    EXPECT_EQ(device.detection.bit_rate(), bit_rate);
    EXPECT_EQ(bus.statistics().error_frames, 0U) << bit_rate;
    EXPECT_EQ(bus.error_counters(sender).transmit(), 0);
  }
}

TEST(BitRateDetectionOnABus, FindsThatOfOneSenderWhenItIsErrorPassive) {
  for (const std::uint32_t bit_rate : BitRateDetection::usual_bit_rates) {
    SimulatedBus bus({.bit_rate = bit_rate});
    const ControllerId sender = bus.attach({});
    Device device(bus, {});
    EXPECT_TRUE(device.run_until(Time(2min), sender, 1s)) << bit_rate;
    EXPECT_EQ(device.detection.bit_rate(), bit_rate);
    const Time found = bus.now();
    bus.advance(found + 1s);
    EXPECT_GE(bus.statistics(sender).sent, 1U) << "and acknowledges the next one";
  }
}

TEST(BitRateDetectionOnABus, TakesPartWithFramesOfItsOwnWhenItHasFoundTheRate) {
  SimulatedBus bus({.bit_rate = 250'000});
  const ControllerId sender = bus.attach({});
  const ControllerId other = bus.attach({});
  Device device(bus, {});
  EXPECT_FALSE(bus.send(device.id, heartbeat)) << "it only listens";
  ASSERT_TRUE(device.run_until(Time(1min), sender, 100ms));
  const auto before = bus.statistics(other).received;
  EXPECT_TRUE(bus.send(device.id, heartbeat));
  bus.advance(bus.now() + 1s);
  EXPECT_GT(bus.statistics(other).received, before);
  EXPECT_EQ(bus.statistics().error_frames, 0U);
}

TEST(BitRateDetectionOnABus, FindsItAlthoughFramesAreDisturbed) {
  SimulatedBus bus({.bit_rate = 50'000, .faults = {.frame_error_probability = 0.5}, .seed = 5});
  const ControllerId sender = bus.attach({});
  bus.attach({});
  Device device(bus, {});
  EXPECT_TRUE(device.run_until(Time(10min), sender, 500ms));
  EXPECT_EQ(device.detection.bit_rate(), 50'000U);
}

TEST(BitRateDetectionOnABus, ListensOnWhereNobodyTalks) {
  SimulatedBus bus;
  const ControllerId silent = bus.attach({});
  Device device(bus, {.dwell = 100ms});
  EXPECT_FALSE(device.run_until(Time(10s), silent, 1h));
  EXPECT_EQ(device.visits, 101);
}

}  // namespace
}  // namespace canvoy::bit_rate_detection_test
