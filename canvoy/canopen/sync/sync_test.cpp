#include "canvoy/canopen/sync/sync.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::sync_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

/// Records each SYNC with its time and counter.
struct Listener : SyncListener {
  explicit Listener(PdoNode& owner) : node(owner) {
    received = callback<&Listener::note>(*this);
    node.sync.attach(*this);
  }
  void note(std::uint8_t counter) {
    heard.push_back("@" + std::to_string(node.now.time_since_epoch().count()) + " " +
                    std::to_string(counter));
  }
  Texts take() { return std::exchange(heard, {}); }

  PdoNode& node;
  Texts heard;
};

TEST(Sync, IsHeardInPreOperationalAndOperational) {
  PdoNode node;
  Listener listener(node);
  node.receive("080#");
  EXPECT_EQ(listener.take(), Texts({"@0 0"})) << "pre-operational";
  node.operate();
  node.receive("080#");
  EXPECT_EQ(listener.take(), Texts({"@0 0"})) << "operational";
  node.receive("000#02 00");
  node.receive("080#");
  EXPECT_EQ(listener.take(), Texts()) << "stopped";
}

TEST(Sync, IsHeardOnEveryCanIdThatIsNotRestricted) {
  PdoNode node;
  Listener listener(node);
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    const bool free = is_free(can_id);
    ASSERT_EQ(node.write(0x1005, 0, can_id), free ? none : value_range) << can_id;
    if (!free) continue;
    node.node.receive(Frame::data_frame(can_id, {}), node.now);
    ASSERT_EQ(listener.take().size(), 1U) << can_id;
    if (can_id == 0x080) continue;
    node.receive("080#");
    ASSERT_EQ(listener.take().size(), 0U) << can_id;
  }
}

TEST(Sync, With29BitsIsRefusedAndBit31MeansNothing) {
  PdoNode node;
  Listener listener(node);
  for (unsigned bit = 11; bit <= 29; ++bit) {
    EXPECT_EQ(node.write(0x1005, 0, 0x80U | 1U << bit), value_range) << bit;
  }
  EXPECT_EQ(node.write(0x1005, 0, 0x8000'0081), none);
  node.receive("081#");
  EXPECT_EQ(listener.take().size(), 1U);
}

TEST(Sync, IsProducedEachPeriodFromOnePeriodAfterItsStart) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1006, 0, 10'000), none);
  node.run_until(Time(50ms));
  node.expect({});
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(85ms));
  node.expect({"@60000 080#", "@70000 080#", "@80000 080#"});
  ASSERT_EQ(node.write(0x1005, 0, 0x80), none);
  node.run_until(Time(1s));
  node.expect({});
}

