// The pressed key of a pad, for the user interactions of the terminal (CiA 447-3, 4.2.9): none, one
// key, or several.
//
//     PressedKeys<NumberPadKey> pad;
//     pad.press(NumberPadKey::key_1);
//     pad.state();  // NumberPadKey::key_1
#pragma once

#include <bit>
#include <cstdint>

namespace canvoy::cia447 {

/// `Key` has `none`, the keys from 1 upward, and `several` behind the last of them.
template <class Key>
class PressedKeys {
 public:
  static constexpr unsigned count = static_cast<unsigned>(Key::several) - 1;  ///< keys of the pad
  static_assert(count < 32);

  /// Keys of other pads are ignored.
  constexpr void press(Key key) { pressed_ |= bit(key); }
  /// Notes that a key is released.
  constexpr void release(Key key) { pressed_ &= ~bit(key); }
  /// Notes that all keys are released.
  constexpr void release_all() { pressed_ = 0; }

  /// The pressed key, none, or several.
  constexpr Key state() const {
    if (pressed_ == 0) return Key::none;
    if (std::popcount(pressed_) > 1) return Key::several;
    return static_cast<Key>(std::countr_zero(pressed_) + 1);
  }

 private:
  static constexpr std::uint32_t bit(Key key) {
    const auto number = static_cast<unsigned>(key);
    return number >= 1 && number <= count ? 1U << (number - 1) : 0;
  }

  std::uint32_t pressed_ = 0;
};

}  // namespace canvoy::cia447
