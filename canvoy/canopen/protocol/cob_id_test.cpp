#include "canvoy/canopen/protocol/cob_id.hpp"

#include <gtest/gtest.h>

namespace canvoy::cob_id_test {
namespace {

TEST(NodeId, Is1To127) {
  for (unsigned id = 0; id <= 300; ++id) EXPECT_EQ(is_node_id(id), id >= 1 && id <= 127) << id;
  EXPECT_FALSE(is_node_id(node_id_unconfigured));
}

TEST(CobId, IsInvalidByBit31) {
  EXPECT_FALSE(CobId{}.valid());
  EXPECT_FALSE(CobId{0x8000'0181}.valid());
  EXPECT_TRUE(CobId{0x4000'0181}.valid());
  EXPECT_TRUE(CobId{0x0000'0000}.valid());
}

TEST(CobId, HasItsCanIdInTheLower29Bits) {
  EXPECT_EQ(CobId{0xC000'0181}.can_id(), 0x181U);
  EXPECT_EQ(CobId{0xFFFF'FFFF}.can_id(), 0x1FFF'FFFFU);
}

TEST(CobId, IsABaseFrameWithoutBit29UpTo7FFh) {
  EXPECT_TRUE(CobId{0x0000'07FF}.is_base_frame());
  EXPECT_TRUE(CobId{0xC000'0181}.is_base_frame());
  EXPECT_FALSE(CobId{0x2000'0181}.is_base_frame());
  EXPECT_FALSE(CobId{0x0000'0800}.is_base_frame());
}

TEST(CobId, MustNotBeARestrictedCanId) {
  // First and last of each range, with 180h left to CiA 417 (CiA 301, 7.3.5).
  struct Range {
    std::uint32_t first;
    std::uint32_t last;
  };
  constexpr Range ranges[] = {{0x000, 0x07F}, {0x101, 0x17F}, {0x581, 0x5FF},
                              {0x601, 0x67F}, {0x6E0, 0x6FF}, {0x701, 0x7FF}};
  for (std::uint32_t id = 0; id <= 0x7FF; ++id) {
    bool restricted = false;
    for (const Range& range : ranges) restricted |= id >= range.first && id <= range.last;
    EXPECT_EQ(is_restricted(id), restricted) << std::hex << id;
  }
}

TEST(CobId, OfThePreDefinedConnectionSetBeginsWhereCia301HasIt) {
  EXPECT_EQ(can_id::nmt, 0x000);
  EXPECT_EQ(can_id::sync, 0x080);
  EXPECT_EQ(can_id::emergency, 0x080);
  EXPECT_EQ(can_id::time, 0x100);
  EXPECT_EQ(can_id::tpdo1, 0x180);
  EXPECT_EQ(can_id::rpdo1, 0x200);
  EXPECT_EQ(can_id::sdo_response, 0x580);
  EXPECT_EQ(can_id::sdo_request, 0x600);
  EXPECT_EQ(can_id::error_control, 0x700);
}

}  // namespace
}  // namespace canvoy::cob_id_test
