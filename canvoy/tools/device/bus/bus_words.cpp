#include "canvoy/tools/device/bus/bus_words.hpp"

#include <fmt/format.h>

namespace canvoy::tools {

std::string clock_words(const std::optional<cia407::CivilTime>& time) {
  return time ? fmt::format("{:02}:{:02}", time->hour, time->minute) : "--:--";
}

}  // namespace canvoy::tools
