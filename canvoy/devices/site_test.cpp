// What a place offers is found by its type; more than there is room for is a defect of who offers.
#include "canvoy/devices/site.hpp"

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
void offer_all(Site& site, std::index_sequence<number...>) {
  (site.offer(source<number>()), ...);
}

TEST(Site, WhatIsOfferedIsFoundByItsType) {
  Site site;
  offer_all(site, std::make_index_sequence<24>());
  EXPECT_EQ(site.find<Thing<0>>().value, 1u);
  EXPECT_EQ(site.find<Thing<23>>().value, 24u);
  EXPECT_EQ(site.find<Thing<24>>({99}).value, 99u) << "nobody offers it";
}

TEST(Site, ThereIsNoRoomForA25thOffer) {
  Site site;
  offer_all(site, std::make_index_sequence<24>());
  EXPECT_DEATH(site.offer(source<24>()), "");
}

}  // namespace
}  // namespace canvoy::site_test
