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

TEST(HeartbeatProducer, counts_the_boot_up_message_as_the_first_heartbeat) {
  ProducingNode sut;
  sut.now = Time(300ms);
  sut.start();
  sut.run_until(Time(3300ms));
  sut.expect({"@300000 705#00", "@1300000 705#7F", "@2300000 705#7F", "@3300000 705#7F"});
}

TEST(HeartbeatProducer, tells_the_nmt_state_of_the_moment_also_when_stopped) {
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

TEST(HeartbeatProducer, tells_operational_after_an_autostart) {
  ProducingNode sut(layout.tables(), 127, true);
  sut.start();
  sut.run_until(Time(1000ms));
  sut.expect({"@0 77F#00", "@1000000 77F#05"});
}

TEST(HeartbeatProducer, sends_nothing_while_the_time_is_0) {
  ProducingNode sut(layout_off.tables());
  sut.boot();
  EXPECT_EQ(sut.node.deadline(), never);
  sut.run_until(Time(24h));
  sut.expect({});
}

TEST(HeartbeatProducer, sends_nothing_without_1017h) {
  ProducingNode sut(layout_without.tables());
  sut.boot();
  sut.run_until(Time(24h));
  sut.expect({});
}

TEST(HeartbeatProducer, begins_at_once_when_the_time_is_set) {
  ProducingNode sut(layout_off.tables());
  sut.boot();
  sut.run_until(Time(123ms));
  EXPECT_EQ(sut.write_period(200), AbortCode::none);
  sut.run_until(Time(600ms));
  sut.expect({"@123000 705#7F", "@323000 705#7F", "@523000 705#7F"});
}

TEST(HeartbeatProducer, starts_anew_when_the_time_is_changed) {
  ProducingNode sut;
  sut.boot();
  sut.run_until(Time(900ms));
  EXPECT_EQ(sut.write_period(300), AbortCode::none);
  sut.run_until(Time(1600ms));
  sut.expect({"@900000 705#7F", "@1200000 705#7F", "@1500000 705#7F"});
}

TEST(HeartbeatProducer, counts_from_the_boot_up_message_when_the_time_is_set_during_a_reset) {
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

TEST(HeartbeatProducer, ends_when_the_time_is_set_to_0) {
  ProducingNode sut;
  sut.boot();
  EXPECT_EQ(sut.write_period(0), AbortCode::none);
  sut.run_until(Time(1h));
  sut.expect({});
}

TEST(HeartbeatProducer, serves_the_shortest_and_the_longest_time) {
  ProducingNode sut;
  sut.boot();
  EXPECT_EQ(sut.write_period(1), AbortCode::none);
  sut.run_until(Time(2ms));
  sut.expect({"@0 705#7F", "@1000 705#7F", "@2000 705#7F"});
  EXPECT_EQ(sut.write_period(65535), AbortCode::none);
  sut.run_until(Time(70s));
  sut.expect({"@2000 705#7F", "@65537000 705#7F"});
}

TEST(HeartbeatProducer, returns_to_its_default_time_by_a_reset_of_communication) {
  ProducingNode sut;
  sut.boot();
  sut.write_period(50);
  sut.sent.clear();
  sut.run_until(Time(20ms));
  sut.receive("000#82 00");
  sut.run_until(Time(1020ms));
  sut.expect({"@20000 705#00", "@1020000 705#7F"});
}

TEST(HeartbeatProducer, keeps_its_rhythm_when_it_is_called_late) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(1400ms);
  sut.settle();
  sut.run_until(Time(3000ms));
  sut.expect({"@1400000 705#7F", "@2000000 705#7F", "@3000000 705#7F"});
}

TEST(HeartbeatProducer, does_not_catch_up_on_periods_that_were_slept_through) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(5600ms);
  sut.settle();
  sut.run_until(Time(7000ms));
  sut.expect({"@5600000 705#7F", "@6600000 705#7F"});
}

TEST(HeartbeatProducer, that_is_late_by_exactly_one_period_sends_one_and_waits_for_another) {
  ProducingNode sut;
  sut.boot();
  sut.now = Time(2000ms);
  sut.settle();
  sut.expect({"@2000000 705#7F"});
  sut.run_until(Time(4000ms));
  sut.expect({"@3000000 705#7F", "@4000000 705#7F"});
}

TEST(HeartbeatProducer, is_silent_without_a_node_id) {
  ProducingNode sut(layout.tables(), node_id_unconfigured);
  sut.start();
  sut.run_until(Time(10s));
  EXPECT_EQ(sut.write_period(100), AbortCode::none);
  sut.run_until(Time(20s));
  sut.expect({});
}

}  // namespace
}  // namespace canvoy::heartbeat_producer_test
