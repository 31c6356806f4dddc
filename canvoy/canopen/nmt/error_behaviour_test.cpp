#include "canvoy/canopen/nmt/error_behaviour.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/emergency/emergency_producer.hpp"
#include "canvoy/canopen/nmt/heartbeat_consumer.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::error_behaviour_test {
namespace {

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>({{.index = 0x1014, .entry_count = 1},
                              {.index = 0x1016, .entry_count = 2},
                              {.index = 0x1029, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.type = DataType::unsigned32, .initial = 0x85},
         {.access = Access::const_, .initial = 1},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .initial = 0x000A'0064},
         {.access = Access::const_, .initial = 3},
         {.sub_first = 1, .sub_last = 3, .access = Access::rw}}));

constexpr auto layout_without =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

constexpr NmtState pre_operational = NmtState::pre_operational;
constexpr NmtState operational = NmtState::operational;
constexpr NmtState stopped = NmtState::stopped;

struct BehavingNode : WireNode {
  explicit BehavingNode(const DictionaryTables& tables = layout.tables())
      : WireNode(tables, 5),
        emergency_producer(node, present, waiting),
        heartbeat_consumer(node, slots),
        behaviour(node) {
    boot();
  }
  AbortCode write(std::uint8_t sub, std::uint8_t value) {
    return node.dictionary().write(0x1029, sub, {&value, 1}, Source::sdo);
  }
  void enter(NmtState state) {
    const NmtCommand command = state == operational ? NmtCommand::start
                               : state == stopped   ? NmtCommand::stop
                                                    : NmtCommand::enter_pre_operational;
    node.command(command);
  }

  Error present[4];
  Emergency waiting[4];
  HeartbeatConsumer::Slot slots[1];
  EmergencyProducer emergency_producer;
  HeartbeatConsumer heartbeat_consumer;
  ErrorBehaviour behaviour;
};

struct Case {
  std::uint8_t value;
  NmtState before;
  NmtState after;
};
constexpr Case cases[] = {
    {0, pre_operational, pre_operational}, {0, operational, pre_operational}, {0, stopped, stopped},
    {1, pre_operational, pre_operational}, {1, operational, operational},     {1, stopped, stopped},
    {2, pre_operational, stopped},         {2, operational, stopped},         {2, stopped, stopped},
};

TEST(ErrorBehaviour, FollowsSubIndex1WhenAHeartbeatIsLost) {
  for (const Case& c : cases) {
    BehavingNode sut;
    ASSERT_EQ(sut.write(1, c.value), AbortCode::none);
    sut.enter(c.before);
    sut.receive("70A#05");
    EXPECT_EQ(sut.node.state(), c.before);
    sut.run_for(100ms);
    EXPECT_EQ(sut.node.state(), c.after) << int{c.value};
  }
}

TEST(ErrorBehaviour, FollowsSubIndex1InBusOff) {
  for (const Case& c : cases) {
    BehavingNode sut;
    ASSERT_EQ(sut.write(1, c.value), AbortCode::none);
    sut.enter(c.before);
    for (const BusState state : {BusState::error_warning, BusState::error_passive}) {
      sut.node.bus_state(state, sut.now);
      EXPECT_EQ(sut.node.state(), c.before);
    }
    sut.node.bus_state(BusState::bus_off, sut.now);
    EXPECT_EQ(sut.node.state(), c.after) << int{c.value};
    sut.node.bus_state(BusState::error_active, sut.now);
    EXPECT_EQ(sut.node.state(), c.after) << int{c.value};
  }
}

TEST(ErrorBehaviour, FollowsTheSubIndexOfAFailureOfTheDevice) {
  for (std::uint8_t sub = 1; sub <= 3; ++sub) {
    for (const Case& c : cases) {
      BehavingNode sut;
      for (std::uint8_t other = 1; other <= 3; ++other) sut.write(other, c.value == 1 ? 2 : 1);
      ASSERT_EQ(sut.write(sub, c.value), AbortCode::none);
      sut.enter(c.before);
      sut.behaviour.device_failure(sub);
      EXPECT_EQ(sut.node.state(), c.after) << int{c.value};
    }
  }
}

TEST(ErrorBehaviour, LeavesOperationalWhere1029hOrItsSubIndexIsAbsent) {
  BehavingNode without(layout_without.tables());
  without.enter(operational);
  without.node.bus_state(BusState::bus_off, without.now);
  EXPECT_EQ(without.node.state(), pre_operational);

  BehavingNode sut;
  for (std::uint8_t sub = 1; sub <= 3; ++sub) sut.write(sub, 2);
  sut.enter(operational);
  sut.behaviour.device_failure(4);
  EXPECT_EQ(sut.node.state(), pre_operational);
}

TEST(ErrorBehaviour, DoesNotMindOtherErrorsNorTheEndOfOne) {
  BehavingNode sut;
  sut.enter(operational);
  sut.node.raise({.code = 0x8250, .register_bits = error_register::communication});
  sut.node.raise({.code = 0x4210});
  sut.node.overrun(sut.now);
  sut.node.clear({.code = 0x8130, .instance = 10});
  EXPECT_EQ(sut.node.state(), operational);
}

TEST(ErrorBehaviour, TellsTheEmergencyBeforeItStopsTheNode) {
  BehavingNode sut;
  ASSERT_EQ(sut.write(1, 2), AbortCode::none);
  sut.enter(operational);
  sut.receive("70A#05");
  sut.run_for(100ms);
  EXPECT_EQ(sut.node.state(), stopped);
  sut.expect({"@100000 085#30 81 11 0A 00 00 00 00"});
}

TEST(ErrorBehaviour, DoesNotReturnToOperationalByItself) {
  BehavingNode sut;
  sut.enter(operational);
  sut.receive("70A#05");
  sut.run_for(100ms);
  sut.receive("70A#05");
  EXPECT_EQ(sut.node.state(), pre_operational);
}

TEST(ErrorBehaviour, Takes0To2AndRefusesAllOtherValues) {
  BehavingNode sut;
  for (unsigned value = 0; value < 256; ++value) {
    for (std::uint8_t sub = 1; sub <= 3; ++sub) {
      EXPECT_EQ(sut.write(sub, static_cast<std::uint8_t>(value)),
                value <= 2 ? AbortCode::none : AbortCode::value_range)
          << value;
    }
  }
  EXPECT_EQ(sut.write(0, 1), AbortCode::read_only);
  EXPECT_EQ(sut.write(4, 1), AbortCode::no_sub_index);
}

}  // namespace
}  // namespace canvoy::error_behaviour_test
