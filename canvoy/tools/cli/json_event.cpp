#include "canvoy/tools/cli/json_event.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace canvoy::tools {

JsonEvent::JsonEvent(std::string_view event) {
  json_.begin_object();
  json_.key("event").text(event);
}

void JsonEvent::print() {
  json_.end_object();
  fmt::print("{}\n", line_);
  std::fflush(stdout);
}

}  // namespace canvoy::tools