TEST(Sync, IsProducedWhenThePeriodIsSetLast) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(50ms));
  ASSERT_EQ(node.write(0x1006, 0, 1'500), none);
  node.run_until(Time(53ms));
  node.expect({"@51500 080#", "@53000 080#"});
  ASSERT_EQ(node.write(0x1006, 0, 0), none);
  node.run_until(Time(1s));
  node.expect({});
}

TEST(Sync, HasTheNewPeriodFromNowOn) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1006, 0, 100'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(150ms));
  ASSERT_EQ(node.write(0x1006, 0, 20'000), none);
  node.run_until(Time(155ms));
  ASSERT_EQ(node.write(0x1006, 0, 20'000), none);
  node.run_until(Time(200ms));
  node.expect({"@100000 080#", "@170000 080#", "@190000 080#"});
}

TEST(Sync, KeepsItsCanIdWhileItIsProduced) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  for (unsigned can_id = 0; can_id <= 0x7FF; ++can_id) {
    EXPECT_EQ(node.write(0x1005, 0, 0x4000'0000U | can_id), can_id == 0x80 ? none : value_range);
  }
  EXPECT_EQ(node.write(0x1005, 0, 0x81), none) << "together with bit 30 it may change";
  EXPECT_EQ(node.write(0x1005, 0, 0x4000'0082), none);
}

TEST(Sync, CountsFrom1ToTheOverflowValue) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 3), none);
  ASSERT_EQ(node.write(0x1006, 0, 1'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(5ms));
  node.expect({"080#01", "080#02", "080#03", "080#01", "080#02"});
}

TEST(Sync, CountsFrom1AgainWhenProductionStartsAgain) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 240), none);
  ASSERT_EQ(node.write(0x1006, 0, 1'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(2ms));
  node.expect({"080#01", "080#02"});
  ASSERT_EQ(node.write(0x1005, 0, 0x80), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(4ms));
  node.expect({"@3000 080#01", "@4000 080#02"});
}

TEST(Sync, CountsOnFromPreOperationalToOperationalButFrom1AfterStopped) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 240), none);
  ASSERT_EQ(node.write(0x1006, 0, 1'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.run_until(Time(2ms));
  node.operate();
  node.run_until(Time(3ms));
  node.expect({"080#01", "080#02", "080#03"});
  node.receive("000#02 00");
  node.run_until(Time(10ms));
  node.expect({});
  node.operate();
  node.run_until(Time(12ms));
  node.expect({"@11000 080#01", "@12000 080#02"});
}

TEST(Sync, HasTheOverflowValuesThatAreNotReserved) {
  PdoNode node;
  for (unsigned value = 0; value <= 255; ++value) {
    const bool known = value == 0 || (value >= 2 && value <= 240);
    EXPECT_EQ(node.write(0x1019, 0, value), known ? none : value_range) << value;
  }
}

TEST(Sync, ChangesItsOverflowValueOnlyWhileThePeriodIs0) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1019, 0, 7), none);
  ASSERT_EQ(node.write(0x1006, 0, 1'000), none);
  for (unsigned value = 0; value <= 240; ++value) {
    if (value == 1) continue;
    EXPECT_EQ(node.write(0x1019, 0, value), value == 7 ? none : device_state) << value;
  }
  ASSERT_EQ(node.write(0x1006, 0, 0), none);
  EXPECT_EQ(node.write(0x1019, 0, 8), none);
}

TEST(Sync, OfAnotherLengthIsIgnoredAndAnErrorUntilAGoodOneComes) {
  for (const bool counts : {false, true}) {
    PdoNode node;
    Listener listener(node);
    ASSERT_EQ(node.write(0x1019, 0, counts ? 10 : 0), none);
    const std::string good = counts ? "080#05" : "080#";
    const std::string bad = counts ? "080#" : "080#05";
    node.receive(good);
    EXPECT_EQ(listener.take(), Texts({counts ? "@0 5" : "@0 0"}));
    EXPECT_EQ(node.errors(), Texts());
    node.receive(bad);
    node.receive("080#01 02");
    node.receive("080#01 02 03 04 05 06 07 08");
    EXPECT_EQ(listener.take(), Texts());
    EXPECT_EQ(node.errors(), Texts({"+8240/0"}));
    EXPECT_EQ(node.node.counters().malformed, 3U);
    node.receive(good);
    EXPECT_EQ(listener.take().size(), 1U);
    EXPECT_EQ(node.errors(), Texts({"-8240/0"}));
  }
}

TEST(Sync, RaisesItsErrorAgainAfterAReset) {
  PdoNode node;
  for (int i = 0; i < 2; ++i) {
    node.receive("080#01");
    EXPECT_EQ(node.errors(), Texts({"+8240/0"}));
    node.receive("000#82 00");
  }
}

TEST(Sync, IsNoRemoteFrame) {
  PdoNode node;
  Listener listener(node);
  node.receive("080#R");
  EXPECT_EQ(listener.take(), Texts());
  EXPECT_EQ(node.errors(), Texts());
}

TEST(Sync, ProducedDrivesTheOwnPdosToo) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.map_tpdo(1, 0x185, 2, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1006, 0, 10'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.operate();
  node.receive("205#34 12");
  node.run_until(Time(45ms));
  node.expect({"@10000 080#", "@20000 080#", "@20000 185#34 12", "@30000 080#", "@40000 080#",
               "@40000 185#34 12"});
}

TEST(Sync, IsAppliedToRpdosThenToTheApplicationThenToTpdos) {
  PdoNode node;
  struct Doubler : SyncListener {
    explicit Doubler(PdoNode& owner) : node(owner) {
      received = callback<&Doubler::compute>(*this);
      node.sync.attach(*this);
    }
    void compute(std::uint8_t) {
      node.node.dictionary().set_number(0x2010, 2, 2 * node.number(0x2010, 1));
    }
    PdoNode& node;
  } doubler(node);
  node.map_rpdo(1, 0x205, 1, {0x2010'01'10});
  node.map_tpdo(1, 0x185, 1, {0x2010'02'10});
  node.operate();
  node.receive("205#21 00");
  node.receive("080#");
  node.expect({"185#42 00"});
}

TEST(Sync, ThatNobodyHadTimeForIsLeftOut) {
  PdoNode node;
  ASSERT_EQ(node.write(0x1006, 0, 10'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0080), none);
  node.now = Time(57ms);
  node.settle();
  node.expect({"@57000 080#"});
  node.run_until(Time(70ms));
  node.expect({"@60000 080#", "@70000 080#"});
}

TEST(Sync, OfABusOffIsNotSentAfterIt) {
  PdoNode node;
  node.write(0x1005, 0, 0x4000'0080);
  node.write(0x1006, 0, 10'000);
  node.full = true;
  node.node.bus_state(BusState::bus_off, node.now);
  node.run_until(Time(1s + 5ms));
  node.full = false;
  node.node.bus_state(BusState::error_active, node.now);
  node.expect({});
  node.run_until(Time(1s + 20ms));
  node.expect({"@1010000 080#", "@1020000 080#"});
}

TEST(Sync, HasItsDefaultsAgainAfterAReset) {
  PdoNode node;
  Listener listener(node);
  ASSERT_EQ(node.write(0x1006, 0, 10'000), none);
  ASSERT_EQ(node.write(0x1005, 0, 0x4000'0081), none);
  node.receive("000#82 00");
  node.expect({"705#00"});
  node.run_until(Time(1s));
  node.expect({});
  node.receive("081#");
  EXPECT_EQ(listener.take().size(), 0U);
  node.receive("080#");
  EXPECT_EQ(listener.take().size(), 1U);
}

TEST(Sync, WithoutItsObjectsIsHeardOn080) {
  constexpr static auto layout =
      lay_out(std::to_array<ObjectRow>({{.index = 0x2000, .entry_count = 1}}),
              std::to_array<EntryRow>({{.type = DataType::unsigned8}}));
  constexpr static DictionaryTables tables = layout.tables();
  WireNode wire(tables, 5);
  Sync sync(wire.node);
  int heard = 0;
  auto count = [&](std::uint8_t) { ++heard; };
  SyncListener listener;
  listener.received = Callback<void(std::uint8_t)>::of(count);
  sync.attach(listener);
  wire.boot();
  wire.receive("080#");
  EXPECT_EQ(heard, 1);
  wire.run_until(Time(10s));
  wire.expect({});
}

constexpr auto sync_of_29_bits =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1005, .entry_count = 1}}),
            std::to_array<EntryRow>({parameter(0, DataType::unsigned32, 0x2000'0080)}));
constexpr auto sync_restricted =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1005, .entry_count = 1}}),
            std::to_array<EntryRow>({parameter(0, DataType::unsigned32, 0x601)}));

/// A data sheet may say what 1005h would refuse (CiA 301, 7.3.5: 601h is of SDO).
TEST(Sync, OnADefaultThatIsRestrictedOrHas29BitsIsNotHeard) {
  for (const DictionaryTables& tables : {sync_of_29_bits.tables(), sync_restricted.tables()}) {
    WireNode node(tables, 5);
    Sync sync(node.node);
    unsigned heard = 0;
    auto count = [&heard](std::uint8_t) { ++heard; };
    SyncListener listener;
    listener.received = decltype(listener.received)::of(count);
    sync.attach(listener);
    node.boot_operational();
    node.receive("080#");
    node.receive("601#");
    node.receive("00000080#");
    EXPECT_EQ(heard, 0u);
  }
}

TEST(Sync, IsToldToEachOfItsListeners) {
  PdoNode node;
  Listener one(node);
  Listener other(node);
  Listener third(node);
  node.receive("080#");
  for (Listener* each : {&one, &other, &third}) EXPECT_EQ(each->take(), Texts({"@0 0"}));
}

}  // namespace
}  // namespace canvoy::sync_test
