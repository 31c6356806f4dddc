// Contents of a passenger information device of CiA 407, element by element, as in 6203h (9.2.8.4).
// The hardware arranges them.
//
//     void show(std::span<const ShownElement> elements);   // from the upper left on
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/profiles/cia407/passenger_information.hpp"

namespace canvoy::cia407 {

struct ShownElement {
  /// What the bytes of an element are.
  enum class Content : std::uint8_t {
    text,     ///< plain
    xml,      ///< of 6200h, with its format in the text
    picture,  ///< of 6202h: a file
  };
  Content content = Content::text;  ///< see Content
  /// Valid while the hardware's callback runs.
  std::span<const std::uint8_t> octets;
  /// For plain texts, as in 6205h: 0 ISO 646-US, n ISO 8859-n.
  std::uint16_t character_set = 0;
  FontSize size = FontSize::no_mode;
  Alignment alignment = Alignment::no_mode;  ///< of a text
  FontStyle style = FontStyle::no_mode;      ///< of a text
  FlashSpeed flash = FlashSpeed::no_flash;   ///< of a text
};

}  // namespace canvoy::cia407
