// The gateway as master of a car's network, with add-on devices on one cable: names by Fastscan,
// NMT, sleep (facts 2.1 and 2.4, CiA 305).
#include "canvoy/devices/cia447/kit/car_master.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>

#include "canvoy/canopen/lss/lss_slave.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"

namespace canvoy::cia447::car_master_test {
namespace {

/// An add-on device without a node-ID.
struct AddOn {
  AddOn(Cable& cable, std::size_t place, unsigned serial)
      : device(only_unit<BlueLightKind>, cable.port(place), node_id_unconfigured, environment),
        lss(device.node()) {
    device.node().dictionary().set_number(0x1018, 4, serial);
    serial_number = serial;
    keep = device.node().on_defaults_restored(callback<&AddOn::restored>(*this));
    cable.connect(place, device.node());
  }
  void restored(ResetScope scope) {
    keep(scope);
    device.node().dictionary().set_number(0x1018, 4, serial_number);
  }

  Environment environment;
  CarDevice device;
  LssSlave lss;
  unsigned serial_number = 0;
  Callback<void(ResetScope)> keep;
};

/// A device of others that has node-ID 9, and answers Fastscan although it has one.
struct AnswersAlways {
  static constexpr unsigned serial = 0x99;

  AnswersAlways(Cable& cable, std::size_t place)
      : device(only_unit<BlueLightKind>, cable.port(place), 9, environment) {
    device.node().router().add(0x7E5, callback<&AnswersAlways::ask>(*this));
    cable.connect(place, device.node());
  }
  /// CiA 305: Fastscan (51h), switch state (04h), inquire identity (5Ah to 5Dh), node-ID (11h).
  void ask(const Frame& frame, Time) {
    const auto value = load<std::uint32_t>(frame.data.data() + 1);
    const std::uint8_t bit = frame.data[5];
    const std::uint8_t part = frame.data[6];
    const std::uint8_t command = frame.data[0];
    if (command == 0x51 && bit == 0x80) {
      expected = 0;
      answer(0x4F, 0);
    } else if (command == 0x51 && part == expected && (identity[part] ^ value) >> bit == 0) {
      expected = frame.data[7];
      is_in_configuration = is_in_configuration || (bit == 0 && expected < part);
      answer(0x4F, 0);
    } else if (command == 0x04) {
      is_in_configuration = frame.data[1] == 1;
    } else if (is_in_configuration && command >= 0x5A && command <= 0x5D) {
      answer(command, identity[command - 0x5AU]);
    } else if (is_in_configuration && command == 0x11) {
      answer(command, 0);
    }
  }
  void answer(std::uint8_t command, std::uint32_t value) {
    Frame frame = {.id = 0x7E4, .length = 8, .data = {command}};
    store(frame.data.data() + 1, value);
    device.node().transmitter().send(frame);
  }

  Environment environment;
  CarDevice device;
  std::array<std::uint32_t, 4> identity = {0, 44719, 0, serial};
  unsigned expected = 0;
  bool is_in_configuration = false;
};

class Gateway : public testing::Test {
 protected:
  Gateway() {
    master.on_event(callback<&Gateway::happened>(*this));
    cable.connect(0, device.node());
  }
  void happened(const CarEvent& event) { events.push_back(event); }
  std::size_t count(CarEvent::Kind kind) const {
    return static_cast<std::size_t>(
        std::ranges::count(events, kind, [](const CarEvent& event) { return event.kind; }));
  }
  AddOn& add(unsigned serial) { return add_ons.emplace_back(cable, add_ons.size() + 1, serial); }
  static KnownDevices remembered() { return kept; }
  static void remember(const KnownDevices& known) { kept = known; }

