#include "canvoy/tools/device/car/car_words.hpp"

#include <gtest/gtest.h>

namespace canvoy::tools {
namespace {

TEST(CarWords, StatesAreThoseOfTheProfile) {
  EXPECT_EQ(taximeter_words(cia447::Taximeter::for_hire), "for hire");
  EXPECT_EQ(taximeter_words(cia447::Taximeter::standby_mode), "standby mode");
  EXPECT_EQ(taximeter_words(static_cast<cia447::Taximeter>(9)), "reserved");
  EXPECT_EQ(lamp_words(cia447::Lamp::off), "off");
  EXPECT_EQ(lamp_words(cia447::Lamp::blinking), "blinking");
  EXPECT_EQ(lamp_words(cia447::Lamp::failure), "failure");
}

TEST(CarWords, WhomThereIsNoRoomForIsToldInOneLine) {
  using Kind = cia447::CarEvent::Kind;
  EXPECT_EQ(car_event_words(Kind::refused, ""), "there is no node-ID left: 15 devices have one");
  EXPECT_EQ(car_event_words(Kind::lost, "node 5"), "node 5 is lost");
  EXPECT_EQ(car_event_words(Kind::asleep, ""), "the network sleeps");
}

}  // namespace
}  // namespace canvoy::tools
