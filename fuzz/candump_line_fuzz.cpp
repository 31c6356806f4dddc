// Arbitrary text as a line of a log: an accepted line is written and read back unchanged.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "canvoy/can/host/candump_log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy::host;
  const LogLine line = parse_log_line({reinterpret_cast<const char*>(data), size});
  if (line.kind == LogLineKind::malformed && line.problem.empty()) std::abort();
  if (line.kind != LogLineKind::frame) return 0;
  std::string text;
  append_log_line(text, line.time.time_since_epoch(), line.interface, line.frame);
  text.pop_back();
  const LogLine again = parse_log_line(text);
  const bool same = again.kind == line.kind && again.time == line.time &&
                    again.interface == line.interface && again.frame == line.frame;
  if (!same) std::abort();
  return 0;
}
