#include "canvoy/tools/sheet/network_text.hpp"

#include <fmt/format.h>

#include <chrono>

namespace canvoy::tools {

std::string text_value(std::string_view text) {
  constexpr unsigned char blank = 0x20;
  constexpr unsigned char delete_character = 0x7F;
  std::string value = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      value += '\\';
      value += letter;
    } else if (code < blank || code == delete_character) {
      value += fmt::format("\\u{:04X}", code);
    } else {
      value += letter;
    }
  }
  return value + '"';
}

std::string date_value(CivilTime time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{time - day};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

}  // namespace canvoy::tools
