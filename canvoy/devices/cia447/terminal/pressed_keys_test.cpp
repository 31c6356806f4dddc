// Keys that are pressed, alone and together: the codes of 6082h, 6087h, 608Ch and 6092h.
#include "canvoy/devices/cia447/terminal/pressed_keys.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::cia447::pressed_keys_test {
namespace {

template <class Key>
void tell_one_and_several(unsigned keys, unsigned several) {
  EXPECT_EQ(PressedKeys<Key>::count, keys);
  for (unsigned one = 1; one <= keys; ++one) {
    PressedKeys<Key> sut;
    EXPECT_EQ(static_cast<unsigned>(sut.state()), 0u);
    sut.press(static_cast<Key>(one));
    EXPECT_EQ(static_cast<unsigned>(sut.state()), one);
    for (unsigned other = 1; other <= keys; ++other) {
      if (other == one) continue;
      sut.press(static_cast<Key>(other));
      EXPECT_EQ(static_cast<unsigned>(sut.state()), several);
      sut.release(static_cast<Key>(other));
      EXPECT_EQ(static_cast<unsigned>(sut.state()), one) << "the first is still down";
    }
    sut.release(static_cast<Key>(one));
    EXPECT_EQ(static_cast<unsigned>(sut.state()), 0u);
  }
}

TEST(PressedKeys, TheNumberPadHasTwelve) {
  tell_one_and_several<NumberPadKey>(12, 0x0D);
}
TEST(PressedKeys, ThereAreSevenFunctionKeys) {
  tell_one_and_several<FunctionKey>(7, 0x08);
}
TEST(PressedKeys, ThereAreFifteenControlKeys) {
  tell_one_and_several<ControlKey>(15, 0x10);
}
TEST(PressedKeys, ThereAreTwelveTipSwitches) {
  tell_one_and_several<TipSwitch>(12, 0x0D);
}

TEST(PressedKeys, WhatIsNoKeyIsPassedOver) {
  PressedKeys<FunctionKey> sut;
  for (const FunctionKey no_key : {FunctionKey::none, FunctionKey::several, FunctionKey::failure,
                                   FunctionKey::not_available}) {
    sut.press(no_key);
    EXPECT_EQ(sut.state(), FunctionKey::none);
  }
  sut.press(FunctionKey::key_7);
  sut.release(FunctionKey::none);
  EXPECT_EQ(sut.state(), FunctionKey::key_7);
}

TEST(PressedKeys, AKeyThatIsPressedTwiceIsOneKey) {
  PressedKeys<NumberPadKey> sut;
  sut.press(NumberPadKey::star);
  sut.press(NumberPadKey::star);
  EXPECT_EQ(sut.state(), NumberPadKey::star);
  sut.press(NumberPadKey::hash);
  sut.release_all();
  EXPECT_EQ(sut.state(), NumberPadKey::none);
}

}  // namespace
}  // namespace canvoy::cia447::pressed_keys_test
