#include "canvoy/tools/page/write_permission.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::write_permission_test {
namespace {

TEST(WritePermission, AllowsNothingWhereNothingIsSaid) {
  const WritePermission permission = parse_write_permission("");
  EXPECT_TRUE(permission.is_empty());
  EXPECT_FALSE(permission.allows(5, 0x1017));
  EXPECT_FALSE(permission.allows_nmt());
}

TEST(WritePermission, AllowsWhatIsInTheListAndNothingElse) {
  const WritePermission permission = parse_write_permission("1017,10:6010,6100-61FF");
  EXPECT_TRUE(permission.allows(5, 0x1017));
  EXPECT_FALSE(permission.allows(5, 0x1016));
  EXPECT_TRUE(permission.allows(10, 0x6010));
  EXPECT_FALSE(permission.allows(11, 0x6010));
  EXPECT_TRUE(permission.allows(1, 0x61FF));
  EXPECT_FALSE(permission.allows(1, 0x6200));
  EXPECT_FALSE(permission.allows_nmt());
}

TEST(WritePermission, NmtIsNotAmongObjects) {
  const WritePermission permission = parse_write_permission("nmt");
  EXPECT_TRUE(permission.allows_nmt());
  EXPECT_FALSE(permission.allows(1, 0x1017));
}

TEST(WritePermission, AllIsAll) {
  const WritePermission permission = parse_write_permission("all");
  EXPECT_TRUE(permission.allows(127, 0xFFFF));
  EXPECT_TRUE(permission.allows_nmt());
}

TEST(WritePermission, RefusesWhatItDoesNotUnderstand) {
  for (const char* text : {"10:", ":6010", "0:6010", "128:6010", "61FF-6100", "10000", "x", "6010-",
                           "nmt,,1017", "10:5:6010", "-5"}) {
    EXPECT_THROW(parse_write_permission(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace canvoy::tools::write_permission_test
