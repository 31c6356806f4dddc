#include "canvoy/tools/session/sent_frame.hpp"

#include <fmt/format.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/text/json_line.hpp"

namespace canvoy::tools {

void print_sent(Session& session, const Frame& frame) {
  constexpr unsigned places = 6;
  const Duration time = session.loop().epoch() + session.loop().now().time_since_epoch();
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("time").decimal(time.count(), places);
  json.key("bus").text(session.bus().name());
  json.key("frame").text(FrameText(frame).view());
  json.end_object();
  fmt::print("{}\n", line);
}

}  // namespace canvoy::tools
