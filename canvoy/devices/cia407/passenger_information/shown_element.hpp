// What a passenger information device of CiA 407 shows, element by element, as 6203h says
// (9.2.8.4): the hardware lays it out.
//
//     void show(std::span<const ShownElement> elements);   // from the upper left on
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/profiles/cia407/passenger_information.hpp"

namespace canvoy::cia407 {

struct ShownElement {
  enum class Content : std::uint8_t {
    text,     ///< plain
    xml,      ///< of 6200h: how it is formatted stands in it
    picture,  ///< of 6202h: a file
  };
  Content content = Content::text;
  /// Valid for as long as it is shown to the hardware.
  std::span<const std::uint8_t> octets;
  /// Of plain texts, as 6205h has it: 0 ISO 646-US, n ISO 8859-n.
  std::uint16_t character_set = 0;
  FontSize size = FontSize::no_mode;
  Alignment alignment = Alignment::no_mode;
  FontStyle style = FontStyle::no_mode;
  FlashSpeed flash = FlashSpeed::no_flash;
};

}  // namespace canvoy::cia407
