#include "canvoy/canopen/protocol/abort_reason.hpp"

#include <gtest/gtest.h>

#include <set>

namespace canvoy::abort_reason_test {
namespace {

/// The codes of CiA 301, 7.2.4.3.17, in the form of its table.
constexpr std::uint32_t codes[] = {
    0x0503'0000, 0x0504'0000, 0x0504'0001, 0x0504'0002, 0x0504'0003, 0x0504'0004, 0x0504'0005,
    0x0601'0000, 0x0601'0001, 0x0601'0002, 0x0602'0000, 0x0604'0041, 0x0604'0042, 0x0604'0043,
    0x0604'0047, 0x0606'0000, 0x0607'0010, 0x0607'0012, 0x0607'0013, 0x0609'0011, 0x0609'0030,
    0x0609'0031, 0x0609'0032, 0x0609'0036, 0x060A'0023, 0x0800'0000, 0x0800'0020, 0x0800'0021,
    0x0800'0022, 0x0800'0023, 0x0800'0024};

TEST(AbortReason, IsOneOfItsOwnForEachCodeOfCia301) {
  std::set<std::string_view> reasons{abort_reason(AbortCode{0x0504'0006})};
  EXPECT_EQ(*reasons.begin(), "unknown abort code");
  for (const std::uint32_t code : codes) {
    EXPECT_TRUE(reasons.insert(abort_reason(AbortCode{code})).second) << std::hex << code;
  }
}

TEST(AbortReason, SaysWhatIsWrong) {
  EXPECT_EQ(abort_reason(AbortCode{0x0602'0000}), "the object does not exist in the dictionary");
  EXPECT_EQ(abort_reason(AbortCode{0x0504'0000}), "SDO time-out");
  EXPECT_EQ(abort_reason(AbortCode{0x0601'0001}), "the object is write-only");
  EXPECT_EQ(abort_reason(AbortCode{0x0601'0002}), "the object is read-only");
  EXPECT_EQ(abort_reason(AbortCode::none), "no abort");
}

TEST(AbortReason, OfWhatNoServerMaySayIsUnknown) {
  for (const std::uint32_t code : {0x0000'0001U, 0x0609'0033U, 0x0800'0025U, 0xFFFF'FFFFU}) {
    EXPECT_EQ(abort_reason(AbortCode{code}), "unknown abort code");
  }
}

}  // namespace
}  // namespace canvoy::abort_reason_test