  static inline KnownDevices kept;
  std::vector<CarEvent> events;
  Cable cable;
  Environment environment;
  CarDevice device{only_unit<BlueLightKind>, cable.port(0), 1, environment};
  CarMaster master{device.network(), device.sleep(), {}};
  std::deque<AddOn> add_ons;
};

TEST_F(Gateway, NamesAndStartsWhoHasNoNodeId) {
  AddOn& first = add(0x11);
  AddOn& second = add(0x22);
  cable.start_all();
  cable.run_for(10s);
  std::vector<NodeId> ids = {first.device.node().id(), second.device.node().id()};
  std::ranges::sort(ids);
  EXPECT_EQ(ids, (std::vector<NodeId>{2, 3}));
  EXPECT_EQ(cable.count(0x702) > 0, true);
  EXPECT_EQ(first.device.node().state(), NmtState::operational);
  EXPECT_EQ(second.device.node().state(), NmtState::operational);
  EXPECT_EQ(count(CarEvent::Kind::named), 2u);
  EXPECT_EQ(count(CarEvent::Kind::started), 2u);
}

TEST_F(Gateway, GivesTheSameNodeIdAgainAfterAPowerCut) {
  add(0x11);
  AddOn& second = add(0x22);
  cable.start_all();
  cable.run_for(10s);
  const NodeId before = second.device.node().id();
  cable.cut(2);
  cable.run_for(10s);
  EXPECT_EQ(count(CarEvent::Kind::lost), 1u);
  EXPECT_FALSE(master.is_present(before));
  AddOn& third = add(0x33);
  third.device.node().start(cable.now);
  cable.run_for(10s);
  EXPECT_EQ(third.device.node().id(), 4) << "the node-ID of who is away is kept for him";
  second.device.node().set_power_on_id(node_id_unconfigured);
  second.device.node().set_pending_id(node_id_unconfigured);
  second.device.node().start(cable.now);
  cable.cut(2, false);
  cable.run_for(10s);
  EXPECT_EQ(second.device.node().id(), before);
  EXPECT_EQ(second.device.node().state(), NmtState::operational);
}

/// A device that always answers would cause a hundred messages a second.
TEST_F(Gateway, WhoAnswersFastscanWithANodeIdNeitherFillsTheBusNorKeepsALostDeviceAway) {
  AddOn& mine = add(0x11);
  AnswersAlways other(cable, 7);
  cable.start_all();
  cable.run_for(30s);
  ASSERT_EQ(mine.device.node().id(), 2);
  ASSERT_EQ(mine.device.node().state(), NmtState::operational);
  cable.clear();
  cable.run_for(60s);
  EXPECT_LT(cable.count(0x7E5), 1000u);

  cable.cut(1);
  cable.run_for(10s);
  ASSERT_FALSE(master.is_present(2));
  mine.device.node().set_power_on_id(node_id_unconfigured);
  mine.device.node().set_pending_id(node_id_unconfigured);
  mine.device.node().start(cable.now);
  cable.cut(1, false);
  cable.run_for(3s);
  EXPECT_EQ(mine.device.node().id(), 2);
  EXPECT_EQ(mine.device.node().state(), NmtState::operational);
}

TEST_F(Gateway, KeepsNamesOverItsOwnRestart) {
  kept = {};
  Cable other;
  Environment at;
  const CarMemory memory = {
      .load = {[](void*) { return remembered(); }, nullptr},
      .store = {[](void*, const KnownDevices& known) { remember(known); }, nullptr}};
  LssAddress address;
  address.parts = {0, 44719, 0, 0x22};
  kept.addresses[5] = address;
  kept.is_known[5] = true;
  CarDevice gateway(only_unit<BlueLightKind>, other.port(0), 1, at);
  CarMaster reborn(gateway.network(), gateway.sleep(), memory);
  other.connect(0, gateway.node());
  AddOn known(other, 1, 0x22);
  AddOn stranger(other, 2, 0x33);
  other.start_all();
  other.run_for(10s);
  EXPECT_EQ(known.device.node().id(), 7);
  EXPECT_EQ(stranger.device.node().id(), 2);
  EXPECT_TRUE(kept.is_known[0]) << "and this one was stored";
}

TEST_F(Gateway, HasNodeIdsFor15) {
  for (unsigned i = 1; i <= 3; ++i) add(i);
  cable.start_all();
  for (unsigned node = 2; node <= 14; ++node) {
    char heartbeat[8];
    std::snprintf(heartbeat, sizeof heartbeat, "7%02X#05", node);
    cable.send(heartbeat);
  }
  cable.run_for(2900ms);
  std::vector<NodeId> ids;
  for (AddOn& one : add_ons) ids.push_back(one.device.node().id());
  std::ranges::sort(ids);
  EXPECT_EQ(ids, (std::vector<NodeId>{15, 16, node_id_unconfigured}));
  EXPECT_GT(count(CarEvent::Kind::refused), 0u);
}

TEST_F(Gateway, SendsTheNetworkToSleepWhereNobodyObjectsAndWakesItUp) {
  AddOn& one = add(0x11);
  cable.start_all();
  cable.run_for(10s);
  cable.clear();
  master.send_to_sleep();
  cable.run_for(0s);
  EXPECT_EQ(cable.last(0x691), "691#01 00 00 00 00 00 00 00");
  cable.run_for(999ms);
  EXPECT_EQ(cable.count(0x691), 1u);
  cable.run_for(1ms);
  EXPECT_EQ(cable.last(0x691), "691#02 00 00 00 00 00 00 00");
  cable.run_for(1s);
  cable.clear();
  cable.run_for(1h);
  EXPECT_TRUE(cable.heard.empty()) << "nothing is sent while all sleep";
  master.wake_up();
  cable.run_for(5s);
  EXPECT_EQ(cable.count(0x691), 2u);
  EXPECT_EQ(one.device.node().id(), 2);
  EXPECT_EQ(one.device.node().state(), NmtState::operational);
  EXPECT_EQ(count(CarEvent::Kind::asleep), 1u);
  EXPECT_EQ(count(CarEvent::Kind::awake), 1u);
}

TEST_F(Gateway, AnObjectionKeepsTheNetworkAwake) {
  AddOn& one = add(0x11);
  cable.start_all();
  cable.run_for(10s);
  one.device.sleep().object(0x33);
  master.send_to_sleep();
  cable.run_for(10s);
  ASSERT_EQ(count(CarEvent::Kind::objection), 1u);
  EXPECT_EQ(events.back().node, 2);
  EXPECT_EQ(events.back().reason, 0x33);
  EXPECT_EQ(device.sleep().state(), SleepState::awake);
}

TEST_F(Gateway, AWakeUpWhileItAsksForObjectionsKeepsTheNetworkAwake) {
  AddOn& one = add(0x11);
  cable.start_all();
  cable.run_for(10s);
  const std::function<void()> ways[] = {[&] { master.wake_up(); },
                                        [&] { one.device.sleep().wake_up(); }};
  for (const auto& wake_up : ways) {
    cable.clear();
    master.send_to_sleep();
    cable.run_for(500ms);
    wake_up();
    cable.run_for(10s);
    EXPECT_EQ(device.sleep().state(), SleepState::awake);
    EXPECT_EQ(one.device.sleep().state(), SleepState::awake);
    const auto is_order = [](const auto& heard) {
      return heard.frame.id == 0x691 && heard.frame.data[0] == 0x02;
    };
    EXPECT_TRUE(std::ranges::none_of(cable.heard, is_order));
  }
}

TEST_F(Gateway, ADeviceAsksForSleepAndAnotherWakesAllUp) {
  AddOn& one = add(0x11);
  AddOn& two = add(0x22);
  cable.start_all();
  cable.run_for(10s);
  one.device.sleep().request_sleep();
  cable.run_for(5s);
  EXPECT_EQ(device.sleep().state(), SleepState::asleep);
  EXPECT_EQ(two.device.sleep().state(), SleepState::asleep);
  two.device.sleep().wake_up();
  cable.run_for(5s);
  EXPECT_EQ(device.sleep().state(), SleepState::awake);
  EXPECT_EQ(one.device.node().state(), NmtState::operational);
  EXPECT_EQ(two.device.node().state(), NmtState::operational);
}

/// A network half asleep: one device has not received the order to sleep.
class HalfAsleep : public Gateway {
 protected:
  HalfAsleep() {
    cable.start_all();
    cable.run_for(10s);
    cable.cut(1);
    master.send_to_sleep();
    cable.run_for(30s);
    cable.cut(1, false);
    cable.clear();
  }
  AddOn& one = add(0x11);
  AddOn& two = add(0x22);
};

TEST_F(HalfAsleep, WhoHasNotHeardTheOrderIsAskedAndSentToSleep) {
  ASSERT_EQ(one.device.sleep().state(), SleepState::awake);
  ASSERT_EQ(two.device.sleep().state(), SleepState::asleep);
  cable.run_for(1s);
  EXPECT_EQ(cable.last(0x691), "691#01 00 00 00 00 00 00 00");
  cable.run_for(1s);
  EXPECT_EQ(cable.last(0x691), "691#02 00 00 00 00 00 00 00");
  cable.run_for(1s);
  EXPECT_EQ(one.device.sleep().state(), SleepState::asleep);
  cable.clear();
  cable.run_for(1h);
  EXPECT_TRUE(cable.heard.empty());
  EXPECT_EQ(count(CarEvent::Kind::awake), 0u);
}

TEST_F(HalfAsleep, WhoHasNotHeardTheQueryMayStillObjectAndAllAreWokenUp) {
  one.device.sleep().object(0x33);
  cable.run_for(10s);
  ASSERT_EQ(count(CarEvent::Kind::objection), 1u);
  EXPECT_EQ(device.sleep().state(), SleepState::awake);
  EXPECT_EQ(one.device.node().state(), NmtState::operational);
  EXPECT_EQ(two.device.node().state(), NmtState::operational);
}

/// A foreign device may not implement sleep.
TEST_F(HalfAsleep, WhoNeverSleepsIsAskedNowAndThen) {
  for (int second = 0; second < 60; ++second) {
    cable.send("709#05");
    cable.run_for(1s);
  }
  EXPECT_LE(cable.count(0x691), 12u) << "a query and an order each 10 s";
  EXPECT_EQ(two.device.sleep().state(), SleepState::asleep);
}

TEST_F(Gateway, ThatBootsWhileTheOthersSleepWakesThemUp) {
  AddOn& one = add(0x11);
  cable.start_all();
  cable.run_for(60s);
  EXPECT_EQ(cable.count(0x691), 0u) << "all are there";
  master.send_to_sleep();
  cable.run_for(10s);
  ASSERT_EQ(one.device.sleep().state(), SleepState::asleep);
  kept = master.known();
  const CarMemory memory = {.load = {[](void*) { return remembered(); }, nullptr}};
  CarDevice again(only_unit<BlueLightKind>, cable.port(0), 1, environment);
  CarMaster reborn(again.network(), again.sleep(), memory);
  cable.connect(0, again.node());
  cable.clear();
  again.node().start(cable.now);
  cable.run_for(10s);
  EXPECT_EQ(cable.last(0x691), "691#82 FE 00 00 00 00 00 00");
  cable.run_for(10s);
  EXPECT_EQ(cable.count(0x691), 2u);
  EXPECT_EQ(one.device.node().id(), 2);
  EXPECT_EQ(one.device.node().state(), NmtState::operational);
}

TEST_F(Gateway, ADeviceThatABusOffMadePreOperationalIsStartedAgain) {
  Node& node = add(0x11).device.node();
  cable.start_all();
  cable.run_for(10s);
  ASSERT_EQ(node.state(), NmtState::operational);
  node.bus_state(BusState::bus_off, cable.now);
  cable.run_for(20ms);
  node.bus_state(BusState::error_active, cable.now);
  EXPECT_EQ(node.state(), NmtState::pre_operational) << "1029h";
  cable.run_for(3s);
  EXPECT_EQ(node.state(), NmtState::operational);
}

TEST_F(Gateway, ADeviceThatAToolMadePreOperationalStaysSo) {
  Node& node = add(0x11).device.node();
  cable.start_all();
  cable.run_for(10s);
  cable.send("000#80 02");
  cable.run_for(60s);
  EXPECT_EQ(node.state(), NmtState::pre_operational);
  cable.send("000#01 00");
  cable.run_for(2s);
  node.bus_state(BusState::bus_off, cable.now);
  node.bus_state(BusState::error_active, cable.now);
  cable.run_for(3s);
  EXPECT_EQ(node.state(), NmtState::operational) << "it has been started since";
}

TEST_F(Gateway, WhoseQuestionItsOwnResetEndsTakesNobodyForAStranger) {
  cable.start_all();
  cable.run_for(1s);
  cable.send("705#00");
  cable.send("000#82 01");
  EXPECT_EQ(count(CarEvent::Kind::stranger), 0U);
}

/// CiA 401, no device of the car (1000h), answers the second request.
TEST_F(Gateway, AsksAgainWhatADeviceIsWhereItsOwnStateEndedTheQuestion) {
  const std::string question = "605#40 00 10 00 00 00 00 00";
  const std::function<void()> ends[] = {[&] {
                                          cable.send("000#02 01");
                                          cable.send("000#01 01");
                                        },
                                        [&] {
                                          device.node().bus_state(BusState::bus_off, cable.now);
                                          cable.run_for(2s);
                                          device.node().bus_state(BusState::error_active,
                                                                  cable.now);
                                        },
                                        [&] { cable.send("000#82 01"); }};
  cable.start_all();
  for (const auto& end : ends) {
    cable.run_for(5s);
    events.clear();
    cable.send("705#00");
    ASSERT_EQ(cable.last(0x605), question);
    cable.clear();
    end();
    cable.send("705#05");
    EXPECT_EQ(cable.last(0x605), question);
    EXPECT_EQ(count(CarEvent::Kind::stranger), 0U);
    cable.send("585#43 00 10 00 91 01 00 00");
    EXPECT_EQ(count(CarEvent::Kind::stranger), 1U);
    cable.clear();
    cable.send("705#05");
    EXPECT_EQ(cable.count(0x605), 0U) << "now it is known";
  }
}

TEST_F(Gateway, AsksWhatADeviceIsThatBootedWhileItCouldNotAsk) {
  cable.start_all();
  cable.run_for(5s);
  cable.send("000#02 01");
  cable.send("705#00");
  EXPECT_EQ(cable.count(0x605), 0U);
  cable.send("000#01 01");
  cable.send("705#05");
  EXPECT_EQ(cable.last(0x605), "605#40 00 10 00 00 00 00 00");
}

/// A cable that is cut behind the gateway leaves its queue full: the port takes nothing.
TEST_F(Gateway, ADeviceThatBootsWhileNothingCanBeSentIsStartedLater) {
  cable.start_all();
  cable.run_for(5s);
  cable.refuse(0);
  Node& node = device.node();
  while (node.transmitter().send(Frame::data_frame(0x7F0, {}))) {
  }
  node.receive(wire_frame("703#00"), cable.now);
  EXPECT_EQ(count(CarEvent::Kind::started), 0U);
  cable.refuse(0, false);
  node.tx_ready(cable.now);
  cable.run_for(1s);
  cable.clear();
  cable.send("703#7F");
  EXPECT_EQ(cable.last(0), "000#01 03");
  EXPECT_EQ(count(CarEvent::Kind::started), 1U);
}

}  // namespace
}  // namespace canvoy::cia447::car_master_test
