#include "canvoy/can/must_hold.hpp"

#include <gtest/gtest.h>

namespace canvoy::must_hold_test {
namespace {

TEST(MustHold, StopsTheProgramWhereItDoesNot) {
  must_hold(true);
  EXPECT_DEATH(must_hold(false), "");
}

TEST(MustHold, IsPartOfAConstantExpression) {
  constexpr auto half = [](int number) {
    must_hold(number % 2 == 0);
    return number / 2;
  };
  static_assert(half(4) == 2);
}

}  // namespace
}  // namespace canvoy::must_hold_test
