// Real devices in a simulated building: the test is a node that the description has and does not
// simulate. Its frames on the bus are those of a foreign device, and people board by them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/testing/broken.hpp"

namespace canvoy::lift::lift_real_device_test {
namespace {

/// A foreign device: sends given frames, and a heartbeat each 500 ms.
class Stranger {
 public:
  Stranger(LiftNetwork& network, NodeId id)
      : world_(network.world()), id_(id), slot_(world_.add_slot(0, {.accept_all = true})) {
    world_.occupy(slot_, *this);
    world_.start(slot_);
  }

  void say(std::uint32_t can_id, std::initializer_list<std::uint8_t> bytes) {
    const Port port = world_.port(slot_);
    ASSERT_TRUE(port.send(port.context, Frame::data_frame(can_id, bytes)));
  }
  void fall_silent() { next_ = never; }
  void on_frame(std::function<void(const Frame&)> heard) { heard_ = std::move(heard); }

  void start(Time now) {
    say(0x700U + id_, {0x00});
    next_ = now + 100ms;
  }
  void receive(const Frame& frame, Time) {
    if (heard_) heard_(frame);
  }
  void advance(Time now) {
    if (next_ == never || now < next_) return;
    say(0x700U + id_, {0x05});
    next_ = now + 500ms;
  }
  Time deadline() const { return next_; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {}
  void overrun(Time) {}

 private:
  World& world_;
  NodeId id_;
  SlotIndex slot_;
  Time next_ = never;
  std::function<void(const Frame&)> heard_;
};

NodeDescription& node_of(LiftNetworkDescription& description, DeviceKind kind) {
  return *std::ranges::find(description.nodes, kind, &NodeDescription::kind);
}

/// One person wants to go from floor 3 to floor 1 of a lift; a device of this kind is a real one.
LiftNetworkDescription house_with_a_real(DeviceKind kind) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  description.arrivals = {{.at = Time(5s), .from = 3, .to = 1, .mass_kg = 80}};
  node_of(description, kind).played = false;
  return description;
}

template <class What>
std::size_t count_of(const LiftNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(
      network.events(),
      [](const LiftEvent& event) { return std::holds_alternative<What>(event.what); }));
}

bool has_told(const LiftNetwork& network, std::uint16_t code) {
  return std::ranges::any_of(network.events(), [code](const LiftEvent& event) {
    const auto* told = std::get_if<EmergencySeen>(&event.what);
    return told != nullptr && told->code == code;
  });
}

TEST(LiftRealDevice, ALoadUnitThatSaysOverloadKeepsTheCarAtItsFloor) {
  LiftNetwork network(house_with_a_real(DeviceKind::load));
  Stranger load(network, 13);
  network.run_until(Time(2s));
  load.say(0x188, {14});  // norm, full and overload (6482h:01h)
  network.run_until(Time(60s));
  EXPECT_EQ(count_of<CarStarted>(network), 0U);
  EXPECT_EQ(network.summary().served, 0U);
  EXPECT_TRUE(network.snapshot().lifts.at(0).overload) << "the car shows it";
  EXPECT_GE(network.snapshot().lifts.at(0).load_kg, 1100) << "so much the scale says at least";
  load.say(0x188, {0});
  network.run_until(Time(2min));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftRealDevice, ALoadUnitThatFallsSilentIsToldAndTheCarStands) {
  LiftNetwork network(house_with_a_real(DeviceKind::load));
  Stranger load(network, 13);
  network.run_until(Time(2s));
  load.say(0x188, {0});
  network.run_until(Time(4s));
  EXPECT_FALSE(has_told(network, 0x8130));
  EXPECT_EQ(network.snapshot().lifts.at(0).mode, LiftMode::normal);
  load.fall_silent();
  network.run_until(Time(6s));
  EXPECT_TRUE(has_told(network, 0x8130)) << "1016h has its node-ID, and 1.5 s";
}

/// A foreign position unit: reports the position of the simulated car each 50 ms, in 0.1 mm.
class StrangersPosition {
 public:
  explicit StrangersPosition(LiftNetwork& network) : network_(network), stranger_(network, 4) {
    network.world().at(Time(1s), [this](Time now) { tell(now); });
  }
  /// Reports 7 m for ever.
  void get_stuck() { is_stuck_ = true; }

