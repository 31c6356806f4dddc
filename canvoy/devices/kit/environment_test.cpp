// Offers of an environment are found by their types; more than there is room for is a defect of the
// environment.
#include "canvoy/devices/kit/environment.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace canvoy::site_test {
namespace {

template <std::size_t number>
struct Thing {
  std::size_t value = 0;
};

template <std::size_t number>
Callback<Thing<number>()> source() {
  return {[](void*) { return Thing<number>{number + 1}; }, nullptr};
}

template <std::size_t... number>
void provide_all(Environment& environment, std::index_sequence<number...>) {
  (environment.provide(source<number>()), ...);
}

TEST(Environment, WhatIsOfferedIsFoundByItsType) {
  Environment environment;
  provide_all(environment, std::make_index_sequence<24>());
  EXPECT_EQ(environment.get<Thing<0>>().value, 1u);
  EXPECT_EQ(environment.get<Thing<23>>().value, 24u);
  EXPECT_EQ(environment.get<Thing<24>>({99}).value, 99u) << "nobody offers it";
}

TEST(Environment, ThereIsNoRoomForA25thOffer) {
  Environment environment;
  provide_all(environment, std::make_index_sequence<24>());
  EXPECT_DEATH(environment.provide(source<24>()), "");
}

}  // namespace
}  // namespace canvoy::site_test
