// Every transmission type with and without its timers, in one scenario each: the expected frames
// follow from the meaning of the types (CiA 301, 7.5.2.35 and 7.5.2.37).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::pdo_types_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

struct Settings {
  unsigned type;
  bool inhibit_time;  ///< of 10 ms
  bool event_timer;   ///< of 20 ms
  bool remote;        ///< may be requested
};

/// Times in ms, and the frames sent then. The scenario: values at 5 and 8 ms, SYNC at 10, 20 and 30
/// ms, a remote frame at 33 ms, the end at 60 ms.
Texts expected(const Settings& s) {
  Texts sent;
  const auto add = [&](unsigned ms, unsigned value) {
    sent.push_back("@" + std::to_string(ms * 1000) + " 185#0" + std::to_string(value) + " 00");
  };
  if (s.type >= 254) {
    add(5, 1);
    add(s.inhibit_time ? 15 : 8, 2);
    if (s.event_timer && !s.inhibit_time) add(28, 2);
    if (s.remote) add(33, 2);
    if (s.event_timer && s.remote) add(53, 2);
    if (s.event_timer && !s.remote && s.inhibit_time) add(35, 2);
    if (s.event_timer && !s.remote) add(s.inhibit_time ? 55 : 48, 2);
    return sent;
  }
  if (s.type == 0) add(10, 2);
  for (unsigned sync = 1; sync <= 3; ++sync) {
    if (s.type != 0 && s.type <= 240 && sync % s.type == 0) add(sync * 10, 2);
  }
  if (s.remote) add(33, 2);
  return sent;
}

void run_world(PdoNode& node) {
  const auto at = [&](Duration time) { node.run_until(Time(time)); };
  node.operate();
  at(5ms);
  node.set(0x2010, 1, 1);
  at(8ms);
  node.set(0x2010, 1, 2);
  for (const Duration time : {10ms, 20ms, 30ms}) {
    at(time);
    node.receive("080#");
  }
  at(33ms);
  node.receive("185#R2");
  at(60ms);
}

TEST(TransmissionType, OfATpdoSaysWhenItIsSent) {
  for (unsigned i = 0; i < 256 * 8; ++i) {
    const Settings s{i / 8, (i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
    if (s.type > 240 && s.type < 252) continue;
    SCOPED_TRACE(testing::Message()
                 << "type " << s.type << ", inhibit time " << s.inhibit_time << ", event timer "
                 << s.event_timer << ", remote " << s.remote);
    PdoNode node;
    ASSERT_EQ(node.write(0x1800, 3, s.inhibit_time ? 100 : 0), none);
    ASSERT_EQ(node.write(0x1800, 5, s.event_timer ? 20 : 0), none);
    node.map_tpdo(1, s.remote ? 0x185 : 0x4000'0185, s.type, {0x2010'01'10});
    run_world(node);
    node.expect(expected(s));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TransmissionType, OfATpdoThatIsReservedIsRefusedAndLeavesTheOldOne) {
  for (unsigned type = 241; type <= 251; ++type) {
    PdoNode node;
    node.map_tpdo(1, 0x185, 1, {0x2010'01'10});
    EXPECT_EQ(node.write(0x1800, 2, type), value_range);
    EXPECT_EQ(node.number(0x1800, 2), 1U);
    node.operate();
    node.receive("080#");
    node.expect({"185#00 00"});
  }
}

/// A reception at 5 ms, SYNC at 10 ms; a deadline of 20 ms is missed at 25 ms.
TEST(TransmissionType, OfAnRpdoSaysWhenItIsTakenAndNotWhenItIsLate) {
  for (unsigned i = 0; i < 256 * 2; ++i) {
    const unsigned type = i / 2;
    const bool deadline = i % 2 != 0;
    if (type > 240 && type < 254) continue;
    SCOPED_TRACE(testing::Message() << "type " << type << ", deadline " << deadline);
    PdoNode node;
    ASSERT_EQ(node.write(0x1400, 5, deadline ? 20 : 0), none);
    node.map_rpdo(1, 0x205, type, {0x2010'01'10});
    node.operate();
    node.run_until(Time(5ms));
    node.receive("205#34 12");
    ASSERT_EQ(node.number(0x2010, 1), type <= 240 ? 0U : 0x1234U);
    node.run_until(Time(10ms));
    node.receive("080#");
    ASSERT_EQ(node.number(0x2010, 1), 0x1234U);
    node.run_until(Time(25ms - 1us));
    ASSERT_EQ(node.errors(), Texts());
    node.run_until(Time(25ms));
    ASSERT_EQ(node.errors(), deadline ? Texts({"+8250/1"}) : Texts());
    node.receive("205#35 12");
    ASSERT_EQ(node.errors(), deadline ? Texts({"-8250/1"}) : Texts());
  }
}

TEST(TransmissionType, OfAnRpdoThatIsReservedIsRefusedAndLeavesTheOldOne) {
  for (unsigned type = 241; type <= 253; ++type) {
    PdoNode node;
    node.map_rpdo(1, 0x205, 254, {0x2010'01'10});
    EXPECT_EQ(node.write(0x1400, 2, type), value_range);
    EXPECT_EQ(node.number(0x1400, 2), 254U);
    node.operate();
    node.receive("205#34 12");
    EXPECT_EQ(node.number(0x2010, 1), 0x1234U);
  }
}

}  // namespace
}  // namespace canvoy::pdo_types_test
