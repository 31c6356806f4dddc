// Invariants of the bus: properties over random histories. Single sentences of the standard are in
// simulated_bus_frame_test.cpp, simulated_bus_errors_test.cpp and simulated_cable_test.cpp.
#include "canvoy/can/simulated/simulated_bus.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "canvoy/can/frame_bits.hpp"
#include "canvoy/can/simulated/simulated_bus_test.hpp"

namespace canvoy::simulated_bus_test {
namespace {

using Nodes = std::vector<std::unique_ptr<BusTestNode>>;

Nodes make_nodes(SimulatedBus& bus, std::size_t count, const ControllerOptions& options = {}) {
  Nodes nodes;
  for (std::size_t i = 0; i < count; ++i)
    nodes.push_back(std::make_unique<BusTestNode>(bus, options));
  return nodes;
}

/// The frames with one identifier, without the repetition of a frame that was disturbed in its last
/// bit.
std::vector<Frame> frames_with(std::uint32_t id, const std::vector<TimedFrame>& log) {
  std::vector<Frame> frames;
  for (const TimedFrame& timed : log) {
    if (timed.frame.id != id || (!frames.empty() && frames.back() == timed.frame)) continue;
    frames.push_back(timed.frame);
  }
  return frames;
}

Frame numbered(std::uint32_t id, unsigned number) {
  return Frame::data_frame(
      id, {static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8)});
}

TEST(SimulatedBus, BringsEveryFrameToEveryNodeInOrderHoweverDisturbed) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SimulatedBus bus({.bit_rate = 500'000,
                      .faults = {.frame_error_probability = 0.02, .bit_error_rate = 1e-4},
                      .seed = seed});
    const Nodes nodes = make_nodes(bus, 6);
    Random random(seed);
    std::vector<std::vector<Frame>> queued(nodes.size());
    for (unsigned i = 0; i < 1000; ++i) {
      const std::size_t node = random.below(6);
      const Frame frame = numbered(0x180U + static_cast<std::uint32_t>(node), i);
      if (nodes[node]->send(frame)) queued[node].push_back(frame);
      bus.advance(bus.now() + Duration(random.below(400)));
    }
    bus.advance(bus.now() + 10s);
    for (std::size_t from = 0; from < nodes.size(); ++from) {
      const std::uint32_t id = 0x180U + static_cast<std::uint32_t>(from);
      ASSERT_GT(queued[from].size(), 50U);
      EXPECT_EQ(frames_with(id, nodes[from]->sent), queued[from]);
      EXPECT_EQ(nodes[from]->sent.size(), queued[from].size());
      for (std::size_t to = 0; to < nodes.size(); ++to) {
        if (to == from) continue;
        EXPECT_EQ(frames_with(id, nodes[to]->received), queued[from]);
      }
    }
  }
}

/// Any operation on a bus, at random.
class Chaos {
 public:
  Chaos(SimulatedBus& bus, std::uint32_t nodes, std::uint64_t seed)
      : bus_(bus), nodes_(nodes), random_(seed) {}

  void act() {
    const auto id = static_cast<ControllerId>(random_.below(nodes_));
    const bool choice = random_.below(2) == 1;
    switch (random_.below(14)) {
      case 0:
        bus_.cut_cable(id);
        break;
      case 1:
        bus_.mend_cable();
        break;
      case 2:
        bus_.unplug(id);
        break;
      case 3:
        bus_.plug(id);
        break;
      case 4:
        bus_.power(id, choice);
        break;
      case 5:
        bus_.set_bit_rate(id, choice ? 125'000 : 250'000);
        break;
      case 6:
        bus_.set_listen_only(id, choice);
        break;
      case 7:
        bus_.babble(id, numbered(0x100, random_.below(3)));
        break;
      case 8:
        bus_.stop_babbling(id);
        break;
      case 9:
        bus_.disturb(random_.below(40), random_.below(60));
        break;
      case 10:
        bus_.recover(id);
        break;
      case 11:
        bus_.discard_pending(id);
        break;
      default:
        bus_.send(id, numbered(0x200 + random_.below(4), random_.below(3)));
    }
    const Time before = bus_.now();
    bus_.step(before + Duration(random_.below(1500)));
    ASSERT_GE(bus_.now(), before);
    ASSERT_GE(bus_.next_event(), bus_.now());
    ASSERT_LE(bus_.load(id), 1.0);
  }