 private:
  void tell(Time now) {
    const double position_m = is_stuck_ ? 7 : network_.snapshot().lifts.at(0).position_m;
    const auto counts = static_cast<std::uint32_t>(std::lround(position_m * 10'000));
    const auto byte = [counts](unsigned i) { return static_cast<std::uint8_t>(counts >> (8 * i)); };
    stranger_.say(0x18C, {byte(0), byte(1), byte(2), byte(3)});
    network_.world().at(now + 50ms, [this](Time at) { tell(at); });
  }

  LiftNetwork& network_;
  Stranger stranger_;
  bool is_stuck_ = false;
};

TEST(LiftRealDevice, APositionThatIsSoBreaksNothing) {
  LiftNetwork network(house_with_a_real(DeviceKind::position));
  const StrangersPosition position(network);
  network.run_until(Time(2min));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_EQ(broken(network), "");
}

/// The controller stops the car fast, which is right: that acceleration or jerk is not its own
/// fault.
TEST(LiftRealDevice, APositionThatIsNotSoIsToldAsItsDoing) {
  LiftNetwork network(house_with_a_real(DeviceKind::position));
  StrangersPosition position(network);
  network.run_until(Time(5s));
  while (std::abs(network.snapshot().lifts.at(0).speed_m_s) < 1) {
    ASSERT_LT(network.now(), Time(1min));
    network.run_until(network.now() + 100ms);
  }
  position.get_stuck();
  network.run_until(network.now() + 30s);
  for (const Invariant& invariant : network.invariants()) {
    EXPECT_EQ(invariant.held, invariant.kind != InvariantKind::real_position)
        << invariant_name(invariant.kind).name;
  }
}

/// A foreign door: opens and closes in two seconds each, and reports it.
class StrangersDoor {
 public:
  StrangersDoor(LiftNetwork& network, bool tells_position)
      : world_(network.world()), stranger_(network, 6), tells_position_(tells_position) {
    stranger_.on_frame([this](const Frame& frame) { heard(frame); });
  }

 private:
  // 6301h, the states in bits 12 to 15 (4.7.1).
  static constexpr std::uint8_t closed = 0x00, closing = 0x20, opened = 0x30, opening = 0x50;

  void heard(const Frame& frame) {
    if (frame.is_remote() && frame.id == 0x201) return tell();
    if (frame.id != 0x200 || frame.length != 8) return;
    const unsigned command = frame.data[1] >> 4U;  // of door 1 (4.6.1)
    if (command <= 1) move(closing, closed, 0);
    if (command == 3 || command == 4) move(opening, opened, 700);
  }
  void move(std::uint8_t on_the_way, std::uint8_t at_last, std::uint16_t end_mm) {
    if (state_ == on_the_way || state_ == at_last) return;
    const unsigned order = ++orders_;
    turn(on_the_way, 350);
    world_.at(world_.now() + 2s, [this, order, at_last, end_mm](Time) {
      if (order == orders_) turn(at_last, end_mm);
    });
  }
  void turn(std::uint8_t state, std::uint16_t position_mm) {
    state_ = state;
    position_mm_ = position_mm;
    tell();
  }
  void tell() {
    // Lock and safety contact closed, in bits 4 and 0; without battery and detectors.
    const std::uint8_t contacts = state_ == closed ? 0xDD : 0xCC;
    const std::uint16_t position = tells_position_ ? position_mm_ : 0xFFFF;
    stranger_.say(0x201, {contacts, static_cast<std::uint8_t>(state_ | 0x03U),
                          static_cast<std::uint8_t>(position & 0xFFU),
                          static_cast<std::uint8_t>(position >> 8U)});
  }

  World& world_;
  Stranger stranger_;
  bool tells_position_;
  std::uint8_t state_ = closed;
  std::uint16_t position_mm_ = 0;
  unsigned orders_ = 0;
};

TEST(LiftRealDevice, PeopleBoardThroughADoorThatSaysThatItIsOpen) {
  for (const bool tells_position : {true, false}) {
    LiftNetwork network(house_with_a_real(DeviceKind::door));
    const StrangersDoor door(network, tells_position);
    network.run_until(Time(2min));
    EXPECT_EQ(network.summary().served, 1U);
    EXPECT_EQ(count_of<DoorsOpened>(network), 2U) << "at floors 3 and 1";
    EXPECT_EQ(broken(network), "");
  }
}

TEST(LiftRealDevice, ADoorIsAsWideOpenAsItSays) {
  LiftNetwork network(house_with_a_real(DeviceKind::door));
  Stranger door(network, 6);
  const auto after = [&](std::initializer_list<std::uint8_t> said) {
    door.say(0x201, said);
    network.run_until(network.now() + 100ms);
    return network.snapshot().lifts.at(0).doors.at(0);
  };
  network.run_until(Time(2s));
  EXPECT_DOUBLE_EQ(after({0xCC, 0x53, 0xC2, 0x01}).open_share, 0.5) << "opening, 450 mm of 900";
  EXPECT_DOUBLE_EQ(after({0xCC, 0x73, 0xE1, 0x00}).open_share, 0.25) << "stopped, at 225 mm";
  EXPECT_DOUBLE_EQ(after({0xCC, 0x33, 0xBC, 0x02}).open_share, 1) << "opened: no wider than 700 mm";
  EXPECT_FALSE(after({0xCC, 0x03, 0x00, 0x00}).locked) << "closed, not locked";
  EXPECT_TRUE(after({0xDD, 0x03, 0x00, 0x00}).locked);
  EXPECT_TRUE(after({0xFD, 0x03, 0x00, 0x00}).locked) << "closed, and has no lock";
}

TEST(LiftRealDevice, ALightBarrierThatSeesSomebodyKeepsTheDoorOpen) {
  LiftNetwork network(house_with_a_real(DeviceKind::light_barrier));
  Stranger barrier(network, 9);
  network.run_until(Time(2s));
  barrier.say(0x205, {0x3F});  // 6310h:01h, the status in bits 6 and 7 (4.8.1)
  while (count_of<DoorsOpened>(network) == 0) {
    ASSERT_LT(network.now(), Time(1min));
    network.run_until(network.now() + 100ms);
  }
  barrier.say(0x205, {0x7F});
  network.run_until(network.now() + 15s);
  EXPECT_EQ(count_of<CarStarted>(network), 1U) << "to floor 3, and not on from there";
  EXPECT_TRUE(network.snapshot().lifts.at(0).doors.at(0).blocked);
  barrier.say(0x205, {0x3F});
  network.run_until(Time(2min));
  EXPECT_EQ(network.summary().served, 1U);
  EXPECT_FALSE(network.snapshot().lifts.at(0).doors.at(0).blocked);
  EXPECT_EQ(broken(network), "");
}

TEST(LiftRealDevice, AFireKeyOfARealPanelBringsEverybodyOut) {
  LiftNetworkDescription description = house_with_a_real(DeviceKind::landing_panel);
  ASSERT_EQ(node_of(description, DeviceKind::landing_panel).id, 21);
  description.arrivals = {{.at = Time(5s), .from = 2, .to = 4, .mass_kg = 80},
                          {.at = Time(6s), .from = 4, .to = 2, .mass_kg = 80}};
  LiftNetwork network(description);
  Stranger panel(network, 21);
  network.run_until(Time(20s));
  panel.say(0x495, {0x0E, 0x0B, 0x01, 0x01, 0x10, 0x81});  // fire service enable, turned
  network.run_until(Time(2min));
  EXPECT_EQ(network.snapshot().lifts.at(0).mode, LiftMode::fire_recall);
  EXPECT_EQ(network.snapshot().lifts.at(0).nearest_floor, 1);
  EXPECT_TRUE(network.snapshot().lifts.at(0).car_calls.empty());
  EXPECT_EQ(broken(network), "") << "calls are taken back for the key";
}

TEST(LiftRealDevice, AHallCallOfARealPanelBringsTheCar) {
  LiftNetworkDescription description = house_with_a_real(DeviceKind::landing_panel);
  description.nodes.back().played = false;  // of floor 4, node 24
  description.arrivals.clear();
  description.traffic.percent_in_5_minutes = 0;
  LiftNetwork network(description);
  Stranger panel(network, 24);
  network.run_until(Time(5s));
  panel.say(0x498, {0x02, 0x02, 0xFF, 0x04, 0x10, 0x01});
  panel.say(0x498, {0x02, 0x02, 0xFF, 0x04, 0x10, 0x00});
  network.run_until(Time(40s));
  EXPECT_EQ(network.snapshot().lifts.at(0).nearest_floor, 4);
  EXPECT_EQ(count_of<DoorsOpened>(network), 1U);
}

TEST(LiftRealDevice, EveryNodeThatIsNotPlayedIsSupervised) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4});
  for (NodeDescription& node : description.nodes) {
    node.played = node.kind == DeviceKind::lift_controller;
  }
  LiftNetwork network(description);
  std::vector<std::unique_ptr<Stranger>> strangers;
  for (const NodeDescription& node : description.nodes) {
    if (!node.played) strangers.push_back(std::make_unique<Stranger>(network, node.id));
  }
  network.run_until(Time(5s));
  EXPECT_FALSE(has_told(network, 0x8130));
  for (const auto& each : strangers) each->fall_silent();
  std::set<unsigned> lost;
  network.observe(
      0, {.context = &lost, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
            const bool is_lost = frame.id == 0x081 && frame.data[1] == 0x81;
            if (is_lost) static_cast<std::set<unsigned>*>(self)->insert(frame.data[3]);
          }});
  network.run_until(Time(10s));
  EXPECT_EQ(lost, (std::set<unsigned>{2, 4, 6, 9, 13, 16, 21, 22, 23, 24}));
}

