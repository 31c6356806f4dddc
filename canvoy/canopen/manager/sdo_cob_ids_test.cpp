#include "canvoy/canopen/manager/sdo_cob_ids.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"

namespace canvoy::sdo_cob_ids_test {
namespace {

constexpr std::uint32_t invalid = 0x8000'0000;

/// 1F02h with 680h to 684h, and a sixth entry that is not valid.
struct SdoCobIdsTest : testing::Test {
  SdoCobIdsTest() { manager.boot(); }
  void set(std::uint8_t sub, std::uint32_t value) {
    manager.node.dictionary().set_number(dynamic_sdo::cob_ids, sub, value);
  }
  AbortCode check(std::uint8_t sub, std::uint32_t value) {
    const Result<Entry> entry = manager.node.dictionary().find(dynamic_sdo::cob_ids, sub);
    EXPECT_TRUE(entry);
    return entry ? sut.check(*entry, value) : entry.abort();
  }

  WireNode manager{dynamic_sdo_manager(), 1};
  std::array<SdoConnection, 2> memory{};
  SdoConnections connections{memory};
  SdoCobIds sut{manager.node.dictionary(), connections};
};

/// Values that a configuration tool or a damaged memory may have left there.
TEST_F(SdoCobIdsTest, GiveNothingThatIsNotValidOf29BitsOrRestricted) {
  set(1, invalid | 0x690);
  set(2, 0x2000'0691);
  set(3, 0x605);
  set(4, 0);
  EXPECT_EQ(sut.free_can_id(), 0x684);
  EXPECT_EQ(sut.free_can_id(0x684), 0) << "no two of them";
}

TEST_F(SdoCobIdsTest, GiveTheLastEntryToo) {
  for (std::uint8_t sub = 1; sub <= 5; ++sub) set(sub, invalid);
  set(6, 0x685);
  EXPECT_EQ(sut.free_can_id(), 0x685);
  EXPECT_EQ(check(1, 0x685), AbortCode::parameter_incompatible);
}

/// One CAN-ID for both directions is not a channel.
TEST_F(SdoCobIdsTest, GiveNoCanIdForBothDirectionsThoughItStandsThereTwice) {
  set(2, 0x4000'0680);
  EXPECT_EQ(sut.free_can_id(), 0x680);
  EXPECT_EQ(sut.free_can_id(0x680), 0x682);
}

TEST_F(SdoCobIdsTest, AreFreeAgainWhenTheirConnectionIsClosedAndNotWhenItBeginsToEnd) {
  memory[0] = {.state = SdoConnection::State::ending, .request = 0x680, .response = 0x681};
  EXPECT_EQ(sut.free_can_id(), 0x682);
  EXPECT_EQ(check(1, 0x685), AbortCode::device_state);
  EXPECT_EQ(check(2, invalid), AbortCode::device_state);
  memory[0] = {};
  EXPECT_EQ(sut.free_can_id(), 0x680);
  EXPECT_EQ(check(1, 0x685), AbortCode::none);
  EXPECT_EQ(check(2, invalid), AbortCode::none);
}

/// Bit 30 alone makes another COB-ID of the same CAN-ID.
TEST_F(SdoCobIdsTest, MayBeWrittenWithTheirOwnCanIdUnlessItIsGiven) {
  EXPECT_EQ(check(1, 0x4000'0680), AbortCode::none);
  memory[0] = {.state = SdoConnection::State::given, .request = 0x680, .response = 0x681};
  EXPECT_EQ(check(1, 0x680), AbortCode::none) << "it stays as it is";
  EXPECT_EQ(check(1, 0x4000'0680), AbortCode::device_state);
}

}  // namespace
}  // namespace canvoy::sdo_cob_ids_test
