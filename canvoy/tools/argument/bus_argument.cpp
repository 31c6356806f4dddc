#include "canvoy/tools/argument/bus_argument.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

namespace canvoy::tools {

namespace {

/// `can0`, `vcan12`, `slcan0`: letters with "can" in them, and a number.
bool looks_like_interface(std::string_view word) {
  const std::size_t letters = word.find_last_not_of("0123456789");
  return letters != std::string_view::npos && letters + 1 < word.size() &&
         word.substr(0, letters + 1).ends_with("can");
}

bool is_interface(std::string_view word) {
  constexpr std::size_t length_max = 15;
  std::error_code none;
  return !word.empty() && word.size() <= length_max && word.find('/') == std::string_view::npos &&
         !word.starts_with('.') &&
         std::filesystem::exists("/sys/class/net/" + std::string(word), none);
}

}  // namespace

bool names_bus(std::string_view word) {
  const std::string_view first = word.substr(0, word.find(','));
  const std::string_view interface = first.substr(0, first.find('/'));
  return first == "sim" || first.starts_with("udp:") || first.starts_with("tcp:") ||
         looks_like_interface(interface) || is_interface(interface);
}

}  // namespace canvoy::tools
