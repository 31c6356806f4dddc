// Decodes UTF-8 that arrives byte by byte. Invalid input gives U+FFFD, once for each piece that
// cannot be continued.
//
//     Utf8Stream text;
//     text.push(0xC3, put);  // nothing yet
//     text.push(0xA4, put);  // put(U'ä')
#pragma once

#include <cstdint>

namespace canvoy::cia447 {

class Utf8Stream {
 public:
  static constexpr char32_t replacement = 0xFFFD;  ///< for invalid input

  /// Takes a byte, and calls `put` with each character that is complete.
  template <class Put>
  void push(std::uint8_t byte, Put&& put) {
    if (missing_ > 0) {
      if (byte >= low_ && byte <= high_) {
        code_ = code_ << 6 | (byte & 0x3FU);
        allow_any();
        if (--missing_ == 0) put(code_);
        return;
      }
      missing_ = 0;
      put(replacement);
    }
    if (byte < 0x80) {
      put(static_cast<char32_t>(byte));
    } else if (!begin(byte)) {
      put(replacement);
    }
  }
  /// Ends the input.
  template <class Put>
  void end(Put&& put) {
    if (missing_ == 0) return;
    missing_ = 0;
    put(replacement);
  }
  /// Discards an incomplete character.
  void forget() { missing_ = 0; }

 private:
  void allow_any() {
    low_ = 0x80;
    high_ = 0xBF;
  }
  /// Limits the second byte of some: overlong forms, UTF-16 surrogates, and values above 10 FFFFh.
  bool begin(std::uint8_t byte) {
    if (byte < 0xC2 || byte > 0xF4) return false;
    allow_any();
    if (byte < 0xE0) {
      missing_ = 1;
      code_ = byte & 0x1FU;
    } else if (byte < 0xF0) {
      missing_ = 2;
      code_ = byte & 0x0FU;
      if (byte == 0xE0) low_ = 0xA0;
      if (byte == 0xED) high_ = 0x9F;
    } else {
      missing_ = 3;
      code_ = byte & 0x07U;
      if (byte == 0xF0) low_ = 0x90;
      if (byte == 0xF4) high_ = 0x8F;
    }
    return true;
  }

  char32_t code_ = 0;
  std::uint8_t missing_ = 0;
  std::uint8_t low_ = 0x80;
  std::uint8_t high_ = 0xBF;
};

}  // namespace canvoy::cia447
