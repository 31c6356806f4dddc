#include <gtest/gtest.h>

#include "canvoy/canopen/testing/pdo_node.hpp"

namespace canvoy::rpdo_length_test {
namespace {

using enum AbortCode;
using Texts = std::vector<std::string>;

TEST(Rpdo, TooShortIsIgnoredAndAnErrorUntilAGoodOneComes) {
  for (std::size_t length = 0; length < 8; ++length) {
    PdoNode node;
    node.map_rpdo(3, 0x205, 255, {0x2020'01'20, 0x2020'02'20});
    node.operate();
    node.receive("205#11 11 11 11 22 22 22 22");
    Frame frame = wire_frame("205#33 33 33 33 44 44 44");
    frame.length = static_cast<std::uint8_t>(length);
    node.node.receive(frame, node.now);
    node.node.receive(frame, node.now);
    EXPECT_EQ(node.errors(), Texts({"+8210/3"}));
    EXPECT_EQ(node.number(0x2020, 1), 0x11111111U);
    EXPECT_EQ(node.number(0x2020, 2), 0x22222222U);
    EXPECT_EQ(node.last_error().register_bits, error_register::communication);
    node.receive("205#55 55 55 55 66 66 66 66");
    EXPECT_EQ(node.errors(), Texts({"-8210/3"}));
    EXPECT_EQ(node.number(0x2020, 2), 0x66666666U);
  }
}

TEST(Rpdo, TooLongIsTakenWithItsFirstBytesAndAnErrorUntilAGoodOneComes) {
  PdoNode node;
  node.map_rpdo(2, 0x205, 255, {0x2010'01'10});
  node.operate();
  node.receive("205#01 02 03");
  EXPECT_EQ(node.number(0x2010, 1), 0x0201U);
  node.receive("205#03 04 05 06 07 08 09 0A");
  EXPECT_EQ(node.number(0x2010, 1), 0x0403U);
  EXPECT_EQ(node.errors(), Texts({"+8220/2"}));
  node.receive("205#05");
  EXPECT_EQ(node.errors(), Texts({"-8220/2", "+8210/2"}));
  node.receive("205#07 08 09");
  EXPECT_EQ(node.errors(), Texts({"-8210/2", "+8220/2"}));
  node.receive("205#09 0A");
  EXPECT_EQ(node.errors(), Texts({"-8220/2"}));
  EXPECT_EQ(node.number(0x2010, 1), 0x0A09U);
}

TEST(Rpdo, OfAFewBitsHasTheBytesThatTheyNeed) {
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, {0x2030'01'01, 0x2030'02'01, 0x2040'06'07});
  node.operate();
  node.receive("205#FF");
  EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
  node.receive("205#FE 03");
  EXPECT_EQ(node.errors(), Texts({"-8210/1"}));
  EXPECT_EQ(node.number(0x2030, 1), 0U);
  EXPECT_EQ(node.number(0x2030, 2), 1U);
}

TEST(Rpdo, RaisesItsErrorAgainAfterAReset) {
  PdoNode node;
  for (int i = 0; i < 2; ++i) {
    node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
    node.operate();
    node.receive("205#01");
    EXPECT_EQ(node.errors(), Texts({"+8210/1"}));
    node.receive("000#82 00");
  }
}

/// The error behaviour 1029h may end operational because of the present frame.
TEST(Rpdo, IsNotTakenWhereItsLengthErrorEndedOperational) {
  PdoNode node;
  Service service;
  auto stop = [&](const Error&, bool) { node.node.command(NmtCommand::enter_pre_operational); };
  service.error_changed = Callback<void(const Error&, bool)>::of(stop);
  node.node.attach(service);
  node.map_rpdo(1, 0x205, 255, {0x2010'01'10});
  ASSERT_EQ(node.write(0x1400, 5, 100), none);
  node.operate();
  node.receive("205#01 00 00");
  EXPECT_EQ(node.number(0x2010, 1), 0U);
  EXPECT_FALSE(node.rpdos[1].is_supervised());
}

}  // namespace
}  // namespace canvoy::rpdo_length_test