  void heal() {
    bus_.mend_cable();
    bus_.disturb(0, 1);
    for (std::uint32_t i = 0; i < nodes_; ++i) {
      const auto id = static_cast<ControllerId>(i);
      bus_.stop_babbling(id);
      bus_.plug(id);
      bus_.set_listen_only(id, false);
      bus_.set_bit_rate(id, 125'000);
      bus_.power(id, true);
      bus_.discard_pending(id);
      bus_.recover(id);
    }
    bus_.advance(bus_.now() + 10s);
  }

 private:
  SimulatedBus& bus_;
  std::uint32_t nodes_;
  Random random_;
};

TEST(SimulatedBus, WorksAgainAfterAnythingThatWasDoneToItIsUndone) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SimulatedBus bus({.faults = {.bit_error_rate = 1e-4}, .seed = seed});
    const Nodes nodes = make_nodes(bus, 5, {.recover_automatically = seed % 2 == 0});
    Chaos chaos(bus, 5, seed);
    for (int i = 0; i < 400; ++i) chaos.act();
    chaos.heal();
    for (const auto& node : nodes) {
      ASSERT_NE(node->state(), BusState::bus_off) << seed;
      node->received.clear();
      node->sent.clear();
    }
    for (const auto& node : nodes) node->send(numbered(0x300U + node->id, 7));
    bus.advance(bus.now() + 1s);
    for (const auto& from : nodes) {
      EXPECT_EQ(from->sent.size(), 1U) << seed;
      for (const auto& to : nodes) {
        if (to == from) continue;
        EXPECT_EQ(frames_with(0x300U + from->id, to->received).size(), 1U) << seed;
      }
    }
  }
}

TEST(SimulatedBus, HasTheSameHistoryForTheSameSeedHoweverItIsAdvanced) {
  const auto history = [](Duration stride) {
    SimulatedBus bus({.faults = {.frame_error_probability = 0.1}, .seed = 9});
    const Nodes nodes = make_nodes(bus, 3);
    for (unsigned i = 0; i < 300; ++i) {
      nodes[i % 3]->send(numbered(0x180 + i % 3, i));
      const Time next(Duration(1000) * (i + 1));
      while (bus.now() + stride < next) bus.advance(bus.now() + stride);
      bus.advance(next);
    }
    bus.advance(bus.now() + 1s);
    return nodes[0]->received;
  };
  const std::vector<TimedFrame> expected = history(1ms);
  EXPECT_GE(expected.size(), 200U);
  EXPECT_EQ(history(1us), expected);
  EXPECT_EQ(history(137us), expected);
}

TEST(SimulatedBus, WithoutAControllerIsIdle) {
  SimulatedBus bus;
  bus.advance(Time(1s));
  EXPECT_EQ(bus.next_event(), never);
  EXPECT_EQ(bus.load(), 0);
  EXPECT_EQ(bus.load_total(), 0);
}

TEST(SimulatedBus, CarriesEveryFrameOnceAtATimeWithAnIntermissionBetween) {
  SimulatedBus bus;
  struct Wire {
    std::vector<Duration> ends;
    std::vector<unsigned> bits;
  } wire;
  bus.observe(
      {.context = &wire, .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
         static_cast<Wire*>(context)->ends.push_back(now.time_since_epoch());
         static_cast<Wire*>(context)->bits.push_back(frame_bits(frame));
       }});
  const Nodes nodes = make_nodes(bus, 4);
  Random random(4);
  for (unsigned i = 0; i < 2000; ++i) {
    const std::uint32_t node = random.below(4);
    nodes[node]->send(numbered(0x180 + node, i));
    bus.advance(bus.now() + Duration(random.below(900)));
  }
  ASSERT_GT(wire.ends.size(), 1000U);
  for (std::size_t i = 1; i < wire.ends.size(); ++i) {
    EXPECT_GE(wire.ends[i] - wire.ends[i - 1], Duration(8) * (wire.bits[i] + intermission_bits));
  }
}

}  // namespace
}  // namespace canvoy::simulated_bus_test