TEST(LiftRealDevice, OfTwoLightBarriersEachSpeaksOfItsOwnDoor) {
  LiftNetworkDescription description = standard_lift_network({.floors = 4, .lift = {.doors = 3}});
  node_of(description, DeviceKind::light_barrier).doors = 0b01;
  description.nodes.push_back({.id = 10, .kind = DeviceKind::light_barrier, .doors = 0b10});
  description.nodes.back().played = false;
  LiftNetwork network(description);
  unsigned spoken = 0;
  network.observe(
      0, {.context = &spoken, .on_frame = [](void* self, Time, ControllerId, const Frame& frame) {
            if (frame.id == 0x206 && !frame.is_remote()) ++*static_cast<unsigned*>(self);
          }});
  network.run_until(Time(10s));
  EXPECT_EQ(spoken, 0U) << "206h is that of the real one";
}

TEST(LiftRealDevice, IsNotBrokenHere) {
  LiftNetworkDescription description = house_with_a_real(DeviceKind::light_barrier);
  const auto error_of = [&](FaultKind kind, NodeId node = 0) {
    description.faults.faults = {{.kind = kind, .start = Time(1s), .part = 1, .node = node}};
    return check(description);
  };
  EXPECT_EQ(
      error_of(FaultKind::light_barrier),
      "fault light-barrier: lift-light-barrier with node-ID 9 is a real one, and is not broken "
      "here");
  EXPECT_EQ(
      error_of(FaultKind::lost_node, 9),
      "fault lost-node: lift-light-barrier with node-ID 9 is a real one, and is not broken here");
  EXPECT_EQ(error_of(FaultKind::lost_node, 2), "");
  EXPECT_EQ(error_of(FaultKind::fire_alarm), "");
  node_of(description, DeviceKind::landing_panel).played = false;
  EXPECT_EQ(error_of(FaultKind::fire_alarm),
            "fault fire-alarm: lift-landing-panel with node-ID 21 is a real one, and is not broken "
            "here");
}

}  // namespace
}  // namespace canvoy::lift::lift_real_device_test
