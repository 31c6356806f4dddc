#include "canvoy/tools/cli/place_json.hpp"

#include <fmt/format.h>

namespace canvoy::tools {

void append_index(text::JsonLine& json, std::uint16_t index, std::uint8_t sub) {
  json.key("index").text(fmt::format("{:04X}", index));
  json.key("sub").text(fmt::format("{:02X}", sub));
}

}  // namespace canvoy::tools
