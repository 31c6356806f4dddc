// Names for the access to a part of the terminal: eighteen for each part, made of the part's name
// and common words.
//
//     inline constexpr AccessTexts texts = access_texts("Off", "On and access");
//     inline constexpr auto values = access_values(texts);  // "On and access by ... device 16"
#pragma once

#include "canvoy/profiles/cia447/values.hpp"

namespace canvoy::cia447 {

/// A name that is put together at compile time.
class JoinedText {
 public:
  constexpr JoinedText() = default;
  /// Both texts, and the number where it is above 0; at most 56 characters.
  constexpr JoinedText(std::string_view first, std::string_view second, unsigned number = 0) {
    append(first);
    append(second);
    if (number >= 10) append_digit(number / 10);
    if (number > 0) append_digit(number % 10);
  }
  /// Valid as long as this object.
  constexpr std::string_view text() const { return {characters_, size_}; }

 private:
  constexpr void append(std::string_view text) {
    for (const char character : text) characters_[size_++] = character;
  }
  constexpr void append_digit(unsigned digit) {
    characters_[size_++] = static_cast<char>('0' + digit);
  }

  char characters_[56]{};
  std::size_t size_ = 0;
};

inline constexpr unsigned add_on_device_max = 16;
/// Of no device, the vehicle, and add-on devices 1 to 16.
using AccessTexts = std::array<JoinedText, add_on_device_max + 2>;

/// Names for a part that is not in use (`idle`), or to which a device has access (`access`).
constexpr AccessTexts access_texts(std::string_view idle, std::string_view access) {
  AccessTexts texts{};
  texts[0] = JoinedText(idle, "");
  texts[1] = JoinedText(access, " by standard vehicle application");
  for (unsigned device = 1; device <= add_on_device_max; ++device) {
    texts[device + 1] = JoinedText(access, " by car add-on device ", device);
  }
  return texts;
}
/// Codes of a status of 5 bits with these names. The names have to live as long.
constexpr auto access_values(const AccessTexts& texts) {
  std::string_view states[std::tuple_size_v<AccessTexts>];
  for (std::size_t i = 0; i < texts.size(); ++i) states[i] = texts[i].text();
  return coded<5>(states, status_sentinels<5>);
}

}  // namespace canvoy::cia447
