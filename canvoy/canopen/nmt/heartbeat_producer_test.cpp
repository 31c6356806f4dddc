#include "canvoy/canopen/nmt/heartbeat_producer.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::heartbeat_producer_test {
namespace {

constexpr auto layout =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1017, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.type = DataType::unsigned16, .access = Access::rw, .initial = 1000}}));

constexpr auto layout_off =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1017, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned16, .access = Access::rw}}));

constexpr auto layout_without =
    lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1}}),
            std::to_array<EntryRow>({{.type = DataType::unsigned32}}));

struct ProducingNode : WireNode {
  explicit ProducingNode(const DictionaryTables& tables = layout.tables(), NodeId id = 5,
                         bool autostart = false)
      : WireNode(tables, id, autostart), producer(node) {}

  AbortCode write_period(std::uint16_t milliseconds) {
    std::uint8_t bytes[2];
    store(bytes, milliseconds);
    node.advance(now);
    const AbortCode answer = node.dictionary().write(0x1017, 0, bytes, Source::sdo);
    settle();
    return answer;
  }

  HeartbeatProducer producer;
};

TEST(HeartbeatProducer, CountsTheBootUpMessageAsTheFirstHeartbeat) {
  ProducingNode sut;
  sut.now = Time(300ms);
  sut.start();
  sut.run_until(Time(3300ms));
  sut.expect({"@300000 705#00", "@1300000 705#7F", "@2300000 705#7F", "@3300000 705#7F"});
}

TEST(HeartbeatProducer, TellsNothingAfterABusOffOfWhatWasMeanwhile) {
  ProducingNode sut;
  sut.boot();
  sut.full = true;
  sut.node.bus_state(BusState::bus_off, sut.now);
  sut.run_until(Time(3500ms));
  sut.full = false;
  sut.node.bus_state(BusState::error_active, sut.now);
  sut.node.tx_ready(sut.now);
  sut.expect({});
  sut.run_until(Time(4s));
  sut.expect({"@4000000 705#7F"});
}

TEST(HeartbeatProducer, TellsTheNmtStateOfTheMomentAlsoWhenStopped) {
  ProducingNode sut;
  sut.boot();
  sut.run_until(Time(1000ms));
  sut.receive("000#01 05");
  sut.run_until(Time(2000ms));
  sut.receive("000#02 05");
  sut.run_until(Time(3000ms));
  sut.receive("000#80 05");
  sut.run_until(Time(4000ms));
  sut.expect({"@1000000 705#7F", "@2000000 705#05", "@3000000 705#04", "@4000000 705#7F"});
}

TEST(HeartbeatProducer, TellsOperationalAfterAnAutostart) {
  ProducingNode sut(layout.tables(), 127, true);
  sut.start();
  sut.run_until(Time(1000ms));
  sut.expect({"@0 77F#00", "@1000000 77F#05"});
}

TEST(HeartbeatProducer, SendsNothingWhileTheTimeIs0) {
  ProducingNode sut(layout_off.tables());
  sut.boot();
  EXPECT_EQ(sut.node.deadline(), never);
  sut.run_until(Time(24h));
  sut.expect({});
}

TEST(HeartbeatProducer, SendsNothingWithout1017h) {
  ProducingNode sut(layout_without.tables());
  sut.boot();
  sut.run_until(Time(24h));
  sut.expect({});
}

TEST(HeartbeatProducer, BeginsAtOnceWhenTheTimeIsSet) {
  ProducingNode sut(layout_off.tables());
  sut.boot();
  sut.run_until(Time(123ms));
  EXPECT_EQ(sut.write_period(200), AbortCode::none);
  sut.run_until(Time(600ms));
  sut.expect({"@123000 705#7F", "@323000 705#7F", "@523000 705#7F"});
}

TEST(HeartbeatProducer, StartsAnewWhenTheTimeIsChanged) {
  ProducingNode sut;
  sut.boot();
  sut.run_until(Time(900ms));
  EXPECT_EQ(sut.write_period(300), AbortCode::none);
  sut.run_until(Time(1600ms));
  sut.expect({"@900000 705#7F", "@1200000 705#7F", "@1500000 705#7F"});
}

TEST(HeartbeatProducer, CountsFromTheBootUpMessageWhenTheTimeIsSetDuringAReset) {
  ProducingNode sut(layout_off.tables());
  auto set = [&](ResetScope) {
    const std::uint8_t milliseconds[] = {200, 0};
    EXPECT_EQ(sut.node.dictionary().write(0x1017, 0, milliseconds, Source::application),
              AbortCode::none);
  };
  Service application;
  application.reset = Callback<void(ResetScope)>::of(set);
  sut.node.attach(application);
  sut.start();
  sut.run_until(Time(400ms));
  sut.expect({"@0 705#00", "@200000 705#7F", "@400000 705#7F"});
}

TEST(HeartbeatProducer, EndsWhenTheTimeIsSetTo0) {
  ProducingNode sut;
  sut.boot();
  EXPECT_EQ(sut.write_period(0), AbortCode::none);
  sut.run_until(Time(1h));
  sut.expect({});
}

TEST(HeartbeatProducer, ServesTheShortestAndTheLongestTime) {
  ProducingNode sut;
  sut.boot();
  EXPECT_EQ(sut.write_period(1), AbortCode::none);
  sut.run_until(Time(2ms));
  sut.expect({"@0 705#7F", "@1000 705#7F", "@2000 705#7F"});
  EXPECT_EQ(sut.write_period(65535), AbortCode::none);
  sut.run_until(Time(70s));
  sut.expect({"@2000 705#7F", "@65537000 705#7F"});
}

TEST(HeartbeatProducer, ReturnsToItsDefaultTimeByAResetOfCommunication) {
  ProducingNode sut;
  sut.boot();
  sut.write_period(50);
  sut.sent.clear();
  sut.run_until(Time(20ms));
  sut.receive("000#82 00");
  sut.run_until(Time(1020ms));
  sut.expect({"@20000 705#00", "@1020000 705#7F"});
}

TEST(HeartbeatProducer, KeepsItsRhythmWhenItIsCalledLate) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(1400ms);
  sut.settle();
  sut.run_until(Time(3000ms));
  sut.expect({"@1400000 705#7F", "@2000000 705#7F", "@3000000 705#7F"});
}

TEST(HeartbeatProducer, DoesNotCatchUpOnPeriodsThatWereSleptThrough) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(5600ms);
  sut.settle();
  sut.run_until(Time(7000ms));
  sut.expect({"@5600000 705#7F", "@6600000 705#7F"});
}

TEST(HeartbeatProducer, ThatIsLateByExactlyOnePeriodSendsOneAndWaitsForAnother) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(2000ms);
  sut.settle();
  sut.expect({"@2000000 705#7F"});
  sut.run_until(Time(4000ms));
  sut.expect({"@3000000 705#7F", "@4000000 705#7F"});
}

TEST(HeartbeatProducer, IsSilentWithoutANodeId) {
  ProducingNode sut(layout.tables(), node_id_unconfigured);
  sut.start();
  sut.run_until(Time(10s));
  EXPECT_EQ(sut.write_period(100), AbortCode::none);
  sut.run_until(Time(20s));
  sut.expect({});
}

}  // namespace
}  // namespace canvoy::heartbeat_producer_test
