#include "canvoy/can/check_invariant.hpp"

#include <gtest/gtest.h>

namespace canvoy::must_hold_test {
namespace {

TEST(MustHold, StopsTheProgramWhereItDoesNot) {
  check_invariant(true);
  EXPECT_DEATH(check_invariant(false), "");
}

TEST(MustHold, IsPartOfAConstantExpression) {
  constexpr auto half = [](int number) {
    check_invariant(number % 2 == 0);
    return number / 2;
  };
  static_assert(half(4) == 2);
}

}  // namespace
}  // namespace canvoy::must_hold_test
